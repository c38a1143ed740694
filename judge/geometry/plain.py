"""What plain programs in doubles find, with a tolerance or without: for scenes that keep the draws that tell.

A scene asks both, `telling(scene, count, partial(count, tolerance=1e-10))`, and keeps a case where they
differ. Nothing here decides an answer. A tolerance is a part of e, the figure's size.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import copysign, sqrt

from judge.geometry.crowd import inside
from judge.geometry.quadratic import Number, Point

MISS, AT_ORIGIN, AHEAD = "miss", "at the origin", "ahead"
_NEAR = 1e-9  # of the size: what counts as at the origin, after the program has decided


def _length(*parts: Number) -> float:
    """√ of the sum of squares: every Python rounds it alike, and not `math.hypot`."""
    total = 0.0
    for part in parts:
        total += part * part
    return sqrt(total)


def _past(f: Point, d: Point, length: float) -> tuple[float, float]:
    """How far the line f + t·d passes the origin, and the way from f to the foot of the perpendicular."""
    return abs(d[0] * f[1] - d[1] * f[0]) / length, -(f[0] * d[0] + f[1] * d[1]) / length


def count(cx: Number, cy: Number, r: Number, A: Point, B: Point, *, tolerance: float = 0.0) -> int | None:
    """How many points a plain program sees a circle and a line have in common."""
    fx, fy, dx, dy = A[0] - cx, A[1] - cy, B[0] - A[0], B[1] - A[1]
    length, edge = _length(dx, dy), tolerance * max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    if length == 0:
        return None
    gap = abs(dx * fy - dy * fx) / length - r
    return 1 if abs(gap) <= edge else 2 if gap < 0 else 0


def lie(
    cx1: Number, cy1: Number, r1: Number, cx2: Number, cy2: Number, r2: Number, *, tolerance: float = 0.0
) -> tuple[int, int]:
    """The signs that a plain program sees of d − (r1 + r2) and d − |r1 − r2|; d is the centres' distance."""
    vx, vy = cx2 - cx1, cy2 - cy1
    edge = tolerance * max(r1, r2, abs(vx), abs(vy))
    outer, inner = (_length(vx, vy) - reach for reach in (r1 + r2, abs(r1 - r2)))
    return (outer > edge) - (outer < -edge), (inner > edge) - (inner < -edge)


def first_hit(
    cx: Number, cy: Number, r: Number, O: Point, D: Point, *, tolerance: float = 0.0, power: bool = False
) -> str:
    """Where a plain program sees a ray meet a circle first: MISS, AT_ORIGIN or AHEAD.

    It compares the line's distance with r, and a point's way along the ray with 0; e = max(r, |O − C|∞).
    With `power` it finds the point near O as the power of O by the way to the other one.
    """
    return sphere_hit((cx, cy, 0), r, (*O, 0), (*D, 0), tolerance=tolerance, power=power)


def sphere_hit(
    C: Sequence[Number],
    r: Number,
    O: Sequence[Number],
    D: Sequence[Number],
    *,
    tolerance: float = 0.0,
    power: bool = False,
) -> str:
    """The same of a sphere, in space."""
    f, length = [o - c for o, c in zip(O, C, strict=True)], _length(*D)
    if length == 0:
        return MISS
    size = max(r, *map(abs, f))
    edge, foot = tolerance * size, -(f[0] * D[0] + f[1] * D[1] + f[2] * D[2]) / length
    across = _length(D[1] * f[2] - D[2] * f[1], D[2] * f[0] - D[0] * f[2], D[0] * f[1] - D[1] * f[0]) / length
    if across - r > edge:
        return MISS
    half = sqrt(max(0.0, (r - across) * (r + across))) if r - across > edge else 0.0
    ways = [foot - half, foot + half]
    if power and half:  # the root that would cancel from the other one and the power of O
        outer = foot + copysign(half, foot)
        ways = sorted([outer, (f[0] * f[0] + f[1] * f[1] + f[2] * f[2] - r * r) / outer])
    for way in ways:
        if way >= -edge:
            return AT_ORIGIN if way <= _NEAR * size else AHEAD
    return MISS


def hits(
    circles: Sequence[tuple[Number, Number, Number]], O: Point, D: Point, *, tolerance: float = 0.0
) -> list[tuple[int, str, bool]]:
    """What a plain program sees along a ray, one circle after the other: (index, tag, whether at the origin).

    e is the largest of all r and all |C − O|∞.
    """
    edge = tolerance * max(max(r, abs(x - O[0]), abs(y - O[1])) for x, y, r in circles)
    length, found = _length(*D), []
    for index, (x, y, r) in enumerate(circles):
        across, foot = _past((O[0] - x, O[1] - y), D, length)
        if across - r > edge:
            continue
        half = sqrt(max(0.0, (r - across) * (r + across)))
        ways = [(foot, "touch")] if across - r >= -edge else [(foot - half, "enter"), (foot + half, "exit")]
        found += [(index, tag, way <= edge) for way, tag in ways if way >= -edge]
    return found


def spans(
    circles: Sequence[tuple[Number, Number, Number]],
    O: Point,
    D: Point,
    program: Sequence[int],
    *,
    tolerance: float = 0.0,
) -> int:
    """How many intervals a plain program finds inside a solid of discs: see judge.geometry.crowd.

    It compares values of t, which round more than ways along the ray.
    """
    edge = tolerance * max(max(r, abs(x - O[0]), abs(y - O[1])) for x, y, r in circles)
    length, ends = _length(*D), []
    for x, y, r in circles:
        across, foot = _past((O[0] - x, O[1] - y), D, length)
        foot /= length
        half = sqrt((r - across) * (r + across)) / length if r - across > edge else 0.0
        ends.append((max(0.0, foot - half), max(0.0, foot + half)) if half else (0.0, 0.0))
    cuts: list[float] = []
    for end in sorted({0.0, *(end for disc in ends for end in disc)}):
        if not cuts or (end - cuts[-1]) * length > edge:
            cuts.append(end)
    held = [
        inside(program, [start < (cut + after) / 2 < end for start, end in ends])
        for cut, after in pairwise(cuts)
    ]
    return sum(now and not before for before, now in pairwise([False, *held]))


def crossings(cx: Number, cy: Number, r: Number, V: Sequence[Point], *, tolerance: float = 0.0) -> list[int]:
    """The edges at whose line's points a plain program sees a polygon's boundary cross a circle."""
    edge, found = tolerance * max(r, *(max(abs(x - cx), abs(y - cy)) for x, y in V)), []
    for number, ((ax, ay), (bx, by)) in enumerate(zip(V, (*V[1:], V[0]), strict=True)):
        d = bx - ax, by - ay
        length = _length(*d)
        if length == 0:
            return []
        across, foot = _past((ax - cx, ay - cy), d, length)
        if across - r > edge:
            continue
        half = sqrt(max(0.0, (r - across) * (r + across)))
        ways = (foot,) if across - r >= -edge else (foot - half, foot + half)
        found += [number for way in ways if -edge <= way < length - edge]
    return found


def balls_meet(
    P0: Point, P1: Point, r: Number, Q0: Point, Q1: Point, s: Number, *, tolerance: float = 0.0
) -> str | None:
    """Whether a plain program sees two discs touch at the start, later, or not at all."""
    f, reach = (P0[0] - Q0[0], P0[1] - Q0[1]), r + s
    p, q = (P1[0] - P0[0], P1[1] - P0[1]), (Q1[0] - Q0[0], Q1[1] - Q0[1])
    d = p[0] - q[0], p[1] - q[1]
    edge = tolerance * max(reach, *map(abs, (*f, *p, Q1[0] - P0[0], Q1[1] - P0[1])))
    if _length(*f) - reach <= edge:
        return "start"
    return _within(_first(f, d, reach, edge), d, edge)


def wall_meet(P0: Point, P1: Point, r: Number, A: Point, B: Point, *, tolerance: float = 0.0) -> str | None:
    """The same of a disc and a wall."""
    f, g, w = (P0[0] - A[0], P0[1] - A[1]), (P0[0] - B[0], P0[1] - B[1]), (B[0] - A[0], B[1] - A[1])
    d, wall = (P1[0] - P0[0], P1[1] - P0[1]), _length(*w)
    edge = tolerance * max(r, *map(abs, (*f, *g, P1[0] - A[0], P1[1] - A[1], P1[0] - B[0], P1[1] - B[1])))
    k, foot = (w[0] * f[1] - w[1] * f[0], f[0] * w[0] + f[1] * w[1]) if wall else (0.0, 0.0)
    apart = abs(k) / wall if 0 < foot < wall * wall else min(_length(*f), _length(*g))
    if apart - r <= edge:
        return "start"
    times = [time for time in (_first(each, d, r, edge) for each in (f, g)) if time is not None]
    turn = w[0] * d[1] - w[1] * d[0]
    if turn and wall:
        time = ((r if k > 0 else -r) * wall - k) / turn
        if 0 <= foot + time * (d[0] * w[0] + d[1] * w[1]) <= wall * wall:
            times.append(time)
    return _within(min(times, default=None), d, edge)


def _first(f: Point, d: Point, r: Number, edge: float) -> float | None:
    """The time at which f + t·d first is r away from the origin."""
    way = _length(*d)
    if not way:
        return None
    across, foot = _past(f, d, way)
    if across - r > edge:
        return None
    return (foot - (sqrt((r - across) * (r + across)) if r - across > edge else 0.0)) / way


def _within(time: float | None, d: Point, edge: float) -> str | None:
    return None if time is None or time < 0 or (time - 1) * _length(*d) > edge else "later"


def counts(
    cx: Sequence[float],
    cy: Sequence[float],
    r: Sequence[float],
    A: Point,
    B: Point,
    *,
    tolerance: float = 0.0,
) -> list[int | None]:
    """`count` of each circle of three columns."""
    return [count(*circle, A, B, tolerance=tolerance) for circle in zip(cx, cy, r, strict=True)]
