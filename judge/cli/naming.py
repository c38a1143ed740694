"""Naming the mistake after a wrong answer: what `judge run` does with `judge.diagnose`."""

from __future__ import annotations

import os
import threading
from contextlib import nullcontext
from typing import TYPE_CHECKING

from judge.data import ProblemData
from judge.errors import told
from judge.problem import Verdict
from judge.report.progress import progress
from judge.report.screen import note
from judge.run import Result, Settings

if TYPE_CHECKING:
    from judge.diagnose import Namer

_MOST_AT_ONCE = 4  # of the known-wrong programs, where nobody said how many


class Naming:
    """Adds the mistake's name to results; what it needs is imported with the first wrong answer."""

    def __init__(self, data: ProblemData, seed: int | None, settings: Settings, jobs: int) -> None:
        self._data = data
        self._seed = seed
        self._settings = settings
        self._jobs = jobs
        self._lock = threading.Lock()
        self._namer: Namer | None = None

    def named(self, result: Result) -> Result:
        """The result with its pitfall where there is one; what goes wrong with that is only a note."""
        if result.verdict not in (Verdict.WA, Verdict.RTE):
            return result
        namer = self._ready()
        try:
            result = namer.named(result)
        except Exception as fault:  # the verdict is known, and worth more
            note(f"the mistake is not named: {told(fault)}")
        with self._lock:
            notes, namer.notes = namer.notes, []
        for text in notes:
            note(text)
        return result

    def _ready(self) -> Namer:
        from judge.diagnose import Namer

        with self._lock:
            if self._namer is None:
                workers = self._jobs if self._jobs > 1 else min(_MOST_AT_ONCE, os.cpu_count() or 1)
                label = f"learning the mistakes of {self._data.problem.id}"
                # With several submissions at once results are written meanwhile, which a bar would garble.
                self._namer = Namer(
                    self._data,
                    self._seed,
                    self._settings,
                    workers,
                    lambda: progress(label) if self._jobs == 1 else nullcontext(),
                )
            return self._namer
