"""What a topic adds to the engine: hooks, every one optional, which a problem.py hands over as TOPIC.

The engine knows no topic: what it draws or makes simpler as a whole, these functions draw or make simpler. A
problem without a topic works in every command. It has no picture.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any, Protocol

from msgspec import Struct

from judge.problem.model import Case, Problem

if TYPE_CHECKING:
    from judge.drawing import Picture


class Chance(Protocol):
    """A source of chance; every `judge.data.draw.Draw` is one."""

    def integer(self, low: int, high: int) -> int:
        """An int from low to high, both included."""
        ...


class Shown(Struct, frozen=True):
    """A case and its answers, to be drawn.

    `values` are the arguments by parameter name, `exact` is what the problem's `solve` answers. `wanted` and
    `got` are the two answers in words; `given` is the submission's own, JSON of any shape whatever, and None
    where there is none. `heading` says which case it is.
    """

    problem: Problem
    values: Mapping[str, Any]
    exact: Any
    wanted: str | None
    got: str | None
    given: Any | None = None
    heading: str = ""


class Puzzle(Struct, frozen=True):
    """A small figure, and the answer to a question about it.

    Attributes:
        given: the figure in words, a line each: all that is needed for the answer.
        picture: the figure without the answer; None where it cannot be drawn.
        words: what an answer is made of, each with what it means, empty where that is plain.
        answer: the right one; empty for "none".
        one: whether one word is the whole answer.
        why: what makes it so.
    """

    given: tuple[str, ...]
    picture: Picture | None
    words: Mapping[str, str]
    answer: tuple[str, ...]
    one: bool = False
    why: str = ""


class Topic(Struct, frozen=True):
    """The hooks of a topic.

    Attributes:
        simpler: cases that may fail as a case does and are simpler; each is proved before it is tried.
        special: how many things in a case are special in themselves, such as a length of 0: of two failing
            cases the one without them is the simpler.
        picture: a case drawn, or None where it cannot be.
        explore: an HTML page, whole in itself, on which a person moves a case about; it begins with these
            arguments by parameter name, or a usual case. None where there is no such page for the problem.
        puzzle: a figure for a form of quiz cards, from chance and the problem's `solve`, which knows the
            answer; None for a form that it has no figures for.
    """

    simpler: Callable[[Problem, Case], Iterable[Case]] | None = None
    special: Callable[[Case], int] | None = None
    picture: Callable[[Shown], Picture | None] | None = None
    explore: Callable[[Problem, Mapping[str, Any] | None], str | None] | None = None
    puzzle: Callable[[str, Chance, Callable[..., Any]], Puzzle | None] | None = None
