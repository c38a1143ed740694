"""How alike two programs are by their wrong answers, and what is near enough to be compared."""

from __future__ import annotations

import pytest

from judge.mistakes.answers import Answers
from judge.mistakes.evidence import Evidence
from judge.mistakes.likeness import Likeness
from judge.mistakes.naming import Known
from judge.mistakes.nearest import nearest
from judge.values import Usual, parse

COUNT, USUAL = parse("count"), Usual(frozenset({0.0, 1.0, 2.0}))
RIGHTS = [COUNT.right(2)] * 40


def one(count):
    return ("count", (float(count),))


def likeness(ours, theirs):
    """Of two programs, by their wrong answers of 40 cases."""
    evidence = Evidence(Answers(40, ours), [Answers(40, theirs)], [1.0], RIGHTS, COUNT, USUAL)
    return Likeness.of([evidence.overlap(0)])


def test_likeness_counts_cases_of_either():
    same = {case: one(1) for case in range(20)}
    assert likeness(same, same).share == 1.0
    assert likeness(same, {**same, **{case: one(1) for case in range(20, 40)}}).share == 0.5
    assert likeness(same, {case: one(0) for case in range(20)}).share == 0.0
    assert likeness({}, {}).share == 0.0


def test_an_answer_is_not_like_an_exception():
    ended = dict.fromkeys(range(20), ("raised ValueError", ()))
    other = dict.fromkeys(range(20), ("raised ZeroDivisionError", ()))
    assert likeness({case: one(-1) for case in range(20)}, ended).share == 0.0
    assert likeness(other, ended).share == 1.0


@pytest.mark.parametrize(
    ("ours", "theirs", "chances", "score", "wanted"),
    [
        (range(20), range(20), [False], 0.9, True),
        (range(20), range(23), [False], 0.9, False),
        (range(30), range(20), [False], 0.9, True),
        (range(41, 90), range(20), [False], 0.9, False),
        (range(20), range(35), [True], 0.7, True),
        (range(30), range(20, 40), [True], 0.9, True),
        (range(30), range(20, 40), [True], 0.8, False),
        (range(20), range(35), [True, False], 0.9, False),
        (range(30), range(20), [False, False], 0.9, False),
        (range(20), range(20), [False, False], 0.9, True),
        (range(20), range(20, 40), [True], 1.0, False),
    ],
)
def test_how_much_is_enough(ours, theirs, chances, score, wanted):
    ours, theirs = ({case: one(1) for case in cases if case < 40} for cases in (ours, theirs))
    assert likeness(ours, theirs).enough(chances, score) is wanted


class Data:
    """A group with as many cases."""

    def __init__(self, name, size):
        self.group = type("Group", (), {"name": name})
        self.cases = [None] * size


def program(name, cases):
    return Known(name, {"a": Answers(40, {case: one(1) for case in cases})}, chance=False)


def test_only_what_fails_like_cases_is_compared():
    known = [
        program("same", range(20)),
        program("half", range(10)),
        program("rest", range(10, 20)),
        program("elsewhere", range(30, 40)),
    ]
    found = nearest({"a": Answers(40, {case: one(1) for case in range(20)})}, known, [Data("a", 40)])
    assert found.same == (0,)
    assert found.worth == (0, 1, 2)
    first, *others = [{known[place].name for place in pair} for pair in found.pairs]
    assert first == {"half", "rest"}
    assert not any("elsewhere" in pair for pair in others)


def test_what_fails_everywhere_is_like_nothing_that_does_not():
    known = [program("few", range(3)), program("none", ())]
    found = nearest({"a": Answers(40, {case: one(1) for case in range(40)})}, known, [Data("a", 40)])
    assert (found.same, found.worth, [*found.pairs]) == ((), (), [])
