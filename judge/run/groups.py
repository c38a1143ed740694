"""Running a submission on test groups, in as few processes as it takes, until each of them has ended."""

from __future__ import annotations

import marshal
from collections.abc import Callable, Iterator, Sequence
from itertools import accumulate, takewhile
from math import inf
from typing import NamedTuple

from judge.errors import JudgeError
from judge.problem import Case, Verdict
from judge.run.budget import Budget
from judge.run.group import GroupRun, group_limits
from judge.run.runner import Breakdown, Replies, Runner
from judge.sandbox.boundary import Box, Stop, Usage

MOST_LOSSES = 3  # calls of a group that may end their process before the rest is given up
MOST_ARGUMENTS = 16 << 20  # bytes of the arguments that one process is handed, unless a group has more
SEARCHED_SECONDS = 1.0  # the longest run that is worth repeating to find the case it breaks at
_TIME = (Stop.CPU, Stop.WALL, Stop.WAITING)
_OF_A_PROCESS = (Stop.MEMORY, Stop.OUTPUT)  # limits that all calls before may have passed together
_CRASHES = (Stop.EXCEPTION, Stop.EXITED)


def run_groups(
    runner: Runner,
    box: Box,
    groups: Sequence[GroupRun],
    budget: Budget,
    on_group: Callable[[GroupRun], None],
) -> None:
    """Run the submission on every case of the groups and record what comes of it.

    Calls of groups with equal limits are made by one process; where that passes a limit of one group, those
    that it did not come to the end of have a process each. A call that takes its process with it costs itself
    alone; one that uses up its group's time, or the third loss of a group, ends the group, and so does any
    breakdown. `on_group` is told of each group that has ended; nothing more is begun once the budget is
    used up.
    """
    waiting = [_Progress(runner, box, group, budget) for group in groups]
    together = runner.calls
    while waiting and not budget.over:
        # A group that has lost a call goes on by itself, with what is left of its limits.
        first = waiting[0].group
        batch = _of_equal_limits(waiting) if together and not first.reached else waiting[:1]
        limits = budget.within(group_limits(first.problem, first.group, first.usage))
        replies = runner.ask(box, [case for progress in batch for case in progress.rest], limits)
        if not (replies.replies or replies.breakdown):
            raise JudgeError("the sandbox made no call at all", where=first.group.name)
        if _is_nobodys(replies, batch):
            together = False
            budget.booked(replies._replace(stop=Stop.ANSWERED, lost=False))
            shares = _shares(replies, batch)[:-1] if replies.stop not in _OF_A_PROCESS else []
        else:
            shares = _shares(budget.booked(replies), batch)
        for progress, share in zip(batch, shares, strict=False):
            progress.take(share)
            if progress.over:
                on_group(progress.group)
        waiting = [progress for progress in waiting if not progress.over]


def _is_nobodys(replies: Replies, batch: Sequence[_Progress]) -> bool:
    """Whether a limit was passed by several groups together, so that none may be blamed."""
    if replies.stop in _OF_A_PROCESS:
        return len(batch) > 1
    return replies.stop in _TIME[:2] and len(replies.replies) > len(batch[0].rest)


def _shares(replies: Replies, batch: Sequence[_Progress]) -> list[Replies]:
    """What came of each of the groups that were begun, its time by the number of its calls."""
    if len(batch) == 1:
        return [replies]
    shares: list[Replies] = []
    start, (cpu, wall, memory) = 0, replies.usage
    for progress in batch:
        own = replies.replies[start : start + len(progress.rest)]
        if not own:
            break
        start += len(own)
        part = len(own) / len(replies.replies)
        progress.group.shares = True
        shares.append(Replies(own, Usage(cpu * part, wall * part, memory)))
    shares[0] = shares[0]._replace(imported=replies.imported)
    shares[-1] = shares[-1]._replace(stop=replies.stop, lost=replies.lost)
    return shares


class TimedPart(NamedTuple):
    """What was run of a group, and what it used without the import; `cut` where it was stopped early."""

    cases: Sequence[Case]
    usage: Usage
    cut: bool


def run_timed(
    runner: Runner, box: Box, group: GroupRun, budget: Budget, first: float | None = None
) -> Iterator[TimedPart]:
    """As `run_groups` for one group, piece by piece: all cases, or the first one and then the others.

    The first one may take so many CPU seconds at first; if it is cut, nothing is recorded of it, and it is
    run once more, within the group's own limits.
    """
    progress = _Progress(runner, box, group, budget)
    one_first, most = first is not None, first or inf
    while not progress.over and not budget.over:
        cases = progress.rest[:1] if one_first and not group.reached else progress.rest
        within = budget.within(group_limits(group.problem, group.group, group.usage))
        early = within._replace(cpu_seconds=min(within.cpu_seconds, most))
        replies = budget.booked(runner.ask(box, cases, early))
        if not (replies.replies or replies.breakdown):
            raise JudgeError("the sandbox made no call at all", where=group.group.name)
        cut = replies.stop is Stop.CPU and most < within.cpu_seconds
        if not cut:
            progress.take(replies)
        most = inf
        # The limits hold for an import too; one that was cut tells nothing of the calls.
        called = not (cut and runner.calls) or replies.imported != Usage()
        yield TimedPart(cases, replies.usage if called else Usage(), cut)


class _Progress:
    """A group on its way to its end."""

    def __init__(self, runner: Runner, box: Box, group: GroupRun, budget: Budget) -> None:
        self.group = group
        self.over = False
        self._runner = runner
        self._box = box
        self._budget = budget
        self._losses = 0

    @property
    def rest(self) -> Sequence[Case]:
        """The cases still to be run: at first the group's own list, which need not be packed again."""
        cases, reached = self.group.cases, self.group.reached
        return cases[reached:] if reached else cases

    def take(self, replies: Replies) -> None:
        """Record what came of the next cases."""
        group, breakdown = self.group, replies.breakdown
        if breakdown and breakdown.verdict is Verdict.OLE:  # goes before what its lines say
            group.failed(breakdown.case, breakdown.verdict, breakdown.detail)
        group.take(replies)
        if breakdown:
            self._broken_down(breakdown, replies)
        self._losses += replies.lost
        self.over = (
            breakdown is not None
            or group.reached >= len(group.cases)
            or self._losses >= MOST_LOSSES
            or replies.stop in _TIME
        )

    def _broken_down(self, breakdown: Breakdown, replies: Replies) -> None:
        group = self.group
        if breakdown.verdict is Verdict.WA:
            group.failed_whole(breakdown.verdict, breakdown.detail + breakdown.so_far)
        if group.failure is not None:  # a wrong line says more than what came of the run afterwards
            return
        culprit = self._culprit(replies)
        if culprit is None:
            message = breakdown.detail + breakdown.so_far
            group.failed(breakdown.case, breakdown.verdict, message, breakdown.got)
        else:
            group.stopped(culprit, replies.stop, breakdown.detail)

    def _culprit(self, replies: Replies) -> int | None:
        """The case at which a run breaks, found by halving, or None where it breaks without any.

        What it had printed may still have been in its buffer, so the lines that arrived do not tell. None,
        too, where the search takes too long.
        """
        if replies.stop not in _CRASHES or replies.usage.wall_seconds >= SEARCHED_SECONDS:
            return None
        if not self._budget.may_search() or self._breaks(0):
            return None
        good, bad = 0, len(self.group.cases)
        while bad - good > 1:
            if not self._budget.may_search():
                return None
            middle = (good + bad) // 2
            good, bad = (good, middle) if self._breaks(middle) else (middle, bad)
        return bad - 1

    def _breaks(self, count: int) -> bool:
        """Whether a run on the first so many cases breaks too."""
        limits = group_limits(self.group.problem, self.group.group, self.group.usage)
        limits = limits._replace(
            cpu_seconds=min(limits.cpu_seconds, 2 * SEARCHED_SECONDS),
            wall_seconds=min(limits.wall_seconds, 2 * SEARCHED_SECONDS),
        )
        replies = self._runner.ask(self._box, self.group.cases[:count], self._budget.within(limits))
        self._budget.searched(replies.usage)
        return replies.stop is not Stop.ANSWERED


def _of_equal_limits(waiting: Sequence[_Progress]) -> Sequence[_Progress]:
    """The first ones that the same limits hold for, as far as their arguments fit into one process."""
    limits_of = waiting[0].group.problem.limits_of
    limits = limits_of(waiting[0].group.group)
    small = takewhile(lambda each: each.group.group.size is None, waiting)
    alike = [*takewhile(lambda each: limits_of(each.group.group) == limits, small)]
    sizes = accumulate(len(marshal.dumps([*each.rest])) for each in alike)
    return [each for each, size in zip(alike, sizes, strict=True) if size <= MOST_ARGUMENTS] or waiting[:1]
