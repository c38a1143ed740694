"""Judging one submission: which way it is run, all its groups, what they come to and how long they take."""

from __future__ import annotations

import threading
from collections.abc import Callable, Collection, Iterable, Sequence
from contextlib import ExitStack
from typing import TYPE_CHECKING

from msgspec import Struct, field
from msgspec.structs import replace

from judge.errors import nearest
from judge.problem import Problem, Verdict
from judge.run.budget import Budget
from judge.run.function import judge_calls
from judge.run.group import GroupRun
from judge.run.measure import Reference, measure
from judge.run.parallel import Turnstile, share
from judge.run.program import judge_programs
from judge.run.result import Failure, Mode, Result, Timing
from judge.run.timing import Decision
from judge.sandbox import Box, Boxes, BoxFactory, Inspection, SourceFault, Usage

if TYPE_CHECKING:
    from judge.data import GroupData, ProblemData

Progress = Callable[[int, int], None]  # cases done, cases in all


class Settings(Struct, frozen=True):
    """How to judge, whatever is judged.

    `box_factory` opens the containment; `workers` is how many boxes one submission may use at once;
    `measured` says whether an accepted one is raced against the reference; `turnstile` keeps races alone;
    `reference` is there where several submissions share it; `diagnose` is given what was not accepted, with
    the submission's box, and adds to it.
    """

    box_factory: BoxFactory = field(default_factory=Boxes)
    workers: int = 1
    measured: bool = True
    turnstile: Turnstile | None = None
    reference: Reference | None = None
    diagnose: Callable[[Result, Box], Result] | None = None


def run_submission(
    problem: Problem,
    data: ProblemData,
    source: bytes,
    name: str,
    *,
    groups: Collection[str] | None = None,
    on_progress: Progress | None = None,
    settings: Settings | None = None,
) -> Result:
    """Judge one submission on a problem's data.

    Args:
        source: the bytes of its file.
        name: the file's name, for tracebacks and the result.
        groups: the names of the groups to run; all where it is None.
        on_progress: called after each group.
        settings: how.

    Raises:
        ProblemError: the reference fails on a case.
        JudgeError: nothing can be run on this machine.
    """
    chosen = [group for group in data.groups if groups is None or group.group.name in groups]
    settings = settings or Settings()
    turnstile = settings.turnstile or Turnstile()
    with settings.box_factory(source, name) as box:
        inspection = box.inspect()
        if inspection.fault:
            failure = Failure(fault_text(inspection.fault, source))
            return Result(
                problem.id, name, Mode.FUNCTION, Verdict.CE, failure=failure, isolation=box.isolation
            )
        mode = Mode.FUNCTION if inspection.defines(problem.entry) else Mode.PROGRAM
        budget = Budget(problem)
        judging = _Judging(data, mode, source, name, settings, on_progress, budget)
        with turnstile.judging():
            tallies = judging.groups(box, chosen)
        timing = Decision(None)
        if settings.measured and all(tally.verdict is Verdict.AC for tally in tallies):
            timing = _race(problem, mode, tallies, box, settings, turnstile, budget)
        if timing.too_slow and timing.ratio and problem.time:
            slowest = max(tallies, key=lambda tally: tally.usage.cpu_seconds)
            slowest.too_slow(
                f"it takes {timing.ratio.median:,.0f} times the CPU time of the reference solution; "
                f"the limit is {problem.time.limit:g} times"
            )
        result = _result(judging, tallies, inspection, timing, box.isolation)
        if settings.diagnose and result.failure:
            result = settings.diagnose(result, box)
    return result


def _result(
    judging: _Judging, tallies: Sequence[GroupRun], inspection: Inspection, timing: Decision, isolation: str
) -> Result:
    """What the groups come to together."""
    problem = judging.data.problem
    usage = sum((tally.usage for tally in tallies), Usage())
    rejected = [tally for tally in tallies if tally.verdict is not Verdict.AC]
    failing = next((tally for tally in rejected if not tally.given_up), None)  # one that says why
    failing = failing or next(iter(rejected), None)
    first = failing.failure if failing else None
    if first and judging.mode is Mode.PROGRAM:
        first = noted(first, inspection, problem.entry, judging.source)
    return Result(
        problem.id,
        judging.name,
        judging.mode,
        failing.verdict if failing else Verdict.AC,
        tuple(tally.result() for tally in tallies),
        first,
        Timing(usage.cpu_seconds, usage.wall_seconds, timing.ratio, timing.borderline),
        usage.memory_bytes,
        isolation,
    )


def _race(
    problem: Problem,
    mode: Mode,
    tallies: Sequence[GroupRun],
    box: Box,
    settings: Settings,
    turnstile: Turnstile,
    budget: Budget,
) -> Decision:
    with ExitStack() as stack:
        shared = settings.reference or stack.enter_context(Reference(problem, settings.box_factory))
        stack.enter_context(turnstile.measuring())
        reference = shared.open(mode)
        return measure(problem, mode, tallies, box, reference, budget) if reference else Decision(None)


class _Judging:
    """The groups of one submission, in one box or several at once."""

    def __init__(
        self,
        data: ProblemData,
        mode: Mode,
        source: bytes,
        name: str,
        settings: Settings,
        on_progress: Progress | None,
        budget: Budget,
    ) -> None:
        self.data = data
        self.mode = mode
        self.source = source
        self.name = name
        self._settings = settings
        self._on_progress = on_progress
        self._budget = budget
        self._lock = threading.Lock()
        self._called: set[str] = set()
        self._done = self._total = 0

    def groups(self, box: Box, groups: Sequence[GroupData]) -> list[GroupRun]:
        """Judge the groups; `box` is the first worker's, the others open their own."""
        tallies = [GroupRun(self.data, group, self.mode) for group in groups]
        self._total = sum(len(group.cases) for group in groups)
        workers = self._settings.workers
        here = threading.current_thread()

        def work(queue: Iterable[tuple[int, list[GroupRun]]]) -> None:
            with ExitStack() as stack:
                mine = box
                if threading.current_thread() is not here:
                    mine = stack.enter_context(self._settings.box_factory(self.source, self.name))
                for _, share_of in queue:
                    self._judge(mine, share_of)

        share([tallies[first::workers] for first in range(min(workers, len(tallies)))], workers, work)
        for tally in tallies:
            if not tally.run:
                assert self._budget.over
                tally.give_up(*self._budget.over)
        return tallies

    def _judge(self, box: Box, tallies: Sequence[GroupRun]) -> None:
        judge_groups = judge_calls if self.mode is Mode.FUNCTION else judge_programs
        judge_groups(
            box,
            tallies,
            budget=self._budget,
            on_calls=self._after_calls,
            on_group=self._after_group,
        )

    def _after_calls(self, tally: GroupRun) -> None:
        with self._lock:
            if tally.group.group.name not in self._called:
                self._called.add(tally.group.group.name)
                self._done += len(tally.group.cases)
                if self._on_progress:
                    self._on_progress(self._done, self._total)

    def _after_group(self, tally: GroupRun) -> None:
        tally.run = True
        self._after_calls(tally)
        if tally.verdict is Verdict.TLE or tally.out_of_time:
            self._budget.ran_out_of_time()


def fault_text(fault: SourceFault, source: bytes) -> str:
    """Why a source does not compile, in one line."""
    if "unicode error" in fault.message:
        try:
            source.decode()
        except UnicodeDecodeError as error:
            line = source.count(b"\n", 0, error.start) + 1
            byte = f"0x{source[error.start]:02x}"
            return f"the file is not UTF-8: byte {byte} (line {line}); save it as UTF-8"
    place = f"line {fault.line}" if fault.line else ""
    place += f", column {fault.column}" if fault.line and fault.column else ""
    text = fault.text.strip()
    quoted = f": {text[:120]}" if text else ""
    return f"{fault.message} ({place}){quoted}" if place else fault.message


_READS = (b"stdin", b"input", b"open(0", b"os.read")  # what a program that is meant as one has somewhere


def noted(failure: Failure, inspection: Inspection, entry: str, source: bytes) -> Failure:
    """A program's failure, told that it was taken for one only because the entry function is missing."""
    close = nearest(entry, (name for name, _ in inspection.names))
    nested = f"def {entry}(".encode() in source
    if close is None and not nested and any(word in source for word in _READS):
        return failure
    note = f"it was run as a program because it defines no {entry}"
    if nested:
        note += " at its top level: move it out of the class or function it stands in"
    elif close:
        line = next(line for name, line in inspection.names if name == close)
        note += f"; is {close} (line {line}) meant to be it?"
    return replace(failure, message=f"{failure.message}; {note}")
