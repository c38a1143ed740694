"""What one submission may cost in all, whatever the limits of each test group would still allow.

A person waits for the verdict. A submission that keeps just inside the limits of every group, or breaks its
process again and again, is not run to the end.

    timeouts   groups that ran out of time; one is enough where its first case did that
    losses     processes ended by force or in mid-call, each of which the judge has to clear up after
    waiting    wall time beyond CPU time, in a few times the wall limit of one group
    searching  wall time of the runs that find the case a program breaks at
"""

from __future__ import annotations

from judge.problem import Problem, Verdict
from judge.run.runner import VERDICTS, Replies
from judge.sandbox.boundary import Limits, Stop, Usage

MOST_TIMEOUTS = 2
MOST_LOSSES = 10
WAITING_LIMITS = 3  # wall limits of a group; CPU time, which has limits of its own, does not count
SEARCH_SECONDS = 5.0


class Budget:
    """The account of one submission."""

    def __init__(self, problem: Problem) -> None:
        self._timeouts = self._losses = 0
        self._lost_by: set[Verdict] = set()
        self._at_once = False
        longest = max([problem.limits_of(group).wall_seconds for group in problem.groups], default=0.0)
        self._most_waiting = WAITING_LIMITS * max(longest, problem.limits.wall_seconds)
        self._waited = self._searched = 0.0

    def within(self, limits: Limits) -> Limits:
        """The limits of one process, no longer waiting than is left."""
        return limits._replace(waiting_seconds=max(0.0, self._most_waiting - self._waited))

    def booked(self, replies: Replies) -> Replies:
        """Book what a series of cases has cost; its replies, as a person sees them."""
        stop = replies.stop
        self._waited += replies.usage.waiting_seconds
        if stop is Stop.WAITING:  # whatever the clocks say of the last millisecond
            self._waited = max(self._waited, self._most_waiting)
        if replies.lost:
            self._losses += 1
            self._lost_by.add(VERDICTS.get(stop, Verdict.RTE))
        # The box knows only what was left of the time for waiting.
        return replies.told(self._waited_too_long) if stop is Stop.WAITING else replies

    def searched(self, usage: Usage) -> None:
        """Book a run that looked for the case a program breaks at."""
        self._waited += usage.waiting_seconds
        self._searched += usage.wall_seconds

    def ran_out_of_time(self, *, at_once: bool) -> None:
        """Book a group whose own time was used up; `at_once` where nothing had come of it before."""
        self._timeouts += MOST_TIMEOUTS if at_once else 1
        self._at_once = self._at_once or at_once

    def may_search(self) -> bool:
        """Whether one more run is worth it to find the case a program breaks at."""
        return self._searched < SEARCH_SECONDS and self.over is None

    @property
    def over(self) -> tuple[Verdict, str] | None:
        """The verdict of what is not run any more, and why; None while there is something left."""
        if self._timeouts >= MOST_TIMEOUTS:
            one = "the first case of a group used up all its time"
            return Verdict.TLE, one if self._at_once else f"{MOST_TIMEOUTS} groups ran out of time"
        if self._waited >= self._most_waiting:
            return Verdict.TLE, f"{self._waited_too_long} before"
        if self._losses >= MOST_LOSSES:
            verdict = next(iter(self._lost_by)) if len(self._lost_by) == 1 else Verdict.RTE
            return verdict, f"its process was lost {MOST_LOSSES} times"
        return None

    @property
    def _waited_too_long(self) -> str:
        return f"it waited more than {self._most_waiting:g} s in all its groups together"
