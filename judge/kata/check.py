"""What a kata needs beyond being judged: hints that can be read, and a stub. For `judge verify`."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from judge.errors import ProblemError
from judge.kata.stub import make_stub
from judge.problem import Problem
from judge.problem.hints import read_hints
from judge.run.verify import Fault


def kata_faults(problem: Problem) -> Iterator[Fault]:
    """The setter's faults; a problem without hints has none of these."""
    checks: tuple[Callable[[Problem], object], ...] = (read_hints, make_stub)
    for check in checks:
        try:
            check(problem)
        except ProblemError as fault:
            yield Fault(fault.what, fault.where or problem.id, fault.remedy or "")
