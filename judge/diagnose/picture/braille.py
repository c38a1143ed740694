"""A picture in braille characters for a terminal: eight dots a character, coloured by what they belong to.

The points of the case stand as their letters, a wanted one as `o`, a given one as `x`, both together as `*`.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from math import hypot

from judge.diagnose.picture.shapes import Dot, Mark, Panel, Picture, Role, Stroke

COLUMNS = 60
ROWS = 16
_WIDE = 29  # characters of a panel
_HIGH = 14
_BITS = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))  # of a dot, by row and column
_BLANK = 0x2800
_ORDER = (Role.BEYOND, Role.CIRCLE, Role.LINE, Role.CASE, Role.WANTED, Role.GOT)  # the last one colours
_LETTERS = {Role.WANTED: "o", Role.GOT: "x"}


@dataclass(frozen=True, slots=True)
class Piece:
    """A run of characters of one role; None for words beside the drawing."""

    text: str
    role: Role | None = None


def to_braille(picture: Picture) -> list[list[Piece]]:
    """At most `ROWS` rows of at most `COLUMNS` columns."""
    grids = [_grid(panel) for panel in picture.panels]
    titles = [panel.title.removeprefix("Lens: ") for panel in picture.panels]
    rows = [[Piece(_heading(title).ljust(_WIDE + 2)) for title in titles]]
    for level in range(_HIGH):
        row: list[Piece] = []
        for grid in grids:
            row += [*_pieces(grid[level]), Piece("  ")]
        rows.append(row)
    rows.append([Piece("o wanted", Role.WANTED), Piece("  "), Piece("x got", Role.GOT), Piece("  * both")])
    return [_trimmed(row) for row in rows]


def _heading(title: str) -> str:
    """What of a title goes above a panel: whole words."""
    return title if len(title) <= _WIDE else title[: _WIDE + 1].rpartition(" ")[0].rstrip(" ,;")


Cell = tuple[str, Role | None]


def _grid(panel: Panel) -> list[list[Cell]]:
    dots = [[0] * _WIDE for _ in range(_HIGH)]
    roles: list[list[Role | None]] = [[None] * _WIDE for _ in range(_HIGH)]
    for stroke in panel.strokes:
        if not stroke.filled:
            _draw(stroke, dots, roles)
    cells: list[list[Cell]] = [
        [(chr(_BLANK + bits) if bits else " ", role) for bits, role in zip(*pair, strict=True)]
        for pair in zip(dots, roles, strict=True)
    ]
    for role in _ORDER:
        for mark in panel.marks:
            if mark.role is role:
                _set(mark, cells)
    return cells


def _draw(stroke: Stroke, dots: list[list[int]], roles: list[list[Role | None]]) -> None:
    """Set the dots of a stroke, those beyond a segment's ends two on, two off."""
    travelled = 0
    for (x1, y1), (x2, y2) in pairwise(map(_fine, stroke.dots)):
        steps = max(1, int(hypot(x2 - x1, y2 - y1) * 1.5))
        for i in range(steps + 1):
            travelled += 1
            if stroke.role is Role.BEYOND and travelled % 8 >= 3:
                continue
            x, y = _cell(x1 + (x2 - x1) * i / steps, y1 + (y2 - y1) * i / steps)
            row, column = y // 4, x // 2
            dots[row][column] |= _BITS[y % 4][x % 2]
            before = roles[row][column]
            if before is None or _ORDER.index(stroke.role) > _ORDER.index(before):
                roles[row][column] = stroke.role


def _fine(dot: Dot) -> Dot:
    """Where a dot of the panel is on the raster, rows downwards."""
    return (dot[0] + 1) / 2 * (2 * _WIDE - 1), (1 - dot[1]) / 2 * (4 * _HIGH - 1)


def _cell(x: float, y: float) -> tuple[int, int]:
    return min(max(round(x), 0), 2 * _WIDE - 1), min(max(round(y), 0), 4 * _HIGH - 1)


def _set(mark: Mark, cells: list[list[Cell]]) -> None:
    x, y = _cell(*_fine(mark.at))
    row, column = y // 4, x // 2
    letter = _LETTERS.get(mark.role) or mark.text[:1]
    if not letter:
        return
    if mark.role is Role.GOT and cells[row][column][0] in ("o", "*"):
        cells[row][column] = ("*", Role.WANTED)
    else:
        cells[row][column] = (letter, mark.role)


def _pieces(cells: list[Cell]) -> list[Piece]:
    pieces: list[Piece] = []
    for letter, role in cells:
        if pieces and pieces[-1].role is role:
            pieces[-1] = Piece(pieces[-1].text + letter, role)
        else:
            pieces.append(Piece(letter, role))
    return pieces


def _trimmed(row: list[Piece]) -> list[Piece]:
    """A row without spaces at its end."""
    kept = list(row)
    while kept and not kept[-1].text.rstrip(" "):
        kept.pop()
    if kept:
        kept[-1] = Piece(kept[-1].text.rstrip(" "), kept[-1].role)
    return kept
