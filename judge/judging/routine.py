"""Holding a routine of this very process against a problem: trusted, so without a container or limits."""

from __future__ import annotations

import decimal
import sys
import warnings
from collections.abc import Callable, Collection, Iterator, Sequence
from contextlib import ExitStack, contextmanager, nullcontext
from pathlib import Path
from types import TracebackType
from typing import Any, NamedTuple

from msgspec.structs import replace

from judge.data.load import GroupData, ProblemData
from judge.problem import Case, Group, Verdict
from judge.run.function import FunctionRunner
from judge.run.group import GroupRun
from judge.run.reference import Reference
from judge.run.replies import Replies
from judge.run.result import Answers, Failure, GroupResult, Result, earned
from judge.run.settings import Settings
from judge.sandbox.boundary import Box, Limits, Reply, Stop, Usage
from judge.sandbox.encode import encode
from judge.sandbox.factory import Boxes

Routine = Callable[..., Any]
_HERE = object()  # instead of a box: this process


class Held(NamedTuple):
    """What the routine came to in one group; `raised` is its exception where that is the first failure."""

    group: Group
    result: GroupResult
    answers: Answers
    failure: Failure | None
    raised: Exception | None


def held(data: ProblemData, routine: Routine, groups: Collection[str]) -> list[Held]:
    """Call the routine with every case of the groups of those names. Raises ProblemError."""
    return [_held(data, each, routine) for each in data.groups if each.group.name in groups]


def explained(data: ProblemData, routine: Routine) -> Result:
    """What `judge run` would say of the routine: every group, the smallest case, the mistake's name.

    What it lacks it lacks with a note. Raises ProblemError.
    """
    from judge.diagnose.shrink import shrink  # only after a failure
    from judge.mistakes.namer import Namer

    judged = held(data, routine, [each.group.name for each in data.groups])
    first = next((each for each in judged if each.failure is not None), None)
    groups = tuple(each.result for each in judged)
    verdict = first.result.verdict if first else Verdict.AC
    runner = _RoutineRunner(data.problem, routine=routine)
    result = Result(
        problem=data.problem.id, submission=routine_name(routine), verdict=verdict, **earned(groups)
    )
    if first is None or first.failure is None:
        return result
    result = replace(result, failure=first.failure)
    rule = data.problem.time
    name = runner.reference(rule) if rule else None
    with _as_it_was(), Reference(data.problem, Boxes()) as reference:
        here: Any = _HERE
        found = shrink(data, here, runner, verdict, first.failure, reference=lambda: reference.open(name))
    if found is not None:
        result = replace(result, counterexample=found)

    def alone(group: str, case: int) -> bool:
        (one,) = [each for each in data.groups if each.group.name == group]
        one = replace(one, cases=[one.cases[case]], targets=[one.targets[case]])
        return _held(data, one, routine).failure is not None

    namer = Namer(data, None, Settings(measured=False), nullcontext)
    does = {each.group.name: each.answers for each in judged}
    return namer.named(result, does, _source(routine), alone)


def routine_name(routine: Routine) -> str:
    """What a routine is called where it is told of."""
    return getattr(routine, "__qualname__", None) or repr(routine)


def _source(routine: Routine) -> bytes:
    """The file that the routine is written in; nothing where it is in none."""
    code = getattr(routine, "__code__", None)
    try:
        return Path(code.co_filename).read_bytes() if code else b""
    except OSError:
        return b""


class _RoutineRunner(FunctionRunner, frozen=True):
    """Calls the routine where any other runner asks a box to; its box is `_HERE`."""

    routine: Routine = print  # there is always one: fields without a default cannot follow others

    def answers(self, box: Box, cases: Sequence[Case], limits: Limits) -> Replies:
        """What it answers to each of the cases, in this process and without limits; another box is asked."""
        return self.called(cases)[0] if box is _HERE else super().answers(box, cases, limits)

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
    runner = _RoutineRunner(data.problem, routine=routine)
    run = GroupRun(data, group, runner)
    with _as_it_was():
        replies, raised = runner.called(group.cases)
    run.take(replies)
    return Held(
        run.group, run.result(), run.answers, run.failure, raised if run.verdict is Verdict.RTE else None
    )


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
