"""Naming mistakes: leave one program out, mixtures of two, silence where nothing fits."""

from __future__ import annotations

import math
import random
from collections import Counter

import pytest

from judge.data import load_data
from judge.mistakes.agreement import Alike, WrongAnswer
from judge.mistakes.answers import Answers
from judge.mistakes.known import KnownAnswers
from judge.mistakes.makers import distinct, read_makers
from judge.mistakes.naming import LEAST, Known, best_match
from judge.problem.find import find_problem
from judge.run import Settings
from judge.values import Usual, parse

pytestmark = pytest.mark.slow

MIXTURES = [
    ("segment", "no-clamp", "tangent-twice"),
    ("segment", "none-for-empty", "reversed-order"),
    ("count", "no-degenerate", "slope-intercept"),
    ("exact-count", "segment-for-line", "no-degenerate"),
]


class Groups(tuple):
    """A problem's groups, with the type of its answers."""

    def __new__(cls, groups, answer):
        made = super().__new__(cls, groups)
        made.answer = answer
        return made


def matched(behaviour, known, groups):
    return best_match(behaviour, known, groups, groups.answer)


@pytest.fixture(scope="module")
def library(built):
    """Each problem's groups and known programs, judged once."""
    found = {}
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("JUDGE_CACHE", str(built))
        for name in ("count", "segment", "ray-nearest", "exact-count"):
            problem = find_problem(name)
            data, read = load_data(problem), read_makers(problem)
            makers = [each for each in read.all if each.choice is not None]
            does, note = KnownAnswers(data, None, Settings(measured=False)).of([m.program for m in makers])
            assert (note, read.faults) == (None, ())
            known = [Known(makers[i].name, does[i], makers[i].chance) for i, *_ in distinct(makers, does)]
            found[name] = Groups(data.groups, problem.answer), known, [each.name for each in known]
    return found


def named(match, known):
    return {known[place].name for place in match.places} if match else set()


def test_a_known_program_is_recognised(library):
    """What fails in a few cases of one group may be too little to say; another name is never said."""
    outcomes = Counter()
    for groups, known, _ in library.values():
        for each in known[::8]:
            match = matched(each.behaviour, known, groups)
            outcomes["silent" if match is None else each.name in named(match, known)] += 1
            assert match is None or 0.7 <= match.score <= 1.0
    assert outcomes[True] > 0.97 * outcomes.total()
    assert outcomes[False] == 0


@pytest.mark.parametrize(("problem", "one", "other"), MIXTURES)
def test_two_mistakes_at_once(library, problem, one, other):
    groups, known, files = library[problem]
    first, second = known[files.index(one)], known[files.index(other)]
    mixed = {
        name: Answers(
            min(first.behaviour[name].reached, second.behaviour[name].reached),
            {**first.behaviour[name].wrong, **second.behaviour[name].wrong},
        )
        for name in first.behaviour
    }
    match = matched(mixed, known, groups)
    assert {first.name, second.name} == named(match, known) or match.score > 0.97
    assert len(match.places) == 2


@pytest.mark.parametrize("share", [0.02, 0.3, 1.0])
def test_silence_on_noise(library, share):
    for groups, known, _ in library.values():
        draw = random.Random(7)
        noise = {
            group.group.name: Answers(
                len(group.cases),
                {i: ("noise", (draw.random(),)) for i in range(len(group.cases)) if draw.random() < share},
            )
            for group in groups
        }
        assert matched(noise, known, groups) is None


@pytest.mark.parametrize("answer", [("count", (0.0,)), ("points 0", ()), ("none", ())])
def test_silence_on_one_answer_to_everything(library, answer):
    for groups, known, _ in library.values():
        always = {
            group.group.name: Answers(
                len(group.cases),
                {
                    i: answer
                    for i, target in enumerate(group.targets)
                    if groups.answer.right(target) != answer
                },
            )
            for group in groups
        }
        assert matched(always, known, groups) is None


def test_silence_without_evidence(library):
    groups, known, _ = library["count"]
    assert matched({}, known, groups) is None
    assert matched({groups[0].group.name: Answers(13, {})}, known, groups) is None
    assert matched({groups[0].group.name: Answers(13, {3: ("text", ())})}, [], groups) is None
    one_case = {groups[1].group.name: Answers(200, {5: ("count", (9.0,))})}
    assert matched(one_case, known, groups) is None


def test_unfinished_groups_are_compared_as_far_as_they_went(library):
    groups, known, files = library["count"]
    whole = known[files.index("tangent-twice")].behaviour
    half = {
        name: Answers(
            answers.reached // 2, {i: w for i, w in answers.wrong.items() if i < answers.reached // 2}
        )
        for name, answers in whole.items()
    }
    match = matched(half, known, groups)
    assert named(match, known) == {"tangent-twice"}
    assert match.score > 0.95


def test_most_unknown_mistakes_are_met_with_silence(library):
    """With all programs of a mistake gone, what is named in its place is one that looks nearly the same.

    Vetoes, which keep many of these names back in a run, are left out here.
    """
    outcomes = Counter()
    for groups, known, files in library.values():
        for each, file in zip(known, files, strict=True):
            if known[files.index(file)] is each:
                others = [other for other in known if other.name != each.name]
                outcomes[matched(each.behaviour, others, groups) is None] += 1
    assert outcomes[True] > 0.75 * outcomes.total()


def test_a_mistake_is_recognised_by_its_other_programs(library):
    """One program left out at a time; of two programs of a mistake only, half may be too different."""
    outcomes = Counter()
    for groups, known, _ in library.values():
        for each in known[3::6]:
            others = [other for other in known if other is not each]
            if any(other.name == each.name for other in others):
                match = matched(each.behaviour, others, groups)
                outcomes["silent" if match is None else each.name in named(match, others)] += 1
    assert outcomes[True] > 0.45 * outcomes.total()
    assert outcomes[False] < 0.06 * outcomes.total()


def number(value):
    """The target of a number, as far as comparing wrong answers needs it."""
    return (value - 0.1, value + 0.1, value, 0.0, 2.0**-52)


POINT = ("points", [(number(1.0), number(1.0))])
CHORD = ("points", [(number(1.0), number(2.0)), (number(3.0), number(2.0))])
NO_T, T = ("parameter", None), ("parameter", number(1.0))
USUAL = Usual(frozenset({0.0, 1.0, 2.0}))


@pytest.mark.parametrize(
    ("one", "other", "target", "wanted"),
    [
        (("count", (1.0,)), ("count", (0.0,)), ("count", 2), Alike.NOTHING),
        (("count", (-1.0,)), ("count", (99.0,)), ("count", None), Alike.ALL),
        (("count", (3.0,)), ("type float", ()), ("count", None), Alike.ALL),
        (("type float", (1.0,)), ("count", (0.0,)), ("count", 2), Alike.NOTHING),
        (("none", ()), ("count", (0.0,)), ("count", 2), Alike.NOTHING),
        (("raised ValueError", ()), ("count", (0.0,)), ("count", 2), Alike.KIND),
        (("raised ValueError", ()), ("raised ZeroDivisionError", ()), ("count", 2), Alike.KIND),
        (("points 1", (3.0, 4.0)), ("points 1", (3.0, 4.0000001)), POINT, Alike.ALL),
        (("points 1", (3.0, 4.0)), ("points 1", (4.0, 3.0)), POINT, Alike.NOTHING),
        (("points 1", (1.000001, 1.0)), ("points 1", (1.0, 0.999999)), POINT, Alike.KIND),
        (("points 1", (1.000001, 1.0)), ("points 1", (1.00000101, 1.0)), POINT, Alike.ALL),
        (("points 1", (1.0001, 1.0)), ("points 1", (1.0, 0.999999)), POINT, Alike.NOTHING),
        (("points 2", (1.0, 1.0, 1.0, 1.0)), ("points 2", (1.0, 1.0, 1.0, 1.0001)), POINT, Alike.ALL),
        (("points 1", (1.0, 2.0)), ("points 0", ()), CHORD, Alike.NOTHING),
        (("points 2", (3.0, 2.0, 1.0, 2.0)), ("points 2", (3.01, 2.0, 1.0, 2.0)), CHORD, Alike.ALL),
        (("points 2", (3.0, 2.0, 1.0, 2.0)), ("points 2", (1.0, 2.0, 3.0, 9.0)), CHORD, Alike.NOTHING),
        (("number", (-1.0,)), ("number", (-2.0,)), NO_T, Alike.ALL),
        (("number", (-1.0,)), ("type float", ()), NO_T, Alike.ALL),
        (("number", (0.5,)), ("number", (-1.0,)), NO_T, Alike.NOTHING),
        (("number", (5.0,)), ("number", (5.1,)), T, Alike.ALL),
        (("number", (5.0,)), ("number", (9.0,)), T, Alike.NOTHING),
        (("number", (0.5,)), ("number", (9.0,)), T, Alike.NOTHING),
        (("number", (-2.0,)), ("number", (0.3,)), T, Alike.NOTHING),
        (("number", (math.inf,)), ("number", (2.0,)), T, Alike.NOTHING),
        (("shape 2", (1.0, 2.0)), ("shape 2", (5.0, 2.0)), T, Alike.NOTHING),
        (("type bool", ()), ("type bool", ()), T, Alike.ALL),
    ],
)
def test_how_alike_wrong_answers_are(one, other, target, wanted):
    text, doubles = target
    answer = parse(text)

    def alike(first, second):
        return WrongAnswer(first, answer.right(doubles), answer, USUAL).alike(second)

    assert alike(one, other) == wanted == alike(other, one)
    assert alike(one, one) == Alike.ALL


@pytest.mark.parametrize(
    ("kind", "answer", "wanted"),
    [
        ("count", 3, ("count", (3.0,))),
        ("count", 1.0, ("type float", (1.0,))),
        ("count", {"type": "bool", "text": "True"}, ("type bool", ())),
        ("count", None, ("none", ())),
        ("points", [[1, 2.5]], ("points 1", (1.0, 2.5))),
        ("points", [0.5, 1], ("shape 2", (0.5, 1.0))),
        ("points", [], ("points 0", ())),
        ("points", 4.0, ("number", (4.0,))),
        ("parameter", {"fraction": ["1", "2"]}, ("number", (0.5,))),
        ("parameter", [1.0, None], ("shape 2", (1.0,))),
        ("parameter", {"int": "f" * 300}, ("number", (float("inf"),))),
        ("parameter", {"what": "ever"}, ("type dict", ())),
    ],
)
def test_outlines(kind, answer, wanted):
    assert parse(kind).outline(answer) == wanted


def test_a_line_has_the_outline_of_its_answer():
    assert parse("points").line_outline("1 0.5 2") == ("points 1", (0.5, 2.0))
    assert parse("count").line_outline("none") == ("none", ())
    assert parse("parameter").line_outline("0.1e1") == ("number", (1.0,))
    assert parse("count").line_outline("two") == ("text", ())
    assert LEAST == 0.7
