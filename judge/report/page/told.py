"""One failing case in words and pictures, from a published result; the problem may have changed since."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from msgspec import Struct

from judge.data.validate import Validator
from judge.drawing import Picture
from judge.drawing.shapes import Role
from judge.drawing.svg import panel_svg
from judge.errors import JudgeError
from judge.problem import Problem, Verdict
from judge.problem.declare import Shown
from judge.problem.model import case_of
from judge.problem.module import Module, load_module
from judge.report.names import shown_command
from judge.report.page.parts import Drawing
from judge.report.page.reread import reread
from judge.report.values import arguments, with_points
from judge.run.result import Failure, Result
from judge.values import parameters

_LONGEST = 2000  # characters of a submission's own words that are shown


class ToldCase(Struct, frozen=True):
    """The smallest failing case of a result, or else its first one.

    `kind` says which it is, `group` where it failed first. The rest is as of FailingCase.
    """

    kind: str
    group: str | None
    facts: tuple[tuple[str, str, str], ...]
    drawings: tuple[Drawing, ...]
    marks: tuple[str, ...]


def told_case(record: Result, file: str, artist: Artist, anchor: str) -> ToldCase:
    """The failing case of a submission called `file`; `anchor` begins the ids within its drawings."""
    first, small = record.failure or Failure(""), record.counterexample
    smallest = small is not None and small.replay is not None
    shown = small if small is not None and smallest else first
    picture = artist.picture(shown, first.group)
    return ToldCase(
        kind=_kind(first, smallest=smallest),
        group=first.group,
        facts=tuple(_facts(file, shown, first, small, artist.problem)),
        drawings=tuple(_drawings(picture, anchor)) if picture else (),
        marks=_marks(picture) if picture else (),
    )


def kind_title(verdict: Verdict, group: str | None) -> str:
    """What a failure without a mistake's name is called."""
    where = f" in {group}" if group else ""
    return f"{verdict.meaning}{where}".capitalize()


def _kind(first: Failure, *, smallest: bool) -> str:
    place = f"{first.group}, case {first.case}" if first.group and first.case else ""
    if smallest:
        return f"Smallest case found (first failed: {place})" if place else "Smallest case found"
    return place


def _facts(
    file: str, shown: Failure, first: Failure, small: Failure | None, problem: Problem | None
) -> Iterable[tuple[str, str, str]]:
    if shown.input:
        yield "input", arguments(_as_called(problem, shown.input)), "code"
    if shown.expected is not None and shown.input:
        yield "wanted", _cut(shown.expected), "wanted"
        yield "got", _cut(shown.got or "no answer"), "got"
    if shown.printed:
        yield "printed", _cut(shown.printed), "code"
    message = shown.message or first.message
    if message and message != f"{shown.expected} wanted, {shown.got} given":
        yield "why", _cut(message), ""
    if small is not None and small.replay is None:
        yield "note", _cut(small.message), ""
    if shown.replay:
        yield "again", shown_command("judge", "replay", shown.replay, file=file), "code"


def _as_called(problem: Problem | None, values: Mapping[str, Any]) -> Mapping[str, Any]:
    """The arguments with lists and tuples as their types have them; as they look if it has changed."""
    if problem is not None and list(values) == [parameter.name for parameter in problem.parameters]:
        case = case_of(values)
        typed = zip(problem.parameters, case, strict=True)
        if all(parameters.fault(parameter.type, parameter.name, value) is None for parameter, value in typed):
            return problem.named(case)
    return with_points(values)


def _cut(text: str) -> str:
    return text if len(text) <= _LONGEST else text[: _LONGEST - 1] + "…"


def _drawings(picture: Picture, anchor: str) -> Iterator[Drawing]:
    for panel, name in zip(picture.panels, ("whole", "lens"), strict=False):
        svg = panel_svg(panel, f"{anchor}-{name}", picture.description)
        yield Drawing(svg, panel.title, panel.note)


def _marks(picture: Picture) -> tuple[str, ...]:
    drawn = {mark.role for panel in picture.panels for mark in panel.marks}
    return tuple(role.value for role in (Role.WANTED, Role.GOT) if role in drawn)


class Artist:
    """Draws cases of one problem, which may be gone; its reference is loaded with the first of them."""

    def __init__(self, problem: Problem | None) -> None:
        self.problem = problem
        self._module: Module | None = None

    def picture(self, case: Failure, group: str | None) -> Picture | None:
        """The picture of a case, or None where there is none: the problem may have changed since."""
        problem = self.problem
        known = problem.group(group) if problem and group else None
        if problem is None or known is None or not case.input:
            return None
        names = [parameter.name for parameter in problem.parameters]
        if list(case.input) != names:
            return None
        values = case_of(case.input)
        try:
            if self._module is None:
                self._module = load_module(problem)
            draw = self._module.hooks.picture
            if draw is None:
                return None
            proof = Validator(problem, self._module.solve).proof(values)
            if proof.fault:
                return None
        except JudgeError:  # a problem that is broken now: its runs are told of all the same
            return None
        given = reread(problem.answer, case.got)
        return draw(Shown(problem, case.input, proof.answer, case.expected, case.got, given))
