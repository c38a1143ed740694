"""Running in this very process what is trusted: a routine of one's own, or a setter's source.

`InProcess` is a `Box` without containment or limits. What a series of calls does to the state that the whole
process shares is undone at its end, so that no test group depends on the one before it, nor the caller's next
test on any.
"""

from __future__ import annotations

import decimal
import io
import sys
import warnings
from collections.abc import Callable, Collection, Iterator, Sequence
from contextlib import ExitStack, contextmanager, nullcontext, redirect_stdout, suppress
from pathlib import Path
from traceback import walk_tb
from typing import Any, NamedTuple

from msgspec.structs import replace

from judge.data.load import ProblemData
from judge.problem import Verdict
from judge.run.function import FunctionRunner
from judge.run.group import GroupRun, group_limits, one_case
from judge.run.reference import Reference
from judge.run.result import Result, earned
from judge.run.settings import Settings
from judge.sandbox.boundary import (
    CallsResult,
    Defined,
    Inspection,
    Limits,
    ProgramResult,
    Reply,
    SourceFault,
    Stop,
    Usage,
)
from judge.sandbox.encode import encode
from judge.sandbox.inside.source import inspect

Routine = Callable[..., Any]


class InProcess:
    """See `judge.sandbox.boundary.Box`; of a `routine` there need be no source. Only Ctrl-C ends a call."""

    isolation = ""

    def __init__(self, source: bytes = b"", name: str = "", routine: Routine | None = None) -> None:
        self.raised: Exception | None = None  # the first one that a call raised
        self._source = source
        self._name = name
        self._routine = routine

    def __enter__(self) -> InProcess:
        return self

    def __exit__(self, *exc: object) -> None:
        pass

    def warm_up(self) -> None:
        """There is nothing to get ready."""

    def inspect(self) -> Inspection:
        """See `Box.inspect`."""
        found = inspect(self._source, self._name)
        functions = tuple(Defined(*each) for each in found["functions"])
        fault = SourceFault(*found["fault"]) if found["fault"] else None
        return Inspection(fault, tuple(map(tuple, found["names"])), functions)

    def call_many(self, entry: str, calls: Sequence[Sequence[Any]], limits: Limits) -> CallsResult:
        """See `Box.call_many`."""
        return self.call_series(entry, [calls], limits)[0]

    def call_series(
        self,
        entry: str,
        series: Sequence[Sequence[Sequence[Any]]],
        limits: Limits,
        on_series: Callable[[], None] | None = None,
    ) -> list[CallsResult]:
        """See `Box.call_series`; each series begins with the caller's state, and nothing is measured."""
        found: list[CallsResult] = []
        for calls in series:
            if found and on_series:
                on_series()
            with as_it_was():
                found.append(CallsResult(tuple(self._replies(entry, calls, limits.items)), Usage()))
        return found

    def _replies(self, entry: str, calls: Sequence[Sequence[Any]], items: int) -> Iterator[Reply]:
        routine = self._routine
        for arguments in calls:
            try:
                if routine is None:  # the import's own fault is each call's
                    routine = self._executed("submission")[entry]
                yield Reply(Stop.ANSWERED, encode(routine(*arguments), items))
            except Exception as fault:  # this case is lost, the others are called
                self.raised = self.raised or fault
                yield Reply(Stop.EXCEPTION, None, _told(fault))

    def run_program(self, stdin: bytes, limits: Limits) -> ProgramResult:  # noqa: ARG002 - there are none
        """See `Box.run_program`."""
        printed, before = io.BytesIO(), sys.stdin
        stop, detail = Stop.ANSWERED, ""
        out = io.TextIOWrapper(printed, "utf-8", write_through=True)
        sys.stdin = io.TextIOWrapper(io.BytesIO(stdin), "utf-8")
        try:
            with as_it_was(), redirect_stdout(out):
                self._executed("__main__")
        except SystemExit as left:
            if left.code not in (None, 0):
                stop, detail = Stop.EXITED, f"exit status {left.code}"
        except Exception as fault:
            stop, detail = Stop.EXCEPTION, _told(fault)
        finally:
            sys.stdin = before
        return ProgramResult(stop, printed.getvalue(), b"", detail, Usage())

    def _executed(self, module: str) -> dict[str, Any]:
        names: dict[str, Any] = {"__name__": module, "__file__": self._name}
        exec(compile(self._source, self._name, "exec", dont_inherit=True), names)
        return names


class Held(NamedTuple):
    """What a routine came to in one group; `raised` is its exception where that is the first failure."""

    run: GroupRun
    raised: Exception | None


def check_routine(data: ProblemData, routine: Routine, groups: Collection[str]) -> list[Held]:
    """Call the routine with every case of the groups of those names. Raises ProblemError."""
    found = []
    runner = FunctionRunner(data.problem)
    for each in data.groups:
        if each.group.name in groups:
            box, run = InProcess(routine=routine), GroupRun(data, each, runner)
            run.take(runner.answers(box, each.cases, group_limits(data.problem, each.group, Usage())))
            found.append(Held(run, box.raised if run.verdict is Verdict.RTE else None))
    return found


def explain_routine(data: ProblemData, routine: Routine) -> Result:
    """What `judge run` would say of the routine: every group, the smallest case, the mistake's name.

    What it lacks it lacks with a note. Raises ProblemError.
    """
    from judge.diagnose.shrink import shrink  # only after a failure
    from judge.mistakes.namer import Namer

    runs = [each.run for each in check_routine(data, routine, [each.group.name for each in data.groups])]
    first = next(run for run in runs if run.failure is not None)
    result = Result(
        problem=data.problem.id,
        submission=routine_name(routine),
        verdict=first.verdict,
        failure=first.failure,
        **earned([run.result() for run in runs]),
    )
    with Reference(data.problem, InProcess) as reference:
        box = InProcess(routine=routine)
        found = shrink(data, box, FunctionRunner(data.problem), result, reference=reference)

    def fails_alone(group: str, case: int) -> bool:
        (one,) = check_routine(one_case(data, group, case), routine, [group])
        return one.run.failure is not None

    namer = Namer(data, None, Settings(measured=False), nullcontext)
    does = {run.group.name: run.answers for run in runs}
    return namer.named(replace(result, counterexample=found), does, _source(routine), fails_alone)


def routine_name(routine: Routine) -> str:
    """What a routine is called where it is told of."""
    return getattr(routine, "__qualname__", None) or repr(routine)


def _source(routine: Routine) -> bytes:
    """The file that the routine is written in; nothing where it is in none."""
    with suppress(AttributeError, OSError):
        return Path(routine.__code__.co_filename).read_bytes()
    return b""


@contextmanager
def as_it_was() -> Iterator[None]:
    """Undo at the end what was done to the state that the whole process shares."""
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
    """The exception in a line, with its place as editors open it, unless that is here."""
    try:
        what = " ".join(str(fault).split())
    except Exception:  # a text of its own that fails: what was raised matters more
        what = "(its text cannot be shown)"
    *_, (frame, line) = walk_tb(fault.__traceback__)
    file = frame.f_code.co_filename
    place = "" if file == __file__ else f" ({file}:{line})"
    return f"{type(fault).__name__}{': ' if what else ''}{what}{place}"
