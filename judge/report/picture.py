"""The failing case drawn on a terminal."""

from __future__ import annotations

from collections.abc import Iterator

from judge.drawing import Picture
from judge.drawing.braille import COLUMNS, ROWS, to_braille
from judge.drawing.braille import LEAST_ROWS as LEAST_ROWS
from judge.drawing.shapes import Role
from judge.report.layout import Line, Span, Style, line
from judge.report.screen import Screen, is_terminal

_STYLES = {
    Role.WANTED: Style.GOOD,
    Role.GOT: Style.BAD,
    Role.CASE: Style.STRONG,
    Role.BEYOND: Style.FAINT,
}


def has_room(screen: Screen, columns: int = COLUMNS) -> bool:
    """Whether a drawing can be read there: a terminal that is wide enough and knows the characters."""
    if not is_terminal(screen.stream) or screen.width is None or screen.width < columns:
        return False
    try:
        "\u28ff".encode(getattr(screen.stream, "encoding", None) or "utf-8")
    except UnicodeEncodeError:
        return False
    return True


def picture_lines(picture: Picture, rows: int | None = None, *, answered: bool = True) -> Iterator[Line]:
    """The drawing in about so many rows, coloured by what is wanted and what was given."""
    for row in to_braille(picture, ROWS if rows is None else rows, answered=answered):
        yield line(*(Span(piece.text, _style(piece.role)) for piece in row))


def _style(role: Role | None) -> Style:
    return _STYLES.get(role, Style.PLAIN) if role else Style.PLAIN
