"""`enclosure`: two numbers (lo, hi) that must hold the exact one between them, and not be too far apart.

The target is (down, up, nearest, "n/d"): the doubles on both sides of the exact number, equal where it is
one, the nearest double, and the greatest width as a ratio.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import cached_property
from math import inf, nextafter
from typing import TYPE_CHECKING, Any

from judge.values.decode import Fault, Given, Written, fault, items, near, number
from judge.values.lines import Tokens
from judge.values.numbers import double
from judge.values.outcome import Mismatch, Place, Unfit, Unreadable, Words
from judge.values.plain import number_fault
from judge.values.tolerance import Tolerance
from judge.values.tree import Enclosure, Exact
from judge.values.type import NOTHING_MEASURED, Question, Quick, Raw, Target, Type

if TYPE_CHECKING:
    from judge.values.interval import Roots

_DIGITS = 40


class EnclosureType(Type):
    """A pair of numbers around the exact one; answers only."""

    noun = "(lo, hi)"
    plural = "enclosures"
    is_parameter = False
    settled = False
    width = 2
    depth = 1
    most = 2
    annotation = "tuple[float, float]"

    def __init__(self) -> None:
        self.text = "enclosure"

    def aimed(self, exact: Exact, tolerance: Tolerance, roots: Roots) -> Target:
        """The doubles around it, and the width."""
        from judge.exact import Surd

        if type(exact) is not Enclosure:
            raise Unfit(f"{exact!r} where an Enclosure is meant")
        if exact.width < 0:
            raise Unfit("no interval has a negative width")
        x, width = Surd.of(exact.x), Fraction(exact.width)
        down, up = x.round_down(), x.round_up()
        if not (abs(down) < inf and abs(up) < inf):
            raise Unfit("the number is beyond all doubles")
        return down, up, float(x), f"{width.numerator}/{width.denominator}"

    @cached_property
    def quick(self) -> Quick:
        """Doubles, by exact arithmetic on them."""

        def quick(raw: Raw, target: Target) -> float | None:
            if type(raw) is not list or len(raw) != 2 or type(target) is dict:
                return None
            low, high = raw
            if type(low) is not float or type(high) is not float:
                return None
            down, up, _, width = target
            held = low <= down and high >= up and Fraction(high) - Fraction(low) <= Fraction(width)
            return NOTHING_MEASURED if held else None

        return quick

    def read(self, raw: Raw, question: Question, place: Place) -> Any:
        """A pair of numbers."""
        found = items(raw)
        name = place.name()
        meant = f"{name} is meant to be (lo, hi)" if name else "(lo, hi) is meant"
        if found is None:
            raise Unreadable(fault(raw).where(meant))
        if len(found) != 2:
            raise Unreadable(f"{len(found)} numbers where {meant}")
        return tuple([_end(each, end, name) for each, end in zip(found, ("lo", "hi"), strict=True)])

    def matched(self, value: Any, target: Target, question: Question, place: Place) -> float:
        """Whether it holds the number, and is narrow enough."""
        low, high = (given.exact() if isinstance(given, Written) else Fraction(given) for given in value)
        down, up, nearest, width = target
        if low > high:
            raise Mismatch(f"{place.prefix()}lo is above hi", place.name())
        # Between the doubles around it, the exact number itself decides.
        if low > down and (low >= up or _order(question, place, low) < 0):
            raise Mismatch(f"{place.prefix()}lo is above the exact number, {nearest!r}", place.name())
        if high < up and (high <= down or _order(question, place, high) > 0):
            raise Mismatch(f"{place.prefix()}hi is below the exact number, {nearest!r}", place.name())
        if high - low > Fraction(width):
            wide, most = near(high - low), near(Fraction(width))
            raise Mismatch(f"{place.prefix()}it is {wide:.3g} wide, {most:.3g} is allowed", place.name())
        return NOTHING_MEASURED

    def take(self, tokens: Tokens) -> Raw:
        """Two decimals."""
        return [tokens.number("lo"), tokens.number("hi")]

    def hint(self, words: Words) -> str:
        """Both ends."""
        return "lo hi"

    def printed_one(self, target: Target) -> Iterator[str]:
        """The doubles around it; a text that is rounded inwards would be another number, so the next ones."""
        down, up = target[:2]
        yield repr(down if Fraction(repr(down)) <= down else nextafter(down, -inf))
        yield repr(up if Fraction(repr(up)) >= up else nextafter(up, inf))

    def wanted_one(self, target: Target) -> str:
        """The number, and how wide the interval may be."""
        return f"an interval around {target[2]!r} at most {near(Fraction(target[3])):.3g} wide"

    def exact_text_one(self, exact: Exact) -> Any:
        """The number and the width."""
        from judge.exact import Surd

        return {"enclosed": Surd.of(exact.x).decimal(_DIGITS), "width": str(Fraction(exact.width))}

    def accepted_one(self, target: Target) -> Any:
        """The greatest lo, the least hi, the greatest width."""
        return {"lo": target[0], "hi": target[1], "width": target[3]}

    def asserts_one(self, what: str, target: Target) -> Iterator[str]:
        """Both ends and the width, exactly."""
        down, up, _, width = target
        top, bottom = width.split("/")
        yield f"{what}[0] <= {down!r}"
        yield f"{up!r} <= {what}[1]"
        yield f"(Fraction({what}[1]) - Fraction({what}[0])) * {bottom} <= {top}"

    def fault(self, name: str, value: Any) -> str | None:
        """Two numbers, as an example in a statement gives them."""
        if type(value) is not tuple or len(value) != 2:
            return f"{name} must be (lo, hi), not {value!r}"
        return next((number_fault(name, each) for each in value if type(each) is not float), None)

    def form(self, value: Any, *, target: bool = False) -> str:
        """Two numbers."""
        return "enclosure"

    def flat(self, value: Any, *, target: bool = False) -> Iterator[float]:
        """Both ends."""
        return iter(value[:2]) if target else map(double, value)


def _order(question: Question, place: Place, end: Fraction) -> int:
    """The sign of the exact number less `end`."""
    from judge.exact import Surd

    exact, _ = question.exact_at(place)
    return Surd.of(exact.x).compare(end)


def _end(raw: Raw, end: str, name: str) -> Given:
    given = number(raw)
    if isinstance(given, Fault):
        raise Unreadable(given.where(f"{end}{f' of {name}' if name else ''} is meant"))
    return given


TYPE = EnclosureType
