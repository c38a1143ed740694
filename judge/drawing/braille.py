"""A picture in braille characters for a terminal: eight dots a character, coloured by what they belong to.

The points of the case stand as their letters, a wanted one as `o`, a given one as `x`, both together as `*`.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby, pairwise
from math import hypot
from typing import NamedTuple

from judge.drawing.shapes import Dot, Panel, Picture, Role, Stroke

COLUMNS = 60
ROWS = 16
LEAST_ROWS = 9  # with fewer nothing round looks round
_WIDE = 29  # characters of the widest panel
_BITS = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))  # of a dot, by row and column
_BLANK = 0x2800
_ORDER = (Role.BEYOND, Role.SHAPE, Role.LINE, Role.CASE, Role.WANTED, Role.GOT)  # the last one colours
LETTERS = {Role.WANTED: "o", Role.GOT: "x"}


class Piece(NamedTuple):
    """A run of characters of one role; None for words beside the drawing."""

    text: str
    role: Role | None = None


def to_braille(picture: Picture, rows: int = ROWS, *, answered: bool = True) -> list[list[Piece]]:
    """At most `rows` rows, or `LEAST_ROWS` where that is more, of at most `COLUMNS` columns.

    The legend is of the marks that are drawn; a picture that is not `answered` has none, and titles only
    where there are any.

    A lower drawing is narrower too: true scale stays true. Rows that are blank in every panel at the top and
    at the bottom are left out.
    """
    high = min(max(rows, LEAST_ROWS), ROWS) - 2
    raster = Raster(high, 2 * high + 1)
    gap = Piece(" " * (_WIDE + 2 - raster.wide))  # to where the next panel begins, below its title
    grids = [grid(panel, raster) for panel in picture.panels]
    levels = [level for level in range(raster.high) if any(_inked(each[level]) for each in grids)]
    titles = [_heading(panel.title.removeprefix("Lens: ")) for panel in picture.panels]
    drawn = [[Piece(title.ljust(_WIDE + 2)) for title in titles]] if answered or any(titles) else []
    for level in range(levels[0], levels[-1] + 1) if levels else ():
        drawn.append([piece for each in grids for piece in (*pieces(each[level]), gap)])
    if answered and (legend := _legend(picture, {cell for each in grids for row in each for cell in row})):
        drawn.append(legend)
    return [trimmed(row) for row in drawn]


def _legend(picture: Picture, drawn: set[Cell]) -> list[Piece]:
    """What the letters of answers stand for, of those that are drawn."""
    letters = zip((*LETTERS.items(), (None, "*")), (*picture.keys, "both"), strict=True)
    shown = [
        Piece(f"{letter} {key}", role)
        for (role, letter), key in letters
        if (letter, role or Role.WANTED) in drawn
    ]
    return [part for piece in shown for part in (Piece("  "), piece)][1:]


class Raster(NamedTuple):
    """The characters of a panel: rows and columns; twice as many columns as rows, and one, are square."""

    high: int
    wide: int

    def fine(self, dot: Dot) -> Dot:
        """Where a dot of the panel is on the raster, rows downwards."""
        return (dot[0] + 1) / 2 * (2 * self.wide - 1), (1 - dot[1]) / 2 * (4 * self.high - 1)

    def cell(self, x: float, y: float) -> tuple[int, int]:
        """The dot of the raster that is nearest."""
        return min(max(round(x), 0), 2 * self.wide - 1), min(max(round(y), 0), 4 * self.high - 1)


def _heading(title: str) -> str:
    """What of a title goes above a panel: whole words."""
    return title if len(title) <= _WIDE else title[: _WIDE + 1].rpartition(" ")[0].rstrip(" ,;")


Cell = tuple[str, Role | None]


def grid(panel: Panel, raster: Raster) -> list[list[Cell]]:
    """The characters of a panel by row, each with the role that colours it: the last in the order."""
    bits = [[0] * raster.wide for _ in range(raster.high)]
    cells: list[list[Cell]] = [[(" ", None)] * raster.wide for _ in range(raster.high)]
    for stroke in sorted(panel.strokes, key=lambda stroke: _ORDER.index(stroke.role)):
        for x, y in _dots(stroke, raster):
            row, column = y // 4, x // 2
            bits[row][column] |= _BITS[y % 4][x % 2]
            cells[row][column] = chr(_BLANK + bits[row][column]), stroke.role
    for mark in sorted(panel.marks, key=lambda mark: _ORDER.index(mark.role)):
        x, y = raster.cell(*raster.fine(mark.at))
        row, column = y // 4, x // 2
        if letter := LETTERS.get(mark.role) or mark.text[:1]:
            both = mark.role is Role.GOT and cells[row][column][0] in ("o", "*")
            cells[row][column] = ("*", Role.WANTED) if both else (letter, mark.role)
    return cells


def _dots(stroke: Stroke, raster: Raster) -> Iterator[tuple[int, int]]:
    """The dots of a stroke, those beyond a line's ends two on, two off."""
    travelled = 0
    for (x1, y1), (x2, y2) in pairwise(() if stroke.filled else map(raster.fine, stroke.dots)):
        steps = max(1, int(hypot(x2 - x1, y2 - y1) * 1.5))
        for i in range(steps + 1):
            travelled += 1
            if stroke.role is not Role.BEYOND or travelled % 8 < 3:
                yield raster.cell(x1 + (x2 - x1) * i / steps, y1 + (y2 - y1) * i / steps)


def _inked(cells: list[Cell]) -> bool:
    return any(letter != " " for letter, _ in cells)


def pieces(cells: list[Cell]) -> list[Piece]:
    """A row of characters, neighbours of one role together."""
    runs = groupby(cells, key=lambda cell: cell[1])
    return [Piece("".join(letter for letter, _ in run), role) for role, run in runs]


def trimmed(row: list[Piece]) -> list[Piece]:
    """A row without spaces at its end."""
    while row and not row[-1].text.rstrip(" "):
        row = row[:-1]
    return [*row[:-1], Piece(row[-1].text.rstrip(" "), row[-1].role)] if row else []
