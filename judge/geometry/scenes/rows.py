"""Scenes of many circles in three columns and one line: (cx, cy, r, A, B).

    columns("touch", "cut~", count=(20, 60), **NEAR)

Each row is a circle with a word of its own; "~" puts it just off, by its own size.

    touch, cut, miss     a circle that the line touches, cuts or misses
    dot, dot-miss        a circle of radius 0, on the line or beside it
"""

from __future__ import annotations

from array import array
from collections.abc import Sequence
from sys import byteorder
from typing import Any

from judge.data.draw import Draw
from judge.geometry.level import Case, Scene, Vocabulary, maker, near_gap, parsed
from judge.geometry.pose import Atom, Length, Point, posed

_WORDS = Vocabulary.of("how a circle lies to the line", "touch cut miss dot dot-miss")
_FINE = 18  # bits by which all grows where a circle is just off
_CHUNK = 2048  # numbers that are drawn at once
_TRIPLES = ((3, 4, 5), (-4, 3, 5), (5, -12, 13), (8, 15, 17), (-7, 24, 25), (20, 21, 29))


def columns(
    *words: str,
    count: tuple[int, int] = (20, 60),
    size: int = 30,
    octaves: tuple[int, int] = (0, 0),
    along: int = 1,
    **how: Any,
) -> Scene:
    """As many rows as `count` bounds, each of one of the words.

    Args:
        octaves: bounds of the power of two by which a row is larger than the others; one row in three is.
        along: how many sizes A and B are apart, at most.
        how: the pose.
    """
    parsed(words, _WORDS)
    fine = _FINE if any(word[-1] == "~" for word in words) else 0

    def draw_case(draw: Draw) -> Case:
        end = (draw.integer(1, size * along) * draw.sign()) << fine
        atoms: list[Atom] = [Point([0, 0]), Point([end, 0])]
        for _ in range(draw.integer(*count)):
            times = draw.integer(*octaves) if draw.integer(0, 2) == 0 else 0
            centre, r = _row(draw, draw.choice(words), size, end, fine)
            atoms += [Point([x << times for x in centre]), Length([r << times])]
        A, B, *rest = posed(draw, atoms, **how)
        rows = [(*centre, r) for centre, r in zip(rest[::2], rest[1::2], strict=True)]
        return _columns(rows, A, B)

    return draw_case


def _row(draw: Draw, word: str, size: int, end: int, fine: int) -> tuple[list[int], int]:
    kind = word.rstrip("~")
    near = draw.choice((0, end))
    beside = draw.integer(0, 3) and draw.integer(-3 * size, 3 * size)  # or level with A or B
    x, r = near + (beside << fine), draw.integer(size // 4 + 1, size) << fine
    y = r * draw.sign()
    if kind == "cut":
        y = draw.integer(1 - r, r - 1)
    elif kind == "miss":
        y += draw.integer(1, 2 * r) * (1 if y > 0 else -1)
    elif kind == "dot":
        y, r = 0, 0
    elif kind == "dot-miss":
        r = 0
    if word[-1] == "~":
        reach = max(r, abs(x), abs(x - end), abs(y))
        y += near_gap(draw, reach) * draw.sign()
    return [x, y], r


@maker
def any_columns(draw: Draw, reach: int, count: int) -> Case:
    """So many circles and a line in whole numbers up to `reach`."""

    def number() -> int:
        return draw.integer(-reach, reach)

    rows = [(number(), number(), draw.integer(0, reach)) for _ in range(count)]
    return _columns(rows, (number(), number()), (number(), number()))


@maker
def million(draw: Draw, count: int, radius: int, every: int, bits: int) -> Case:
    """So many circles anywhere on a grid of 2**16 places each way; all of it times a power of two.

    One of `every` so many touches the line, or is off by 2e-7 to 1e-5 of its own size. All is moved by
    numbers of so many bits, so that single precision has no room for the figure.
    """
    p, q, h = draw.choice(_TRIPLES)
    unit = 2.0 ** draw.integer(-9, 3)
    xs, ys, rs = (list(_shorts(draw, count)) for _ in range(3))
    start = draw.integer(-9999, 9999), draw.integer(-9999, 9999)
    end = start[0] + 500 * p, start[1] + 500 * q
    radii: list[float] = [abs(r) % radius for r in rs]
    for place in range(draw.integer(0, every - 1), count, every):
        along, off, side = draw.integer(-1000, 1000), draw.integer(1, 99), draw.sign()
        x, y = start[0] + along * p - side * off * q, start[1] + along * q + side * off * p
        reach = max(off * h, *(abs(v) for at in (start, end) for v in (at[0] - x, at[1] - y)))
        share = draw.choice((0, draw.sign())) * draw.integer(20, 99) * 10.0 ** draw.integer(-8, -7)
        xs[place], ys[place], radii[place] = x, y, off * h + share * reach
    dx, dy = (draw.sign() * draw.integer((1 << bits) // 2, 1 << bits) for _ in range(2))
    return (
        tuple([(x + dx) * unit for x in xs]),
        tuple([(y + dy) * unit for y in ys]),
        tuple([r * unit for r in radii]),
        ((start[0] + dx) * unit, (start[1] + dy) * unit),
        ((end[0] + dx) * unit, (end[1] + dy) * unit),
    )


def _columns(rows: Sequence[tuple[float, ...]], A: Any, B: Any) -> Case:
    cx, cy, r = (tuple(float(row[place]) for row in rows) for place in range(3))
    return cx, cy, r, A, B


def _shorts(draw: Draw, count: int) -> array[int]:
    """So many ints of 16 bits, drawn a few thousand at a time."""
    found = array("h")
    while len(found) < count:
        size = min(_CHUNK, count - len(found))
        found.frombytes(draw.integer(0, (1 << 16 * size) - 1).to_bytes(2 * size, "little"))
    if byteorder == "big":
        found.byteswap()
    return found
