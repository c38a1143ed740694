"""Circles in whole numbers that a ray from (0, 0) touches within the band, and not exactly.

For D = (dx, dy) and a = dx² + dy² the ray's line is |k|/√a from a centre, k = dx·y − dy·x being a whole
number again: so k² − a·r² is one, and never 0 where a is no square. Divided by 2·a·r it is by how much the
line misses the circle or cuts it.
"""

from __future__ import annotations

from math import gcd, isqrt

from judge.data.draw import Draw
from judge.topics.circles.cells import IntCircle, IntPoint
from judge.topics.circles.many import FASTEST

_BAND = 10**12  # the parts of the extent of which one is the band
_LEAST, _MOST = 50, 95  # percent of the band: clearly in it, and clearly more than rounding
_RADII = 6000  # so many are tried


def steep(draw: Draw) -> IntPoint:
    """A direction whose numbers have no common divisor, as long as may be."""
    dx, dy = draw.integer(FASTEST // 2, FASTEST), draw.integer(FASTEST // 2, FASTEST)
    if gcd(dx, dy) > 1:
        draw.reject()
    return dx * draw.sign(), dy * draw.sign()


def brushed(draw: Draw, way: IntPoint, extent: int) -> IntCircle:
    """A circle that the ray from (0, 0) along `way` touches within the band, `extent` being the scene's."""
    dx, dy = way
    a = dx * dx + dy * dy
    least = draw.integer(2, 99)
    for r in range(least, least + _RADII):
        below = isqrt(r * r * a)
        for k in (below, below + 1):
            off = abs(k * k - r * r * a) * _BAND * 100
            if _LEAST * extent <= off // (2 * r * a) <= _MOST * extent:
                return (*_placed(draw, way, k * draw.sign()), r)
    return draw.reject()


def _placed(draw: Draw, way: IntPoint, k: int) -> IntPoint:
    """A place ahead with dx·y − dy·x = k, a few steps of the way beyond the first one."""
    dx, dy = way
    x = -k * pow(dy, -1, abs(dx)) % abs(dx)
    y = (k + dy * x) // dx
    behind = -(x * dx + y * dy) // (dx * dx + dy * dy)
    steps = behind + draw.integer(2, 4)
    return x + steps * dx, y + steps * dy
