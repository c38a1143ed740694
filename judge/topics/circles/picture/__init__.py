"""Pictures of a failing case: the whole at true scale and a lens on the place that matters.

The geometry is exact (fractions and square roots) until it is relative to a panel's centre, for the gap of a
minimal case is 1e-9 of its circle and coordinates go to 10**100; what draws only ever sees numbers near 1.
"""

from judge.topics.circles.picture.compose import compose

__all__ = ["compose"]
