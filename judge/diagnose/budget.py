"""What the search for the smallest case may cost."""

from __future__ import annotations

import time
from collections.abc import Callable

from judge.sandbox.boundary import Usage

Clock = Callable[[], float]

SHORT_SECONDS = 0.1  # of CPU time, after which a call that once ran out of time is not waited for
_SLOW_SECONDS = 4.0  # that the processes of a search may take where each is slow
_RUN_COSTS = 20  # calls that starting a process is worth
_LOSS_COSTS = 5000  # calls that SHORT_SECONDS of a call in vain are worth


class SearchBudget:
    """What the search may cost, counted in calls, so that it comes to the same on every machine.

    `most` calls may be made; a process that is begun, and a call that is waited for in vain, count as so
    many. A guard by the clocks is for submissions whose every call takes long, and for machines that stand
    still.
    """

    def __init__(self, most: int = 60_000, guard: Guard | None = None) -> None:
        self._most = most
        self._guard = guard or Guard()
        self._cost = 0
        self._run_costs = _RUN_COSTS
        self._warned = False
        self.calls = 0

    def slow(self, seconds: float) -> None:
        """From now on each process takes so long, whatever is called in it."""
        self._run_costs = _RUN_COSTS + round(self._most * seconds / _SLOW_SECONDS)

    def asked(self, calls: int, lost_seconds: float, usage: Usage) -> None:
        """Book one process: the calls made in it, the limit of the time that was used up, if one was."""
        self.calls += calls
        self._cost += calls + self._run_costs + round(_LOSS_COSTS * lost_seconds / SHORT_SECONDS)
        self._guard.used(usage)

    def looked_at(self) -> None:
        """Book a case that was only looked at."""
        self._cost += 1

    @property
    def spent(self) -> bool:
        """Whether nothing more may be begun."""
        self._warned = self._warned or self._cost >= self._most or self._guard.over
        return self._warned

    @property
    def cut_short(self) -> bool:
        """Whether the search wanted to go on when it was spent."""
        return self._warned


class Guard:
    """The clocks' last word: CPU seconds of the search with the submission's own, and seconds on the wall."""

    def __init__(self, cpu: float = 8.0, wall: float = 40.0, clock: Clock = time.monotonic) -> None:
        self._clock = clock
        self._end = clock() + wall
        self._left = cpu
        self._began = time.process_time()

    def used(self, usage: Usage) -> None:
        """Book what the submission has used."""
        self._left -= usage.cpu_seconds

    @property
    def over(self) -> bool:
        """Whether either is up."""
        return time.process_time() - self._began >= self._left or self._clock() >= self._end
