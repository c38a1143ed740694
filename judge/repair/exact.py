"""Numbers without rounding, as a program meets them: each knows how many of its digits it has lost.

In a case that is decided exactly a difference cancels to nothing; otherwise much more than its last digits is
left: what has lost nearly all of its digits is therefore 0. This file is handed to the contained process:
standard library only, and no import of judge but of what stands beside it.
"""

from __future__ import annotations

import builtins
import decimal
import math
from decimal import Decimal
from functools import total_ordering

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from types import ModuleType
    from typing import Any

_SPARE = 8  # digits at the end that count for nothing
_BOTTOM = -(10**7)
_DOUBLE = 16  # digits that a function has which is not computed here
_FOREIGN = ("numpy", "fractions", "decimal", "cmath", "ctypes", "struct", "array")  # other numbers
_ROUGH = ("sin", "cos", "tan", "asin", "acos", "atan", "atan2", "exp", "log", "degrees", "radians")


class Foreign(Exception):  # noqa: N818 - of the program, which has numbers of its own
    """It cannot be run without rounding."""


@total_ordering
class Long:
    """A number of many digits; `lost` of them are gone."""

    __slots__ = ("lost", "v")

    def __init__(self, v: Decimal, lost: int = 0) -> None:
        self.v, self.lost = v, lost

    def __add__(self, other: Any) -> Any:
        right = _read(other)
        if right is None:
            return NotImplemented
        total = self.v + right.v
        if not total or not total.is_finite():
            return Long(total)
        top = max(each.v.adjusted() + each.lost if each.v else _BOTTOM for each in (self, right))
        lost = max(0, top - total.adjusted())
        return Long(total, lost) if lost <= decimal.getcontext().prec - _SPARE else Long(Decimal(0))

    __radd__ = __add__

    def __sub__(self, other: Any) -> Any:
        right = _read(other)
        return NotImplemented if right is None else self + -right

    def __rsub__(self, other: Any) -> Any:
        return -self + other

    def __mul__(self, other: Any) -> Any:
        right = _read(other)
        return NotImplemented if right is None else Long(self.v * right.v, max(self.lost, right.lost))

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Any:
        right = _read(other)
        if right is None:
            return NotImplemented
        if not right.v:
            raise ZeroDivisionError("division by zero")
        return Long(self.v / right.v, max(self.lost, right.lost))

    def __rtruediv__(self, other: Any) -> Any:
        left = _read(other)
        return NotImplemented if left is None else left / self

    def __floordiv__(self, other: Any) -> Any:
        return Long(Decimal(math.floor((self / other).v)))

    def __rfloordiv__(self, other: Any) -> Any:
        return long(other) // self

    def __mod__(self, other: Any) -> Any:
        return self - self // other * other

    def __rmod__(self, other: Any) -> Any:
        return long(other) % self

    def __divmod__(self, other: Any) -> Any:
        return self // other, self % other

    def __pow__(self, other: Any) -> Any:
        power = long(other).v
        if power == 2:
            return self * self
        if power == Decimal("0.5"):
            return sqrt(self)
        return Long(self.v**power, self.lost)

    def __rpow__(self, other: Any) -> Any:
        return long(other) ** self

    def __neg__(self) -> Long:
        return Long(-self.v, self.lost)

    def __pos__(self) -> Long:
        return self

    def __abs__(self) -> Long:
        return Long(abs(self.v), self.lost)

    def __bool__(self) -> bool:
        return bool(self.v)

    def __hash__(self) -> int:
        return hash(self.v)

    def __float__(self) -> float:
        return float(self.v)

    def __int__(self) -> int:
        return int(self.v)

    __trunc__ = __int__

    def __index__(self) -> int:
        if self.v != int(self.v):
            raise TypeError("not a whole number")
        return int(self.v)

    def __floor__(self) -> int:
        return math.floor(self.v)

    def __ceil__(self) -> int:
        return math.ceil(self.v)

    def __round__(self, digits: int | None = None) -> Any:
        return round(self.v) if digits is None else Long(round(self.v, digits))

    def _beyond(self, other: Any) -> Any:
        """By how much it is above the other one; None where that is no number."""
        right = _read(other)
        if right is None:
            return None
        return (self + -right).v if self.v.is_finite() and right.v.is_finite() else self.v.compare(right.v)

    def __eq__(self, other: object) -> Any:
        found = self._beyond(other)
        return NotImplemented if found is None else not found

    def __lt__(self, other: Any) -> Any:
        found = self._beyond(other)
        return NotImplemented if found is None else found < 0

    def is_integer(self) -> bool:
        """As a float has it."""
        return bool(self.v == self.v.to_integral_value())


def _read(value: Any) -> Long | None:
    if type(value) is Long:
        return value
    return Long(Decimal(value)) if isinstance(value, int | float) else None


def long(value: Any) -> Long:
    """The number; TypeError where it is none."""
    found = _read(value)
    if found is None:
        raise TypeError("not a number")
    return found


def sqrt(value: Any) -> Long:
    """The root; ValueError as `math.sqrt` raises it."""
    x = long(value)
    if x.v < 0:
        raise ValueError("math domain error")
    return Long(x.v.sqrt(), x.lost)


def hypot(*sides: Any) -> Long:
    """The root of the sum of the squares."""
    return sqrt(builtins.sum((long(side) * long(side) for side in sides), Long(Decimal(0))))


def _rough(function: Callable[..., float]) -> Callable[..., Long]:
    def called(*given: Any) -> Long:
        lost = decimal.getcontext().prec - _DOUBLE
        return Long(Decimal(function(*map(float, given))), lost)

    return called


def mathematics(factor: Decimal) -> ModuleType:
    """The module `math` of such numbers; `factor` shrinks the tolerance that `isclose` has by itself."""

    def isclose(a: Any, b: Any, *, rel_tol: Any = None, abs_tol: Any = 0) -> bool:
        share = Long(factor * Decimal("1e-9")) if rel_tol is None else rel_tol
        a, b = long(a), long(b)
        return bool(abs(a - b) <= max(share * max(abs(a), abs(b)), long(abs_tol)))

    made = type(math)("math")
    vars(made).update(vars(math))
    vars(made).update((name, _rough(getattr(math, name))) for name in _ROUGH)
    vars(made).update(
        sqrt=sqrt,
        hypot=hypot,
        fabs=abs,
        isclose=isclose,
        isqrt=lambda x: math.isqrt(int(x)),
        dist=lambda p, q: hypot(*(long(a) - b for a, b in zip(p, q, strict=True))),
        copysign=lambda a, b: abs(long(a)) if long(b).v >= 0 else -abs(long(a)),
        pow=lambda a, b: long(a) ** b,
        fsum=lambda some: builtins.sum(some, Long(Decimal(0))),
        prod=lambda some: math.prod(map(long, some), start=Long(Decimal(1))),
        isfinite=lambda x: long(x).v.is_finite(),
        isinf=lambda x: long(x).v.is_infinite(),
        isnan=lambda x: long(x).v.is_nan(),
    )
    return made


class _Kind(type):
    """Of the class `float`: every such number is one."""

    def __instancecheck__(cls, value: Any) -> bool:
        return isinstance(value, Long | builtins.float)


class _Float(metaclass=_Kind):
    def __new__(cls, value: Any = 0.0) -> Any:
        return value if type(value) is Long else Long(Decimal(builtins.float(value)))


class _Whole(type):
    """Of the class `int`: who asks whether a number is one has another way for those that are."""

    def __instancecheck__(cls, value: Any) -> bool:
        if type(value) is Long:
            raise Foreign("int")
        return isinstance(value, builtins.int)


class _Int(metaclass=_Whole):
    def __new__(cls, *given: Any) -> Any:
        return builtins.int(*given)


_CLASSES = {builtins.float: _Float, builtins.int: _Int}


def names(factor: str) -> dict[str, Any]:
    """The built-in names of a program that is run so; its tolerances are to be multiplied by `_FACTOR`."""
    numbers = mathematics(Decimal(factor))

    def load(name: str, *given: Any) -> Any:
        if name.partition(".")[0] in _FOREIGN:
            raise Foreign(name)
        return numbers if name == "math" else __import__(name, *given)

    own = {kind.__name__: each for kind, each in _CLASSES.items()}
    return {**vars(builtins), **own, "__import__": load, "_FACTOR": Long(Decimal(factor))}


def context(digits: int) -> decimal.Context:
    """The context to run it in."""
    traps = [decimal.InvalidOperation, decimal.DivisionByZero, decimal.Overflow]
    return decimal.Context(prec=digits, Emax=10**8, Emin=-(10**8), traps=traps)


def lifted(value: Any) -> Any:
    """An argument with such numbers in it."""
    if isinstance(value, list | tuple):
        return type(value)(map(lifted, value))
    return value if value is None or isinstance(value, str | bool) else long(value)


def raised(value: Any, numbers: Any) -> Any:
    """The same of whatever a name stands for; the functions of `math` are those of `numbers`."""
    if value is math:
        return numbers
    if isinstance(value, type) and value in _CLASSES:
        return _CLASSES[value]
    if type(value) in (list, tuple):
        return type(value)(raised(each, numbers) for each in value)
    if type(value) in (int, float):
        return long(value)
    return getattr(numbers, value.__name__) if getattr(value, "__module__", "") == "math" else value


def lowered(value: Any, whole: bool) -> Any:
    """An answer with usual numbers in it, ints where it is `whole`."""
    if type(value) is Long:
        return int(value.v) if whole and value.is_integer() else float(value.v)
    return type(value)(lowered(each, whole) for each in value) if type(value) in (list, tuple) else value
