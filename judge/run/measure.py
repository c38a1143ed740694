"""What the timing races: a submission and the reference solution, each in a box, on the same cases."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from judge.run.program import render_group
from judge.run.result import Mode
from judge.run.timing import Decision, Run, race
from judge.sandbox import Box, Limits, Stop
from judge.spec import Case, Problem

if TYPE_CHECKING:
    from judge.data import GroupData


def reference_source(problem: Problem, mode: Mode) -> tuple[bytes, str] | None:
    """The source and the file name of the solution that sets the time limit; None where there is none."""
    if problem.time is None:
        return None
    name = problem.time.function if mode is Mode.FUNCTION else problem.time.program
    if name is None:
        return None
    try:
        return (problem.solutions / "accepted" / name).read_bytes(), name
    except OSError:  # an installed pack may come without solutions; `judge verify` complains of a wrong name
        return None


def measure(
    problem: Problem, mode: Mode, groups: Sequence[GroupData], submission: Box, reference: Box
) -> Decision:
    """Race the two on all cases of the groups, in one series of calls or one program a turn."""
    assert problem.time is not None
    cases = [case for group in groups for case in group.cases]
    limits = _limits(problem, len(groups))
    stdin = render_group(cases) if mode is Mode.PROGRAM else b""

    def turn_of(box: Box) -> Run:
        if mode is Mode.PROGRAM:
            return lambda: _program_seconds(box, stdin, limits)
        return lambda: _calls_seconds(box, problem.entry, cases, limits)

    return race(turn_of(submission), turn_of(reference), problem.time.limit)


def _calls_seconds(box: Box, entry: str, cases: Sequence[Case], limits: Limits) -> float | None:
    result = box.call_many(entry, cases, limits)
    whole = len(result.replies) == len(cases) and result.replies[-1].stop is Stop.ANSWERED
    return result.usage.cpu_seconds if whole else None


def _program_seconds(box: Box, stdin: bytes, limits: Limits) -> float | None:
    result = box.run_program(stdin, limits)
    return result.usage.cpu_seconds if result.stop is Stop.ANSWERED else None


def _limits(problem: Problem, groups: int) -> Limits:
    """The bounds of all groups together."""
    each = problem.limits
    return Limits(
        each.cpu_seconds * groups, each.wall_seconds * groups, each.memory_bytes, each.output_bytes * groups
    )
