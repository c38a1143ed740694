"""Pictures: the failing case on a terminal, how the time grows, the figure of a statement."""

from __future__ import annotations

from typing import TYPE_CHECKING

from judge.drawing import Picture
from judge.drawing.braille import COLUMNS, ROWS, to_braille
from judge.drawing.braille import LEAST_ROWS as LEAST_ROWS
from judge.drawing.chart import Axis, Chart, Series, chart_braille
from judge.drawing.shapes import Role
from judge.problem import Problem
from judge.problem.declare import Shown
from judge.report.screen import Screen, is_terminal
from judge.report.words import seconds
from judge.run.result import Growth

if TYPE_CHECKING:
    from rich.text import Text

_COLOURS: dict[Role | None, str] = {
    Role.WANTED: "green",
    Role.GOT: "red",
    Role.CASE: "bold",
    Role.BEYOND: "dim",
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


def picture_rows(picture: Picture | Chart, rows: int = ROWS, *, answered: bool = True) -> list[Text]:
    """The drawing in about so many rows, coloured by what is expected and what was given."""
    from rich.text import Text

    if isinstance(picture, Chart):
        drawn = chart_braille(picture, rows)
    else:
        drawn = to_braille(picture, rows, answered=answered)
    return [Text.assemble(*((each.text, _COLOURS.get(each.role, "")) for each in row)) for row in drawn]


FIGURE = "figure.svg"


def figure(problem: Problem) -> str | None:
    """The SVG; None where the problem draws none of its examples."""
    from judge.drawing.svg import panel_svg
    from judge.problem.module import load_module
    from judge.values import show

    module = load_module(problem)
    draw = module.hooks.picture
    if draw is None:
        return None
    names = [parameter.name for parameter in problem.parameters]
    for example in problem.examples:
        values = dict(zip(names, example.case, strict=True))
        exact = module.solve(*example.case)
        picture = draw(Shown(problem, values, exact, str(show.exact_text(exact)), None, heading="example"))
        if picture is not None:
            return panel_svg(picture.whole, "figure", picture.description, alone=True) + "\n"
    return None
