"""What the timing races: a submission and the reference solution, each in a box, on the same cases."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from judge.run.program import render_group
from judge.run.result import Mode
from judge.run.timing import Decision, Run, race
from judge.sandbox import Box, BoxFactory, Limits, Stop
from judge.spec import Case, Problem

if TYPE_CHECKING:
    from judge.data import GroupData


MOST_CASES = 400  # in a turn; a sample of the groups' cases where there are more


class Reference:
    """The solutions that set the time limit, each opened once in a box of its own and raced again and again.

    A context manager, its boxes end with it; one race at a time may use them.
    """

    def __init__(self, problem: Problem, box_factory: BoxFactory) -> None:
        self._problem = problem
        self._box_factory = box_factory
        self._boxes: dict[Mode, Box | None] = {}

    def __enter__(self) -> Reference:
        return self

    def __exit__(self, *exc: object) -> None:
        for box in self._boxes.values():
            if box is not None:
                box.__exit__(*exc)
        self._boxes.clear()

    def open(self, mode: Mode) -> Box | None:
        """The reference for submissions run in this way; None where the problem has none."""
        if mode not in self._boxes:
            source = self._source(mode)
            self._boxes[mode] = self._box_factory(*source) if source else None  # entered by its first use
        return self._boxes[mode]

    def _source(self, mode: Mode) -> tuple[bytes, str] | None:
        rule = self._problem.time
        name = None if rule is None else rule.function if mode is Mode.FUNCTION else rule.program
        if name is None:
            return None
        try:
            return (self._problem.solutions / "accepted" / name).read_bytes(), name
        except OSError:  # an installed pack may come without solutions; `judge verify` tells of a wrong name
            return None


def measure(
    problem: Problem, mode: Mode, groups: Sequence[GroupData], submission: Box, reference: Box
) -> Decision:
    """Race the two on the groups' cases, in one series of calls or one program a turn."""
    assert problem.time is not None
    cases = [case for group in groups for case in group.cases]
    cases = cases[:: 1 + (len(cases) - 1) // MOST_CASES]
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
