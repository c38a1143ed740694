"""Function mode: the submission's entry function is called once for each case."""

from __future__ import annotations

from judge.errors import JudgeError
from judge.run.tally import Tally, group_limits
from judge.sandbox import Box, Stop

MOST_LOSSES = 3  # calls of a group that may end their process before the rest is given up
_TIME = (Stop.CPU, Stop.WALL)


def judge_calls(box: Box, tally: Tally) -> None:
    """Call the entry function for each case of the group.

    A call that takes its process with it costs itself alone; one that uses up the group's time, or the third
    loss, ends the group.
    """
    from judge.compare.check import check

    problem, cases, targets = tally.problem, tally.group.cases, tally.group.targets
    done = losses = 0
    while done < len(cases) and losses < MOST_LOSSES:
        result = box.call_many(problem.entry, cases[done:], group_limits(problem, tally.usage))
        if not result.replies:
            raise JudgeError("the sandbox made no call at all", where=tally.group.group.name)
        tally.usage += result.usage
        for index, reply in enumerate(result.replies, done):
            if reply.stop is Stop.ANSWERED:
                tally.compared(index, check(problem.answer, reply.answer, targets[index], tally.exact(index)))
            else:
                tally.stopped(index, reply.stop, reply.detail)
        done += len(result.replies)
        last = result.replies[-1].stop
        losses += last not in (Stop.ANSWERED, Stop.EXCEPTION)
        if last in _TIME:
            return
