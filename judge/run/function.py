"""Function mode: the submission's entry function is called once for each case."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from judge.errors import JudgeError
from judge.run.budget import Budget
from judge.run.group import GroupRun, group_limits
from judge.sandbox import Box, CallsResult, Stop

MOST_LOSSES = 3  # calls of a group that may end their process before the rest is given up
_TIME = (Stop.CPU, Stop.WALL, Stop.WAITING)


def judge_calls(
    box: Box,
    tallies: Sequence[GroupRun],
    *,
    budget: Budget,
    on_calls: Callable[[GroupRun], None],
    on_group: Callable[[GroupRun], None],
) -> None:
    """Call the entry function for each case of the groups, in as few processes as it takes.

    A call that takes its process with it costs itself alone; one that uses up its group's time, or the third
    loss of a group, ends the group. `on_calls` is told as soon as a group's calls have been made, `on_group`
    once its answers are compared; nothing more is begun once the budget is used up.
    """
    waiting = [_Group(tally) for tally in tallies]
    while waiting and not budget.over:
        # A group that has lost a call goes on by itself, with what is left of its limits.
        batch = waiting if not waiting[0].done else waiting[:1]
        tally = batch[0].tally
        series = [group.tally.group.cases[group.done :] for group in batch]
        called = iter(batch)
        results = box.call_series(
            tally.problem.entry,
            series,
            budget.within(group_limits(tally.problem, tally.usage)),
            lambda called=called: on_calls(next(called).tally),  # type: ignore[misc]
        )
        if not any(result.replies for result in results):
            raise JudgeError("the sandbox made no call at all", where=tally.group.group.name)
        for group, result in zip(batch, results, strict=False):
            group.record(result, budget)
            if group.over:
                on_group(group.tally)
        waiting = [group for group in waiting if not group.over]


class _Group:
    """How far a group has come."""

    def __init__(self, tally: GroupRun) -> None:
        self.tally = tally
        self.done = 0
        self._losses = 0
        self._out_of_time = False

    @property
    def over(self) -> bool:
        """Whether nothing more of it is to be run."""
        return self.done >= len(self.tally.group.cases) or self._losses >= MOST_LOSSES or self._out_of_time

    def record(self, result: CallsResult, budget: Budget) -> None:
        """Compare the answers of one series, or note how its calls ended."""
        from judge.compare.check import check

        tally = self.tally
        tally.usage += result.usage
        for index, reply in enumerate(result.replies, self.done):
            if reply.stop is Stop.ANSWERED:
                target = tally.group.targets[index]
                outcome = check(tally.problem.answer, reply.answer, target, tally.exact(index))
                tally.compared(index, outcome, reply.answer)
            else:
                tally.stopped(index, reply.stop, budget.told(reply.stop, reply.detail))
        self.done += len(result.replies)
        tally.reached = self.done
        last = result.replies[-1].stop if result.replies else Stop.ANSWERED
        self._losses += last not in (Stop.ANSWERED, Stop.EXCEPTION)
        self._out_of_time = last in _TIME
        budget.spent(result.usage, last)
