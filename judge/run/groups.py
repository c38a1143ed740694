"""Judging a submission's test groups, in as few processes as it takes, until each of them has ended.

A person waits for the verdict. A submission that keeps just inside the limits of every group, or breaks its
process again and again, is not run to the end, whatever the limits of each group would still allow:

    timeouts   groups that ran out of time; one is enough where its first case did that
    losses     processes ended by force or in mid-call, each of which the judge has to clear up after
    waiting    wall time beyond CPU time, in a few times the wall limit of one group
    searching  wall time of the runs that find the case a program breaks at
"""

from __future__ import annotations

import marshal
from bisect import bisect_left
from collections.abc import Callable, Sequence
from functools import partial
from itertools import accumulate, takewhile

from judge.errors import JudgeError
from judge.problem import Case, Problem, Verdict
from judge.run.group import GroupRun, group_limits
from judge.run.runner import VERDICTS, Breakdown, Replies, Runner
from judge.sandbox.boundary import Box, Limits, Stop, Usage

MOST_LOSSES = 3  # calls of a group that may end their process before the rest is given up
MOST_ARGUMENTS = 16 << 20  # bytes of the arguments that one process is handed, unless a group has more
SEARCHED_SECONDS = 1.0  # the longest run that is worth repeating to find the case it breaks at
MOST_TIMEOUTS = 2
MOST_LOSSES_IN_ALL = 10
WAITING_LIMITS = 3  # wall limits of a group; CPU time, which has limits of its own, does not count
SEARCH_SECONDS = 5.0
_TIME = (Stop.CPU, Stop.WALL, Stop.WAITING)
_OF_A_PROCESS = (Stop.MEMORY, Stop.OUTPUT)  # limits that all calls before may have passed together
_CRASHES = (Stop.EXCEPTION, Stop.EXITED)


class Budget:
    """The account of one submission; whatever is left, it is used up once `stop` says so."""

    def __init__(self, problem: Problem, stop: Callable[[], bool] = lambda: False) -> None:
        self._stop = stop
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
        if self._stop():
            return Verdict.TLE, "the time is up"
        if self._timeouts >= MOST_TIMEOUTS:
            one = "the first case of a group used up all its time"
            return Verdict.TLE, one if self._at_once else f"{MOST_TIMEOUTS} groups ran out of time"
        if self._waited >= self._most_waiting:
            return Verdict.TLE, f"before, {self._waited_too_long}"
        if self._losses >= MOST_LOSSES_IN_ALL:
            verdict = next(iter(self._lost_by)) if len(self._lost_by) == 1 else Verdict.RTE
            return verdict, f"its process was lost {MOST_LOSSES_IN_ALL} times"
        return None

    @property
    def _waited_too_long(self) -> str:
        seconds = f"{self._most_waiting:g} s"
        return f"it waited more than {seconds} in all its groups together, perhaps for a busy machine"


class Judging:
    """A submission in its box while it is judged; `on_group` is told of each group that has ended."""

    def __init__(
        self,
        runner: Runner,
        box: Box,
        budget: Budget | None = None,
        on_group: Callable[[GroupRun], None] = lambda _: None,
    ) -> None:
        self.runner = runner
        self.box = box
        self.budget = budget or Budget(runner.problem)
        self._on_group = on_group

    def ask(self, cases: Sequence[Case], limits: Limits) -> Replies:
        """One process on these cases, which is booked."""
        return self.budget.booked(self.runner.ask(self.box, cases, self.budget.within(limits)))

    def run(self, groups: Sequence[GroupRun]) -> None:
        """Run the submission on every case of the groups and record what comes of it.

        Calls of groups with equal limits are made by one process; where that passes a limit of one group,
        those that it did not come to the end of have a process each. A call that takes its process with it
        costs itself alone; one that uses up its group's time, or the third loss of a group, ends the group,
        and so does any breakdown. What is not begun when the budget is used up is given up.
        """
        waiting, together = groups, self.runner.calls
        while waiting and not self.budget.over:
            # A group that has lost a call goes on by itself, with what is left of its limits.
            first = waiting[0]
            batch = _of_equal_limits(waiting) if together and not first.reached else waiting[:1]
            limits = self.budget.within(group_limits(first.problem, first.group, first.usage))
            replies = self._process(first, [case for group in batch for case in group.rest], limits)
            if _is_nobodys(replies, batch):
                together = False
                self.budget.booked(replies._replace(stop=Stop.ANSWERED, lost=False))
                shares = _shares(replies, batch)[:-1] if replies.stop not in _OF_A_PROCESS else []
            else:
                shares = _shares(self.budget.booked(replies), batch)
            for group, share in zip(batch, shares, strict=False):
                self._take(group, share)
                if group.ended:
                    self.end(group)
            waiting = [group for group in waiting if not group.ended]
        self.give_up(waiting)

    def part(self, group: GroupRun, cases: Sequence[Case], most: float) -> tuple[Replies, bool]:
        """As `run` for the next cases of one group, whose process may take so many CPU seconds.

        Whether that is less than what is left of the group's own limits, and it was cut there: then nothing
        is recorded.
        """
        limits = group_limits(group.problem, group.group, group.usage)
        early = limits._replace(cpu_seconds=min(limits.cpu_seconds, most))
        replies = self.budget.booked(self._process(group, cases, self.budget.within(early)))
        cut = replies.stop is Stop.CPU and most < limits.cpu_seconds
        if not cut:
            self._take(group, replies)
        return replies, cut

    def end(self, group: GroupRun) -> None:
        """Nothing more of the group is to be run."""
        group.ended = True
        if group.verdict is Verdict.TLE or group.out_of_time:
            self.budget.ran_out_of_time(at_once=group.reached <= 1 < len(group.cases))
        self._on_group(group)

    def give_up(self, groups: Sequence[GroupRun]) -> None:
        """Record it of those that were not begun, since the budget is used up."""
        for group in groups:
            if not (group.ended or group.given_up):
                assert self.budget.over
                group.give_up(*self.budget.over)

    def _process(self, group: GroupRun, cases: Sequence[Case], limits: Limits) -> Replies:
        """One process that begins with this group."""
        replies = self.runner.ask(self.box, cases, limits)
        if not (replies.replies or replies.breakdown):
            raise JudgeError("the sandbox made no call at all", where=group.group.name)
        return replies

    def _take(self, group: GroupRun, replies: Replies) -> None:
        """Record what came of the group's next cases."""
        breakdown = replies.breakdown
        if breakdown and breakdown.verdict is Verdict.OLE:  # goes before what its lines say
            group.failed(breakdown.case, breakdown.verdict, breakdown.detail)
        group.take(replies)
        if breakdown:
            self._broken_down(group, breakdown, replies)
        group.losses += replies.lost
        group.ended = (
            breakdown is not None
            or group.reached >= len(group.cases)
            or group.losses >= MOST_LOSSES
            or replies.stop in _TIME
        )

    def _broken_down(self, group: GroupRun, breakdown: Breakdown, replies: Replies) -> None:
        message = breakdown.detail + breakdown.so_far
        if breakdown.verdict is Verdict.WA:
            group.failed_whole(breakdown.verdict, message)
        if group.failure is not None:  # a wrong line says more than what came of the run afterwards
            return
        culprit = self._culprit(group, replies)
        if culprit is None:
            group.failed(breakdown.case, breakdown.verdict, message, breakdown.got)
        else:
            group.stopped(culprit, replies.stop, breakdown.detail)

    def _culprit(self, group: GroupRun, replies: Replies) -> int | None:
        """The case at which a run breaks, found by halving, or None where it breaks without any.

        What it had printed may still have been in its buffer, so the lines that arrived do not tell. None,
        too, where the search takes too long.
        """
        if replies.stop not in _CRASHES or replies.usage.wall_seconds >= SEARCHED_SECONDS:
            return None
        if self._breaks(group, 0):
            return None
        count = bisect_left(range(len(group.cases)), True, lo=1, key=partial(self._breaks, group))
        return count - 1 if self.budget.may_search() else None

    def _breaks(self, group: GroupRun, count: int) -> bool:
        """Whether a run on the first so many cases breaks too; none is made when there is no time for it."""
        if not self.budget.may_search():
            return True
        limits = group_limits(group.problem, group.group, group.usage)
        limits = limits._replace(
            cpu_seconds=min(limits.cpu_seconds, 2 * SEARCHED_SECONDS),
            wall_seconds=min(limits.wall_seconds, 2 * SEARCHED_SECONDS),
        )
        replies = self.runner.ask(self.box, group.cases[:count], self.budget.within(limits))
        self.budget.searched(replies.usage)
        return replies.stop is not Stop.ANSWERED


def _is_nobodys(replies: Replies, batch: Sequence[GroupRun]) -> bool:
    """Whether a limit was passed by several groups together, so that none may be blamed."""
    if replies.stop in _OF_A_PROCESS:
        return len(batch) > 1
    return replies.stop in _TIME[:2] and len(replies.replies) > len(batch[0].rest)


def _shares(replies: Replies, batch: Sequence[GroupRun]) -> list[Replies]:
    """What came of each of the groups that were begun, its time by the number of its calls."""
    if len(batch) == 1:
        return [replies]
    shares: list[Replies] = []
    start, (cpu, wall, memory) = 0, replies.usage
    for group in batch:
        own = replies.replies[start : start + len(group.rest)]
        if not own:
            break
        start += len(own)
        part = len(own) / len(replies.replies)
        group.shares = True
        shares.append(Replies(own, Usage(cpu * part, wall * part, memory)))
    shares[0] = shares[0]._replace(imported=replies.imported)
    shares[-1] = shares[-1]._replace(stop=replies.stop, lost=replies.lost)
    return shares


def _of_equal_limits(waiting: Sequence[GroupRun]) -> Sequence[GroupRun]:
    """The first ones that the same limits hold for, as far as their arguments fit into one process."""
    limits_of = waiting[0].problem.limits_of
    limits = limits_of(waiting[0].group)
    small = takewhile(lambda each: each.group.size is None, waiting)
    alike = [*takewhile(lambda each: limits_of(each.group) == limits, small)]
    sizes = accumulate(len(marshal.dumps([*each.rest])) for each in alike)
    return [each for each, size in zip(alike, sizes, strict=True) if size <= MOST_ARGUMENTS] or waiting[:1]
