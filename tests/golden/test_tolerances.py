"""A tolerance below 1e-7 of the size is right; one above it is wrong, and so is one of another size."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import pytest
from sampling import daily

from judge.data.load import load_data
from judge.problem.find import find_problem
from judge.run.execute import judge_submission
from judge.run.settings import Settings

SOLUTIONS = Path(__file__).parents[2] / "solutions"
COMPARED = re.compile(r"\b1e-[89] \* ")  # the usual tolerance, or the widest that there is
# The tolerance of `shadow` is how far off the surface a second ray starts, which may not be so small.
KATAS = sorted({path.parents[1].name for path in SOLUTIONS.glob("*/accepted/tolerant.py")} - {"shadow"})
RIGHT, WRONG = ("1e-12", "1e-9", "0.5e-7", "0.9e-7"), ("1.5e-7", "2e-7")
SEEDS = None, 31, 32
LEAST = 5  # cases that must reject what is wrong
# A quantity that the statement's size has not, or one that it has and the program leaves out.
CENTRE, AWAY, LONG = "max(abs(cx), abs(cy), ", "max(*map(abs, C), ", "max(hypot(*D), "
SIZES = [
    *((kata, "max(", CENTRE) for kata in ("segment", "count", "chord", "line-points", "on-circle")),
    *((kata, "max(", how) for kata in ("ray-nearest", "normal", "reflect") for how in (CENTRE, LONG)),
    *(("sphere", "max(", how) for how in (AWAY, LONG)),
    *((kata, "max(r1", "max(abs(cx1), abs(cy1), r1") for kata in ("circle-circle", "common-tangents")),
    *((kata, "max(r", f"{CENTRE}r") for kata in ("tangents", "polygon")),
    *((kata, "max(r", "max(*map(abs, P0), r") for kata in ("swept-balls", "swept-wall")),
    *(
        (kata, "max(r", f"max(*map(abs, {v}), r")
        for kata in ("enter-exit", "csg", "silhouette")
        for v in "OD"
    ),
    ("segment", ", abs(ax), abs(ay)", ""),
    ("ray-nearest", ", abs(fx), abs(fy)", ""),
]

pytestmark = pytest.mark.slow


@pytest.mark.parametrize("kata", daily(KATAS, ["count", "circle-circle"]))
def test_a_tolerance_is_right_up_to_the_promise_and_not_beyond(kata):
    assert COMPARED.search(tolerant(kata))
    for tolerance in (*RIGHT, *WRONG):
        changed = COMPARED.sub(f"{tolerance} * ", tolerant(kata))
        for seed in SEEDS:
            failing = failures(kata, changed, seed)
            assert failing >= LEAST if tolerance in WRONG else failing == 0, (tolerance, seed, failing)


@pytest.mark.parametrize("size", daily(SIZES, [SIZES[0], SIZES[-1]]), ids="-".join)
def test_a_size_of_other_quantities_is_wrong(size):
    kata, was, becomes = size
    assert was in tolerant(kata)
    changed = tolerant(kata).replace(was, becomes, 1)
    for seed in SEEDS:
        assert failures(kata, changed, seed) >= LEAST, seed


def tolerant(kata):
    return (SOLUTIONS / kata / "accepted" / "tolerant.py").read_text(encoding="utf-8")


@cache
def data_of(kata, seed):
    return load_data(find_problem(kata), seed=seed)


def failures(kata, source, seed):
    """How many cases reject it."""
    settings = Settings(measured=False)
    found = judge_submission(data_of(kata, seed), source.encode(), "mine.py", settings).result
    return sum(group.cases - group.passed for group in found.groups)
