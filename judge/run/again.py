"""A submission that was accepted and is run again to be timed: its limits, and whether it answers alike."""

from __future__ import annotations

import marshal
from collections.abc import Sequence

from judge.problem import Problem, Verdict
from judge.run.group import GroupRun
from judge.run.replies import VERDICTS, Replies
from judge.run.runner import Runner
from judge.sandbox.boundary import Limits, Stop
from judge.values.check import Accepted

_AGAIN = "when it was run again to be timed"


def exactly(replies: Replies) -> bytes | None:
    """The answers as bytes, for 1, 1.0 and True are equal and yet three answers; None if some are missing."""
    return None if replies.trouble else marshal.dumps([reply.answer for reply in replies.replies], 2)


def as_before(runner: Runner, replies: Replies, places: Sequence[tuple[GroupRun, int]]) -> bool:
    """Whether all answers are accepted as when they were judged; the first that is not is recorded."""
    for (run, index), reply in zip(places, replies.replies, strict=False):
        if reply.stop is not Stop.ANSWERED:
            run.unsteady(index, VERDICTS[reply.stop], f"{reply.detail}, {_AGAIN}")
            return False
        outcome = runner.decide(reply.answer, run.targets[index], run.exact(index))
        if not isinstance(outcome, Accepted):
            run.unsteady(index, Verdict.WA, f"{outcome.message}, {_AGAIN}", outcome.got)
            return False
    if replies.breakdown is None and len(replies.replies) == len(places):
        return True
    run, index = places[min(len(replies.replies), len(places) - 1)]
    verdict = replies.breakdown.verdict if replies.breakdown else Verdict.WA
    run.unsteady(index, verdict, f"{replies.trouble or 'it answered no more'}, {_AGAIN}")
    return False


def limits_of(problem: Problem, runs: Sequence[GroupRun]) -> Limits:
    """The bounds of all groups together."""
    each = [problem.limits_of(run.group) for run in runs]
    return Limits(
        sum(limits.cpu_seconds for limits in each),
        sum(limits.wall_seconds for limits in each),
        problem.limits.memory_bytes,
        sum(limits.output_bytes for limits in each),
        items=problem.answer.items,
    )
