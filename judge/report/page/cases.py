"""The failing cases worth showing: of every mistake made on a problem the latest one, with its picture."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from datetime import datetime
from typing import Any

from judge.data.module import ProblemModule, load_module
from judge.data.validate import Validator
from judge.drawing import Picture
from judge.drawing.shapes import Role
from judge.drawing.svg import panel_svg
from judge.errors import JudgeError
from judge.kata.history import Run
from judge.kata.skills import mistake_names
from judge.problem import Problem, Verdict
from judge.problem.model import case_of
from judge.problem.topic import Shown
from judge.report.names import shown_command
from judge.report.page.parts import Drawing, Explained, FailingCase
from judge.report.page.record import CaseRecord, read_record
from judge.report.values import arguments, with_points
from judge.values.reread import reread

MOST = 12  # kinds of failure of one problem
_LONGEST = 2000  # characters of a submission's own words that are shown

Kind = tuple[str, ...]


def kind_of(run: Run) -> Kind:
    """What a failed run has in common with others: its mistake, or else its verdict and its first group."""
    return ("mistake", run.mistake) if run.mistake else ("verdict", run.verdict.value, *run.failed[:1])


def anchors(part: str, runs: Sequence[Run]) -> dict[Kind, str]:
    """The kinds of failure shown of a problem's runs, latest first, each with its place in the page."""
    failed = (kind_of(run) for run in reversed(runs) if _failed(run))
    kinds = list(dict.fromkeys(failed))[:MOST]
    return {kind: f"{part}-case-{place}" for place, kind in enumerate(kinds, 1)}


def failing_cases(
    problem: Problem | None, runs: Sequence[Run], places: Mapping[Kind, str], advice: Mapping[str, str]
) -> Iterator[FailingCase]:
    """The latest run of every kind in `places`, of one problem's runs, oldest first.

    `advice` explains the mistakes by name. Without the problem, which may be gone, nothing is drawn.
    """
    times = Counter(kind_of(run) for run in runs if _failed(run))
    latest = {kind_of(run): run for run in runs if _failed(run)}
    artist = _Artist(problem)
    for kind, anchor in places.items():
        run = latest[kind]
        solved = next((each.when for each in runs if each.id > run.id and each.solved), None)
        yield _case(run, anchor, times[kind], solved, artist, advice)


def left_out(runs: Sequence[Run], places: Mapping[Kind, str]) -> int:
    """How many kinds of failure are not shown."""
    return len({kind_of(run) for run in runs if _failed(run)}) - len(places)


def _failed(run: Run) -> bool:
    return run.counts and run.verdict is not Verdict.AC


def _case(
    run: Run,
    anchor: str,
    times: int,
    solved: datetime | None,
    artist: _Artist,
    advice: Mapping[str, str],
) -> FailingCase:
    record = read_record(run)
    first, small = record.failure or CaseRecord(""), record.counterexample
    smallest = small is not None and small.replay is not None
    shown = small if small is not None and smallest else first
    picture = artist.picture(shown, first.group)
    return FailingCase(
        anchor=anchor,
        title=run.mistake or _title(run, first),
        number=run.id,
        when=run.when,
        verdict=run.verdict,
        times=times,
        overcome=solved,
        kind=_kind(first, smallest=smallest),
        facts=tuple(_facts(run, shown, first, small, artist.problem)),
        drawings=tuple(_drawings(picture, anchor)) if picture else (),
        marks=_marks(picture) if picture else (),
        explained=tuple(Explained(name, advice[name]) for name in mistake_names(run) if name in advice),
    )


def _title(run: Run, first: CaseRecord) -> str:
    group = f" in {first.group}" if first.group else ""
    return f"{run.verdict.meaning}{group}".capitalize()


def _kind(first: CaseRecord, *, smallest: bool) -> str:
    place = f"{first.group}, case {first.case}" if first.group and first.case else ""
    if smallest:
        return f"Smallest case found (first failed: {place})" if place else "Smallest case found"
    return place


def _facts(
    run: Run, shown: CaseRecord, first: CaseRecord, small: CaseRecord | None, problem: Problem | None
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
        yield "again", shown_command("judge", "replay", shown.replay, file=run.submission), "code"


def _as_called(problem: Problem | None, values: Mapping[str, Any]) -> Mapping[str, Any]:
    """The arguments with lists and tuples as their types have them; as they look if it has changed."""
    if problem is not None and list(values) == [parameter.name for parameter in problem.parameters]:
        case = case_of(values)
        typed = zip(problem.parameters, case, strict=True)
        if all(parameter.type.fault(parameter.name, value) is None for parameter, value in typed):
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


class _Artist:
    """Draws cases of one problem, which may be gone; its reference is loaded with the first of them."""

    def __init__(self, problem: Problem | None) -> None:
        self.problem = problem
        self._module: ProblemModule | None = None

    def picture(self, case: CaseRecord, group: str | None) -> Picture | None:
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
            draw = self._module.topic.picture
            if draw is None:
                return None
            proof = Validator(problem, self._module.solve).proof(values)
            if proof.fault:
                return None
        except JudgeError:  # a problem that is broken now: its runs are told of all the same
            return None
        given = reread(problem.answer, case.got)
        return draw(Shown(problem, case.input, proof.answer, case.expected, case.got, given))
