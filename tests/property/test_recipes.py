"""What the groups of the shipped katas promise by their names and sentences, by the topics' exact predicates.

A line of PROMISED is `katas / groups: words`, and a word looks at all cases of a group.
"""

from __future__ import annotations

from collections import Counter
from fnmatch import filter as fitting
from functools import cached_property
from itertools import product
from pathlib import Path

import flint
import pytest
from hypothesis import find, settings
from msgspec.structs import replace
from sampling import nightly

from judge.data import load_data
from judge.data.build import bound_builder, build_cases, choices_of
from judge.data.draw import QuickDraw, RecordedDraw, Rejected, SeededDraw
from judge.data.module import load_module
from judge.data.strategy import HypothesisDraw, strategy
from judge.errors import ProblemError
from judge.problem.load import load_problem
from judge.topics.circles import CircleLine

PROBLEMS = Path(__file__).parents[2] / "problems"
BIG = {"beams", "nearest", "vector", "test-writer"}  # which has no cases
KATAS = sorted({path.parent.name for path in PROBLEMS.glob("*/problem.toml")} - BIG)
SAMPLE = {"count", "segment", "ray-nearest", "exact-count", "circle-circle", "swept-balls", "which-side"}

PROMISED = """
* / grid: upto 12
count *-count chord line-points segment distance foot normal-form / degenerate* point-edge: one-point
count exact-count chord line-points distance foot normal-form ray-nearest / degenerate null-*: answers None
*count / grid neighbours: answers 0 1 2 None, ints
exact-count / tangent*: answers 1
count / near-hit: answers 2
count / near-miss: answers 0
chord line-points normal reflect sphere / small: upto 1
count segment ray-nearest / tiny: upto 1e-15
count exact-count segment ray-nearest / axis-parallel axis-huge: axis
count exact-count segment ray-nearest chord line-points on-circle tangents / point-circle* zero-r*: no-radius
count segment / speck: radius 0 1e-12
count / close-points: answers 0 1 2
count exact-count / off-segment*: answers 2
exact-count / wide wider: answers 0 2
count / offset offset-fine: far 2e8
chord line-points distance foot segment ray-nearest normal reflect / offset offset-[ft]*: far 5e7
circle-circle common-tangents on-circle tangents polygon sphere enter-exit csg shadow / offset: from 5e7 2e8
count segment ray-nearest line-points / far-*: radius 0 1e-4
count chord distance foot normal-form / bounds: ints, from 1e9 1073741824
count chord line-points segment ray-nearest normal reflect / whole random: from 2e7 1073741824
count segment ray-nearest normal reflect circle-circle common-tangents tangents swept-* csg / whole: ints
count normal line-points ray-nearest on-circle polygon enter-exit shadow / whole-band reach whole: ints
exact-count / just-hit: answers 2, gap 1 100
exact-count / just-miss: answers 0, gap 1 1
exact-count / just-hit-huge: answers 2, gap 1 1e4, from 1e19 1e102
exact-count / hairline*: answers 0 2, gap 1 81
exact-count / small-gap: answers 0 2, gap 2 40, prime-radius
exact-segment / touch: answers 0 1
segment / through: answers 2
segment / one-end-inside from-the-foot tangent turned-tangent band large end-band one-far-end: answers 1
segment / both-ends-inside beyond beside degenerate-near: answers 0
segment / tangent-beyond: answers 0 1
segment / end-on-circle: answers 1 2
segment / end-near-circle small-end: answers 0 1
segment / degenerate-band: answers 1
ray-nearest / ahead inside just-ahead from-the-foot whole-ahead: answers some
ray-nearest normal / behind: answers None
ray-nearest / on-circle on-circle-turned origin-band* large-origin: answers 0
normal reflect sphere / inside: answers some
tangents / outside order far beside: answers 2
circle-circle common-tangents / crossing beside: answers 2
circle-circle / outer-touch inner-touch turned close-centres: answers 1
circle-circle / apart one-inside: answers 0
circle-circle / same-centre: answers 0 None
common-tangents / apart: answers 4
common-tangents / inner-touch close-centres: answers 1
polygon common-tangents / inside-around inside: answers 0
shadow / far-side blocked gap small own-wall-near one-end-inside: answers dark
swept-* / fast long-way turned rush head-on ends slide flat short-walls broad-disc: answers some
swept-* / overlap: answers 0
swept-* / away beyond: answers None
error-bound adaptive / touch: from 1e5 1e15
circle-side diameter which-side / on-the-circle on-the-line: answers 0
circle-side diameter which-side / close: answers -1 1
"""


class Case:
    """A case of a kata, and what the topic's exact predicates say of it."""

    def __init__(self, problem, module, case):
        self.problem, self.module, self.case = problem, module, case
        self.given = {each.name: value for each, value in zip(problem.parameters, case, strict=True)}
        self.numbers = flat(case)
        self.largest = max(map(abs, self.numbers))

    @cached_property
    def answer(self):
        """None, a word, a sign, a count, the length of a list; "some" for other numbers."""
        solved = self.module.solve(*self.case)
        assert solved.broken is None
        answer = getattr(solved.answer, "x", solved.answer)
        if isinstance(answer, tuple) or hasattr(answer, "sign"):
            return "some" if isinstance(answer, tuple) or answer.sign() else "0"
        return str(len(answer) if isinstance(answer, list) else answer)

    @cached_property
    def line(self):
        """The circle and the line or ray; without a circle, P, C or the origin is its centre."""
        x, y = self.given.get("P") or self.given.get("C") or (0, 0)
        given = {"cx": x, "cy": y, "r": 0, **self.given}
        build, names = (CircleLine.ray, "OD") if "D" in given else (CircleLine.through, "AB")
        return build(given["cx"], given["cy"], given["r"], *(given[name] for name in names))


def replayed(choices):
    """A draw that makes these choices."""
    given = iter(choices)
    return HypothesisDraw(lambda _: next(given))


def flat(value):
    return [number for each in value for number in flat(each)] if isinstance(value, tuple) else [value]


def every(holds):
    return lambda cases, *words: all(holds(case, *map(float, words)) for case in cases)


def all_from(value):
    return every(lambda case, low, high: low <= value(case) <= high)


WORDS = {
    "answers": lambda cases, *words: {case.answer for case in cases} == set(words),
    "ints": every(lambda case: {*map(type, case.numbers)} == {int}),
    "upto": every(lambda case, most: case.largest <= most),
    "from": all_from(lambda case: case.largest),
    "far": every(lambda case, away: case.largest >= away > 5000 * case.line.extent / 2**case.line.shift),
    "one-point": every(lambda case: case.line.a == 0),
    "axis": every(lambda case: 0 in (case.line.dx, case.line.dy)),
    "no-radius": every(lambda case: case.given["r"] == 0),
    "radius": all_from(lambda case: case.line.r / case.line.extent),
    "gap": all_from(lambda case: abs(case.line.delta)),
    "prime-radius": every(lambda case: flint.fmpz(case.given["r"]).is_prime()),
}
LINES = [line.replace(" / ", ": ").split(": ") for line in PROMISED.strip().splitlines()]


def matching(names, patterns):
    return {name for pattern in patterns.split() for name in fitting(names, pattern)}


def test_every_promise_is_about_groups_that_there_are():
    groups = {kata: [group.name for group in load_problem(PROBLEMS / kata).groups] for kata in KATAS}
    for katas, names, _ in LINES:
        for one in katas.split():
            assert any(matching(groups[kata], names) for kata in matching(KATAS, one)), (one, names)
        for one in names.split():
            assert any(matching(groups[kata], one) for kata in matching(KATAS, katas)), (katas, one)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("kata", "seed"),
    [(kata, None) if kata in SAMPLE else nightly(kata, None) for kata in KATAS]
    + [nightly(*both) for both in product(KATAS, (1, 2))],
)
def test_the_cases_are_what_their_groups_say(kata, seed):
    problem = load_problem(PROBLEMS / kata)
    data = load_data(problem, seed=seed, cache=False)
    groups = {g.group.name: [Case(problem, data.module, case) for case in g.cases] for g in data.groups}
    for name, case in ((name, case) for name, cases in groups.items() for case in cases):
        for parameter in problem.parameters:
            numbers = [abs(x) for x in flat((case.given[parameter.name],)) if x]
            assert max(numbers, default=0) <= max(abs(parameter.low), parameter.high), name
            assert min(numbers, default=1) >= (parameter.smallest or 0), name
    for katas, names, words in LINES:
        for name in matching(groups, names) if matching([kata], katas) else ():
            for word, *rest in map(str.split, words.split(", ")):
                assert WORDS[word](groups[name], *rest), (name, word, *rest)


@pytest.mark.slow
def test_a_seed_gives_the_same_data_and_another_seed_other_data():
    problem = load_problem(PROBLEMS / "on-circle")
    first, again, other = (load_data(problem, seed=seed, cache=False).groups for seed in (5, 5, 6))
    assert [each.cases for each in first] == [each.cases for each in again]
    assert [one for one, two in zip(first, other, strict=True) if one.cases == two.cases] == [first[0]]


@pytest.mark.slow
@pytest.mark.parametrize("kata", ["count", "segment", "ray-nearest", "exact-count"])
def test_every_builder_gives_its_case_back_from_its_choices(kata):
    problem = load_problem(PROBLEMS / kata)
    data = load_data(problem, cache=False)
    for group, cases in ((each.group, each.cases) for each in data.groups):
        if group.builder == "examples" or group.neighbours:  # which follow from the case before them too
            continue
        builder = bound_builder(problem, data.module, group)
        choices = choices_of(group, builder, 0, cases[0])
        assert repr(builder(replayed(choices))) == repr(cases[0])


@pytest.mark.parametrize(
    ("group", "parameter", "fault"),
    [
        ("through", {"where": ["nowhere"]}, "'nowhere' is a place"),
        ("through", {"poses": ["exact"], "divisor": 10}, "only a figure that is rounded"),
        ("point-edge", {"edges": ["hair"]}, "'hair' is an edge, one of snap, clear"),
        ("tangent-edge", {"sides": ["left"]}, "'left' is a side, one of hit, miss"),
    ],
)
def test_a_parameter_that_makes_no_sense_is_a_fault_of_the_problem(group, parameter, fault):
    problem = load_problem(PROBLEMS / "segment")
    (declared,) = (each for each in problem.groups if each.name == group)
    changed = replace(declared, parameters={**declared.parameters, **parameter})
    with pytest.raises(ProblemError, match=fault):
        build_cases(problem, load_module(problem), changed)


@pytest.mark.parametrize("source", [SeededDraw, QuickDraw])
def test_choices_reach_everything_within_their_ends_evenly(source):
    draw = source("even")
    assert len({source(str(seed)).integer(0, 10**9) for seed in range(100)}) == 100
    assert all(-(10**400) <= draw.integer(-(10**400), 10**400) <= 10**400 for _ in range(300))
    counts = Counter(each for _ in range(5000) for each in (draw.integer(-2, 2), draw.choice("abcde")))
    assert len(counts) == 10
    assert all(850 < each < 1150 for each in counts.values())
    assert {(draw.sign(), draw.boolean()) for _ in range(60)} == {*product((-1, 1), (False, True))}


@pytest.mark.parametrize("draw", [SeededDraw(""), QuickDraw(""), HypothesisDraw(None)])
def test_impossible_choices_are_refused(draw):
    with pytest.raises(ValueError, match="no integer from 1 to 0"):
        draw.integer(1, 0)
    with pytest.raises(ValueError, match="nothing to choose from"):
        draw.choice([])
    with pytest.raises(Rejected):
        draw.reject()


def some(draw):
    return (draw.integer(-5, 10**20), draw.choice("abcdef"), draw.sign(), draw.boolean(), draw.choice([7]))


def test_recorded_choices_change_nothing_and_replay():
    for seed in map(str, range(50)):
        recorded = RecordedDraw(SeededDraw(seed))
        assert some(recorded) == some(SeededDraw(seed)) == some(replayed(recorded.choices))


@pytest.mark.parametrize("fault", [ZeroDivisionError, KeyError, Rejected, ProblemError("no such figure")])
def test_choices_that_a_builder_cannot_use_are_passed_over_in_a_search(fault):
    def builder(draw):
        if draw.integer(0, 9) < 4:
            raise fault
        return (draw.integer(0, 3),)

    found = find(strategy(builder), lambda case: case[0] > 1, settings=settings(database=None))
    assert found == (2,)
