"""Pictures: a failing case, the figure of a statement; as rows of a terminal."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from rich.console import Group, RenderableType
from rich.text import Text

from judge.drawing import Picture
from judge.drawing.braille import LEAST_COLUMNS, ROWS, to_braille
from judge.drawing.shapes import Role
from judge.errors import JudgeError, told
from judge.problem import Problem
from judge.problem.declare import InvalidCase, Shown
from judge.problem.model import EXAMPLES, case_of
from judge.problem.module import Module, load_module
from judge.report.parts import FIGURE, blocks, indented, prose
from judge.report.screen import Screen, drawn, is_terminal, note
from judge.report.tell import shown_failure
from judge.run.result import Failure
from judge.values import show
from judge.values.answers import within

if TYPE_CHECKING:
    from judge.report.published_result import RunReport

Drawing = Callable[[int], list[Text]]  # a picture in about so many rows
INDENT = 4  # columns beside a drawing at most
_COLOURS = {None: "", Role.WANTED: "green", Role.GOT: "red", Role.CASE: "bold", Role.BEYOND: "dim"}


def has_room(screen: Screen) -> bool:
    """Whether a drawing can be read there: a terminal that is wide enough and knows the characters."""
    try:
        "\u28ff".encode(getattr(screen.stream, "encoding", None) or "utf-8")
    except UnicodeEncodeError:
        return False
    return is_terminal(screen.stream) and screen.width is not None and screen.width >= LEAST_COLUMNS + INDENT


def picture_rows(picture: Picture, screen: Screen, rows: int = ROWS, *, answered: bool = True) -> list[Text]:
    """The drawing in about so many rows, coloured by what is expected and what was given."""
    pieces = to_braille(picture, rows, (screen.width or 0) - INDENT, answered=answered)
    return [Text.assemble(*((each.text, _COLOURS.get(each.role, "")) for each in row)) for row in pieces]


def drawing(make: Callable[[], Picture | None], screen: Screen, what: str) -> tuple[str, Drawing | None]:
    """What the picture turns on, and what draws it in about so many rows.

    None where there is none, no room on the screen, or a fault in it, of which a note is made.
    """
    try:
        picture = make()
    except Exception as fault:  # what is known without it is worth more
        note(f"{what} is not drawn: {told(fault)}")
        return "", None
    if picture is None:
        return "", None
    return picture.why, partial(picture_rows, picture, screen) if has_room(screen) else None


def result_picture(found: RunReport) -> Picture | None:
    """The failing case that is shown; None where there is nothing to draw."""
    failure, shown = found.result.failure, shown_failure(found.result)
    if failure is None or shown is None or found.data is None:
        return None
    return case_picture(found.data.problem, found.data.module, shown, failure.group)


def figure(problem: Problem) -> str | None:
    """The SVG of a statement; None where the problem draws none of its examples."""
    from judge.drawing.svg import panel_svg

    found = example_picture(problem)
    return panel_svg(found.whole, "figure", found.description, alone=True) + "\n" if found else None


def example_picture(problem: Problem) -> Picture | None:
    """The first example that the problem draws, with its answer; None where it draws none."""
    module = load_module(problem)
    for example in problem.examples:
        wanted = str(show.exact_text(module.solve(*example.case)))
        case = Failure("", input=problem.named(example.case), expected=wanted)
        picture = case_picture(problem, module, case, EXAMPLES)
        if picture is not None:
            return picture
    return None


def statement(problem: Problem, screen: Screen, *, titled: bool = True) -> RenderableType:
    """The statement, on a terminal with its figure; its title may be left out."""
    whole = problem.statement if titled else problem.statement.partition("\n")[2].lstrip("\n")
    before, *after = FIGURE.split(whole, 1)
    figured = after and has_room(screen)
    _, rows = drawing(partial(example_picture, problem), screen, "the figure") if figured else ("", None)
    if rows is None:
        return prose(whole, screen)
    rest = Text.from_ansi(drawn(prose(after[0], screen), screen).strip("\n"))  # a list begins with a blank
    return blocks(prose(before, screen), indented(Group(*rows(ROWS))), rest)


def case_picture(problem: Problem, module: Module, failure: Failure, group: str | None) -> Picture | None:
    """A failing case of a test group, drawn with both answers.

    None where the kata draws no such case, or it is none of its cases any more.
    """
    from judge.data.build import validate

    draw, values = module.hooks.picture, failure.input
    named = [each.name for each in problem.parameters]
    if not draw or not values or [*values] != named or not problem.group(group or ""):
        return None
    try:
        exact = within(validate(problem, module, case_of(values)), group or "")
    except (InvalidCase, JudgeError):
        return None
    return draw(Shown(problem, values, exact, failure.expected, failure.got, failure.given))
