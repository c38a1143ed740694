"""The smallest failing cases of hand-ins, for the pages that show them.

Looking for one takes about two seconds, so it is done only for what a page shows, once for equal texts, and
kept.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from pathlib import PurePath

from msgspec.structs import replace

from judge.batch.model import Handin, Row
from judge.errors import JudgeError
from judge.judging.options import RunOptions
from judge.judging.session import Bars, Session
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
    options: RunOptions,
    bars: Bars,
    keep: Callable[[list[Row]], None],
) -> dict[tuple[str, str], Result]:
    """The result of each row, by problem and file, with its smallest case; `handins` are those of the rows.

    `keep` is handed the rows that have a smallest case now. One whose problem is not there, or that another
    verdict comes of now, is as it was.
    """
    found = {(row.problem, row.file): row.result for row in rows}
    sources = {each.file: each.source for each in handins}
    options = replace(options, timed=False, diagnosed=True)
    for problem in problems.values():
        broken = [row for row in rows if row.problem == problem.id and row.result.verdict in _BROKEN]
        small = {row.digest: row.smallest for row in broken if row.smallest}
        texts = {row.digest: row for row in broken if row.digest not in small}
        if texts:
            with (
                suppress(JudgeError),  # then the pages show the failing cases as they are
                bars(f"smallest cases of {problem.id}") as advance,
                Session(problem, options) as session,
            ):
                for done, (digest, row) in enumerate(texts.items()):
                    if advance:
                        advance(done, len(texts))
                    result = session.judge(sources[row.file], PurePath(row.file).name)
                    if result.verdict is row.result.verdict:
                        small[digest], plain = result, result.as_json()
                        keep([replace(each, small=plain) for each in broken if each.digest == digest])
        found |= {(row.problem, row.file): small[row.digest] for row in broken if row.digest in small}
    return found
