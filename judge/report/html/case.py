"""A failing case as a page or a notebook shows it; its kata may have changed since, or be gone."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress

from msgspec import Struct

from judge.drawing import Picture
from judge.drawing.svg import panel_svg, style
from judge.errors import JudgeError
from judge.problem import Problem
from judge.problem.find import find_problem
from judge.problem.module import Module, load_module
from judge.report.html import rendered
from judge.report.picture import case_picture
from judge.report.tell import shown_failure, tell
from judge.report.words import shown_name
from judge.run.result import Result

_LONGEST = 2000  # characters of a submission's own words that are shown


class Drawing(Struct, frozen=True):
    """One panel of a picture, as an SVG element, with its heading and its note."""

    svg: str
    title: str
    note: str


class ShownCase(Struct, frozen=True):
    """A failing case. `place` says which one it is, `advice` what is wrong, by each of its mistakes."""

    anchor: str
    title: str
    place: str = ""
    facts: tuple[tuple[str, str], ...] = ()  # label and text
    drawings: tuple[Drawing, ...] = ()
    advice: tuple[str, ...] = ()


class ShownCases:
    """Tells failing cases of these katas, by id. A kata's code is loaded with the first case drawn of it."""

    def __init__(self, problems: Mapping[str, Problem]) -> None:
        self.problems = problems
        self._modules: dict[str, Module] = {}

    def tell(self, problem: str, mistake: str, result: Result, anchor: str) -> ShownCase:
        """The smallest failing case of a result, or else its first one.

        `mistake` is its name, two as "a + b", or empty. `anchor` is the id of the case in its page.
        """
        known = self.problems.get(problem)
        where = f", {result.failure.group}" if result.failure and result.failure.group else ""
        title = mistake or f"{result.verdict.meaning}{where}".capitalize()
        with suppress(ValueError, TypeError):  # it has other parameters now
            result = result.typed(known) if known else result
        picture = self.picture(known, result)
        told = tell(known, result, why=picture.why if picture else "")
        facts = (("input", ", ".join(told.input)), *told.facts, ("why", told.happened))
        said = tuple((label, _cut(text)) for label, text in facts if text)
        return ShownCase(anchor, title, told.case, said, _drawings(picture, anchor), told.advice)

    def picture(self, problem: Problem | None, result: Result) -> Picture | None:
        """The failing case, where the kata is there and draws it."""
        shown = shown_failure(result)
        if problem is None or shown is None or result.failure is None:
            return None
        with suppress(JudgeError):
            module = self._modules[problem.id] = self._modules.get(problem.id) or load_module(problem)
            return case_picture(problem, module, shown, result.failure.group)
        return None


def _drawings(picture: Picture | None, anchor: str) -> tuple[Drawing, ...]:
    """The panels of a picture."""
    if picture is None:
        return ()
    return tuple(
        Drawing(panel_svg(panel, f"{anchor}-{name}", picture.description), panel.title, panel.note)
        for panel, name in zip(picture.panels, ("whole", "lens"), strict=False)
    )


def _cut(text: str) -> str:
    return text if len(text) <= _LONGEST else text[: _LONGEST - 1] + "…"


def notebook(result: Result) -> str:
    """A result as an element of HTML with its own style sheet; without a drawing if its kata is not found."""
    told, anchor, picture = tell(None, result), f"judge-{id(result):x}", None
    with suppress(JudgeError):
        picture = ShownCases({}).picture(find_problem(result.problem), result)
    return rendered(
        "notebook.html.j2",
        anchor=anchor,
        style=style(f"#{anchor} figure"),
        head=f"{told.verdict.value}  {told.meaning}  {shown_name(result.submission)}  {told.stars}".rstrip(),
        text="\n".join((*told.lines, told.last)),
        drawings=_drawings(picture, anchor),
    ).decode()
