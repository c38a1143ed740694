"""What a problem is, and the words it is judged in."""

from judge.problem.model import Case, Example, Group, Parameter, Problem, Tier, TimeRule, Verdict
from judge.values.answers import Tolerance

__all__ = ["Case", "Example", "Group", "Parameter", "Problem", "Tier", "TimeRule", "Tolerance", "Verdict"]
