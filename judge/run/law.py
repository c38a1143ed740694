"""How the CPU time of a submission grows with the size, and in which words."""

from __future__ import annotations

import math
from collections.abc import Sequence
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
        took = [(point.size, point.cpu_seconds) for point in points]
        steps = [exponent(pair) for pair in pairwise(took) if pair[0][0] < pair[1][0]]
        if all(point.ended for point in points) and (not steps or steps[-1] <= steps[0] + _SETTLED):
            return f"like n^{self.exponent:.1f}"
        return f"at least like n^{math.floor(self.exponent * 10) / 10:.1f}"


def exponent(points: Sequence[tuple[int, float]]) -> float:
    """The e of the law y = c·nᵉ that fits the points (n, y) best; of n at least two must differ."""
    xs = [math.log(size) for size, _ in points]
    ys = [math.log(max(value, _SHORTEST)) for _, value in points]
    x_mean, y_mean = math.fsum(xs) / len(xs), math.fsum(ys) / len(ys)
    over = math.fsum((x - x_mean) * (y - y_mean) for x, y in zip(xs, ys, strict=True))
    return over / math.fsum((x - x_mean) ** 2 for x in xs)
