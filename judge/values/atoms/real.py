"""`real`: a real number, an int or a float among others; `number` as a parameter."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any

from judge.values import numbers
from judge.values.decode import Fault, number, written_off
from judge.values.digits import cut_short
from judge.values.likeness import Outline, Usual, only_digits
from judge.values.lines import Tokens
from judge.values.outcome import COORDINATES, Mismatch, Place, Unfit, Unreadable
from judge.values.plain import integer_of, number_fault
from judge.values.tolerance import Tolerance
from judge.values.tree import Exact, Real
from judge.values.type import Draws, Number, Question, Quick, Raw, Target, Type

if TYPE_CHECKING:
    from judge.values.interval import Roots

_DIGITS = 40  # of an irrational number's decimal text, correctly rounded
_ROUNDED = 6  # decimals in a doctest


class RealType(Type):
    """A real number, held against five doubles; `least` bounds a parameter from below in any case."""

    measured = True
    noun = "a number"
    plural = "numbers"
    annotation = "float"  # for which an int is welcome
    rounded = f"round({{0}}, {_ROUNDED}) + 0.0"

    def __init__(self, *, least: int | None = None) -> None:
        self.text = "real"
        self.least = least

    def aimed(self, exact: Exact, tolerance: Tolerance, roots: Roots) -> Target:
        """The five doubles."""
        from judge.exact import Surd
        from judge.values.interval import measure

        if type(exact) is not Real:
            raise Unfit(f"{exact!r} where a Real is meant")
        if isinstance(exact.x, float) or isinstance(exact.unit, float):  # rounded already, most likely
            raise Unfit(f"{exact!r} holds a float; write Fraction(x) where a double is the exact number")
        return tuple(measure(Surd.of(exact.x), tolerance, Surd.of(exact.unit), roots))

    @cached_property
    def quick(self) -> Quick:
        """Two comparisons, and the error."""

        def quick(raw: Raw, target: Target) -> float | None:
            if type(raw) is not float:
                return written_off(raw, target)
            lo, hi, nearest, residual, unit = target
            if not lo <= raw <= hi:
                return None
            return abs((raw - nearest) / unit - residual) if nearest else 0.0

        return quick

    def read(self, raw: Raw, question: Question, place: Place) -> Any:
        """An int, a float, a Fraction or a Written."""
        given = number(raw)
        if not isinstance(given, Fault):
            return given
        noun = self.noun + (" or None" if question.optional and place.parent is None else "")
        is_point = place.word in COORDINATES and given.type.startswith("complex")
        remedy = "return a point as (x, y)" if is_point else ""
        raise Unreadable(given.where(f"{place.name() or noun} is meant", remedy))

    def matched(self, value: Any, target: Target, question: Question, place: Place) -> float:
        """Its error in ulps."""
        if numbers.accepts(value, target, lambda: question.exact_at(place)):
            return numbers.ulps_off(value, target)
        errors = numbers.errors(value, target)
        where = place.name(short=True) or question.words.answer or "the answer"
        how = cut_short(value, numbers.exactly(target))
        message = numbers.off(place.told() or where, errors) + (how and f"; {how}")
        raise Mismatch(message, where, errors)

    def fits(self, value: Any, target: Target, question: Question, place: Place) -> bool:
        """Whether it lies in the interval."""
        return numbers.accepts(value, target, lambda: question.exact_at(place))

    def take(self, tokens: Tokens) -> Raw:
        """A decimal."""
        return tokens.number(tokens.meant if tokens.whole else self.noun)

    def printed_one(self, target: Target) -> Iterator[str]:
        """The nearest double."""
        yield repr(target[2])

    def wanted_one(self, target: Target) -> str:
        """The nearest double."""
        return repr(target[2])

    def exact_text_one(self, exact: Exact) -> Any:
        """Decimal text."""
        from judge.exact import Surd

        return Surd.of(exact.x).decimal(_DIGITS)

    def accepted_one(self, target: Target) -> Any:
        """The ends."""
        return list(target[:2])

    def asserts_one(self, what: str, target: Target) -> Iterator[str]:
        """Between the ends."""
        yield f"{target[0]!r} <= {what} <= {target[1]!r}"

    def form(self, value: Any, *, target: bool = False) -> str:
        """All numbers are alike."""
        return "number"

    def flat(self, value: Any, *, target: bool = False) -> Iterator[float]:
        """The double next to it."""
        yield value[2] if target else numbers.double(value)

    def kind(self, given: Outline, right: Outline, usual: Usual) -> str:
        """A number where there is none, one of other digits, a negative one, a smaller or a larger one."""
        (form, numbers), (_, wanted) = given, right
        if form == "type float":  # inf or nan
            return "sentinel"
        if form != "number":
            return form
        (t,) = numbers
        if not wanted:
            return "invented" if math.isfinite(t) and (t >= 0.0 or usual.negative) else "sentinel"
        if not math.isfinite(t):
            return "sentinel"
        if only_digits(numbers, wanted):
            return "digits"
        if t < 0.0 and not usual.negative:
            return "negative"
        return "less" if t < wanted[0] else "more"

    # -- values of parameters ------------------------------------------------------------------------

    def fault(self, name: str, value: Any) -> str | None:
        """Exactly an int or a float: a bool would not come back from the cache as it went in."""
        if type(value) is not float:
            return number_fault(name, value)
        return None if math.isfinite(value) else f"{name} has {value!r}, which is not finite"

    def outside(self, value: Any, low: Fraction | int, high: Fraction | int) -> tuple[Any, Any, Any] | None:
        """Its own bound counts too."""
        if self.least is not None and low < self.least:
            low = self.least
        return None if low <= value <= high else (value, low, high)

    def reals(self, value: Any) -> Iterator[Number]:
        """Itself."""
        yield value

    def tokens(self, value: Any) -> Iterator[str]:
        """As `repr` writes it."""
        yield repr(value)

    def from_tokens(self, tokens: Iterator[str]) -> Any:
        """An int, or else a float."""
        token = next(tokens)
        whole = integer_of(token)
        return float_of(token) if whole is None else whole

    def round(self, value: Any) -> Any:
        """To a few decimals."""
        return round(value, _ROUNDED) + 0.0

    def simple(self, draw: Draws, number: Callable[[bool], Number], *, positive: bool) -> Any:
        """The next simple number."""
        return number(positive or (self.least is not None and self.least >= 0))


def float_of(token: str) -> float:
    """The float that `repr` wrote; raises ValueError for any other text."""
    from judge.values.plain import FLOAT

    if not FLOAT.fullmatch(token):
        raise ValueError(f"no number: {token[:40]!r}")
    return float(token)


TYPE = RealType
