"""A run's result read back for the page; the problem may have changed since."""

from __future__ import annotations

from judge.errors import HistoryError
from judge.kata.history import Run
from judge.run.result import Result


def read_record(run: Run) -> Result:
    """What was kept of a run; of a result that is damaged, its verdict alone."""
    try:
        return run.result
    except HistoryError:
        return Result(problem=run.problem, submission=run.submission, verdict=run.verdict)
