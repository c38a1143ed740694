"""Results as judging makes them, and runs of them in a history, for tests of what is kept of them."""

from __future__ import annotations

from datetime import UTC, datetime

from msgspec.structs import replace

from judge.kata.history import run_of
from judge.problem import Verdict
from judge.run.result import Failure, GroupResult, Mode, Pitfall, Ratio, Result, Timing

START = datetime(2026, 3, 1, 9, 0, tzinfo=UTC)


def past_result(
    problem="segment", passed=("grid", "tangent"), failed=(), *, name="mine.py", mistake=None, ratio=None
):
    """A result with these groups passed and failed; with the first ones only, half of the points."""
    groups = [GroupResult(group, Verdict.AC, 10, 10, 0.5, 0.01, 50) for group in passed]
    groups += [GroupResult(group, Verdict.WA, 10, 4, None, 0.01, 50) for group in failed]
    return Result(
        problem,
        name,
        Mode.FUNCTION,
        Verdict.WA if failed else Verdict.AC,
        tuple(groups),
        Failure("off by 1", failed[0], 3, {"r": 10**30}, "1", "2") if failed else None,
        Timing(0.02, 0.03, Ratio(ratio, ratio, ratio, 9) if ratio else None),
        pitfall=Pitfall((mistake,), 0.9, ("Do better.",)) if mistake else None,
    )


def keep(history, result, source=b"", path="", when=START):
    """Keep a run that ended then; its number."""
    return history.keep(replace(run_of(result, source, path), when=when), source)
