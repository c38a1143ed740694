"""What deciding an answer comes to, and the words in which it is told."""

from __future__ import annotations

from msgspec import Struct


class Accepted(Struct, frozen=True):
    """The answer is right; `worst_ulps` is the largest error of its numbers, in ulps of the exact ones.

    None where the answer has no measured number; an exact 0, which has no scale of its own, adds nothing.
    """

    worst_ulps: float | None = None


class Rejection(Struct, frozen=True):
    """The answer is wrong, and why, for a person.

    `wanted` and `got` are whole answers. Where one number decided, `where` names it ("y of point 2") and its
    errors are given: absolute, relative to the exact number (None where that is 0), and in its ulps.
    """

    message: str
    wanted: str
    got: str
    where: str = ""
    absolute: float | None = None
    relative: float | None = None
    ulps: float | None = None


Outcome = Accepted | Rejection
UNMEASURED = Accepted()


class Words(Struct, frozen=True):
    """A problem's own words for its answers, the table `[words]` of problem.toml; all of them optional."""

    answer: str = ""  # what the number is called, such as "t"; else "the answer"
    meant: str = ""  # what a line of output holds, such as "0, 1, 2 or none"
    missing: str = ""  # why None is wrong where there is an answer
    order: str = ""  # in which order the elements of a list come
    unit: str = ""  # what a tolerance's `extent` and `zero` count in, such as "the size of the figure"


NO_WORDS = Words()
COORDINATES = ("x", "y", "z")


class Place:
    """Where in an answer something is: one step down from its parent.

    `step` is the index in the exact tree, `word` the name for a person ("point 2", "x"; "" for a step of the
    tree alone). A place is `alone` where it is the only one of its kind and need not be counted.
    """

    __slots__ = ("alone", "parent", "step", "word")

    def __init__(self, parent: Place | None, step: int, word: str, *, alone: bool = False) -> None:
        self.parent = parent
        self.step = step
        self.word = word
        self.alone = alone

    def steps(self) -> list[int]:
        """The indices from the root of the exact tree to this place."""
        found = []
        place = self
        while place.parent is not None:
            found.append(place.step)
            place = place.parent
        return found[::-1]

    def name(self, *, short: bool = False) -> str:
        """The place in words, "y of point 2"; a `short` name leaves out what is alone. Empty for the root."""
        return " of ".join(self._words(short=short))

    def told(self) -> str:
        """The place of a number, short; a coordinate of no point comes last: "part 2 of item 3: x"."""
        first, *rest = self._words(short=True) or [""]
        if first in COORDINATES and rest and not rest[0].startswith("point"):
            return f"{' of '.join(rest)}: {first}"
        return " of ".join([first, *rest])

    def prefix(self) -> str:
        """How a sentence about the whole of this place begins: "part 2 of item 3: ", nothing for the root."""
        name = self.name()
        return f"{name}: " if name else ""

    def _words(self, *, short: bool) -> list[str]:
        words = []
        place: Place | None = self
        while place is not None:
            if place.word and not (short and place.alone):
                words.append(place.word)
            place = place.parent
        return words


ROOT = Place(None, 0, "")


class Unreadable(Exception):  # noqa: N818 - it never reaches a person but as its text
    """An answer of the wrong form; its text says why."""


class Mismatch(Exception):  # noqa: N818 - as above
    """An answer of the right form that is wrong: why, where, and the errors of the number that decided."""

    def __init__(
        self,
        message: str,
        where: str = "",
        errors: tuple[float | None, float | None, float | None] = (None, None, None),
    ) -> None:
        super().__init__(message)
        self.message = message
        self.where = where
        self.errors = errors


class Unfit(Exception):  # noqa: N818 - as above
    """An exact answer that is none of its type; its text says why."""
