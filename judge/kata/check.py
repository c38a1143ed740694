"""What a kata needs beyond being judged: hints, a stub, sets and skills that exist. For `judge verify`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from judge.errors import ProblemError
from judge.kata.checklist import unknown_skills
from judge.kata.sets import set_names, unknown_sets
from judge.kata.stub import make_stub
from judge.problem import Problem
from judge.problem.hints import read_hints
from judge.run.verify import Fault


def kata_faults(problem: Problem, extra: Sequence[Path] = ()) -> Iterator[Fault]:
    """The setter's faults; `extra` are folders of problems to look in first for the sets and skills."""
    for fault in _faults(problem, extra):
        yield Fault(fault.what, fault.where or problem.id, fault.remedy or "")


def _faults(problem: Problem, extra: Sequence[Path]) -> Iterator[ProblemError]:
    for check in (read_hints, make_stub):
        try:
            check(problem)
        except ProblemError as fault:
            yield fault
    yield from unknown_sets(problem, set_names(extra))
    try:
        yield from unknown_skills([problem], extra)
    except ProblemError as fault:  # of a file of skills
        yield fault
