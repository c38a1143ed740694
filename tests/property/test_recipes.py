"""What draws a case: choices lie within their ends, are even, and are passed over where they fail."""

from __future__ import annotations

from collections import Counter
from itertools import product
from pathlib import Path

import pytest
from hypothesis import find, settings

from judge.data.draw import Draw, Rejected, quick, seeded
from judge.data.load import load_data
from judge.diagnose.search import strategy
from judge.errors import ProblemError
from judge.problem.load import load_problem

ON_CIRCLE = Path(__file__).parents[2] / "problems" / "on-circle"


def test_a_seed_gives_the_same_data_from_the_same_choices_and_another_seed_other_data():
    problem = load_problem(ON_CIRCLE)
    first, again, other = (load_data(problem, seed=seed, store=None) for seed in (5, 5, 6))
    assert [each.cases for each in first.groups] == [each.cases for each in again.groups]
    pairs = zip(first.groups, other.groups, strict=True)
    assert [one for one, two in pairs if one.cases == two.cases] == [first.groups[0]]


@pytest.mark.parametrize("source", [seeded, quick])
def test_choices_reach_everything_within_their_ends_evenly(source):
    draw = Draw(source("even"))
    assert len({source(str(seed))(0, 10**9) for seed in range(100)}) == 100
    assert all(-(10**400) <= draw.integer(-(10**400), 10**400) <= 10**400 for _ in range(300))
    counts = Counter(each for _ in range(5000) for each in (draw.integer(-2, 2), draw.choice("abcde")))
    assert len(counts) == 10
    assert all(850 < each < 1150 for each in counts.values())
    assert {(draw.sign(), draw.boolean()) for _ in range(60)} == {*product((-1, 1), (False, True))}
    for impossible in (lambda: draw.integer(1, 0), lambda: draw.choice([])):
        with pytest.raises(ValueError, match=r"no integer from 1 to 0|nothing to choose from"):
            impossible()


def test_what_a_seed_gives_is_the_same_on_every_python():
    """Pinned data rest on it: no `random`, whose streams may change, and no hash of a process."""
    draw = Draw(seeded("pinned"))
    assert [draw.integer(-(10**6), 10**6) for _ in range(4)] == [212254, 192178, -54649, -874440]
    assert [draw.sign() for _ in range(12)] == [1, -1, 1, -1, 1, 1, -1, 1, 1, -1, -1, -1]
    assert [draw.integer(0, 10**200) % 10**9 for _ in range(3)] == [
        733813679,
        224258830,
        356450052,
    ]  # beyond one digest of 512 bits


@pytest.mark.parametrize("fault", [ZeroDivisionError, Rejected, ProblemError("no such figure")])
def test_choices_that_a_builder_cannot_use_are_passed_over_in_a_search(fault):
    def builder(draw):
        if draw.integer(0, 9) < 4:
            raise fault
        return (draw.integer(0, 3),)

    found = find(strategy(builder), lambda case: case[0] > 1, settings=settings(database=None))
    assert found == (2,)
