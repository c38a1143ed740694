"""A failing case as a page shows it, from a kept result; its kata may have changed since, or be gone."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from msgspec import Struct

from judge.data.build import validate
from judge.drawing import Picture
from judge.drawing.svg import panel_svg
from judge.errors import JudgeError
from judge.mistakes.told import told_mistakes
from judge.problem import Problem, Verdict
from judge.problem.declare import InvalidCase, Shown
from judge.problem.model import case_of
from judge.problem.module import Module, load_module
from judge.report.words import arguments, with_points
from judge.run.result import Failure, Result
from judge.values import parameters

_LONGEST = 2000  # characters of a submission's own words that are shown


class Drawing(Struct, frozen=True):
    """One panel of a picture, as an SVG element, with its heading and its note."""

    svg: str
    title: str
    note: str


class Case(Struct, frozen=True):
    """A failing case. `place` says which one it is, `advice` explains each of its mistakes by name."""

    anchor: str
    title: str
    verdict: Verdict
    place: str
    facts: tuple[tuple[str, str], ...]  # label and text
    drawings: tuple[Drawing, ...]
    advice: tuple[tuple[str, str], ...]


class Cases:
    """Tells failing cases of these katas, by id. A kata's code is loaded with the first case drawn of it."""

    def __init__(self, problems: Mapping[str, Problem]) -> None:
        self.problems = problems
        self._modules: dict[str, Module] = {}
        self._advice: dict[str, dict[str, str]] = {}

    def tell(self, problem: str, verdict: Verdict, mistake: str, result: Result | None, anchor: str) -> Case:
        """The smallest failing case of a result, or else its first one; of none, no case.

        `mistake` is its name, two as "a + b", or empty. `anchor` is the id of the case in its page.
        """
        first = (result and result.failure) or Failure("")
        small = result.counterexample if result else None
        smallest = small is not None and bool(small.replay)
        shown = small if small is not None and smallest else first
        place = f"{first.group}, case {first.case}" if first.group and first.case else ""
        where = f"{verdict.meaning}, {first.group}" if first.group else verdict.meaning
        picture = self._picture(problem, shown, first.group)
        named = [(name, self._advice_of(problem).get(name, "")) for name in mistake.split(" + ")]
        return Case(
            anchor=anchor,
            title=mistake or where.capitalize(),
            verdict=verdict,
            place="Smallest failing case" if smallest else place,
            facts=tuple((label, _cut(text)) for label, text in self._facts(problem, shown, first)),
            drawings=tuple(_drawings(picture, anchor)) if picture else (),
            advice=tuple(each for each in named if each[1]),
        )

    def _advice_of(self, problem: str) -> dict[str, str]:
        if problem in self.problems and problem not in self._advice:
            told = told_mistakes(self.problems[problem])
            self._advice[problem] = {name: each.advice for name, each in told.items()}
        return self._advice.get(problem, {})

    def _facts(self, problem: str, shown: Failure, first: Failure) -> Iterator[tuple[str, str]]:
        if shown.input:
            yield "input", arguments(self._as_called(problem, shown.input))
        if shown.input is not None and shown.expected is not None:
            yield "expected", shown.expected
            yield "got", shown.got or "no answer"
        if shown.printed:
            yield "printed", shown.printed
        why, answers = shown.message or first.message, (shown.expected, shown.got)
        if why and not all(each and each in why for each in answers):
            yield "why", why

    def _as_called(self, problem: str, values: dict[str, Any]) -> Mapping[str, Any]:
        """The arguments with lists and tuples as their types have them; as they look if the kata changed."""
        known = self.problems.get(problem)
        if known and list(values) == [each.name for each in known.parameters]:
            typed = zip(known.parameters, case_of(values), strict=True)
            if all(parameters.fault(each.type, each.name, value) is None for each, value in typed):
                return known.named(case_of(values))
        return with_points(values)

    def _picture(self, problem: str, case: Failure, group: str | None) -> Picture | None:
        """The picture of a case that is still valid; None for any other."""
        known = self.problems.get(problem)
        if not (known and group and known.group(group) and case.input):
            return None
        if list(case.input) != [parameter.name for parameter in known.parameters]:
            return None
        try:
            module = self._modules.get(problem) or load_module(known)
            self._modules[problem] = module
            exact = validate(known, module, case_of(case.input))
        except (InvalidCase, JudgeError):  # the kata is another now, or broken
            return None
        if module.hooks.picture is None:
            return None
        shown = Shown(known, case.input, exact, case.expected, case.got, case.given)
        return module.hooks.picture(shown)


def _cut(text: str) -> str:
    return text if len(text) <= _LONGEST else text[: _LONGEST - 1] + "…"


def _drawings(picture: Picture, anchor: str) -> Iterator[Drawing]:
    for panel, name in zip(picture.panels, ("whole", "lens"), strict=False):
        yield Drawing(panel_svg(panel, f"{anchor}-{name}", picture.description), panel.title, panel.note)
