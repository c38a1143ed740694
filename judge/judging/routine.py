"""Holding a routine of this very process against a problem: trusted, so without a container or limits."""

from __future__ import annotations

import decimal
import sys
import warnings
from collections.abc import Callable, Collection, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from types import TracebackType
from typing import Any, NamedTuple

from judge.data.model import GroupData, ProblemData
from judge.problem import Case, Group, Verdict
from judge.run.function import FunctionRunner
from judge.run.group import GroupRun
from judge.run.replies import Replies
from judge.run.result import Failure, GroupResult
from judge.sandbox.boundary import Reply, Stop, Usage
from judge.sandbox.encode import encode

Routine = Callable[..., Any]


class Held(NamedTuple):
    """What the routine came to in one group; `raised` is its exception where that is the first failure."""

    group: Group
    result: GroupResult
    failure: Failure | None
    raised: Exception | None


def held(data: ProblemData, routine: Routine, groups: Collection[str]) -> list[Held]:
    """Call the routine with every case of the groups of those names. Raises ProblemError."""
    return [_held(data, each, routine) for each in data.groups if each.group.name in groups]


class _RoutineRunner(FunctionRunner, frozen=True):
    """Calls the routine where any other runner asks a box to."""

    routine: Routine

    def called(self, cases: Sequence[Case]) -> tuple[Replies, Exception | None]:
        """What it answers to each of the cases, and the first exception among them."""
        replies: list[Reply] = []
        first: Exception | None = None
        for arguments in self.problem.calls(cases):
            try:
                replies.append(
                    Reply(Stop.ANSWERED, encode(self.routine(*arguments), self.problem.answer.items))
                )
            except Exception as fault:  # as in a box: this case is lost, the others are called
                first = first or fault
                replies.append(Reply(Stop.EXCEPTION, None, _told(fault)))
        return Replies(replies, Usage()), first


def _held(data: ProblemData, group: GroupData, routine: Routine) -> Held:
    runner = _RoutineRunner(data.problem, routine)
    run = GroupRun(data, group, runner)
    with _as_it_was():
        replies, raised = runner.called(group.cases)
    run.take(replies)
    return Held(run.group, run.result(), run.failure, raised if run.verdict is Verdict.RTE else None)


@contextmanager
def _as_it_was() -> Iterator[None]:
    """Undo at the end what was done to the state that the whole process shares.

    So that no test group depends on the one before it, nor the caller's next test on any.
    """
    with ExitStack() as undone:
        undone.enter_context(decimal.localcontext())
        undone.enter_context(warnings.catch_warnings())
        # Who imports these only now finds them new: there is nothing to undo.
        if random := sys.modules.get("random"):
            undone.callback(random.setstate, random.getstate())
        if numpy := sys.modules.get("numpy"):
            undone.enter_context(numpy.errstate())
        if numpy_random := sys.modules.get("numpy.random"):
            undone.callback(numpy_random.set_state, numpy_random.get_state())
        undone.callback(sys.set_int_max_str_digits, sys.get_int_max_str_digits())
        undone.callback(sys.setrecursionlimit, sys.getrecursionlimit())  # first: the others need room too
        yield


def _told(fault: Exception) -> str:
    try:
        what = " ".join(str(fault).split())
    except Exception:  # a text of its own that fails: what was raised matters more
        what = "(its text cannot be shown)"
    place = _place(fault.__traceback__)
    return f"{type(fault).__name__}{': ' if what else ''}{what}{f' ({place})' if place else ''}"


def _place(step: TracebackType | None) -> str:
    """The innermost line that led to an exception, as editors open it."""
    place = ""
    while step is not None:
        code = step.tb_frame.f_code
        place = "" if code.co_filename == __file__ else f"{code.co_filename}:{step.tb_lineno}"
        step = step.tb_next
    return place
