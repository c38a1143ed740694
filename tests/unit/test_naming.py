"""Naming the mistakes of whole katas: one program left out, mixtures of two, silence where nothing fits."""

from __future__ import annotations

import random

import pytest
from sampling import daily

from judge.data import load_data
from judge.mistakes.answers import Answers
from judge.mistakes.known import KnownAnswers
from judge.mistakes.makers import distinct, read_makers
from judge.mistakes.naming import Known, best_match
from judge.problem.find import find_problem
from judge.run import Settings

pytestmark = pytest.mark.slow

MIXTURES = {"segment": ("no-clamp", "tangent-twice"), "exact-count": ("segment-for-line", "no-degenerate")}


class Library:
    """A problem's groups and its known programs, judged once."""

    def __init__(self, name):
        self.problem = find_problem(name)
        data, read = load_data(self.problem), read_makers(self.problem)
        makers = [each for each in read.all if each.choice is not None]
        does, note = KnownAnswers(data, None, Settings(measured=False)).of([m.program for m in makers])
        assert (note, read.faults) == (None, ())
        self.groups = data.groups
        self.known = [Known(makers[i].name, does[i], makers[i].chance) for i, *_ in distinct(makers, does)]

    def behaviour(self, name):
        return next(each.behaviour for each in self.known if each.name == name)

    def match(self, behaviour, known=None):
        return best_match(behaviour, known or self.known, self.groups, self.problem.answer)

    def said(self, behaviour, known=None):
        match = self.match(behaviour, known)
        return {(known or self.known)[place].name for place in match.places} if match else set()


@pytest.fixture(scope="module")
def library_of(built):
    kept = {}

    def of(name):
        with pytest.MonkeyPatch.context() as patch:
            patch.setenv("JUDGE_CACHE", str(built))
            kept[name] = kept.get(name) or Library(name)
        return kept[name]

    return of


@pytest.fixture(params=daily(MIXTURES, ["exact-count"]))
def library(request, library_of):
    return library_of(request.param)


def test_two_mistakes_at_once_and_one_that_went_half_of_the_way(library):
    one, other = MIXTURES[library.problem.id]
    first, second = library.behaviour(one), library.behaviour(other)
    mixed, half = {}, {}
    for name, each in second.items():
        mixed[name] = Answers(min(first[name].reached, each.reached), {**first[name].wrong, **each.wrong})
        end = each.reached // 2
        half[name] = Answers(end, {i: wrong for i, wrong in each.wrong.items() if i < end})
    match = library.match(mixed)
    assert {one, other} == library.said(mixed) or match.score > 0.97
    assert len(match.places) == 2
    assert library.said(half) == {other}
    assert library.match(half).score > 0.95


@pytest.mark.parametrize("share", [0.02, 1.0])
def test_silence_on_noise(library, share):
    draw = random.Random(7)
    noise = {
        group.group.name: Answers(
            len(group.cases),
            {i: ("noise", (draw.random(),)) for i in range(len(group.cases)) if draw.random() < share},
        )
        for group in library.groups
    }
    assert library.match(noise) is None


@pytest.mark.parametrize("answer", [("count", (0.0,)), ("none", ())])
def test_silence_on_one_answer_to_everything(library, answer):
    right = library.problem.answer.right
    always = {
        group.group.name: Answers(
            len(group.cases), {i: answer for i, target in enumerate(group.targets) if right(target) != answer}
        )
        for group in library.groups
    }
    assert library.match(always) is None


def test_silence_without_evidence(library):
    first, second = (group.group.name for group in library.groups[:2])
    assert library.match({}) is None
    assert library.match({first: Answers(13, {})}) is None
    assert (
        best_match({first: Answers(13, {3: ("text", ())})}, [], library.groups, library.problem.answer)
        is None
    )
    assert library.match({second: Answers(20, {5: ("count", (9.0,))})}) is None
