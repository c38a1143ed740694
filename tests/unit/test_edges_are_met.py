"""Pinned data and fresh cases tell memories and extents that are wrong by little from right ones."""

from __future__ import annotations

from itertools import islice
from pathlib import Path

import pytest
from sampling import daily

from judge.data import load_data
from judge.data.fresh import Fresh
from judge.exact import Surd
from judge.problem.load import load_problem
from judge.topics.circles.line import CircleLine

pytestmark = pytest.mark.slow

PROBLEMS = Path(__file__).parents[2] / "problems"
ELSEWISE = {"beams", "nearest", "vector", "shadow", "common-tangents"}
BANDED = [
    path.parent.name for path in sorted(PROBLEMS.glob("*/problem.toml")) if "[bands]" in path.read_text()
]
KATAS = [name for name in BANDED if name not in ELSEWISE]
ROUNDS = 2  # of fresh cases: less than `judge stress` makes in a second


def pinned_and_fresh(name, cache):
    """A problem's cases with their targets, in order: the pinned ones, and some fresh ones."""
    problem = load_problem(PROBLEMS / name)
    data = load_data(problem)
    fresh = Fresh(problem, data.module, problem.groups, 11)
    series = [each.data for each in islice(fresh.series(), ROUNDS * len(fresh.groups))]
    return [
        [pair for each in several for pair in zip(each.cases, each.targets, strict=True)]
        for several in (data.groups, series)
    ]


@pytest.fixture
def cache(built, monkeypatch):
    monkeypatch.setenv("JUDGE_CACHE", str(built))


def remembered_wrongly(cases, place, *, last):
    """How many cases have another target than the one that is remembered for all arguments but one."""
    kept, wrong = {}, 0
    for case, target in cases:
        key = case[:place] + case[place + 1 :]
        if last:
            kept = {each: kept[each] for each in kept if each == key}
        wrong += kept.setdefault(key, target) != target
    return wrong


@pytest.mark.parametrize("name", daily([*KATAS, "exact-count", "foot"], ["count", "segment"]))
def test_a_memory_that_leaves_an_argument_out_is_met(name, cache):
    pinned, fresh = pinned_and_fresh(name, cache)
    for place in range(3 if name == "silhouette" else len(pinned[0][0])):  # h is hardly ever another
        for last in (False, True):
            assert remembered_wrongly(pinned, place, last=last) >= 5, place
            assert remembered_wrongly(fresh, place, last=last) >= 1, place


EXTENTS = {  # by r, A − C and B − C
    "r": lambda r, ax, ay, bx, by: r,
    "without A": lambda r, ax, ay, bx, by: max(r, abs(bx), abs(by)),
    "without B": lambda r, ax, ay, bx, by: max(r, abs(ax), abs(ay)),
    "without x": lambda r, ax, ay, bx, by: max(r, abs(ay), abs(by)),
    "without y": lambda r, ax, ay, bx, by: max(r, abs(ax), abs(bx)),
    "without a sign": lambda r, *places: max(r, *places),
    "with the other sign": lambda r, *places: max(r, *(-each for each in places)),
    "A to B": lambda r, ax, ay, bx, by: max(abs(bx - ax), abs(by - ay)),
}


@pytest.mark.parametrize("extent", EXTENTS)
@pytest.mark.parametrize("name", ["count", "chord", "line-points"])
def test_another_length_than_the_extent_is_met(name, extent, cache):
    """A touch is off by more than 1e-10 of that length, which a program takes for the extent."""
    problem = load_problem(PROBLEMS / name)
    met = 0
    for case in (case for data in load_data(problem).groups for case in data.cases):
        line = CircleLine.through(*case)
        x, y = line.ax - line.cx, line.ay - line.cy
        length = EXTENTS[extent](line.r, x, y, x + line.dx, y + line.dy)
        gap = abs(float(Surd(-line.r * line.a, abs(line.k), line.a, line.a))) if line.a else 0.0
        met += 1e-10 * length < gap <= 1e-12 * line.extent
    assert met >= 5
