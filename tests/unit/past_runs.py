"""Results as judging makes them, and runs of them in a history, for tests of what is kept of them."""

from __future__ import annotations

from datetime import UTC, datetime

from msgspec.structs import replace

from judge.practice.history import run_of
from judge.problem import Verdict
from judge.run.result import Failure, GroupResult, Pitfall, Ratio, Result, Timing, earned

START = datetime(2026, 3, 1, 9, 0, tzinfo=UTC)


def past_result(
    problem="segment", passed=("grid", "tangent"), failed=(), *, name="mine.py", mistake=None, ratio=None
):
    """A result with these groups passed and failed; with the first ones only, half of the points."""
    groups = [
        GroupResult(name=group, verdict=Verdict.AC, cases=10, passed=10, points=50, worst_ulps=0.5)
        for group in passed
    ]
    groups += [GroupResult(name=group, verdict=Verdict.WA, cases=10, passed=4, points=50) for group in failed]
    return Result(
        problem=problem,
        submission=name,
        verdict=Verdict.WA if failed else Verdict.AC,
        failure=Failure("off by 1", failed[0], 3, {"r": 10**30}, "1", "2") if failed else None,
        time=Timing(cpu_seconds=0.02, ratio=Ratio(ratio, ratio, ratio, 9) if ratio else None),
        pitfall=Pitfall((mistake,), 0.9, ("Do better.",)) if mistake else None,
        **earned(groups),
    )


def keep(history, result, source=b"", path="", when=START):
    """Keep a run that ended then; its number."""
    return history.keep(replace(run_of(result, source, path), when=when), source)
