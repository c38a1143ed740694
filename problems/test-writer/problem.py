"""Cases of `segment` that tell wrong programs from right ones: the known mistakes are the judges."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from judge.mistakes.killing import Jury
from judge.problem.declare import group
from judge.problem.load import load_problem
from judge.values.answers import Judged, Real, vector

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


def solve():
    """Any cases that do, such as those of the statement as far as it shows them."""
    shown = [(*map(Real, case[:3]), vector(case[3]), vector(case[4])) for case in SAMPLE]
    return Judged(why_not, shown)


def family(name, about):
    """All of its programs but a tenth are found out by the twelve cases; nothing is asked."""
    return group(name, about, lambda _draw: (), cases=1, skills="tests that find mistakes")


INTERVIEW = [
    family("formula", "Slips in the formula: a sign, a factor, a swapped pair."),
    family("answer", "Answers of a wrong form or in a wrong order, and points that are rounded."),
]

PRODUCTION = [
    family("ends", "What counts as on the segment: at its ends, beside them, beyond."),
    family("touching", "Touches: missed, counted twice, or decided by == or by a tolerance that is too wide."),
    family("degenerate", "A point for a segment, a point for a circle, and a segment that is nearly a point."),
    family("scale", "Tolerances measured by the wrong length."),
    family("precision", "Digits lost far from the origin, in 32-bit floats, in integers of 32 and 64 bits."),
]
