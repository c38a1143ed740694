"""The smallest failing cases of hand-ins, for the pages that show them.

Looking for one takes about two seconds, so it is done only for what a page shows, and once for equal texts.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import PurePath

from msgspec.structs import replace

from judge.batch.model import Handin, Row
from judge.errors import JudgeError
from judge.judging.api import RunOptions
from judge.judging.session import Bars, Session, silent
from judge.problem import Problem, Verdict
from judge.report.published_klass import Cohort
from judge.run.result import Result

_BROKEN = (Verdict.WA, Verdict.RTE, Verdict.TLE, Verdict.MLE)


def representatives(cohort: Cohort, rows: Iterable[Row]) -> list[Row]:
    """For each mistake of each problem, the row of the first student who made it."""
    by_file = {(row.problem, row.file): row for row in rows}
    mistakes = [each for view in cohort.problems for each in view.mistakes]
    return [by_file[each.problem, each.files[0]] for each in mistakes]


def smallest_cases(
    rows: Sequence[Row],
    handins: Iterable[Handin],
    problems: Mapping[str, Problem],
    options: RunOptions = RunOptions(),  # noqa: B008 - frozen
    bars: Bars = silent,
) -> dict[tuple[str, str], Result]:
    """The result of each row, by problem and file, with its smallest case.

    One whose source or problem is not there, or that another verdict comes of now, is as it was.
    """
    sources = {each.file: each.source for each in handins if each.source}
    options = replace(options, timed=False, diagnosed=True)
    found: dict[tuple[str, str], Result] = {}
    for problem in dict.fromkeys(row.problem for row in rows):
        own = [row for row in rows if row.problem == problem]
        broken = [row for row in own if row.result.verdict in _BROKEN and row.file in sources]
        texts = {row.digest: row for row in broken}
        shrunk = _shrunk(problems[problem], texts, sources, options, bars) if problem in problems else {}
        for row in own:
            found[problem, row.file] = shrunk.get((row.digest, row.result.verdict), row.result)
    return found


def _shrunk(
    problem: Problem,
    texts: Mapping[str, Row],
    sources: Mapping[str, bytes],
    options: RunOptions,
    bars: Bars,
) -> dict[tuple[str, Verdict], Result]:
    """The results by digest and verdict, with the smallest failing cases."""
    found: dict[tuple[str, Verdict], Result] = {}
    if not texts:
        return found
    try:
        with bars(f"smallest cases of {problem.id}") as advance, Session(problem, options) as session:
            for done, (digest, row) in enumerate(texts.items()):
                if advance:
                    advance(done, len(texts))
                result = session.judge(sources[row.file], PurePath(row.file).name)
                found[digest, result.verdict] = result
    except JudgeError:  # the pages show the failing cases as they are
        return found
    return found
