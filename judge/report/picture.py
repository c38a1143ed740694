"""The failing case drawn on a terminal, or how the time grows."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from judge.drawing import Picture
from judge.drawing.braille import COLUMNS, ROWS, to_braille
from judge.drawing.braille import LEAST_ROWS as LEAST_ROWS
from judge.drawing.chart import Axis, Chart, Series, chart_braille
from judge.drawing.shapes import Role
from judge.report.layout import Line, Span, Style, line
from judge.report.screen import Screen, is_terminal
from judge.report.values import seconds
from judge.run.result import Growth

if TYPE_CHECKING:
    from rich.text import Text

_RICH = {Style.GOOD: "green", Style.BAD: "red", Style.STRONG: "bold", Style.FAINT: "dim"}
_STYLES = {
    Role.WANTED: Style.GOOD,
    Role.GOT: Style.BAD,
    Role.CASE: Style.STRONG,
    Role.BEYOND: Style.FAINT,
}


def has_room(screen: Screen, columns: int = COLUMNS) -> bool:
    """Whether a drawing can be read there: a terminal that is wide enough and knows the characters."""
    wide = screen.width is not None and screen.width >= columns
    return is_terminal(screen.stream) and wide and writes(screen, "\u28ff")


def writes(screen: Screen, text: str) -> bool:
    """Whether the screen's encoding has these characters."""
    try:
        text.encode(getattr(screen.stream, "encoding", None) or "utf-8")
    except UnicodeEncodeError:
        return False
    return True


def growth_chart(growth: Growth) -> Chart | None:
    """CPU time against n, of the reference and the submission; None if there are no two sizes."""
    points = sorted(growth.points, key=lambda point: point.size)
    if len({point.size for point in points}) < 2:
        return None
    reference = tuple((float(each.size), each.reference_seconds) for each in points)
    own = tuple((float(each.size), each.cpu_seconds) for each in points)
    stopped = frozenset(float(each.size) for each in points if not each.ended)
    title = "How the time of a case grows"
    about = f"Your time grows like n^{growth.exponent:.1f}, the reference's like n^{growth.reference:.1f}."
    series = (Series("reference", reference, Role.WANTED), Series("yours", own, Role.GOT, stopped))
    return Chart(title, series, Axis("n", log=True), Axis("CPU time", seconds, log=True), about)


def picture_lines(
    picture: Picture | Chart, rows: int | None = None, *, answered: bool = True
) -> Iterator[Line]:
    """The drawing in about so many rows, coloured by what is expected and what was given."""
    rows = ROWS if rows is None else rows
    if isinstance(picture, Chart):
        drawn = chart_braille(picture, rows)
    else:
        drawn = to_braille(picture, rows, answered=answered)
    for row in drawn:
        yield line(*(Span(piece.text, _style(piece.role)) for piece in row))


def _style(role: Role | None) -> Style:
    return _STYLES.get(role, Style.PLAIN) if role else Style.PLAIN


def picture_rows(picture: Picture | Chart, rows: int) -> list[Text]:
    """The same for a view."""
    from rich.text import Text

    return [
        Text.assemble(*((span.text, _RICH.get(span.style, "")) for span in row))
        for row in picture_lines(picture, rows)
    ]
