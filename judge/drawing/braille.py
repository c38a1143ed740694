"""A picture in braille characters for a terminal: eight dots a character, coloured by what they belong to.

The points of the case stand as their letters, a wanted one as `o`, a given one as `x`, both together as `*`;
those of one place stand side by side. A point outside the panel is an arrow in the margin, and how far away
it is stands below.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby, pairwise
from math import atan2, hypot, pi
from typing import NamedTuple

from judge.drawing.shapes import Dot, Mark, Panel, Picture, Role, Stroke, Word
from judge.errors import printable

COLUMNS = 60
ROWS = 16
MOST_ROWS = 24
LEAST_ROWS = 9  # with fewer nothing round looks round
LEAST_COLUMNS = 36
_MARGIN = 3  # columns beside a panel, for the letters of what lies at its edge or beyond
_SIGNS = 6  # of one place, that are shown
_AWAY = 4  # rows and columns that a label may be moved
_BITS = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))  # of a dot, by row and column
_BLANK = 0x2800
_ORDER = (Role.BEYOND, Role.SHAPE, Role.LINE, Role.CASE, Role.WANTED, Role.GOT)  # the last one colours
LETTERS = {Role.WANTED: "o", Role.GOT: "x"}
_ARROWS = "→↗↑↖←↙↓↘"

Cell = tuple[str, Role | None]


class Span(NamedTuple):
    """A run of characters of one role; None for words beside the drawing."""

    text: str
    role: Role | None = None


def to_braille(
    picture: Picture, rows: int = ROWS, columns: int = COLUMNS, *, answered: bool = True
) -> list[list[Span]]:
    """At most so many rows and columns, or `LEAST_ROWS` and `LEAST_COLUMNS` where that is more.

    The legend says whether the scale is true, and what the marks are that are drawn; a picture that is not
    `answered` has none. Of two panels that do not fit beside each other there is the second one, the lens. A
    lower drawing is narrower too: true scale stays true. Rows that are blank in every panel at the top and at
    the bottom are left out.
    """
    rows, columns = min(max(rows, LEAST_ROWS), MOST_ROWS), max(columns, LEAST_COLUMNS)
    panels = picture.panels
    titled = len(panels) > 1
    if _wide(_raster(panels, LEAST_ROWS, titled), len(panels)) > columns:
        panels = panels[1:]
    raster = _raster(panels, rows, titled)
    while _wide(raster, len(panels)) > columns:
        raster = Raster(raster.high - 1, raster.wide - 2)
    legend: list[list[Span]] = []
    drawn: list[list[Span]] = []
    for _ in range(_AWAY):  # a legend of several rows makes the drawing lower
        grids = [grid(panel, raster, _MARGIN) for panel in panels]
        legend = _legend(picture, panels, grids, columns, titled=titled) if answered else []
        drawn = _joined(grids, raster)
        high = len(drawn) + len(legend) + titled
        if high <= rows or raster.high <= 3:
            break
        raster = Raster(raster.high - (high - rows), raster.wide - 2 * (high - rows))
    if titled:
        gap = raster.wide + 2 * _MARGIN - 1
        *left, last = panels
        title = "".join(_heading(panel.title, gap - 1).ljust(gap) for panel in left)
        drawn.insert(0, [Span(title + _heading(last.title, columns - len(title)))])
    return [trimmed(row) for row in (*drawn, *legend)]


def _raster(panels: Sequence[Panel], rows: int, titled: bool) -> Raster:
    """As many rows as are left by titles, one row of legend, and the rows above and below for arrows."""
    framed = sum(any(_side(mark) == side for panel in panels for mark in panel.marks) for side in (-1, 1))
    high = rows - 1 - titled - framed
    return Raster(high, 2 * high + 1)


def _wide(raster: Raster, panels: int) -> int:
    return panels * (raster.wide + 2 * _MARGIN - 1) + 1


def _side(mark: Mark) -> int:
    """1 for an arrow above the panel, -1 for one below it, else 0."""
    x, y = mark.at
    return 0 if mark.towards is None or abs(x) >= abs(y) else 1 if y > 0 else -1


def _joined(grids: Sequence[dict[int, list[Cell]]], raster: Raster) -> list[list[Span]]:
    """The panels beside each other, which share a column of their margins."""
    inked = [level for each in grids for level in each if any(letter != " " for letter, _ in each[level])]
    blank: list[Cell] = [(" ", None)] * (raster.wide + 2 * _MARGIN)
    drawn = []
    for level in range(min(inked), max(inked) + 1) if inked else ():
        cells: list[Cell] = []
        for each in grids:
            row = each.get(level, blank)
            if cells and cells[-1][0] == " ":
                cells.pop()
            else:
                row = row[1:] if cells else row
            cells += row
        drawn.append(pieces(cells))
    return drawn


def _legend(
    picture: Picture,
    panels: Sequence[Panel],
    grids: Sequence[dict[int, list[Cell]]],
    columns: int,
    *,
    titled: bool,
) -> list[list[Span]]:
    """What the letters of answers stand for, of those that are drawn, and how far away what is outside is."""
    drawn = {cell for each in grids for row in each.values() for cell in row}
    letters = zip((*LETTERS.items(), (None, "*")), (*picture.keys, "both"), strict=True)
    found = [Span("true scale")] if picture.scaled and not titled else []
    found += [
        Span(f"{letter} {key}", role)
        for (role, letter), key in letters
        if (letter, role or Role.WANTED) in drawn
    ]
    for mark in (mark for panel in panels for mark in panel.marks if mark.away):
        sign = LETTERS.get(mark.role, mark.sign)
        found.append(Span(f"{sign}{_arrow(mark)} {mark.away} away", mark.role))
    rows: list[list[Span]] = [[]]
    for piece in dict.fromkeys(found):
        used = sum(len(each.text) for each in rows[-1])
        if used and used + len(piece.text) + 2 > columns:
            rows.append([])
        rows[-1] += [Span("  "), piece] if rows[-1] else [piece]
    return rows if found else []


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


def _heading(title: str, room: int) -> str:
    """What of a title goes above a panel: whole words, of a lens how it enlarges."""
    said = title.removeprefix("Lens: ")
    said = said if len(said) <= room else said.partition(", ")[2] or said
    return said if len(said) <= room else said[: room + 1].rpartition(" ")[0].rstrip(" ,;")


# -- a panel -------------------------------------------------------------------------------------------------


def grid(panel: Panel, raster: Raster, margin: int = 0) -> dict[int, list[Cell]]:
    """The characters of a panel by row, each with the role that colours it: the last in the order.

    With so many columns of margin beside it, and the rows -1 and `high` where arrows stand in them.
    """
    bits = [[0] * raster.wide for _ in range(raster.high)]
    blank: list[Cell] = [(" ", None)] * (raster.wide + 2 * margin)
    cells = {level: [*blank] for level in range(raster.high)}
    for stroke in sorted(panel.strokes, key=lambda stroke: _ORDER.index(stroke.role)):
        for x, y in _dots(stroke, raster):
            row, column = y // 4, x // 2
            bits[row][column] |= _BITS[y % 4][x % 2]
            cells[row][margin + column] = chr(_BLANK + bits[row][column]), stroke.role
    sides = {_side(mark) for mark in panel.marks} - {0} if margin else set()
    cells |= {-1 if side > 0 else raster.high: [*blank] for side in sides}
    for row, column, label in _labels(panel.marks, raster, margin, cells):
        cells[row][column : column + len(label)] = label
    for word in panel.words:
        x, y = raster.cell(*raster.fine(word.at))
        text = _in_cell(word, int(word.room / 2 * raster.wide) - 2)
        column = margin + x // 2 - len(text) // 2
        cells[y // 4][column : column + len(text)] = [(letter, word.role) for letter in text]
    return cells


def _in_cell(word: Word, room: int) -> str:
    """A word as far as there is room, and behind it the sign of answers."""
    text, sign = printable(word.text), LETTERS.get(word.role, "")
    room = max(1, room - len(sign))
    return f"{text if len(text) <= room else text[: room - 1] + '…'}{sign}"


def _labels(
    marks: Sequence[Mark], raster: Raster, margin: int, cells: dict[int, list[Cell]]
) -> Iterator[tuple[int, int, list[Cell]]]:
    """The letters of all marks: in their place, or next to it where that is taken."""
    places: dict[tuple[int, int, bool], list[Mark]] = {}
    for mark in sorted(marks, key=lambda mark: _ORDER.index(mark.role)):
        if mark.sign or mark.role in LETTERS:
            x, y = raster.cell(*raster.fine(mark.at))
            row, column = y // 4, margin + x // 2
            if mark.towards is not None and margin:
                side = _side(mark)
                row = row if not side else -1 if side > 0 else raster.high
                column = column if side else margin + raster.wide if mark.at[0] > 0 else margin - 1
            places.setdefault((row, column, mark.towards is not None), []).append(mark)
    taken = {(row, column) for row, column, _ in places}
    for (row, column, outside), found in places.items():
        label = _label(found)
        for at, start in _near(row, column, len(label), outside=outside):
            own = {(at, start + step) for step in range(len(label))}
            if 0 <= start <= len(cells[0]) - len(label) and at in cells and not own & taken - {(row, column)}:
                taken |= own
                yield at, start, label
                break


def _near(row: int, column: int, length: int, *, outside: bool) -> Iterator[tuple[int, int]]:
    """Where a label may begin, the best place first: to the right, to the left, then a row up or down."""
    steps = sorted(range(-_AWAY, _AWAY + 1), key=abs)
    for shift in range(1 + _AWAY if outside else 2):
        for down in steps if shift else [0]:
            yield row + down, column + shift
            yield row + down, column - length + 1 - shift


def _label(marks: Sequence[Mark]) -> list[Cell]:
    """The letters of what meets in one place, the sign of answers behind them, and an arrow."""
    signs = [*dict.fromkeys(mark.sign for mark in marks if mark.sign and mark.role not in LETTERS)]
    comma = "," if any(len(sign) > 1 and not sign.isalpha() for sign in signs) else ""
    text = comma.join(signs[:_SIGNS]) + ("…" if len(signs) > _SIGNS else "")
    label: list[Cell] = [(letter, Role.CASE) for letter in text]
    roles = {mark.role for mark in marks} & {*LETTERS}
    if len(roles) == len(LETTERS):
        label.append(("*", Role.WANTED))
    elif roles:
        label += [(LETTERS[role], role) for role in roles]
    return [*label, *([(_arrow(marks[0]), label[-1][1])] if marks[0].towards else [])]


def _arrow(mark: Mark) -> str:
    x, y = mark.towards or (1.0, 0.0)
    return _ARROWS[round(atan2(y, x) / (pi / 4)) % 8]


def _dots(stroke: Stroke, raster: Raster) -> Iterator[tuple[int, int]]:
    """The dots of a stroke, those beyond a line's ends two on, two off."""
    travelled = 0
    for (x1, y1), (x2, y2) in pairwise(() if stroke.filled else map(raster.fine, stroke.dots)):
        steps = max(1, int(hypot(x2 - x1, y2 - y1) * 1.5))
        for i in range(steps + 1):
            travelled += 1
            if stroke.role is not Role.BEYOND or travelled % 8 < 3:
                yield raster.cell(x1 + (x2 - x1) * i / steps, y1 + (y2 - y1) * i / steps)


def pieces(cells: list[Cell]) -> list[Span]:
    """A row of characters, neighbours of one role together."""
    runs = groupby(cells, key=lambda cell: cell[1])
    return [Span("".join(letter for letter, _ in run), role) for role, run in runs]


def trimmed(row: list[Span]) -> list[Span]:
    """A row without spaces at its end."""
    while row and not row[-1].text.rstrip(" "):
        row = row[:-1]
    return [*row[:-1], Span(row[-1].text.rstrip(" "), row[-1].role)] if row else []
