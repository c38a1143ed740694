"""How CPU time grows with n: when the exponent is too large, and which groups may say so."""

from __future__ import annotations

import math

import pytest
from judging import COUNTS, LIMITS, make_data
from msgspec.structs import replace

from judge.data import ProblemData
from judge.problem import TimeRule, Verdict
from judge.problem.model import GrowthRule
from judge.run.execute import race_of
from judge.run.group import GroupRun
from judge.run.groups import Judging
from judge.run.growing import judge_growing
from judge.run.growth import Course, exponent, grow, is_steep, steep_seconds
from judge.run.runner import Replies, Runner
from judge.run.settings import Reference
from judge.run.timing import MOST_PAIRS, Race, TurnPair
from judge.sandbox.boundary import Reply, Stop, Usage

SLOPE = 0.4
SIZES = (2_000, 8_000, 32_000)


def course(size, mine, theirs, limit=None, cases=1, log=None):
    """A group whose turns take these times; a list is taken one by one, its last value again and again."""

    def run(name, values):
        left = list(values) if isinstance(values, list) else [values]

        def turn():
            if log is not None:
                log.append((name, size))
            return left.pop(0) if len(left) > 1 else left[0]

        return turn

    return Course(f"n-{size}", size, run("mine", mine), run("theirs", theirs), limit, cases)


def law(power, factor=1.0, theirs=1.2, log=None):
    """Courses of a submission that takes n to that power, beside a reference with its own power."""
    return [
        course(size, factor * 0.02 * (size / 2000) ** power, 0.02 * (size / 2000) ** theirs, log=log)
        for size in SIZES
    ]


@pytest.mark.parametrize("power", [0.5, 1.0, 2.0])
def test_the_exponent_of_a_law_is_found(power):
    assert exponent([(size, 3e-6 * size**power) for size in SIZES]) == pytest.approx(power)
    odd = [3e-6 * size**power * (1.2 if size == 8_000 else 1) for size in SIZES]
    assert exponent([*zip(SIZES, odd, strict=True)]) == pytest.approx(power)  # the middle has no weight


def test_a_quadratic_is_too_steep_after_two_rounds():
    grown = grow(law(1.9), SLOPE)  # its longest turns take 4 s
    assert grown.too_steep
    assert str(grown.growth) == "it grows like n^1.9, the reference like n^1.2"
    assert (grown.growth.pairs, grown.growth.borderline) == (2, False)
    assert grown.growth.groups == ("n-2000", "n-8000", "n-32000")
    assert [(point.size, point.cpu_seconds, point.reference_seconds) for point in grown.growth.points] == [
        (size, pytest.approx(0.02 * n**1.9), pytest.approx(0.02 * n**1.2))
        for size, n in ((2_000, 1), (8_000, 4), (32_000, 16))
    ]


@pytest.mark.parametrize("factor", [0.01, 1.0, 40.0])
def test_a_constant_factor_is_no_growth(factor):
    grown = grow(law(1.25, factor), SLOPE)
    assert (grown.too_steep, grown.growth.borderline, grown.growth.pairs) == (False, False, 2)


@pytest.mark.parametrize(("more", "too_steep"), [(0.26, False), (0.38, False), (0.42, True), (0.54, True)])
def test_nine_pairs_decide_in_the_grey_zone_and_it_is_borderline(more, too_steep):
    grown = grow(law(1.2 + more, 0.1), SLOPE)
    assert (grown.too_steep, grown.growth.borderline, grown.growth.pairs) == (too_steep, True, MOST_PAIRS)


@pytest.mark.parametrize(
    ("more", "too_steep", "pairs"),
    [(0.26, False, 2), (0.34, False, 2), (0.36, False, 9), (0.44, True, 9), (0.46, True, 2), (0.54, True, 2)],
)
def test_of_long_turns_the_grey_zone_is_a_third_as_wide(more, too_steep, pairs):
    grown = grow(law(1.2 + more), SLOPE)
    assert (grown.too_steep, grown.growth.borderline, grown.growth.pairs) == (too_steep, True, pairs)


def test_both_the_medians_and_the_least_times_must_be_too_steep():
    steep = 0.02 * 4**1.7
    courses = [course(2_000, 0.02, 0.02), course(8_000, [steep, 0.08, steep], 0.08)]
    grown = grow(courses, SLOPE)
    assert (grown.too_steep, grown.growth.borderline) == (False, True)  # one quick run shows that it can
    assert grown.growth.pairs == MOST_PAIRS


def test_two_slow_rounds_of_short_turns_reject_nobody():
    """A machine that is busy just then doubles them both; turns that are long enough need no more rounds."""
    busy = [0.08 * 2.5, 0.08 * 2.5, 0.08]
    assert not grow([course(2_000, 0.02, 0.02), course(8_000, busy, 0.08)], SLOPE).too_steep
    long = [course(2_000, 0.2, 0.2), course(8_000, 0.8 * 2.5, 0.8)]
    assert grow(long, SLOPE).growth.pairs == 2


def test_one_slow_turn_of_the_reference_saves_nobody():
    slow_once = [0.08, 0.3, 0.08]
    assert grow([course(2_000, 0.02, 0.02), course(8_000, 0.02 * 4**1.9, slow_once)], SLOPE).too_steep


def test_a_grey_first_look_is_settled_by_the_others():
    noisy = [0.08 * 4**0.3, 0.08 * 4**0.3, 0.08]
    grown = grow([course(2_000, 0.02, 0.02), course(8_000, noisy, 0.08)], SLOPE)
    assert (grown.too_steep, grown.growth.borderline) == (False, False)


def test_groups_that_take_the_reference_no_time_say_nothing():
    short = 0.009
    courses = [course(500, 1e-6, short), *law(1.2)]
    grown = grow(courses, SLOPE)
    assert grown.growth.groups == ("n-2000", "n-8000", "n-32000")
    assert not grown.too_steep
    assert grow(courses[:2], SLOPE).growth is None  # one group alone shows no growth
    assert grow([course(500, 9.0, 0.02), course(500, 1.0, 0.02)], SLOPE).growth is None


def test_time_that_was_used_up_counts():
    """What a group took that never came to its end is the least that it takes."""
    courses = [course(2_000, 0.02, 0.02, limit=100.0), course(8_000, 4.0, 0.08)]
    grown = grow(courses, SLOPE)
    assert grown.too_steep
    assert sorted(grown.decisions) == ["n-2000"]  # what ran out of time has no ratio


def test_a_group_that_did_not_end_never_makes_the_growth_flatter():
    """It was stopped at 4 s, whatever it would have taken; the two that ended tell what it grows like."""
    courses = [course(500, 0.02, 0.02), course(2_000, 0.02 * 4**2, 0.02 * 4)]
    cut = Course("n-8000", 8_000, lambda: 0.4, lambda: 0.02 * 16, None, 1, ended=False)
    grown = grow([*courses, cut], SLOPE)
    assert (grown.too_steep, grown.growth.groups) == (True, ("n-500", "n-2000"))
    assert str(grown.growth) == "it grows like n^2.0, the reference like n^1.0"
    assert [(point.group, point.ended) for point in grown.growth.points] == [
        ("n-500", True),
        ("n-2000", True),
        ("n-8000", False),
    ]
    late = Course("n-8000", 8_000, lambda: 40.0, lambda: 0.02 * 16, None, 1, ended=False)
    assert grow([*courses, late], SLOPE).growth.groups == ("n-500", "n-2000", "n-8000")
    assert str(grow([*courses, late], SLOPE).growth).startswith("it grows at least like n^2.7, ")
    assert grow([courses[0], late], SLOPE).growth.groups == ("n-500", "n-8000")


def test_an_exponent_that_still_rises_is_the_least():
    mine = [2e-5 * size + 1e-9 * size**2 for size in SIZES]  # a small constant, as numpy has it
    grown = grow([course(*row) for row in zip(SIZES, mine, [size / 1e5 for size in SIZES], strict=True)], 1.0)
    assert str(grown.growth).startswith("it grows at least like n^1.3, ")


def test_times_are_those_of_one_case():
    courses = [course(2_000, 0.16, 0.16, cases=8), course(8_000, 0.08, 0.08, cases=1)]
    growth = grow(courses, SLOPE).growth
    assert (growth.exponent, growth.reference) == (pytest.approx(1.0), pytest.approx(1.0))


def test_the_rounds_are_interleaved_and_who_goes_first_changes():
    log = []
    grow(law(1.2, log=log), SLOPE)
    first = [(name, size) for size in SIZES for name in ("mine", "theirs")]
    second = [(name, size) for size in SIZES[:2] for name in ("theirs", "mine")]
    assert log == first + second  # the turns of the largest size are long: a pair will do


def test_turns_in_which_a_group_was_judged_are_not_run_again():
    log = []
    courses = law(1.2, factor=20.0, theirs=1.2, log=log)
    judged = [replace(each, pairs=[TurnPair(each.submission() / 20, each.reference())]) for each in courses]
    log.clear()
    grown = grow(judged, SLOPE)
    assert {size for _, size in log} == set(SIZES[:2])
    assert (grown.too_steep, grown.growth.pairs, grown.growth.borderline) == (False, 2, False)


def turned(size, *pairs):
    """A group that took these turns."""
    return Course(f"n-{size}", size, pairs=[TurnPair(*pair) for pair in pairs])


@pytest.mark.parametrize(
    ("smaller", "larger", "steep"),
    [
        ([(0.2, 0.2)], [(0.8 * 4**0.6, 0.8)], True),
        ([(0.2, 0.2)], [(0.8 * 4**0.5, 0.8)], False),  # near the limit
        ([(0.2, 0.2), (0.3, 0.2)], [(0.8 * 4**0.6, 0.8)], False),  # busy at the smaller size
        ([(0.2, 0.2)], [(0.8 * 4**0.6, 0.8), (0.8 * 4**0.6, 1.2)], False),  # … and at the larger
        ([(0.001, 0.009)], [(9.0, 0.08)], False),  # too short for the reference
        ([(0.001, 0.02)], [(9.0, 0.009)], False),
        ([(0.001, 0.02)], [(0.19, 0.08)], False),  # … and for the submission
    ],
)
def test_what_is_clearly_too_steep_so_far(smaller, larger, steep):
    assert is_steep(turned(2_000, *smaller), turned(8_000, *larger), SLOPE) is steep


def test_what_is_cut_is_too_steep_although_the_next_turns_differ():
    most = steep_seconds(turned(2_000, (0.9, 0.1)), 8_000, 0.14, SLOPE)
    smaller = turned(2_000, (0.9, 0.1), (1.0, 0.1))
    assert is_steep(smaller, turned(8_000, (most, 0.14), (most, 0.16)), SLOPE)
    assert steep_seconds(turned(2_000, (0.01, 0.1)), 8_000, 0.14, SLOPE) >= 1.0  # no haste
    assert steep_seconds(turned(2_000, (0.9, 0.009)), 8_000, 0.14, SLOPE) == math.inf  # nobody can say


class Process(list):
    """A box that is the limits of its processes, which take an import and so many CPU seconds of calls."""

    def __init__(self, *calling, importing=0.01):
        self.calling, self.importing = [*calling], importing


class Scripted(Runner):
    """Makes its calls in as many CPU seconds as the box says."""

    def ask(self, box, cases, limits):
        box.append((len(cases), limits.cpu_seconds))
        calling = box.calling.pop(0) if len(box.calling) > 1 else box.calling[0]
        answers = [Reply(Stop.ANSWERED, count) for count in COUNTS[-len(cases) :]]
        stop, imported = [Reply(Stop.CPU)], Usage(box.importing, box.importing)
        if box.importing > limits.cpu_seconds:
            return Replies(stop, Usage(limits.cpu_seconds, 1.0), Stop.CPU, lost=True)
        if calling > limits.cpu_seconds:
            return Replies(stop, Usage(limits.cpu_seconds, 1.0), Stop.CPU, lost=True, imported=imported)
        return Replies(answers[: len(cases)], Usage(calling, calling), imported=imported)


class Shelf(Reference):
    """One reference solution."""

    def __init__(self, box):
        self.box = box

    def open(self, name):
        return self.box


def growing(mine, theirs, limits=LIMITS):
    """The decision and two groups, of 2,000 and of 8,000, one case each."""
    data = make_data("n-2000", "n-8000", limits=limits)
    groups = [replace(each, size=size) for each, size in zip(data.problem.groups, SIZES, strict=False)]
    rule = GrowthRule(("n-2000", "n-8000"), SLOPE)
    problem = replace(data.problem, groups=tuple(groups), growth=rule, time=TimeRule(50.0, "fast.py"))
    runner = Scripted(problem)
    runs = [
        GroupRun(
            ProblemData(problem, ()),
            replace(each, group=group, cases=each.cases[-1:], targets=COUNTS[-1:]),
            runner,
        )
        for each, group in zip(data.groups, groups, strict=True)
    ]
    return judge_growing(Judging(runner, mine), runs, Shelf(theirs), race_of), runs


@pytest.mark.parametrize(
    ("mine", "theirs"),
    [
        (Process(0.1, importing=1.2), Process(0.1)),  # of an import that is cut nothing is charged
        (Process(0.1, 1.5, 0.1, 1.5), Process(0.1, 0.1, 0.1, 2.0)),  # the reference was too quick before
    ],
)
def test_a_first_case_that_is_cut_is_run_again_whole(mine, theirs):
    _, runs = growing(mine, theirs)
    assert mine[1] == (1, 1.0)
    assert (1, 2.0) in mine[2:]
    assert [run.verdict for run in runs] == [Verdict.AC, Verdict.AC]


def test_a_first_case_that_is_cut_is_enough_to_be_too_steep():
    mine = Process(0.1, 9.0, 0.1)
    decision, (smaller, larger) = growing(mine, Process(0.1))
    assert (smaller.verdict, larger.verdict) == (Verdict.AC, Verdict.TLE)
    assert str(decision.growth).startswith("it grows at least like n^")
    assert mine == [(1, 2.0), (1, 1.0), (1, pytest.approx(1.22))]
    assert larger.usage.cpu_seconds == 1.0


def test_what_is_cut_and_doubted_is_cut_again_at_twice_the_time():
    mine = Process(0.1, 9.0, 0.5, 9.0, 0.1)  # a busy moment makes the smaller size slow
    decision, (_, larger) = growing(mine, Process(0.1), replace(LIMITS, cpu_seconds=30.0))
    assert [seconds for _, seconds in mine[:4]] == [30.0, 1.0, pytest.approx(1.22), 2.0]
    assert (larger.verdict, larger.failure.message) == (Verdict.TLE, decision.growth.too_steep)


def test_a_long_import_may_take_as_long_when_the_group_is_raced():
    data = make_data("one", limits=replace(LIMITS, cpu_seconds=9.0))
    runner, box = Scripted(data.problem), Process(0.1, importing=3.0)
    run, judging = GroupRun(data, data.groups[0], runner), Judging(runner, box)
    judging.run([run])
    assert run.verdict is Verdict.AC
    assert Race(judging, [run], None, 1.0).mine() == 0.1
    assert box[1][1] < 9.0


def test_only_what_is_near_its_limit_is_run_again():
    log = []
    courses = [
        course(2_000, 0.02, 0.02, limit=8.0, log=log),
        course(8_000, 0.08 * 1.1, 0.08, limit=1.1, log=log),
    ]
    grown = grow(courses, SLOPE)
    assert grown.decisions["n-8000"].borderline
    assert grown.decisions["n-8000"].ratio.pairs == MOST_PAIRS
    assert grown.decisions["n-2000"].ratio.pairs == 2
    assert not grown.too_steep


def test_turns_that_say_little():
    grown = grow([course(2_000, 0.02, 0.02), course(8_000, None, 0.08)], SLOPE)  # one does not end well
    assert (grown.growth, grown.too_steep, grown.decisions) == (None, False, {})
    grown = grow(law(1.9), SLOPE, lambda: False)  # there may be no more rounds
    assert (grown.too_steep, grown.growth.pairs) == (True, 1)
    grown = grow([course(2_000, 0.0, 0.02), course(8_000, 0.0, 0.08)], SLOPE)  # no time at all
    assert math.isfinite(grown.growth.exponent)
    assert not grown.too_steep
