"""How the CPU time of a submission grows with the size, and in which words."""

from __future__ import annotations

import math
from itertools import pairwise

from msgspec import Struct

_SETTLED = 0.25  # by which its exponent may differ between the smallest sizes and the largest ones
_SHORTEST = 1e-4  # seconds: what takes less cannot be told from nothing


class GrowthPoint(Struct, frozen=True):
    """The CPU seconds of one case; the submission takes so many at least, where it has not `ended`."""

    group: str
    size: int
    cpu_seconds: float
    reference_seconds: float
    ended: bool = True


class Growth(Struct, frozen=True):
    """How CPU time grows with n: `exponent` is the submission's, `reference` that of the reference solution.

    `slope` is by how much the first may exceed the second, `groups` are those that the exponents are of, and
    `pairs` how many interleaved pairs of runs the widest of them had. `points` are all that took long enough,
    by size.
    """

    exponent: float
    reference: float
    slope: float
    groups: tuple[str, ...]
    pairs: int
    borderline: bool = False
    points: tuple[GrowthPoint, ...] = ()

    def __str__(self) -> str:
        return f"it grows {self.law}, the reference like n^{self.reference:.1f}"

    @property
    def too_steep(self) -> str:
        """Why a submission that grows so is rejected."""
        return f"{self}; its exponent may exceed that by {self.slope:g}"

    @property
    def law(self) -> str:
        """`like n^2.0`; `at least` like that where it was stopped on a size, or still grows ever faster."""
        points = [point for point in self.points if point.group in self.groups]
        took = [(point.size, max(point.cpu_seconds, _SHORTEST)) for point in points]
        steps = [math.log(t / s, n / m) for (m, s), (n, t) in pairwise(took) if m < n]
        if all(point.ended for point in points) and (not steps or steps[-1] <= steps[0] + _SETTLED):
            return f"like n^{self.exponent:.1f}"
        return f"at least like n^{math.floor(self.exponent * 10) / 10:.1f}"
