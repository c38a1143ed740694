"""How alike two wrong answers are, and two programs by theirs; what is compared."""

from __future__ import annotations

import math

import pytest

from judge.mistakes.agreement import Alike, WrongAnswer
from judge.mistakes.evidence import Evidence
from judge.mistakes.likeness import Likeness
from judge.mistakes.naming import Known
from judge.mistakes.nearest import nearest
from judge.run.result import Answers
from judge.values import outline
from judge.values.grammar import parse
from judge.values.outline import Usual

COUNT, USUAL = parse("count"), Usual(frozenset({0.0, 1.0, 2.0}))
RIGHTS = [outline.right(COUNT, 2)] * 40


def one(count):
    return ("count", (float(count),))


def likeness(ours, theirs):
    """Of two programs, by their wrong answers of 40 cases."""
    evidence = Evidence(Answers(40, ours), [Answers(40, theirs)], [1.0], RIGHTS, COUNT, USUAL)
    return Likeness.of([evidence.overlap(0)])


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
        (range(20), range(20), [False, False], 0.9, True),
        (range(20), range(20, 40), [True], 1.0, False),
    ],
)
def test_how_much_is_enough(ours, theirs, chances, score, wanted):
    ours, theirs = ({case: one(1) for case in cases if case < 40} for cases in (ours, theirs))
    assert likeness(ours, theirs).enough(chances, score) is wanted


def number(value):
    """The target of a number, as far as comparing wrong answers needs it."""
    return (value - 0.1, value + 0.1, value, 0.0, 2.0**-52)


POINT = ("points", [(number(1.0), number(1.0))])
CHORD = ("points", [(number(1.0), number(2.0)), (number(3.0), number(2.0))])
NO_T, T = ("parameter", None), ("parameter", number(1.0))


@pytest.mark.parametrize(
    ("one", "other", "target", "wanted"),
    [
        (("count", (1.0,)), ("count", (0.0,)), ("count", 2), Alike.NOTHING),
        (("count", (-1.0,)), ("count", (99.0,)), ("count", None), Alike.ALL),
        (("none", ()), ("count", (0.0,)), ("count", 2), Alike.NOTHING),
        (("raised ValueError", ()), ("count", (0.0,)), ("count", 2), Alike.KIND),
        (("points 1", (3.0, 4.0)), ("points 1", (3.0, 4.0000001)), POINT, Alike.ALL),
        (("points 1", (3.0, 4.0)), ("points 1", (4.0, 3.0)), POINT, Alike.NOTHING),
        (("points 1", (1.000001, 1.0)), ("points 1", (1.0, 0.999999)), POINT, Alike.KIND),
        (("points 1", (1.000001, 1.0)), ("points 1", (1.00000101, 1.0)), POINT, Alike.ALL),
        (("points 1", (1.0, 2.0)), ("points 0", ()), CHORD, Alike.NOTHING),
        (("points 2", (3.0, 2.0, 1.0, 2.0)), ("points 2", (3.01, 2.0, 1.0, 2.0)), CHORD, Alike.ALL),
        (("points 2", (3.0, 2.0, 1.0, 2.0)), ("points 2", (1.0, 2.0, 3.0, 9.0)), CHORD, Alike.NOTHING),
        (("number", (-1.0,)), ("number", (-2.0,)), NO_T, Alike.ALL),
        (("number", (0.5,)), ("number", (-1.0,)), NO_T, Alike.NOTHING),
        (("number", (5.0,)), ("number", (5.1,)), T, Alike.ALL),
        (("number", (5.0,)), ("number", (9.0,)), T, Alike.NOTHING),
        (("number", (math.inf,)), ("number", (2.0,)), T, Alike.NOTHING),
        (("shape 2", (1.0, 2.0)), ("shape 2", (5.0, 2.0)), T, Alike.NOTHING),
    ],
)
def test_how_alike_wrong_answers_are(one, other, target, wanted):
    text, doubles = target
    answer = parse(text)

    def alike(first, second):
        return WrongAnswer(first, outline.right(answer, doubles), answer, USUAL).alike(second)

    assert alike(one, other) == wanted == alike(other, one)
    assert alike(one, one) == Alike.ALL


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
