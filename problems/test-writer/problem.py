"""Cases of `segment` that tell wrong programs from right ones: the known mistakes are the judges."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from judge.mistakes.killing import Jury
from judge.problem.load import load_problem
from judge.values import Judged, Real, vector

FAMILIES = {
    "formula": [
        "diameter-for-radius",
        "forgotten-centre",
        "point-for-direction",
        "radius-not-squared",
        "swapped-coordinates",
        "foot-sign",
        "wrong-sign",
        "forgotten-abs",
        "sqrt-of-negative",
        "unnormalised-distance",
        "slope-intercept",
    ],
    "answer": [
        "none-for-empty",
        "first-root-only",
        "parameter-for-point",
        "reversed-order",
        "sorted-by-x",
        "unsorted",
        "floor-division",
        "whole-numbers",
        "rounded-output",
    ],
    "ends": [
        "clamp-to-ends",
        "no-clamp",
        "inside-ends",
        "open-interval",
        "x-range-only",
        "tangent-unclamped",
        "loose-clamp",
        "no-snap",
    ],
    "touching": [
        "tangent-missed",
        "tangent-twice",
        "sign-of-zero",
        "equality-tangency",
        "loose-epsilon",
    ],
    "degenerate": [
        "no-degenerate",
        "zero-radius",
        "degenerate-tight",
        "degenerate-epsilon-absolute",
        "degenerate-loose",
        "short-is-a-point",
    ],
    "scale": [
        "absolute-epsilon",
        "coordinate-epsilon",
    ],
    "precision": ["global-frame", "single-precision", "cancellation", "overflow-32", "overflow-64"],
}
SAMPLE = [(0, 0, 5, (-6, 3), (6, 3))]  # the statement's example


@cache
def jury():
    """Who knows the wrong programs of `segment`; they are read when the first answer is judged."""
    return Jury(load_problem(Path(__file__).parent.parent / "segment"), FAMILIES)


def why_not(cases, group):
    """What the cases lack for that group."""
    return jury().why_not(cases, group)


def asked(_draw):
    """Nothing is asked: the function has no parameters."""
    return ()


def solve():
    """Any cases that do, such as those of the statement as far as it shows them."""
    shown = [(*map(Real, case[:3]), vector(case[3]), vector(case[4])) for case in SAMPLE]
    return Judged(why_not, shown), None


BUILDERS = {"asked": asked}
