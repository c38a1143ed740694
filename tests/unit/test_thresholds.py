"""Measured thresholds: where a submission's answers turn, what that follows, and the mistake it is.

Functions of this very process stand in for contained submissions.
"""

from __future__ import annotations

import json
import math
from decimal import Decimal
from fractions import Fraction
from functools import cache

import pytest
from msgspec.structs import replace

from judge.data.borders import as_plain, borders_of, from_plain
from judge.data.module import load_module
from judge.errors import ProblemError
from judge.mistakes.epsilons import epsilon_family
from judge.mistakes.thresholds import measured
from judge.problem.border import Border, Probe
from judge.problem.find import find_problem
from judge.problem.topic import Topic
from judge.run.function import FunctionRunner
from judge.sandbox.boundary import CallsResult, Reply, Stop, Usage

OUTSIDE, INSIDE, NO_LINE = "a tangency", "a tangency from inside", "no line"


class Here:
    """A box that calls a function; it counts its series and their calls."""

    def __init__(self, function, stops=()):
        self.function = function
        self.stops = list(stops)  # how the first series end
        self.series = []

    def call_many(self, entry, calls, limits):
        self.series.append(len(calls))
        if self.stops and (stop := self.stops.pop(0)) is not Stop.ANSWERED:
            return CallsResult((Reply(stop),), Usage())
        return CallsResult(tuple(self._reply(call) for call in calls), Usage())

    def _reply(self, call):
        try:
            return Reply(Stop.ANSWERED, json.loads(json.dumps(self.function(*call))))
        except Exception as fault:
            return Reply(Stop.EXCEPTION, detail=str(fault))


@cache
def borders(name):
    problem = find_problem(name)
    return borders_of(problem, load_module(problem))


def thresholds(name, function, *, first_only=False, box=None):
    """The thresholds of a function that answers problem `name`, by decision."""
    runner = FunctionRunner(find_problem(name))
    found = measured(borders(name), runner, box or Here(function), first_only=first_only)
    return {each.decision: each for each in found}


def isclose(a, b):
    """What numpy's compares."""
    return abs(a - b) <= 1e-8 + 1e-5 * abs(b)


def counting(touches):
    """A `line_count` that takes a tangency for one where it touches: a function of d, r, length, e and most,
    or its text.
    """
    if isinstance(touches, str):
        touches = eval(f"lambda d, r, length, e, most: {touches}", {"math": math, "isclose": isclose})

    def line_count(cx, cy, r, start, end):
        ax, ay, bx, by = start[0] - cx, start[1] - cy, end[0] - cx, end[1] - cy
        dx, dy = bx - ax, by - ay
        if dx == dy == 0:
            return None
        length = math.hypot(dx, dy)
        distance = abs(dx * ay - dy * ax) / length
        extent = max(r, abs(ax), abs(ay), abs(bx), abs(by))
        if touches(distance, r, length, extent, max(map(abs, (cx, cy, *start, *end)))):
            return 1
        return 2 if distance < r else 0

    return line_count


def exactly(number):
    """A `line_count` in numbers of a kind that rounds nothing here, without a band."""

    def line_count(cx, cy, r, start, end):
        cx, cy, r, ax, ay, bx, by = map(number, (cx, cy, r, *start, *end))
        dx, dy = bx - ax, by - ay
        if dx == dy == 0:
            return None
        cross = dx * (ay - cy) - dy * (ax - cx)
        sign = r * r * (dx * dx + dy * dy) - cross * cross
        return 1 + (sign > 0) - (sign < 0)

    return line_count


USUAL = "abs(d - r) <= 1e-10 * e"
TABLE = [
    ("abs(d - r) <= 1e-3", "absolute-epsilon", 1e-3),
    ("abs(d - r) <= 3.7e-8", "absolute-epsilon", 3.7e-8),
    ("abs(d - r) <= 1e-15", "absolute-epsilon", 1e-15),
    ("abs(d * d - r * r) <= 1e-9", "absolute-epsilon", 5e-10),
    ("round(d, 6) == round(r, 6)", "absolute-epsilon", 5e-7),
    ("round(d - r, 6) == 0", "absolute-epsilon", 5e-7),
    ("abs(d - r) <= 1e-10 * max(1, e)", "absolute-epsilon", 1e-10),
    ("abs(d - r) <= 1e-10 * (1 + most)", "absolute-epsilon", 1e-10),
    ("isclose(d, r)", "absolute-epsilon", 1e-5),
    ("math.isclose(d, r)", "radius-epsilon", 1e-9),
    ("abs(d * d - r * r) <= 1e-9 * r * r", "radius-epsilon", 5e-10),
    ("abs(d - r) <= 1e-9 * length", "length-epsilon", 1e-9),
    ("abs(d - r) <= 1e-10 * max(length, r)", "length-epsilon", 1e-10),
    ("abs(d - r) <= 1e-10 * most", "coordinate-epsilon", 1e-10),
    ("abs(d - r) <= 1e-3 * e", "loose-epsilon", 1e-3),
    ("abs(d - r) <= 1.5e-7 * e", "loose-epsilon", 1.5e-7),
    (USUAL, None, 1e-10),
    ("abs(d - r) <= 1e-12 * e", None, 1e-12),
    ("abs(d - r) <= 5e-13 * e", "tight-epsilon", 5e-13),
    ("abs(d - r) <= 1e-14 * e", "tight-epsilon", 1e-14),
    ("d == r", "no-epsilon", 0.0),
    ("d * d == r * r", "no-epsilon", 0.0),
    (exactly(Fraction), "no-epsilon", 0.0),
    (exactly(Decimal), "no-epsilon", 0.0),
]


@pytest.mark.parametrize(("touches", "mistake", "factor"), TABLE)
def test_the_threshold_of_a_program_is_named_and_its_number_told(touches, mistake, factor):
    function = counting(touches) if isinstance(touches, str) else touches
    found = thresholds("count", function)[OUTSIDE]
    assert found.mistake == mistake
    assert found.law.factor == pytest.approx(factor, rel=0.3)


@pytest.mark.parametrize("factor", [1e-10, 1e-12])
def test_a_short_look_at_a_right_program_finds_the_same_and_says_nothing_of_a_wrong_one(factor):
    (found,) = thresholds("count", counting(f"abs(d - r) <= {factor} * e"), first_only=True).values()
    assert (found.mistake, found.follows_its_size) == (None, True)
    assert found.law.factor == pytest.approx(factor, rel=0.3)
    assert thresholds("count", counting("abs(d - r) <= 1e-9"), first_only=True) == {}
    assert thresholds("count", counting("abs(d - r) <= 1e-14 * e"), first_only=True) == {}


@pytest.mark.parametrize(
    "function",
    [
        lambda *_: 1,
        lambda *_: None,
        lambda *_: "1",
        lambda *_: 1.0,
        lambda *_: 1 / 0,
        counting("False"),  # a tangency is never one
        counting("int(abs(d - r) * 1e9) % 2 == 0"),  # turns again and again
    ],
)
def test_without_a_clear_law_nothing_is_told(function):
    assert OUTSIDE not in thresholds("count", function)


def keeping(known_by):
    """A function that answers again what it answered to a case that is known by the same."""
    known, right = {}, counting(USUAL)
    return lambda *case: known.setdefault(known_by(*case), right(*case))


def growing():
    """An extent that is the largest so far."""
    sizes = []
    return counting(lambda d, r, _length, e, _most: sizes.append(e) or abs(d - r) <= 1e-10 * max(sizes))


@pytest.mark.parametrize(
    ("begun", "told"),
    [
        (lambda: keeping(lambda *case: case[0]), set()),
        (lambda: keeping(lambda *case: round(case[2], 4)), set()),
        (growing, {NO_LINE}),
    ],
)
def test_what_is_kept_between_calls_has_no_threshold(begun, told):
    class Forgetful(Here):
        """A process for each series."""

        def call_many(self, entry, calls, limits):
            self.function = begun()
            return super().call_many(entry, calls, limits)

    assert thresholds("count", None, box=Forgetful(None)).keys() <= told


@pytest.mark.parametrize(
    ("touches", "family"),
    [
        ("abs(d - r) <= 1e-9", "absolute-epsilon"),
        (USUAL, None),
        ("r <= d <= r + 1e-9", None),  # two of them: none from inside
    ],
)
def test_the_family_of_all_the_borders_together(touches, family):
    assert epsilon_family(tuple(thresholds("count", counting(touches)).values())) == family


def test_it_takes_two_series_however_many_borders_there_are():
    problem, names = find_problem("segment"), {}
    exec((problem.solutions / "accepted" / "quadratic.py").read_bytes(), names)
    box, short = Here(names[problem.entry]), Here(names[problem.entry])
    found = thresholds("segment", None, box=box)
    assert list(found) == [border.about for border in borders("segment") if not border.mistaken]
    assert {each.mistake for each in found.values()} == {None}
    assert len(box.series) == 2
    assert sum(box.series) < 1300
    thresholds("segment", None, box=short, first_only=True)
    assert sum(short.series) < 180


@pytest.mark.parametrize("stop", [each for each in Stop if each not in (Stop.ANSWERED, Stop.EXCEPTION)])
@pytest.mark.parametrize("before", [0, 1])
def test_a_submission_that_is_stopped_has_no_thresholds_and_is_not_asked_again(stop, before):
    box = Here(counting(USUAL), stops=[Stop.ANSWERED] * before + [stop])
    assert thresholds("count", None, box=box) == {}
    assert len(box.series) == before + 1


@pytest.mark.parametrize("name", ["count", "segment", "ray-nearest"])
def test_the_exact_answer_turns_at_the_band_and_has_turned_at_the_promise(name):
    problem = find_problem(name)
    solve = load_module(problem).solve
    probes = [(each, probe) for each in borders(name) for probe in each.probes]
    for border, probe in probes:
        for share in (1e-16, 3e-12, 2e-7, probe.widest):  # a gap is rounded once
            moved, gap = probe.at(share * probe.size)
            for place in probe.place:
                moved = moved[place]
            assert gap == float(abs(Fraction(moved) - Fraction(probe.edge)))
        if not border.within:
            continue
        for share, form in ((border.within * 0.8, probe.near), (border.beyond * 1.1, probe.far)):
            case, gap = probe.at(share * probe.size)
            answer, broken = solve(*case)
            target = problem.answer.target(answer, problem.groups[0].tolerance)
            assert (broken, probe.form(problem.answer.right(target), gap)) == (None, form)
        assert solve(*probe.at(1e-9 * probe.size)[0]).broken is not None


def test_borders_come_back_from_plain_values_as_they_were():
    plain = json.loads(json.dumps(as_plain(borders("segment"))))
    assert from_plain(plain) == borders("segment")


def probe(widest, height=0):
    """A circle about 0 that grows up to `widest`, and a line that high above its centre."""
    return Probe((0, 0, 1.0, (-1, height), (1, height)), (2,), 1.0, 1, {"size": 1.0}, widest)


@pytest.mark.parametrize(
    ("made", "what"),
    [
        (lambda: 1 / 0, "the topic's borders cannot be made: ZeroDivisionError"),
        (lambda: Border("it", 0, 0, (probe(0.1),)), "answered 'count 2' on both sides"),
        (lambda: Border("it", 0, 0, (probe(1e30),)), "is invalid: r has 1e\\+30"),
        (
            lambda: Border("it", 0, 0, (probe(0.1, height=1),), mistaken="none"),
            "answered 'count 1' and then 'count 2'",
        ),
    ],
)
def test_a_fault_in_a_topics_borders_is_the_problems(made, what):
    problem = find_problem("count")
    topic = Topic(borders=lambda _: [made()])
    with pytest.raises(ProblemError, match=what):
        borders_of(problem, replace(load_module(problem), topic=topic))
