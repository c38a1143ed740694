"""A submission in the worker of a browser's tab, in this very interpreter: the tab is its sandbox.

What a submission does for too long is ended by `TabWatch`, which counts the jumps and calls of the
submission's own code and leaves the worker whole. What spins inside one call of a built-in cannot be ended
from here: the page ends the worker then.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from time import perf_counter
from types import CodeType

from judge.judging.inprocess import InProcess, LimitPassed, Watch
from judge.sandbox.boundary import Limits, Stop

SPARE_SECONDS = 2.0  # beyond a limit, or twice it: Python is slower in a tab, and slower when it is watched
_TOOL = 4  # of sys.monitoring, free for whoever wants it
_EACH = 512  # jumps between two looks at the clock; a power of 2


class TabWatch(Watch):
    """Ends what goes on for too long, or takes too much memory.

    `memory` tells the bytes that the interpreter has; `alive` is called when an import or the calls begin.
    Before Python 3.12, which cannot be asked to count, nothing is ended.
    """

    def __init__(self, limits: Limits, memory: Callable[[], int], alive: Callable[[], None]) -> None:
        super().__init__(limits)
        allowed = min(limits.cpu_seconds, limits.wall_seconds)
        self._seconds = min(3 * allowed, allowed + SPARE_SECONDS)
        self._memory, self._alive, self._before = memory, alive, memory()
        self._begun = self._end = float("inf")
        self._late = False

    def __enter__(self) -> TabWatch:
        monitoring = getattr(sys, "monitoring", None)
        if monitoring is None:
            return self
        monitoring.use_tool_id(_TOOL, "judge")
        turns = 0

        def turned(*_: object) -> None:
            nonlocal turns
            turns += 1
            if self._late or not turns & (_EACH - 1):
                self._look()

        for event in (monitoring.events.JUMP, monitoring.events.PY_START):
            monitoring.register_callback(_TOOL, event, turned)
        return self

    def __exit__(self, *exc: object) -> None:
        if hasattr(sys, "monitoring"):
            sys.monitoring.free_tool_id(_TOOL)

    def over(self, code: CodeType) -> None:
        """See `Watch`."""
        if not hasattr(sys, "monitoring"):
            return
        sys.monitoring.set_local_events(
            _TOOL, code, sys.monitoring.events.JUMP | sys.monitoring.events.PY_START
        )
        for inner in code.co_consts:
            if isinstance(inner, CodeType):
                self.over(inner)

    def begin(self) -> None:
        """See `Watch`."""
        self._alive()
        self._begun = perf_counter()
        self._end, self._late = self._begun + self._seconds, False

    def rest(self) -> float:
        """See `Watch`."""
        self._end, self._late = float("inf"), False
        return max(perf_counter() - self._begun, 0.0)

    def _look(self) -> None:
        """Raise Ended where it is time to."""
        if perf_counter() > self._end:
            self._late = True  # from now on at each turn, should the submission catch this one
            raise LimitPassed(Stop.CPU, f"used more than {self._seconds:g} s of CPU time")
        if self._memory() - self._before > self.limits.memory_bytes:
            raise LimitPassed(Stop.MEMORY, f"used more than {self.limits.memory_bytes >> 20} MB")


class TabBox(InProcess):
    """See `judge.sandbox.boundary.Box`; `memory` and `alive` are for `TabWatch`."""

    isolation = "tab"
    caught = BaseException  # SystemExit too: the end of this call, not of the next

    def __init__(
        self,
        source: bytes,
        name: str,
        memory: Callable[[], int] = lambda: 0,
        alive: Callable[[], None] = lambda: None,
    ) -> None:
        super().__init__(source, name, watch=lambda limits: TabWatch(limits, memory, alive))
