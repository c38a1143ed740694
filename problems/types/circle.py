"""`circle`: (x, y, r), the centre and the radius, which is not negative."""

from judge.values.atoms import RealType
from judge.values.types import TupleType


def TYPE() -> TupleType:  # noqa: N802 - what the grammar looks for
    """The type."""
    return TupleType((RealType(), RealType(), RealType(0)), ("x", "y", "r"), "Circle")
