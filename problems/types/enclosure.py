"""`enclosure`: (lo, hi), two numbers around the exact one; problem.py says whether they are close enough."""

from judge.values.atoms import RealType
from judge.values.types import TupleType


def TYPE() -> TupleType:  # noqa: N802 - what the grammar looks for
    """The type."""
    made = TupleType((RealType(), RealType()), ("lo", "hi"), "Enclosure")
    made.noun, made.settled = "(lo, hi)", False
    made.measured = False  # by no tolerance
    return made
