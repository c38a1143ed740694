"""The smallest failing cases of submissions, for the pages that show them.

Looking for one takes seconds, so it is done only for what a page shows, once for equal texts, and kept.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from pathlib import PurePath

from msgspec.structs import replace

from judge.batch.model import KeptRow
from judge.batch.store import ResultStore
from judge.errors import JudgeError
from judge.judging.options import RunOptions
from judge.judging.session import Session
from judge.problem import Problem, Verdict
from judge.report.published_klass import Cohort
from judge.report.wait import progress
from judge.run.result import Result

_BROKEN = (Verdict.WA, Verdict.RTE, Verdict.TLE, Verdict.MLE)


def samples(cohort: Cohort, rows: Iterable[KeptRow]) -> list[KeptRow]:
    """For each mistake of each problem, the row of the first student who made it."""
    by_file = {(row.problem, row.file): row for row in rows}
    mistakes = [each for view in cohort.problems for each in view.mistakes]
    return [by_file[each.problem, each.files[0]] for each in mistakes]


class SmallestCases:
    """Finds the smallest failing case of each text of these `problems` once, and keeps it in the `store`."""

    def __init__(self, problems: Mapping[str, Problem], options: RunOptions, store: ResultStore) -> None:
        self._problems, self._store = problems, store
        self._options = replace(options, timed=False, diagnosed=True)
        self._found: dict[tuple[str, str], Result | None] = {}  # by problem and digest

    def of(self, rows: Sequence[KeptRow], sources: Mapping[str, bytes]) -> dict[tuple[str, str], Result]:
        """The result of each row, by problem and file, with its smallest case; `sources` are by file. One
        whose problem is not there, or that another verdict comes of now, is as it was.
        """
        found = {(row.problem, row.file): row.result for row in rows}
        broken = [each for each in rows if each.result.verdict in _BROKEN and each.problem in self._problems]
        with progress("smallest failing cases") as advance:
            for done, row in enumerate(broken):
                if advance:
                    advance(done, len(broken))
                if small := row.smallest or self._sought(row, sources[row.file]):
                    found[row.problem, row.file] = small
        return found

    def _sought(self, row: KeptRow, source: bytes) -> Result | None:
        """It is kept, also that there is none where the text has another verdict now; None on a fault."""
        text = row.problem, row.digest
        if text not in self._found:
            self._found[text] = None
            with suppress(JudgeError), Session(self._problems[row.problem], self._options) as session:
                self._found[text] = session.judge(source, PurePath(row.file).name)
        small = self._found[text]
        if small is None:
            return None
        if small.verdict is not row.result.verdict:
            small = row.result
        self._store.keep_all([replace(row, small=small.as_json())])
        return small
