"""Of every mistake in a class one hand-in, with the smallest case that breaks it.

Looking for that case takes about two seconds, so it is done for these alone, and only where a page shows it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import PurePath

from msgspec.structs import replace

from judge.batch.model import Handin, Row
from judge.errors import JudgeError
from judge.judging.job import RunOptions
from judge.judging.naming import Bars
from judge.judging.session import Session, silent
from judge.problem import Problem, Verdict
from judge.report.cohort.parts import Cohort, Example
from judge.run.result import Result

_BROKEN = (Verdict.WA, Verdict.RTE, Verdict.TLE, Verdict.MLE)


def representatives(cohort: Cohort, rows: Iterable[Row]) -> list[Row]:
    """A row for each bar of each problem, in their order: that of its first student."""
    by_file = {(row.problem, row.file): row for row in rows}
    found = []
    for view in cohort.views:
        for bar in view.mistakes:
            counted = cohort.marks[bar.students[0], view.problem]
            found.append(by_file[view.problem, counted.file])
    return found


def examples(
    rows: Sequence[Row],
    handins: Iterable[Handin],
    problems: Mapping[str, Problem],
    options: RunOptions = RunOptions(),  # noqa: B008 - frozen
    bars: Bars = silent,
) -> Iterator[Example]:
    """What each of these rows shows, shrunk where its source and its problem are there.

    One that cannot be judged again, or that another verdict comes of now, is shown as it was.
    """
    sources = {each.file: each.source for each in handins if each.source}
    options = replace(options, timed=False, diagnosed=True)
    for problem in dict.fromkeys(row.problem for row in rows):
        own = [row for row in rows if row.problem == problem]
        wanted = [row for row in own if Verdict(row.verdict) in _BROKEN and row.file in sources]
        shrunk = _shrunk(problems[problem], wanted, sources, options, bars) if problem in problems else {}
        for row in own:
            yield Example(problem, row.mistake or row.verdict, row.file, shrunk.get(row.file, row.result))


def _shrunk(
    problem: Problem, rows: Sequence[Row], sources: Mapping[str, bytes], options: RunOptions, bars: Bars
) -> dict[str, Result]:
    """By the files of these rows: the result with the smallest case."""
    found: dict[str, Result] = {}
    if not rows:
        return found
    try:
        with bars(f"smallest cases of {problem.id}") as advance, Session(problem, options) as session:
            for done, row in enumerate(rows):
                if advance:
                    advance(done, len(rows))
                result = session.judge(sources[row.file], PurePath(row.file).name)
                if result.verdict.value == row.verdict:
                    found[row.file] = result
    except JudgeError:  # the page shows the failing cases as they are
        return found
    return found
