"""Simpler cases like a failing one: about the origin, laid level, with fewer digits or corners.

Nothing here need be right: a candidate counts only if it is valid and the submission fails on it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from decimal import Context, Decimal, localcontext
from functools import partial
from itertools import permutations
from typing import Any, NamedTuple

from judge.geometry.replaced import replaced
from judge.problem import Case, Problem
from judge.values.atoms import Number

_DIGITS = 60  # of the roots taken here: whatever a double holds, and the narrowest gaps
_FINEST = 16  # digits that are kept at most
_ZERO = Decimal(0)

Pair = tuple[Decimal, Decimal]

_LINES = ("line", "points", "segment", "count in a segment", "chord", "seven")
_RAYS = ("ray", "normal", "reflection")
# Of each kind what may become the x axis: two of its points by their places, or its vector "v".
_AXES: dict[str, tuple[str, ...]] = {
    **dict.fromkeys((*_LINES, "polygon"), ("12",)),
    **dict.fromkeys((*_RAYS, "hits", "spans", "light", "frames"), ("v",)),
    **dict.fromkeys(("point", "tangents", "diameter", "side", "foot", "pair", "common tangents"), ("01",)),
    "balls": ("01", "23"),
    "wall": ("23", "01"),
}
# Of its points the one that becomes the origin, where that is not the first.
_ORIGINS = {"hits": -1, "spans": -1, "frames": -1, "light": -2, "balls": 2, "wall": 2}


def simpler(kind: str, problem: Problem, case: Case) -> Iterator[Case]:
    """Cases that are simpler as a whole."""
    if kind == "sphere":
        yield from _spheres(case)
        return
    if kind not in _AXES:
        return
    yield from _fewer(kind, case)
    floats = any(isinstance(each, float) for each in _numbers(case))
    with localcontext(Context(prec=_DIGITS)):
        read = _read(problem, case)
        for axis in (*_AXES[kind], None):
            laid = _laid(read, _ORIGINS.get(kind, 0), axis)
            if laid is None:
                continue
            variants = [laid]
            if kind == "frames":
                variants.insert(0, _above(laid))
            if kind == "balls":
                variants.insert(0, _one_moves(laid))
            if kind in (*_LINES, *_RAYS) and axis:
                variants.append(_across_the_centre(laid))
            for variant in variants:
                yield from _rounded(variant, partial(_built, problem, case), floats)


def _numbers(value: Any) -> Iterator[Any]:
    if isinstance(value, tuple):
        for each in value:
            yield from _numbers(each)
    else:
        yield value


def _fewer(kind: str, case: Case) -> Iterator[Case]:
    """Half of the corners, and each left out."""
    if kind == "polygon" and len(case[3]) > 3:
        cx, cy, r, V = case
        half = len(V) // 2
        kept = [V[:half], V[half:], V[::2], *(V[:at] + V[at + 1 :] for at in range(len(V)))]
        yield from ((cx, cy, r, each) for each in kept if len(each) >= 3)


# -- a case laid out ---------------------------------------------------------------------------------------


class _Laid(NamedTuple):
    """The points, the vectors and the lengths of a case, in their order."""

    points: list[Pair]
    vectors: list[Pair]
    lengths: list[Decimal]


def _read(problem: Problem, case: Case) -> _Laid:
    found = _Laid([], [], [])

    def change(role: str, _name: str, numbers: tuple[Any, ...]) -> tuple[Any, ...]:
        x, *y = map(Decimal, numbers)
        if role == "length":
            found.lengths.append(x)
        else:
            (found.vectors if role == "way" else found.points).append((x, *y))  # type: ignore[arg-type]
        return numbers

    replaced(problem, case, change)
    return found


def _laid(read: _Laid, origin: int, axis: str | None) -> _Laid | None:
    """The case seen from that point, along the axis and to its left; None where the axis has no length."""
    ox, oy = read.points[origin]
    u, v = Decimal(1), _ZERO
    if axis == "v":
        u, v = read.vectors[0]
    elif axis:
        (ax, ay), (bx, by) = read.points[int(axis[0])], read.points[int(axis[1])]
        u, v = bx - ax, by - ay
    size = (u * u + v * v).sqrt()
    if not size:
        return None
    seen = [(x - ox, y - oy) for x, y in read.points]
    points, vectors = (
        [((x * u + y * v) / size, (u * y - v * x) / size) for x, y in each] for each in (seen, read.vectors)
    )
    return _Laid(points, vectors, read.lengths)


def _above(laid: _Laid) -> _Laid:
    """Circles straight above the line: their distances are all that counts."""
    return laid._replace(points=[(_ZERO, abs(y)) for _, y in laid.points])


def _one_moves(laid: _Laid) -> _Laid:
    """One disc of both radii moves, and the other is a point that rests."""
    p0, p1, q0, q1 = laid.points
    end = p1[0] - q1[0] + q0[0], p1[1] - q1[1] + q0[1]
    return laid._replace(points=[p0, end, q0, q0], lengths=[sum(laid.lengths, _ZERO), _ZERO])


def _across_the_centre(laid: _Laid) -> _Laid:
    """The line through the centre, its ends as far from the nearest root as they were."""
    r, (_, height) = laid.lengths[0], laid.points[1]
    square = r * r - height * height
    half = square.sqrt() if square > 0 else _ZERO
    ends = [(x - half + r if x > 0 else x + half - r, _ZERO) for x, _ in laid.points[1:]]
    return laid._replace(points=[laid.points[0], *ends])


# -- fewer digits ------------------------------------------------------------------------------------------


def _rounded(laid: _Laid, build: Callable[..., Case], floats: bool) -> Iterator[Case]:
    """Cases of few digits like this one: of each number, of all alike, and in integers."""
    size = max([abs(x) for pair in (*laid.points, *laid.vectors) for x in pair] + laid.lengths)
    if not size:
        return
    flipped = laid._replace(points=[(x, -y) for x, y in laid.points])
    for kept in range(1, _FINEST + 1):
        few = partial(_few, digits=kept)
        yield build(laid, few, few, floats)
        yield build(flipped, few, few, floats)
        fine = partial(_quantized, unit=_power(size.adjusted() + 1 - kept))
        for coarse in {1, kept}:
            rough = partial(_quantized, unit=_power(size.adjusted() + 1 - coarse))
            yield build(laid, rough, fine, floats)
        if laid.lengths and laid.lengths[0] and size / laid.lengths[0] < 10**9:
            scale = _power(kept) / laid.lengths[0]
            for digits in (_DIGITS, 1):
                along = partial(_whole, scale=scale, digits=digits)
                yield build(laid, along, partial(_whole, scale=scale), False)


def _quantized(value: Decimal, unit: Decimal) -> Decimal:
    return value.quantize(unit)


def _whole(value: Decimal, scale: Decimal, digits: int = _DIGITS) -> Decimal:
    return _few((value * scale).quantize(Decimal(1)), digits)


def _built(
    problem: Problem,
    case: Case,
    laid: _Laid,
    along: Callable[[Decimal], Decimal],
    across: Callable[[Decimal], Decimal],
    floats: bool,
) -> Case:
    """The case with each number rounded; those along the axis are told apart."""

    def plain(value: Decimal) -> Number:
        return float(value) if floats and value else int(value.to_integral_value())

    places, ways = ([(plain(along(x)), plain(across(y))) for x, y in each] for each in laid[:2])
    parts = {"way": iter(ways), "length": iter([(plain(across(each)),) for each in laid.lengths])}
    points = iter(places)
    return replaced(problem, case, lambda role, *_: next(parts.get(role, points))) or case


def _few(value: Decimal, digits: int) -> Decimal:
    return value.quantize(_power(value.adjusted() + 1 - digits)) if value else value


def _power(exponent: int) -> Decimal:
    """10^exponent, of a single digit: what `quantize` needs, and `**` does not give."""
    return Decimal((0, (1,), exponent))


# -- space -------------------------------------------------------------------------------------------------


def _spheres(case: Case) -> Iterator[Case]:
    """About the origin, in fewer axes, the axes in another order, with signs for a direction."""
    centre, r, origin, direction = case
    signs = tuple((x > 0) - (x < 0) for x in direction)
    floats = any(isinstance(each, float) for each in _numbers(case))
    near = tuple(x - y for x, y in zip(origin, centre, strict=True))
    yield from (((0, 0, 0), r, near, direction), ((0, 0, 0), r, near, signs), (centre, r, origin, signs))
    for axis in range(3):
        yield tuple(_without(each, axis) if isinstance(each, tuple) else each for each in case)
    for order in permutations(range(3)):
        yield tuple(tuple(each[at] for at in order) if isinstance(each, tuple) else each for each in case)
    with localcontext(Context(prec=_DIGITS)):
        for kept in (1, 2, 3, 6):
            yield tuple(
                tuple(_short(x, kept, floats) for x in each)
                if isinstance(each, tuple)
                else _short(each, kept, floats)
                for each in case
            )


def _without(point: tuple[Number, ...], axis: int) -> tuple[Number, ...]:
    return (*point[:axis], 0, *point[axis + 1 :])


def _short(value: Number, digits: int, floats: bool) -> Number:
    short = _few(Decimal(value), digits)
    return (
        float(short)
        if floats and short
        else int(short)
        if short == short.to_integral_value()
        else float(short)
    )
