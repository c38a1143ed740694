"""Judging one submission: which way it is run, all its groups, and what they come to."""

from __future__ import annotations

from collections.abc import Callable, Collection
from typing import TYPE_CHECKING

from msgspec.structs import replace

from judge.errors import nearest
from judge.run.function import judge_calls
from judge.run.program import judge_program
from judge.run.result import Failure, Mode, Result, Timing
from judge.run.tally import Tally
from judge.sandbox import Box, Inspection, SourceFault, Usage, open_box
from judge.spec import Problem, Verdict

if TYPE_CHECKING:
    from judge.data import ProblemData

Progress = Callable[[int, int], None]  # cases done, cases in all
BoxFactory = Callable[[bytes, str], Box]

MOST_TIMEOUTS = 2  # groups that may run out of time before the rest is not run: a person is waiting


def run_submission(
    problem: Problem,
    data: ProblemData,
    source: bytes,
    name: str,
    *,
    groups: Collection[str] | None = None,
    on_progress: Progress | None = None,
    box_factory: BoxFactory = open_box,
) -> Result:
    """Judge one submission on a problem's data.

    Args:
        source: the bytes of its file.
        name: the file's name, for tracebacks and the result.
        groups: the names of the groups to run; all where it is None.
        on_progress: called after each group.
        box_factory: opens the containment.

    Raises:
        ProblemError: the reference fails on a case.
        JudgeError: nothing can be run on this machine.
    """
    with box_factory(source, name) as box:
        inspection = box.inspect()
        if inspection.fault:
            return Result(
                problem.id,
                name,
                Mode.FUNCTION,
                Verdict.CE,
                failure=Failure(_fault_text(inspection.fault, source)),
                isolation=box.isolation,
            )
        mode = Mode.FUNCTION if inspection.defines(problem.entry) else Mode.PROGRAM
        tallies = _run_groups(box, mode, data, groups, on_progress)
        isolation = box.isolation
    usage = sum((tally.usage for tally in tallies), Usage())
    failing = next((tally for tally in tallies if tally.verdict is not Verdict.AC), None)
    failure = failing.failure if failing else None
    if failure and mode is Mode.PROGRAM:
        failure = _noted(failure, inspection, problem.entry, source)
    return Result(
        problem.id,
        name,
        mode,
        failing.verdict if failing else Verdict.AC,
        tuple(tally.result() for tally in tallies),
        failure,
        Timing(usage.cpu_seconds, usage.wall_seconds),
        usage.memory_bytes,
        isolation,
    )


def _run_groups(
    box: Box, mode: Mode, data: ProblemData, groups: Collection[str] | None, on_progress: Progress | None
) -> list[Tally]:
    chosen = [group for group in data.groups if groups is None or group.group.name in groups]
    total = sum(len(group.cases) for group in chosen)
    judge_group = judge_calls if mode is Mode.FUNCTION else judge_program
    tallies: list[Tally] = []
    done = 0
    for group in chosen:
        tally = Tally(data, group, mode)
        if sum(earlier.verdict is Verdict.TLE for earlier in tallies) < MOST_TIMEOUTS:
            judge_group(box, tally)
        else:
            tally.failed(0, Verdict.TLE, f"not run: {MOST_TIMEOUTS} groups before it ran out of time")
        tallies.append(tally)
        done += len(group.cases)
        if on_progress:
            on_progress(done, total)
    return tallies


def _fault_text(fault: SourceFault, source: bytes) -> str:
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


def _noted(failure: Failure, inspection: Inspection, entry: str, source: bytes) -> Failure:
    """A program's failure, told that it was taken for one only because the entry function is missing."""
    close = nearest(entry, (name for name, _ in inspection.names))
    if close is None and any(word in source for word in _READS):
        return failure
    note = f"it was run as a program because it defines no {entry}"
    if close:
        line = next(line for name, line in inspection.names if name == close)
        note += f"; is {close} (line {line}) meant to be it?"
    return replace(failure, message=f"{failure.message}; {note}")
