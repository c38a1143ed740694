"""A submission's own thresholds, as measured: where each of its decisions turns, and what that follows."""

from __future__ import annotations

from collections.abc import Mapping
from math import sqrt
from typing import Any

from msgspec import Struct

Sizes = Mapping[str, float]


class Flip(Struct, frozen=True):
    """Where a decision turns in one figure, between two true gaps in the figure's own units.

    Up to `low` it is taken as if there were no gap, from `high` on as if there were one. `high` is None where
    even the widest gap counts as none. `sizes` are the figure's lengths by name, that of the bands first.
    """

    sizes: Sizes
    low: float
    high: float | None

    @property
    def size(self) -> float:
        """The size that the bands count in."""
        return next(iter(self.sizes.values()))

    @property
    def gap(self) -> float:
        """One number for it: the middle of the two on a logarithmic scale."""
        if self.high is None or not self.low:
            return self.low
        return sqrt(self.low * self.high)

    def as_json(self) -> dict[str, Any]:
        """The flip in the published form."""
        return {"sizes": dict(self.sizes), "low": self.low, "high": self.high}


class Law(Struct, frozen=True):
    """What the thresholds follow: constant + factor · the product of the sizes, each to its power.

    Both numbers are 0 where a decision is taken without a threshold.
    """

    powers: Mapping[str, int]
    factor: float
    constant: float = 0.0

    def of(self, sizes: Sizes) -> float:
        """The threshold at these sizes."""
        product = self.factor
        for name, power in self.powers.items():
            product *= sizes[name] ** power
        return self.constant + product

    def as_json(self) -> dict[str, Any]:
        """The law in the published form."""
        return {"powers": dict(self.powers), "factor": self.factor, "constant": self.constant}


class Threshold(Struct, frozen=True):
    """One decision's thresholds in all its figures, and their law.

    The band is `within` of the first size, the promise holds from `beyond` of it. `mistake` names what is
    wrong with the law by its kind (judge.mistakes.epsilons); it is None where nothing is.
    """

    decision: str
    within: float
    beyond: float
    figures: tuple[Flip, ...]
    law: Law
    mistake: str | None = None

    @property
    def size(self) -> str:
        """The name of the size that the bands count in."""
        return next(iter(self.figures[0].sizes))

    @property
    def degree(self) -> int:
        """The power of the scale that the threshold grows with, but for its constant."""
        return sum(self.law.powers.values())

    @property
    def follows_its_size(self) -> bool:
        """Whether it is a share of the size that the bands count in, and of nothing else."""
        return bool(self.law.factor) and not self.law.constant and dict(self.law.powers) == {self.size: 1}

    def as_json(self) -> dict[str, Any]:
        """The threshold in the published form."""
        return {
            "decision": self.decision,
            "size": self.size,
            "within": self.within,
            "beyond": self.beyond,
            "law": self.law.as_json(),
            "mistake": self.mistake,
            "figures": [flip.as_json() for flip in self.figures],
        }
