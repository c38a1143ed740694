"""Deciding answers exactly: acceptance intervals, reasons, the text of program mode.

`answers` and `tolerance` need exact numbers; everything exported here does without them until it must ask.
"""

from judge.compare.check import Accepted, Exact, Outcome, Rejection, check, wanted_text
from judge.compare.targets import (
    AnyTarget,
    CountTarget,
    ParameterTarget,
    PointsTarget,
    Target,
    compile_answer,
    from_json,
    to_json,
)
from judge.compare.text import check_line, render

__all__ = [
    "Accepted",
    "AnyTarget",
    "CountTarget",
    "Exact",
    "Outcome",
    "ParameterTarget",
    "PointsTarget",
    "Rejection",
    "Target",
    "check",
    "check_line",
    "compile_answer",
    "from_json",
    "render",
    "to_json",
    "wanted_text",
]
