"""What is drawn of a case: circles, ways, points and vectors as decimals, in the caller's units.

`judge.geometry.views` makes a `View` for each signature. Decimals have as many digits as the case needs:
`precision` says how many.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from decimal import Decimal, getcontext
from fractions import Fraction
from typing import Any

from judge.drawing.shapes import Role
from judge.exact.surd import Surd, integers
from judge.geometry.quadratic import TANGENT
from judge.geometry.sure import DecisionWords
from judge.values.answers import AnyOf, Real
from judge.values.wire import Refusal, exactly, number, word

Place = tuple[Decimal, Decimal]
Plain = Any  # of an answer: None, a word, a Decimal, or a list of those

_MOST, _MOST_INSIDE = 256, 8  # elements of a submission's list that are read, and of a list inside it
_DEPTH = 3  # lists in lists


@dataclass(frozen=True, slots=True)
class Ring:
    """A circle; only a SHAPE is filled and decides anything."""

    x: Decimal
    y: Decimal
    r: Decimal
    role: Role = Role.SHAPE
    decides: DecisionWords | None = TANGENT


@dataclass(frozen=True, slots=True)
class Way:
    """The points P + t·D with t from low to high, None being no end; it is drawn faintly `beyond` them.

    `beside` is how far to the left of itself it is drawn, in panels.
    """

    start: Place
    along: Place
    low: int | None = 0
    high: int | None = 1
    role: Role = Role.LINE
    arrow: bool = True
    beyond: bool = False
    decides: bool = False
    beside: float = 0.0

    def at(self, t: Decimal | int) -> Place:
        """The point P + t·D."""
        return self.start[0] + t * self.along[0], self.start[1] + t * self.along[1]


@dataclass(frozen=True, slots=True)
class NamedPoint:
    """A point with its name; `decides` says what it is where it may be on a circle."""

    at: Place
    text: str
    role: Role = Role.CASE
    decides: DecisionWords | None = None


@dataclass(frozen=True, slots=True)
class Contact:
    """A place where something decides by the length `gap`, 0 where it is exact."""

    gap: Decimal
    at: Place
    words: DecisionWords
    along: Place | None = None  # of the line that touches there, and the circle's radius
    r: Decimal = Decimal(0)


@dataclass(slots=True)
class View:
    """All that is drawn of a case, and the size e of the case; `about` is what of a sequence is shown."""

    rings: list[Ring] = field(default_factory=list)
    ways: list[Way] = field(default_factory=list)
    spots: list[NamedPoint] = field(default_factory=list)
    contacts: list[Contact] = field(default_factory=list)
    size: Decimal = Decimal(0)
    about: str = ""
    frame: list[list[Decimal]] = field(default_factory=list)  # in space: the two directions of the plane

    def measure(self, middle: Place, points: Sequence[Place], *lengths: Decimal) -> None:
        """Set e to the largest of the lengths and of the points' distances in x and in y."""
        spans = [abs(p - q) for at in points for p, q in zip(at, middle, strict=True)]
        self.size = max([*lengths, *spans], default=Decimal(0))

    def name(
        self, at: Place, text: str, role: Role = Role.CASE, decides: DecisionWords | None = None
    ) -> None:
        """Add a point."""
        self.spots.append(NamedPoint(at, text, role, decides))

    def arrow(self, start: Place, tip: Place, role: Role, text: str = "") -> None:
        """Add a vector of an answer."""
        self.ways.append(Way(start, minus(tip, start), role=role))
        self.name(tip, text or role.said, role)


def precision(values: Sequence[Any]) -> int:
    """Digits that tell the lengths of such a case apart: products of four of its integers have fewer."""
    whole, shift = integers(*_flat(values))
    bits = max((abs(each).bit_length() for each in whole), default=1)
    return 60 + int(1.3 * max(bits, abs(shift)))


def _flat(value: Any) -> Iterator[Any]:
    for each in value:
        if isinstance(each, list | tuple):
            yield from _flat(each)
        elif isinstance(each, int | float):
            yield each


def decimal(value: Any) -> Decimal:
    """A number to the current precision."""
    if isinstance(value, Surd):
        return (decimal(value.p) + decimal(value.q) * decimal(value.d).sqrt()) / decimal(value.s)
    if isinstance(value, Fraction):
        return Decimal(value.numerator) / Decimal(value.denominator)
    return Decimal(value)


# -- plane vectors -----------------------------------------------------------------------------------------


def minus(p: Place, q: Place) -> Place:
    """p − q."""
    return p[0] - q[0], p[1] - q[1]


def dot(p: Sequence[Decimal], q: Sequence[Decimal]) -> Decimal:
    """p·q, in the plane or in space."""
    return sum((x * y for x, y in zip(p, q, strict=True)), Decimal(0))


def cross(p: Place, q: Place) -> Decimal:
    """p × q."""
    return p[0] * q[1] - p[1] * q[0]


def length(p: Sequence[Decimal]) -> Decimal:
    """|p|."""
    return dot(p, p).sqrt()


def step(start: Place, way: Place, by: Decimal) -> Place:
    """The point as far from start as `by` says, in the direction of way."""
    share = by / (length(way) or 1)
    return start[0] + share * way[0], start[1] + share * way[1]


def tiny() -> Decimal:
    """What a length of 1 is taken for 0 below, at the current precision."""
    return Decimal(10) ** (20 - getcontext().prec)


def met(way: Way, ring: Ring) -> list[Decimal]:
    """The parameters at which the whole line meets the circle."""
    f = minus(way.start, (ring.x, ring.y))
    a, b = dot(way.along, way.along), dot(f, way.along)
    delta = ring.r * ring.r * a - cross(way.along, f) ** 2
    if abs(delta) <= a * ring.r * ring.r * tiny():
        return [-b / a]
    if delta < 0:
        return []
    root = delta.sqrt()
    return [(-b - root) / a, (-b + root) / a]


def foot_of(view: View) -> Place | None:
    """The point of the first way that is next to the first named point."""
    if not view.ways:
        return None
    way, P = view.ways[0], view.spots[0].at
    return way.at(dot(minus(P, way.start), way.along) / dot(way.along, way.along))


# -- answers -----------------------------------------------------------------------------------------------


def wanted(exact: Any) -> Plain:
    """The exact answer in decimals; of several the first."""
    if isinstance(exact, Real):
        return decimal(exact.x)
    if isinstance(exact, AnyOf):
        return wanted(exact.answers[0])
    if isinstance(exact, list | tuple):
        return list(map(wanted, exact))
    if isinstance(exact, int | float | Fraction | Surd):
        return decimal(exact)
    return exact if isinstance(exact, str) else None


def given(raw: Any, depth: int = _DEPTH) -> Plain:
    """A submission's answer in decimals, JSON of any shape whatever: only the beginning of long lists."""
    if type(raw) in (list, tuple):
        most = _MOST if depth == _DEPTH else _MOST_INSIDE
        return [given(each, depth - 1) for each in raw[:most]] if depth else []
    said = word(raw)
    if said and said.isprintable():
        return said
    read = number(raw)
    if isinstance(read, Refusal):
        return None
    return decimal(exactly(read))


def points(plain: Plain) -> list[Place]:
    """Every two numbers that are a list of their own."""
    if not isinstance(plain, list):
        return []
    pair = numbers(plain, 2)
    return [(pair[0], pair[1])] if pair else [point for each in plain for point in points(each)]


def numbers(plain: Plain, many: int) -> list[Decimal] | None:
    """So many numbers in a list; None for anything else."""
    fits = isinstance(plain, list) and len(plain) == many
    return plain if fits and all(isinstance(each, Decimal) for each in plain) else None


def text(value: Plain) -> str:
    """A part of an answer in few digits."""
    return f"{value:.6g}" if isinstance(value, Decimal) else str(value)
