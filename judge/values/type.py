"""What a type is: everything that the judge asks of an answer, or of a parameter's value.

An answer is handled in four forms: the exact tree (`judge.values.tree`), the target made of it once, JSON of
any shape as a submission sent it (`raw`), and the value that was read from that. A target is plain JSON: five
doubles for a real (`judge.values.numbers`), ints and words themselves, None, lists and tuples; {"run": […]},
{"any": […]} and {"such as": …} stand for the wrappers of the exact tree.

An atom defines the methods of `Type` that have no body here, or derives from `judge.values.plain.PlainType`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cached_property
from math import inf
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self

from judge.errors import ProblemError
from judge.values import decode
from judge.values.judged import decide, first_of
from judge.values.likeness import Outline, Usual, only_digits
from judge.values.lines import Tokens, tokens_of
from judge.values.outcome import (
    NO_WORDS,
    ROOT,
    UNMEASURED,
    Accepted,
    Mismatch,
    Outcome,
    Place,
    Rejection,
    Unfit,
    Unreadable,
    Words,
)
from judge.values.parameters import Draws as Draws
from judge.values.parameters import Number as Number
from judge.values.parameters import ParameterValues
from judge.values.tolerance import Tolerance
from judge.values.tree import AnyOf, Exact, Judged

if TYPE_CHECKING:
    from judge.values.interval import Roots

Raw = Any  # JSON of any shape
Target = Any
ExactOf = Callable[[], tuple[Exact, Tolerance]]  # asked only where doubles do not decide
Check = Callable[[Raw, Target, ExactOf], Outcome]
Quick = Callable[[Raw, Target], float | None]

NOTHING_MEASURED = -1.0
UNREADABLE = "text"  # the form of a line that holds no answer
LONGEST = 20_000  # items of all levels, where the type sets no bound above that
MANY_LENGTHS = 1000  # of a list without a bound, and of an array
_ANSWERS = 3  # of several that are right, which are shown


class Question:
    """What an answer's parts may ask while it is decided: the exact answer, and the problem's own words."""

    __slots__ = ("bounded", "exact", "optional", "words")

    def __init__(self, exact: ExactOf, words: Words, *, optional: bool, bounded: bool = True) -> None:
        self.exact = exact
        self.words = words
        self.optional = optional  # whether the whole answer may be None
        self.bounded = bounded  # whether a list may have no more items than its type says

    def exact_at(self, place: Place) -> tuple[Exact, Tolerance]:
        """The exact leaf at that place."""
        exact, tolerance = self.exact()
        for step in place.steps():
            parts: Any = exact.answers if isinstance(exact, AnyOf) else getattr(exact, "items", exact)
            exact = parts[step]
        return exact, tolerance


class Type(ParameterValues):
    """A type of answers and of parameters. Types are equal if they are written alike; they never change."""

    text = ""  # as problem.toml has it
    words = NO_WORDS  # of the problem, on the type of its whole answer
    folder: Path | None = None  # a pack's own types, without which the text may mean nothing

    is_parameter = True  # whether a parameter may be of this type
    is_buffer = False  # whether a submission receives a parameter's value as bytes
    settled = True  # whether an example shows the right answer, and not one of many that differ widely
    measured = False  # whether it holds real numbers, which have a tolerance
    optional = False  # whether None is one of its values
    may_begin_with_none = False  # whether the first token of a value may be `none`
    width: int | None = 1  # tokens on a line; None where that varies
    depth = 0  # levels of lists and tuples
    most = 1  # items of all levels in the longest answer, where the type bounds them
    lengths = 1  # that the longest of its lists may have, as many as are told apart
    noun = "a value"  # what is meant, "a number"
    plural = "values"  # "a list of numbers"
    element = ("item", "items")  # what one and several of them in a list are called
    annotation = "object"  # in a stub
    variable = "answer"  # what a function's parameter of this type is called
    rounded = ""  # the expression that rounds `{}` for a doctest; empty where nothing is rounded
    rounded_as = ""  # the annotation of what that gives, where it is another one

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        return f"parse({self.text!r})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Type) and self._identity() == other._identity()

    def __hash__(self) -> int:
        return hash(self._identity())

    def __reduce__(self) -> tuple[Any, ...]:
        from judge.values.grammar import parse

        return parse, self._identity()

    @property
    def items(self) -> int:
        """How many items an answer is read with, right or wrong."""
        return max(LONGEST, self.most)

    def _identity(self) -> tuple[Any, ...]:
        return self.text, self.folder, self.words

    # -- exact answers and targets -------------------------------------------------------------------

    def target(self, exact: Exact, tolerance: Tolerance) -> Target:
        """What answers are held against. Raises ProblemError for an exact answer that is none of this type,
        and for a tolerance that does not fit it."""
        from judge.values.interval import shared_roots  # building data alone needs exact numbers

        try:
            return self.targeted(exact, tolerance, shared_roots())
        except Unfit as why:
            raise ProblemError(
                f"the exact answer is no {self.text}: {why}", remedy="correct it, or the answer's type"
            ) from None

    def targeted(self, exact: Exact, tolerance: Tolerance, roots: Roots) -> Target:
        """`target` of a part, AnyOf included; raises Unfit."""
        if isinstance(exact, AnyOf):
            if not exact.answers:
                raise Unfit("AnyOf without answers")
            return {"any": [self.targeted(each, tolerance, roots) for each in exact.answers]}
        if isinstance(exact, Judged):
            return {"such as": self.targeted(exact.sample, tolerance, roots)}
        return self.aimed(exact, tolerance, roots)

    def aimed(self, exact: Exact, tolerance: Tolerance, roots: Roots) -> Target:
        """`targeted` of one exact answer."""
        raise NotImplementedError

    # -- deciding ------------------------------------------------------------------------------------

    @cached_property
    def check(self) -> Check:
        """`check(raw, target, exact)` decides an answer, JSON of any shape whatever; it never raises for one.

        `exact` gives the case's exact answer and tolerance; it is asked only where a number that is no double
        lies between an end of the interval and the next double.
        """
        quick, explained = self.quick, self._explained

        def check(raw: Raw, target: Target, exact: ExactOf) -> Outcome:
            try:
                worst = quick(raw, target)
            except (TypeError, ValueError):  # a target with alternatives or runs in it is not unpacked
                worst = None
            if worst is None:
                return explained(raw, target, exact)
            return Accepted(worst) if worst >= 0.0 else UNMEASURED

        return check

    @cached_property
    def quick(self) -> Quick:
        """Accepts the usual right answer and says how far off it is in ulps; None where one must look closer.

        NOTHING_MEASURED where there is nothing to be off. May raise TypeError or ValueError instead of None.
        """
        return lambda _raw, _target: None

    def _explained(self, raw: Raw, target: Target, exact: ExactOf) -> Outcome:
        question = Question(exact, self.words, optional=self.optional)
        try:
            worst = self.held(self.read(raw, question, ROOT), target, question, ROOT)
        except Unreadable as why:
            return Rejection(str(why), self.wanted(target), self.shown(raw))
        except Mismatch as why:
            return Rejection(why.message, self.wanted(target), self.shown(raw), why.where, *why.errors)
        return Accepted(worst) if worst >= 0.0 else UNMEASURED

    def read(self, raw: Raw, question: Question, place: Place) -> Any:
        """The value that `raw` stands for; raises Unreadable."""
        raise NotImplementedError

    def held(self, value: Any, target: Target, question: Question, place: Place) -> float:
        """`matched`, where any of several targets may do, or the problem itself decides."""
        if type(target) is dict and "such as" in target:
            decide(value, question, place)
            return NOTHING_MEASURED
        if type(target) is not dict or "any" not in target:
            return self.matched(value, target, question, place)
        misses = []
        for step, each in enumerate(target["any"]):
            try:
                return self.held(value, each, question, Place(place, step, ""))
            except Mismatch as why:
                misses.append(why)
        raise self.missed(value, target, misses, place)

    def missed(self, value: Any, target: Target, misses: list[Mismatch], place: Place) -> Mismatch:
        """What is told of a value that is none of several right ones: how far the nearest of them is off."""
        return min(misses, key=lambda why: inf if why.errors[0] is None else why.errors[0])

    def matched(self, value: Any, target: Target, question: Question, place: Place) -> float:
        """How many ulps the value is off at most, NOTHING_MEASURED if there is nothing; raises Mismatch."""
        raise NotImplementedError

    def fits(self, value: Any, target: Target, question: Question, place: Place) -> bool:
        """Whether `matched` raises nothing."""
        try:
            self.matched(value, target, question, place)
        except Mismatch:
            return False
        return True

    # -- lines of text -------------------------------------------------------------------------------

    def check_line(self, line: str, target: Target, exact: ExactOf) -> Outcome:
        """Decide one line of a program's output (without its newline, whatever it holds); see `check`."""
        answer = self.read_line(line)
        got = decode.shown(line)[1:-1]
        if isinstance(answer, str):
            return Rejection(answer, self.line(target), got)
        outcome = self.check(answer[0], target, exact)
        if isinstance(outcome, Accepted):
            return outcome
        # The answers are shown as programs write them.
        message = outcome.message.replace("None", "none")
        errors = outcome.where, outcome.absolute, outcome.relative, outcome.ulps
        return Rejection(message, self.line(target), got, *errors)

    def read_line(self, line: str) -> tuple[Raw] | str:
        """The answer that a line holds, in a tuple of one, or why it holds none."""
        try:
            return (self._taken(tokens_of(line)),)
        except Unreadable as why:
            return str(why)

    def _taken(self, words: list[str]) -> Raw:
        if not words:
            raise Unreadable(f"an empty line where {self.meant} is meant")
        if self.width == 1 and len(words) > 1:
            raise Unreadable(self._surplus(words[1]))
        tokens = Tokens(words, self.meant, self.lasting, whole=self.width == 1)
        raw = self.take(tokens)
        if tokens.left:
            raise Unreadable(self._surplus(tokens.next()))
        return raw

    @property
    def lasting(self) -> Type:
        """The type without a question mark."""
        return self

    def _surplus(self, word: str) -> str:
        return f"{decode.shown(word)} after the answer: one line holds {self.meant}"

    @property
    def meant(self) -> str:
        """What a line holds, in words."""
        return self.words.meant or self.hint(self.words)

    def hint(self, words: Words) -> str:
        """`meant`, as far as the type says it."""
        return words.answer or self.noun

    def take(self, tokens: Tokens) -> Raw:
        """The answer that the next tokens hold; raises Unreadable."""
        raise NotImplementedError

    def line(self, target: Target) -> str:
        """The line that a perfect program prints: correctly rounded doubles, as repr writes them."""
        return " ".join(self.printed(target))

    def printed(self, target: Target) -> Iterator[str]:
        """The tokens of `line`; of several answers the first."""
        return self.printed_one(first_of(target))

    def printed_one(self, target: Target) -> Iterator[str]:
        """`printed` of a single answer."""
        raise NotImplementedError

    # -- showing -------------------------------------------------------------------------------------

    def wanted(self, target: Target) -> str:
        """The wanted answer as a person would write it in Python, its numbers correctly rounded."""
        if type(target) is dict and "any" in target:
            answers = target["any"]
            shown = [self.wanted(each) for each in answers[:_ANSWERS]]
            return " or ".join(shown + ["…"] * (len(answers) > _ANSWERS))
        if type(target) is dict and "such as" in target:
            return f"such as {self.wanted(target['such as'])}"
        return self.wanted_one(target)

    def wanted_one(self, target: Target) -> str:
        """`wanted` of a single answer."""
        raise NotImplementedError

    def shown(self, raw: Raw) -> str:
        """An answer, as JSON or read, as a person would write it, bounded whatever its shape."""
        return decode.show(raw)

    def exact_text(self, exact: Exact) -> Any:
        """An exact answer as JSON: numbers that are not ints as decimal text of up to 40 digits."""
        if isinstance(exact, AnyOf):
            return {"any": [self.exact_text(each) for each in exact.answers]}
        if isinstance(exact, Judged):
            return {"such as": self.exact_text(exact.sample)}
        return self.exact_text_one(exact)

    def exact_text_one(self, exact: Exact) -> Any:
        """`exact_text` of a single answer."""
        return exact

    def accepted(self, target: Target) -> Any:
        """What is accepted, as JSON: for each real number the least and the greatest double."""
        if type(target) is not dict or "run" in target:
            return self.accepted_one(target)
        if "such as" in target:
            return {"such as": self.accepted(target["such as"])}
        return {"any": [self.accepted(each) for each in target["any"]]}

    def accepted_one(self, target: Target) -> Any:
        """`accepted` of a single answer."""
        return target

    def asserts(self, what: str, target: Target) -> Iterator[str]:
        """Python conditions on the expression `what`, all of which hold exactly for a right answer."""
        if type(target) is not dict or "run" in target:
            yield from self.asserts_one(what, target)
        elif "any" in target:  # of what the problem itself accepts, only the judge can say
            ways = [" and ".join(self.asserts(what, each)) for each in target["any"]]
            yield " or ".join(f"({way})" for way in ways)

    def asserts_one(self, what: str, target: Target) -> Iterator[str]:
        """`asserts` for a single answer."""
        raise NotImplementedError

    # -- telling one mistake from another ------------------------------------------------------------

    def outline(self, raw: Raw) -> Outline:
        """A wrong answer reduced to its form and its few numbers (`judge.values.outline`)."""
        from judge.values.outline import outline

        return outline(self, raw)

    def line_outline(self, line: str) -> Outline:
        """The outline of one line of a program's output."""
        answer = self.read_line(line)
        return (UNREADABLE, ()) if isinstance(answer, str) else self.outline(answer[0])

    def right(self, target: Target) -> Outline:
        """The outline of the right answer; of several the first."""
        from judge.values.outline import right

        return right(self, first_of(target))

    def kind(self, given: Outline, right: Outline, usual: Usual) -> str:
        """What kind of wrong answer one is, beside the right one and what is usual in the problem."""
        (form, numbers), (wanted_form, wanted) = given, right
        if form != wanted_form or len(numbers) != len(wanted):
            return form
        return "digits" if only_digits(numbers, wanted) else "elsewhere"

    def form(self, value: Any, *, target: bool = False) -> str:
        """The form of an answer that was read, or of a target, without its real numbers."""
        raise NotImplementedError

    def flat(self, value: Any, *, target: bool = False) -> Iterator[float]:
        """The numbers of an answer that was read, or of a target, as doubles."""
        raise NotImplementedError

    # -- of a problem --------------------------------------------------------------------------------

    def worded(self, words: Words) -> Self:
        """The same type with a problem's own words."""
        from copy import copy

        if words == self.words:
            return self
        other = copy(self)
        other.__dict__.pop("check", None)
        other.words = words
        return other
