"""The shipped data hold what the statements promise: a short search finds no wrong program that they accept.

`judge verify --holes` looks longer.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from sampling import daily

from judge.data.load import load_data
from judge.holes.hunt import look_for_holes
from judge.holes.model import HoleSearch
from judge.problem.load import load_problem
from judge.sandbox import Containment
from judge.sandbox.available import levels_here

PROBLEMS = Path(__file__).parents[2] / "problems"
NAMES = sorted(path.parent.name for path in PROBLEMS.glob("*/problem.toml"))
BY_DAY = ["circle-side", "crossings", "distance", "exact-count", "on-circle"]
CASES = 300

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(
        not any(each.available for each in levels_here() if each.name != "limits"),
        reason="mutants need isolation full or strong",
    ),
]


class _Nothing:
    """A store that keeps nothing."""

    def read(self, name, key, kind):
        return None

    def write(self, name, key, value, what=""):
        return None


@pytest.mark.parametrize("name", daily(NAMES, BY_DAY))
def test_no_hole_is_found_in_a_short_search(name):
    problem = load_problem(PROBLEMS / name)
    search = HoleSearch(seed=1, seconds=1e9, cases=CASES)
    found = look_for_holes(problem, [load_data(problem)], Containment(), search, _Nothing())
    assert [f"{hole.file}:{hole.line} {hole.becomes} at {hole.case}" for hole in found.holes] == []
    assert found.faults == ()
