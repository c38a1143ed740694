"""The failing cases worth showing: of every mistake made on a problem the latest one, with its picture."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from datetime import datetime

from judge.kata.events import Run
from judge.kata.progress import mistake_names
from judge.problem import Problem, Verdict
from judge.report.page.parts import Explained, FailingCase
from judge.report.page.record import read_record
from judge.report.page.told import Artist, kind_title, told_case

MOST = 12  # kinds of failure of one problem

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
    artist = Artist(problem)
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
    artist: Artist,
    advice: Mapping[str, str],
) -> FailingCase:
    told = told_case(read_record(run), run.submission, artist, anchor)
    return FailingCase(
        anchor=anchor,
        title=run.mistake or kind_title(run.verdict, told.group),
        number=run.id,
        when=run.when,
        verdict=run.verdict,
        times=times,
        overcome=solved,
        kind=told.kind,
        facts=told.facts,
        drawings=told.drawings,
        marks=told.marks,
        explained=tuple(Explained(name, advice[name]) for name in mistake_names(run) if name in advice),
    )
