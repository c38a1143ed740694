"""How a person stands with each problem: not begun, tried, or passed."""

from __future__ import annotations

from collections.abc import Iterable
from datetime import datetime
from enum import Enum

from msgspec import Struct

from judge.kata.events import Run


class State(Enum):
    """How far a problem has come; the value is its name in JSON."""

    NEW = "new"
    TRIED = "tried"
    PASSED = "passed"


class Standing(Struct, frozen=True):
    """One problem's runs in short.

    `attempts` are the runs up to the first that passed, that one included, or all of them where none did.
    `best` is the highest score.
    """

    attempts: int = 0
    best: int = 0
    passed: datetime | None = None  # first
    last: datetime | None = None

    @property
    def state(self) -> State:
        """How far the problem has come."""
        if self.passed is not None:
            return State.PASSED
        return State.TRIED if self.attempts else State.NEW

    def after(self, run: Run) -> Standing:
        """The standing once that run is done."""
        if not run.counts:
            return self
        return Standing(
            self.attempts + (self.passed is None),
            max(self.best, run.score),
            self.passed or (run.when if run.solved else None),
            run.when,
        )


def standings(runs: Iterable[Run]) -> dict[str, Standing]:
    """The standing of every problem that was ever run; `runs` are in their order."""
    found: dict[str, Standing] = {}
    for run in runs:
        found[run.problem] = found.get(run.problem, Standing()).after(run)
    return found
