"""What a problem is, and the words it is judged in."""

from judge.problem.model import (
    AnswerKind,
    Argument,
    Case,
    Example,
    Group,
    Limits,
    Number,
    Parameter,
    ParameterType,
    Point,
    Problem,
    ShownSkill,
    Tier,
    TimeRule,
    Tolerance,
)
from judge.problem.verdict import Verdict

__all__ = [
    "AnswerKind",
    "Argument",
    "Case",
    "Example",
    "Group",
    "Limits",
    "Number",
    "Parameter",
    "ParameterType",
    "Point",
    "Problem",
    "ShownSkill",
    "Tier",
    "TimeRule",
    "Tolerance",
    "Verdict",
]
