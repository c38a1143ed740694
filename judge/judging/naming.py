"""Naming the mistake after a wrong answer, with what `judge.mistakes` knows of the problem."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager, suppress
from functools import partial
from typing import TYPE_CHECKING

from msgspec.structs import replace

from judge.data.load import ProblemData
from judge.errors import told
from judge.problem import Verdict
from judge.run.result import Behaviour, Result
from judge.run.settings import Progress, Settings

if TYPE_CHECKING:
    from judge.mistakes.namer import Namer

Bars = Callable[[str], AbstractContextManager[Progress | None]]  # opens a bar for work of that label

NAMED = (Verdict.WA, Verdict.RTE)


class Naming:
    """Adds the mistake's name to results; what it needs is imported with the first wrong answer."""

    def __init__(self, data: ProblemData, seed: int | None, settings: Settings, bars: Bars) -> None:
        self._data = data
        self._seed = seed
        self._settings = settings
        self._bars = bars
        self._namer: Namer | None = None
        self._label = f"learning the mistakes of {data.problem.id}, once"

    def learn(self) -> None:
        """Find what the mistakes answer, and keep it; what goes wrong is told when it is needed."""
        with suppress(Exception):
            self._ready().learn()

    def named(self, result: Result, does: Behaviour, source: bytes) -> Result:
        """The result with its pitfall where there is one; what goes wrong with that is only a note.

        `does` is what the submission answered.
        """
        if result.verdict not in NAMED:
            return result
        # Whoever waits for the learning sees the verdict meanwhile.
        label = f"{result.verdict.value}  {result.submission}; {self._label}"
        namer = self._ready(label)
        try:
            result = namer.named(result, does, source, partial(self._fails_alone, source, result.submission))
        except Exception as fault:  # the verdict is known, and worth more
            result = result.noting(f"the mistake is not named: {told(fault)}")
        notes, namer.notes = namer.notes, []
        return result.noting(*notes)

    def _fails_alone(self, source: bytes, name: str, group: str, case: int) -> bool:
        """Whether the submission fails one case when nothing was called before it."""
        from judge.run.execute import run_submission

        (data,) = [each for each in self._data.groups if each.group.name == group]
        one = replace(data, cases=[data.cases[case]], targets=[data.targets[case]])
        alone = ProblemData(self._data.problem, (one,))
        settings = replace(self._settings, measured=False)
        return run_submission(alone.problem, alone, source, name, settings=settings).verdict is not Verdict.AC

    def _ready(self, label: str = "") -> Namer:
        from judge.mistakes.namer import Namer

        if self._namer is None:
            bar = partial(self._bars, label or self._label)
            self._namer = Namer(self._data, self._seed, self._settings, bar)
        return self._namer
