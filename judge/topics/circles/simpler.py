"""Simpler figures like a given one: the circle about the origin, the line level, numbers of few digits.

For cases of the shape (cx, cy, r, P, Q), where Q is a point or, with a ray, a direction: both readings are
offered. Nothing here need be right: a candidate counts only if it is valid and the submission fails on it.
"""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Context, Decimal, localcontext
from fractions import Fraction

from judge.problem import Case, Problem
from judge.problem.model import Number, Point
from judge.topics.circles.signature import circle_and_pairs

_DIGITS = 60  # of the roots taken here: whatever a double holds, and the narrowest gaps
_FINEST = 16  # digits that are kept at most

_Laid = tuple[Decimal, Decimal, Decimal, Decimal]  # radius, height, start, end (seen from the foot)


def simpler(_problem: Problem, case: Case) -> Iterator[Case]:
    """Cases that are simpler as a whole."""
    yield from moved(case)
    yield from levelled(case)


def special(case: Case) -> int:
    """How many points are there twice, and one more for a radius of 0."""
    points = [argument for argument in case if isinstance(argument, tuple)]
    lone = [argument for argument in case if not isinstance(argument, tuple)]
    return len(points) - len(set(points)) + (lone[-1:] == [0])


def levelled(case: Case) -> Iterator[Case]:
    """The case laid level about the origin, at its own size or blown up to integers, and rounded."""
    figure = circle_and_pairs(case)
    if figure is None:
        return
    centre, radius, p, q = figure
    floats = any(isinstance(value, float) for value in (*centre, radius, *p, *q))
    direction = (Fraction(q[0]), Fraction(q[1]))
    span = (direction[0] - Fraction(p[0]), direction[1] - Fraction(p[1]))
    f = (Fraction(p[0]) - Fraction(centre[0]), Fraction(p[1]) - Fraction(centre[1]))
    with localcontext(Context(prec=_DIGITS)):
        for along, is_ray in ((span, False), (direction, True)):
            level = _level(f, along, Fraction(radius))
            if level is None:
                continue
            for variant in (level, _across_the_centre(level)):
                yield from _rounded(variant, is_ray=is_ray, floats=floats)


def moved(case: Case) -> Iterator[Case]:
    """The case with its centre at the origin: its numbers exact, or not moved at all."""
    figure = circle_and_pairs(case)
    if figure is None or figure[0] == (0, 0):
        return
    centre, radius, p, q = figure
    for both in (True, False):
        points = [_less(p, centre), _less(q, centre) if both else q]
        yield (0, 0, radius, *points)


def _level(f: tuple[Fraction, Fraction], d: tuple[Fraction, Fraction], radius: Fraction) -> _Laid | None:
    square = d[0] * d[0] + d[1] * d[1]
    if square == 0:
        return None
    length = _decimal(square).sqrt()
    height = _decimal(d[0] * f[1] - d[1] * f[0]) / length
    start = _decimal(d[0] * f[0] + d[1] * f[1]) / length
    return _decimal(radius), height, start, start + length


def _across_the_centre(level: _Laid) -> _Laid:
    """The figure with the line through the centre, its ends as far from the nearest root as they were."""
    radius, height, start, end = level
    square = radius * radius - height * height
    half = square.sqrt() if square > 0 else Decimal(0)

    def place(x: Decimal) -> Decimal:
        return x - half + radius if x > 0 else x + half - radius

    return radius, Decimal(0), place(start), place(end)


def _rounded(level: _Laid, *, is_ray: bool, floats: bool) -> Iterator[Case]:
    """Cases of few digits like this one; for a ray, the length of its direction is the line's own."""
    radius, height, start, end = level
    size = max(map(abs, level))
    top = size.adjusted()
    length = end - start
    for kept in range(1, _FINEST + 1):
        for coarse in {1, kept}:
            fine_unit, coarse_unit = _power(top + 1 - kept), _power(top + 1 - coarse)
            near = [value.quantize(fine_unit) for value in (radius, height)]
            ends = [value.quantize(coarse_unit) for value in (start, end)]
            second = length.quantize(coarse_unit) if is_ray else ends[1]
            for flip in (1, -1):
                yield _case(near[0], flip * abs(near[1]), ends[0], second, is_ray, floats)
        yield from _whole(level, kept, is_ray)


def _whole(level: _Laid, kept: int, is_ray: bool) -> Iterator[Case]:
    """The figure in integers, with a radius of 10^kept."""
    radius, height, start, end = level
    if radius == 0:
        return
    scale = _power(kept) / radius
    one = Decimal(1)
    try:
        sized = [(value * scale).quantize(one) for value in (height, start, end)]
    except ArithmeticError:  # too many digits for a candidate
        return
    for places in (0, kept):
        ends = [_few(value, 1) if places else value for value in sized[1:]]
        second = ends[1] - ends[0] if is_ray else ends[1]
        yield _case(_power(kept), abs(sized[0]), ends[0], one if is_ray and places else second, is_ray, False)


def _case(radius: Decimal, height: Decimal, start: Decimal, end: Decimal, is_ray: bool, floats: bool) -> Case:
    r, h, s, e = (_number(value, floats) for value in (radius, height, start, end))
    return (0, 0, r, (s, h), (e, 0) if is_ray else (e, h))


def _few(value: Decimal, digits: int) -> Decimal:
    return value.quantize(_power(value.adjusted() + 1 - digits)) if value else value


def _number(value: Decimal, floats: bool) -> Number:
    whole = value == value.to_integral_value()
    if whole and not floats:
        return int(value)
    return int(value) if value == 0 else float(value)


def _less(point: Point, by: Point) -> Point:
    return _difference(point[0], by[0]), _difference(point[1], by[1])


def _difference(x: Number, y: Number) -> Number:
    if isinstance(x, int) and isinstance(y, int):
        return x - y
    return float(Fraction(x) - Fraction(y))


def _power(exponent: int) -> Decimal:
    """10^exponent, of a single digit: what `quantize` needs, and `**` does not give."""
    return Decimal((0, (1,), exponent))


def _decimal(value: Fraction) -> Decimal:
    return Decimal(value.numerator) / Decimal(value.denominator)
