"""How alike a submission is to programs that make known mistakes, and what wrong answers are reduced to."""

from __future__ import annotations

import pytest

from judge.mistakes.catalogue import MistakeText
from judge.mistakes.computed import ComputedProgram
from judge.mistakes.family import Maker
from judge.mistakes.likeness import CASES, Known, Likeness
from judge.run.result import Answers
from judge.values import outline
from judge.values.grammar import parse


def does(cases, answer=1):
    return {"a": Answers(40, {case: ("count", (float(answer),)) for case in cases})}


def made(name, answers, general=False):
    maker = Maker(name, "", "", MistakeText(), ComputedProgram(b"", ""), general=general)
    return Known(maker, answers)


def likeness(ours, **known):
    return Likeness([made(name, each) for name, each in known.items()], ours)


@pytest.mark.parametrize(
    ("theirs", "share"),
    [
        (does(range(10)), 1.0),
        (does(range(5)), 0.5),
        (does(range(10), answer=2), 0.5),
        (does(range(20)), 0.5),
        (does(range(10, 20)), 0.0),
        (does([*range(10), *range(CASES, 40)]), 1.0),
        ({}, 0.0),
    ],
)
def test_the_share_of_failures_that_a_known_program_has_too(theirs, share):
    assert likeness(does(range(10)), known=theirs).share("known") == share


def test_some_of_the_failures_alone():
    alike = likeness(does(range(10)), known=does(range(5)))
    assert alike.share("known", [("a", case) for case in range(5)]) == 1.0
    assert alike.share("known", [("a", case) for case in range(5, 10)]) == 0.0


@pytest.mark.parametrize(
    ("failing", "known", "best"),
    [
        (10, {"one": 10}, "one"),
        (10, {"one": 6}, "one"),
        (10, {"one": 5}, None),
        (10, {"one": 10, "other": 9}, None),
        (10, {"one": 10, "other": 8}, "one"),
        (4, {"one": 4}, None),
        (10, {}, None),
    ],
)
def test_a_name_is_given_where_it_is_sure(failing, known, best):
    found = likeness(
        does(range(failing)), **{name: does(range(count)) for name, count in known.items()}
    ).best()
    assert (found and found[0]) == best


def test_a_name_of_the_katas_own_goes_before_its_twin_of_all_katas():
    ours = does(range(10))
    twins = [made("everywhere", ours, general=True), made("own", ours)]
    assert Likeness(twins, ours).best() == ("own", 1.0)
    assert Likeness(twins[::-1], ours).best() == ("own", 1.0)
    both = [made("everywhere", ours, general=True), made("anywhere", ours, general=True)]
    assert Likeness(both, ours).best() is None


@pytest.mark.parametrize(
    ("kind", "answer", "wanted"),
    [
        ("count", 3, ("count", (3.0,))),
        ("count", {"type": "bool", "text": "True"}, ("type bool", ())),
        ("count", None, ("none", ())),
        ("points", [[1, 2.5]], ("points 1", (1.0, 2.5))),
        ("points", [0.5, 1], ("shape 2", (0.5, 1.0))),
        ("parameter", {"fraction": ["1", "2"]}, ("number", (0.5,))),
        ("parameter", [1.0, None], ("shape 2", (1.0,))),
        ("parameter", {"int": "f" * 300}, ("number", (float("inf"),))),
    ],
)
def test_outlines(kind, answer, wanted):
    assert outline.outline(parse(kind), answer) == wanted
