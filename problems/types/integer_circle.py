"""`integer-circle`: (x, y, r) in integers; the radius is not negative."""

from judge.values.atoms import IntType
from judge.values.types import TupleType


def TYPE() -> TupleType:  # noqa: N802 - what the grammar looks for
    """The type."""
    return TupleType((IntType(), IntType(), IntType(0)), ("x", "y", "r"), "IntCircle")
