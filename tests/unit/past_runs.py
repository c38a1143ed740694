"""Results as judging makes them, for tests of what is kept of them."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta

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


class StoppedClock:
    """A clock that stands still until it is moved."""

    def __init__(self, at=START):
        self.at = at

    def __call__(self):
        return self.at

    def forward(self, **amount):
        self.at += timedelta(**amount)
