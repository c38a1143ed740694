"""Scenes of plain doubles in which one length is a small part of another, and counts.

    ratios(), ratios(near=True)      (cx, cy, r, A, B)
    ratios(centred=True)             the same about the origin
    ratios(short=True)               short chords, whose ends a far smaller part moves

What leaves out a small part of a sum, or the short leg of a right triangle, is wrong by a few times the
tolerance where that part is just large enough. So each case is one where this is so: of one sum, or one root.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import sqrt

from judge.data.draw import Draw
from judge.geometry.level import Case, held, maker

_UNIT = 2**20
Band = tuple[int, int, float]  # from, to, in parts of which unit
# In units of 1e-10: parts that move an answer by a few times 1e-9 (or 1e-7, where the line nearly touches) of
# what they are parts of: added to it, squared, or to the fourth power.
_PARTS: dict[bool, Sequence[tuple[int, int]]] = {
    False: ((15, 100), (500_000, 850_000), (95 * 10**6, 150 * 10**6)),
    True: ((1_200, 10_000), (4_500_000, 8_500_000), (300 * 10**6, 450 * 10**6)),
}
_DIFFERENCES = 0, 1, 2, 3  # what is left out, a part of one of them or of what follows
_PRODUCT, _LEG, _SERIES, _DIAGONAL, _WAY, _HEIGHT, _FOOT, _END = range(4, 12)
_KINDS = (*_DIFFERENCES, *2 * [_PRODUCT, _LEG, _SERIES, _DIAGONAL], _LEG)


@maker
def ratios(draw: Draw, *, near: bool = False, centred: bool = False, short: bool = False) -> Case:
    """A line that cuts a circle, or nearly touches it: the direction hardly leaves an axis or a diagonal, the
    line hardly passes the centre, or a coordinate is hardly 0.
    """
    kinds = (0, 0, 0, 0, _HEIGHT, *_KINDS[4:]) if centred else _KINDS
    at = draw.choice(
        (*kinds, *6 * [_END], _FOOT, _FOOT) if short else kinds if near else (*kinds, _WAY, _HEIGHT)
    )
    # By how much an end moves more than the line: it is r beside half of the chord.
    gain = 2 ** (11 if at == _FOOT else draw.integer(1, 10)) if short else 1
    least, order = (1.25e-7 if near else 1.25e-9) / gain, draw.choice((1, -1))
    powers = zip(_PARTS[near], (1.0, 0.5, 0.25), strict=True)
    parts = tuple((low, high, 1e10 * gain**power) for (low, high), power in powers)
    for _ in range(400):
        A, B = _figure(draw, at, parts)[::order]
        cx, cy = (0.0, 0.0) if centred else [_moved(draw, f, g, parts[0]) for f, g in zip(A, B, strict=True)]
        A, B = ((cx + x, cy + y) for x, y in (A, B))
        (d, way), (off, beside) = _measured(cx, cy, A, B), _measured(cx, cy, A, B, without=at)
        size = max([d, *[abs(x - c) for end in (A, B) for x, c in zip(end, (cx, cy), strict=True)]])
        error = beside - way if at == _WAY else off - d
        low, high = sorted(sqrt((x - cx) ** 2 + (y - cy) ** 2) for x, y in (A, B))
        low = max(low, d / 0.98)
        fits = at in (_HEIGHT, _FOOT, _END) or least * size < abs(error) < 12 * least * size
        if fits and (near or short or high > 1.05 * low):
            break
    else:
        draw.reject()
    if near:
        r = d + size * draw.integer(1020, 1150) / 10**10 * (1 if error > 0 else -1)
    elif short:
        r = d + max(d / 2 / gain**2, 1.02e-7 * size)
    else:
        r = low + (high - low) * draw.integer(2, 98) / 100  # one end is inside
    turn, side, scale = draw.choice((1, -1)), draw.sign(), 2.0 ** draw.integer(-40, 20)
    C, A, B = ((x * scale * side + 0.0, y * scale + 0.0)[::turn] for x, y in ((cx, cy), A, B))  # no −0.0
    return held(draw, (*C, r * scale, A, B))


def _part(draw: Draw, band: Band) -> float:
    low, high, units = band
    return draw.integer(low, high) / units * draw.sign()


def _figure(draw: Draw, at: int, parts: Sequence[Band]) -> Case:
    """A and B, about a unit from one another and from the origin; the line passes it as closely."""
    added, squared, fourth = parts
    q = draw.integer(_UNIT // 4, _UNIT) / _UNIT
    if at == _DIAGONAL:
        q = 1 + _part(draw, added)
    elif at in (_LEG, _SERIES, _FOOT) or (at != _END and draw.boolean()):
        q = _part(draw, {_LEG: squared, _SERIES: fourth, _FOOT: squared}.get(at, added))
        q *= 0.55 if at == _FOOT else 1
    high = _part(draw, added) if at == _HEIGHT else draw.integer(60, 98) / 100 * draw.sign()
    ways = [draw.choice((draw.integer(-_UNIT, _UNIT) / _UNIT, _part(draw, added) + high * q)) for _ in "AB"]
    if at == _END:  # a ray from there meets the circle
        ways = [_part(draw, added) + high * q, draw.integer(1, _UNIT) / _UNIT * (-1 if high * q > 0 else 1)]
    elif draw.boolean():
        ways[1] = ways[0] + draw.integer(30, 300) / 1000 * draw.sign()
    return tuple((x - high * q, x * q + high) for x in ways)


def _moved(draw: Draw, f: float, g: float, added: Band) -> float:
    """A coordinate of C that is 0 or small, or with which that of A or B is."""
    return draw.choice((0.0, _part(draw, added), _part(draw, added) - f, _part(draw, added) - g))


def _measured(cx: float, cy: float, A: Case, B: Case, without: int = -1) -> tuple[float, float]:
    """How far the line is from C, and the foot from A; without a small part of one sum, or of the root."""
    pairs = (B[0], -A[0]), (B[1], -A[1]), (A[0], -cx), (A[1], -cy)
    dx, dy, fx, fy = (_sum(x, y, less=at == without) for at, (x, y) in enumerate(pairs))
    short, long = sorted((abs(dx), abs(dy)))
    length = sqrt(dx * dx + dy * dy)
    if without in (_LEG, _SERIES, _DIAGONAL):
        parts = {_LEG: long, _SERIES: long + short * short / 2 / (long or 1), _DIAGONAL: long * sqrt(2)}
        length = parts[without]
    product = _sum(dx * fy, -dy * fx, less=without == _PRODUCT)
    way = _sum(dx * fx, dy * fy, less=without == _WAY)
    return abs(product) / (length or 1), way / (length or 1)


def _sum(x: float, y: float, *, less: bool) -> float:
    """x + y, or if `less` without the one that is far smaller."""
    small, large = sorted((x, y), key=abs)
    return large if less and abs(small) < 1e-5 * abs(large) else x + y
