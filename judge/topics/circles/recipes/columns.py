"""Recipes of many circles in three columns of doubles, and one line.

Each gives a case (cx, cy, r, A, B). The line runs along (p, q) of a Pythagorean triple p² + q² = h², so that
in whole numbers a circle touches it exactly, or is off by 1/h at least. `count` is how many, from … to.
"""

from __future__ import annotations

from array import array
from collections.abc import Mapping, Sequence
from math import cos, sin
from sys import byteorder

from judge.data.draw import Draw
from judge.problem import Case

_TRIPLES = (
    (1, 0, 1),
    (0, 1, 1),
    (3, 4, 5),
    (-4, 3, 5),
    (5, -12, 13),
    (8, 15, 17),
    (-7, 24, 25),
    (20, 21, 29),
)
_FINE = 2.0**-12  # the size of what is small beside something large
_CHUNK = 2048  # numbers that are drawn at once
_EDGES = {"snap": (905, 995, 10**15), "clear": (105, 295, 10**9)}  # of the extent: from, to, in these parts

Point = tuple[float, float]


def small(draw: Draw, *, count: Sequence[int], size: int, radius: int) -> Case:
    """Whole numbers: circles that cut the line, touch it or miss it."""
    (p, q, h), start, end = _line(draw, size)
    rows = []
    for _ in range(draw.integer(*count)):
        along, off = draw.integer(-size, size), draw.integer(0, radius)
        r = abs(off) * h if draw.integer(0, 3) == 0 else draw.integer(0, radius)
        side = draw.sign()
        rows.append((start[0] + along * p - side * off * q, start[1] + along * q + side * off * p, r))
    return _columns(rows, start, end)


def touching(draw: Draw, *, count: Sequence[int], size: int, scales: Sequence[int]) -> Case:
    """Circles that touch a line at any angle, but for rounding, among others; all times 2**scale."""
    angle = draw.integer(1, 6283) / 1000
    ux, uy = cos(angle), sin(angle)
    start = draw.integer(-size, size), draw.integer(-size, size)
    reach = draw.integer(size // 4, size)
    unit = 2.0 ** draw.choice(scales)
    rows = []
    for _ in range(draw.integer(*count)):
        along, off = draw.integer(-size, size), draw.sign() * draw.integer(1, size)
        x, y = start[0] + along * ux - off * uy, start[1] + along * uy + off * ux
        r = abs(off) if draw.integer(0, 2) else draw.integer(0, size)
        rows.append((x * unit, y * unit, r * unit))
    end = start[0] + reach * ux, start[1] + reach * uy
    return _columns(rows, (start[0] * unit, start[1] * unit), (end[0] * unit, end[1] * unit))


def points(draw: Draw, *, count: Sequence[int], size: int, scales: Sequence[int]) -> Case:
    """Circles of radius 0 on a line at any angle, but for rounding, and beside it; all times 2**scale.

    Among them are a few that touch the line. There may be a single one in all.
    """
    angle = draw.integer(1, 6283) / 1000
    ux, uy = cos(angle), sin(angle)
    start = draw.integer(-size, size), draw.integer(-size, size)
    reach = draw.integer(size // 4, size)
    unit = 2.0 ** draw.choice(scales)
    rows = []
    for _ in range(draw.integer(*count)):
        kind = draw.choice(("on", "on", "beside", "touch"))
        along, off = draw.integer(-size, size), 0 if kind == "on" else draw.sign() * draw.integer(1, size)
        x, y = start[0] + along * ux - off * uy, start[1] + along * uy + off * ux
        rows.append((x * unit, y * unit, abs(off) * unit if kind == "touch" else 0))
    end = start[0] + reach * ux, start[1] + reach * uy
    return _columns(rows, (start[0] * unit, start[1] * unit), (end[0] * unit, end[1] * unit))


def nearly(draw: Draw, *, count: Sequence[int], size: int, scales: Sequence[int]) -> Case:
    """Circles that miss or cut the line by 2e-7 to 1e-5 of their own extent; all times 2**scale."""
    (p, q, h), start, end = _line(draw, size)
    rows = []
    for _ in range(draw.integer(*count)):
        along, off, side = draw.integer(-size, size), draw.integer(1, size), draw.sign()
        x, y = start[0] + along * p - side * off * q, start[1] + along * q + side * off * p
        extent = max(off * h, *(abs(v) for at in (start, end) for v in (at[0] - x, at[1] - y)))
        share = draw.integer(20, 99) * 10.0 ** draw.integer(-8, -7)
        rows.append((x, y, off * h + draw.sign() * share * extent))
    unit = 2.0 ** draw.choice(scales)
    scaled = [(x * unit, y * unit, max(0.0, r) * unit) for x, y, r in rows]
    return _columns(scaled, (start[0] * unit, start[1] * unit), (end[0] * unit, end[1] * unit))


def edge(
    draw: Draw,
    *,
    count: Sequence[int],
    size: int,
    edges: Sequence[str],
    scales: Sequence[int] = (0,),
    ratio: Sequence[int] = (),
    slanted: bool = False,
    far: int = 0,
) -> Case:
    """Circles off a touch by most of the band ("snap") or little more than the promise ("clear").

    With `ratio` (bounds) the line runs along an axis, or is `slanted`, A and B are so many sizes apart, and
    each circle is close to one of them. All is moved by up to ±2**far, and then multiplied by 2**scale.
    """
    (p, q, h), start, end = _line(draw, size)
    if ratio:
        p, q, h = draw.choice(_TRIPLES[2:] if slanted else _TRIPLES[:2])
        times = draw.sign() * size * draw.integer(*ratio)
        end = start[0] + times * p, start[1] + times * q
    low, high, parts = _EDGES[draw.choice(edges)]
    rows = []
    for _ in range(draw.integer(*count)):
        near = draw.choice((start, end)) if ratio else start
        along, off, side = draw.integer(-size, size), draw.integer(1, size), draw.sign()
        x, y = near[0] + along * p - side * off * q, near[1] + along * q + side * off * p
        extent = max(off * h, *(abs(v) for at in (start, end) for v in (at[0] - x, at[1] - y)))
        rows.append((x, y, off * h + draw.sign() * draw.integer(low, high) * extent / parts))
    dx, dy = (draw.sign() * draw.integer((1 << far) // 2, 1 << far) if far else 0 for _ in range(2))
    unit = 2.0 ** draw.choice(scales)
    moved = [((x + dx) * unit, (y + dy) * unit, max(0.0, r) * unit) for x, y, r in rows]
    (ax, ay), (bx, by) = (((x + dx) * unit, (y + dy) * unit) for x, y in (start, end))
    return _columns(moved, (ax, ay), (bx, by))


def mixed(draw: Draw, *, count: Sequence[int], size: int, octaves: Sequence[int]) -> Case:
    """Small circles close to a short line, and circles 2**octaves times as large, which reach to it.

    Each touches the line, or is off by a small part of its own size.
    """
    (p, q, h), (ax, ay), (bx, by) = _line(draw, size)
    rows = []
    for _ in range(draw.integer(*count)):
        along, off, side = draw.integer(-size, size), draw.integer(1, size), draw.sign()
        unit = _FINE * 2.0 ** draw.integer(*octaves) if draw.integer(0, 2) == 0 else _FINE
        x = (ax + along * p) * _FINE - side * off * q * unit
        y = (ay + along * q) * _FINE + side * off * p * unit
        rows.append((x, y, (off * h + draw.choice((-1, 0, 1))) * unit))
    return _columns(rows, (ax * _FINE, ay * _FINE), (bx * _FINE, by * _FINE))


def none(draw: Draw, *, size: int) -> Case:
    """No circle at all."""
    _, start, end = _line(draw, size)
    return _columns([], start, end)


def many(draw: Draw, *, count: int, radius: int, every: int, far: int) -> Case:
    """So many circles anywhere on a grid of 2**16 places each way; all of it times a power of two.

    One of `every` so many touches the line, or is off that by 2e-7 to 1e-5 of its own extent. All is moved by
    up to ±2**far, where single precision has no room for the figure.
    """
    p, q, h = draw.choice(_TRIPLES[2:])
    unit = 2.0 ** draw.integer(-9, 3)
    xs, ys, rs = [list(_shorts(draw, count)) for _ in range(3)]
    start = draw.integer(-9999, 9999), draw.integer(-9999, 9999)
    end = start[0] + 500 * p, start[1] + 500 * q
    radii: list[float] = [abs(r) % radius for r in rs]
    for place in range(draw.integer(0, every - 1), count, every):
        along, off, side = draw.integer(-1000, 1000), draw.integer(1, 99), draw.sign()
        x, y = start[0] + along * p - side * off * q, start[1] + along * q + side * off * p
        extent = max(off * h, *(abs(v) for at in (start, end) for v in (at[0] - x, at[1] - y)))
        share = draw.choice((0, draw.sign())) * draw.integer(20, 99) * 10.0 ** draw.integer(-8, -7)
        xs[place], ys[place], radii[place] = x, y, off * h + share * extent
    dx, dy = (draw.sign() * draw.integer((1 << far) // 2, 1 << far) for _ in range(2))
    return (
        tuple([(x + dx) * unit for x in xs]),
        tuple([(y + dy) * unit for y in ys]),
        tuple([r * unit for r in radii]),
        ((start[0] + dx) * unit, (start[1] + dy) * unit),
        ((end[0] + dx) * unit, (end[1] + dy) * unit),
    )


def _line(draw: Draw, size: int) -> tuple[tuple[int, int, int], tuple[int, int], tuple[int, int]]:
    """A direction of whole length, and two points of a line along it."""
    p, q, h = draw.choice(_TRIPLES)
    start = draw.integer(-size, size), draw.integer(-size, size)
    times = draw.sign() * draw.integer(1, size)
    return (p, q, h), start, (start[0] + times * p, start[1] + times * q)


def _columns(rows: Sequence[tuple[float, float, float]], start: Point, end: Point) -> Case:
    cx, cy, r = ([float(row[place]) for row in rows] for place in range(3))
    return tuple(cx), tuple(cy), tuple(r), start, end


def _shorts(draw: Draw, count: int) -> array[int]:
    """So many ints of 16 bits, drawn a few thousand at a time."""
    found = array("h")
    while len(found) < count:
        size = min(_CHUNK, count - len(found))
        found.frombytes(draw.integer(0, (1 << 16 * size) - 1).to_bytes(2 * size, "little"))
    if byteorder == "big":
        found.byteswap()
    return found


RECIPES: Mapping[str, object] = {
    "small": small,
    "touching": touching,
    "points": points,
    "nearly": nearly,
    "edge": edge,
    "mixed": mixed,
    "none": none,
    "many": many,
}
