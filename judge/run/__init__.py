"""Judging one submission: executing, comparing, measuring."""

from judge.run.execute import Settings, judge_fault, run_submission
from judge.run.measure import Reference
from judge.run.result import (
    Failure,
    GroupResult,
    Mode,
    Pitfall,
    Ratio,
    Result,
    Timing,
    exit_code,
)

__all__ = [
    "Failure",
    "GroupResult",
    "Mode",
    "Pitfall",
    "Ratio",
    "Reference",
    "Result",
    "Settings",
    "Timing",
    "exit_code",
    "judge_fault",
    "run_submission",
]
