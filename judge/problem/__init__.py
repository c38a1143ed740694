"""What a problem is, and the words it is judged in."""

from judge.problem.model import (
    Argument,
    Case,
    Example,
    Group,
    GroupLimits,
    GrowthRule,
    Parameter,
    Point,
    Problem,
    ShownSkill,
    Tier,
    TimeRule,
    Verdict,
)
from judge.values.answers import Tolerance
from judge.values.atoms import Number

__all__ = [
    "Argument",
    "Case",
    "Example",
    "Group",
    "GroupLimits",
    "GrowthRule",
    "Number",
    "Parameter",
    "Point",
    "Problem",
    "ShownSkill",
    "Tier",
    "TimeRule",
    "Tolerance",
    "Verdict",
]
