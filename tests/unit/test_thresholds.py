"""Measured thresholds: where a submission's answers turn, what that follows, and the mistake it is."""

from __future__ import annotations

import json
import math
from decimal import Decimal
from fractions import Fraction

import pytest
from msgspec.structs import replace
from thresholds import Here, borders, thresholds

from judge.data.borders import as_plain, borders_of, from_plain
from judge.data.module import load_module
from judge.errors import ProblemError
from judge.mistakes.epsilons import epsilon_family
from judge.mistakes.thresholds import measured
from judge.problem.border import Border, Probe
from judge.problem.find import find_problem
from judge.problem.topic import Topic
from judge.run.function import FunctionRunner
from judge.sandbox.boundary import Stop

OUTSIDE, INSIDE, NO_LINE = "a tangency", "a tangency from inside", "no line"


def counting(touches):
    """A `line_count` that takes a tangency for one where touches(d, r, length, extent, coordinate)."""

    def line_count(cx, cy, r, start, end):
        ax, ay, bx, by = start[0] - cx, start[1] - cy, end[0] - cx, end[1] - cy
        dx, dy = bx - ax, by - ay
        if dx == dy == 0:
            return None
        length = math.hypot(dx, dy)
        distance = abs(dx * ay - dy * ax) / length
        extent = max(r, abs(ax), abs(ay), abs(bx), abs(by))
        coordinate = max(map(abs, (cx, cy, *start, *end)))
        if touches(distance, r, length, extent, coordinate):
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


def textbook(cx, cy, r, start, end, eps=1e-9):
    """Everything absolute, as it is taught."""
    dx, dy, fx, fy = end[0] - start[0], end[1] - start[1], start[0] - cx, start[1] - cy
    a, b, c = dx * dx + dy * dy, 2 * (fx * dx + fy * dy), fx * fx + fy * fy - r * r
    if a < eps:
        return None
    delta = b * b - 4 * a * c
    return 1 if abs(delta) < eps else 2 if delta > 0 else 0


def isclose(a, b):
    """What numpy's compares."""
    return abs(a - b) <= 1e-8 + 1e-5 * abs(b)


TABLE = {
    "EPS = 1e-3": (counting(lambda d, r, *_: abs(d - r) <= 1e-3), "absolute-epsilon", 1e-3),
    "EPS = 1e-6": (counting(lambda d, r, *_: abs(d - r) <= 1e-6), "absolute-epsilon", 1e-6),
    "EPS = 3.7e-8": (counting(lambda d, r, *_: abs(d - r) <= 3.7e-8), "absolute-epsilon", 3.7e-8),
    "EPS = 1e-9": (counting(lambda d, r, *_: abs(d - r) <= 1e-9), "absolute-epsilon", 1e-9),
    "EPS = 1e-12": (counting(lambda d, r, *_: abs(d - r) <= 1e-12), "absolute-epsilon", 1e-12),
    "EPS = 1e-15": (counting(lambda d, r, *_: abs(d - r) <= 1e-15), "absolute-epsilon", 1e-15),
    "1e-9 r": (counting(lambda d, r, *_: abs(d - r) <= 1e-9 * r), "radius-epsilon", 1e-9),
    "squares, 1e-9 r": (
        counting(lambda d, r, *_: abs(d * d - r * r) <= 1e-9 * r * r),
        "radius-epsilon",
        5e-10,
    ),
    "1e-9 |AB|": (counting(lambda d, r, length, *_: abs(d - r) <= 1e-9 * length), "length-epsilon", 1e-9),
    "1e-10 max(|AB|, r)": (
        counting(lambda d, r, length, *_: abs(d - r) <= 1e-10 * max(length, r)),
        "length-epsilon",
        1e-10,
    ),
    "coordinate": (
        counting(lambda d, r, _l, _e, most: abs(d - r) <= 1e-10 * most),
        "coordinate-epsilon",
        1e-10,
    ),
    "max(1, e)": (
        counting(lambda d, r, _l, e, _c: abs(d - r) <= 1e-10 * max(1, e)),
        "absolute-epsilon",
        1e-10,
    ),
    "1 + coordinate": (
        counting(lambda d, r, _l, _e, most: abs(d - r) <= 1e-10 * (1 + most)),
        "absolute-epsilon",
        1e-10,
    ),
    "1e-3 e": (counting(lambda d, r, _l, e, _c: abs(d - r) <= 1e-3 * e), "loose-epsilon", 1e-3),
    "1.5e-7 e": (counting(lambda d, r, _l, e, _c: abs(d - r) <= 1.5e-7 * e), "loose-epsilon", 1.5e-7),
    "1e-10 e": (counting(lambda d, r, _l, e, _c: abs(d - r) <= 1e-10 * e), None, 1e-10),
    "1e-12 e": (counting(lambda d, r, _l, e, _c: abs(d - r) <= 1e-12 * e), None, 1e-12),
    "5e-13 e": (counting(lambda d, r, _l, e, _c: abs(d - r) <= 5e-13 * e), "tight-epsilon", 5e-13),
    "1e-14 e": (counting(lambda d, r, _l, e, _c: abs(d - r) <= 1e-14 * e), "tight-epsilon", 1e-14),
    "==": (counting(lambda d, r, *_: d == r), "no-epsilon", 0.0),
    "squares, ==": (counting(lambda d, r, *_: d * d == r * r), "no-epsilon", 0.0),
    "Fraction": (exactly(Fraction), "no-epsilon", 0.0),
    "Decimal": (exactly(Decimal), "no-epsilon", 0.0),
    "math.isclose": (counting(lambda d, r, *_: math.isclose(d, r)), "radius-epsilon", 1e-9),
    "np.isclose": (counting(lambda d, r, *_: isclose(d, r)), "absolute-epsilon", 1e-5),
    "round(d, 6)": (counting(lambda d, r, *_: round(d, 6) == round(r, 6)), "absolute-epsilon", 5e-7),
    "round(d - r, 6)": (counting(lambda d, r, *_: round(d - r, 6) == 0), "absolute-epsilon", 5e-7),
    "squares, 1e-9": (counting(lambda d, r, *_: abs(d * d - r * r) <= 1e-9), "absolute-epsilon", 5e-10),
    "textbook": (textbook, "absolute-epsilon", 1.25e-10),
}


@pytest.mark.parametrize("program", TABLE)
def test_the_threshold_of_a_program_is_named_and_its_number_told(program):
    function, mistake, factor = TABLE[program]
    found = thresholds("count", function)[OUTSIDE]
    assert found.mistake == mistake
    assert found.law.factor == pytest.approx(factor, rel=0.3)


@pytest.mark.parametrize("program", [name for name, (_, mistake, _) in TABLE.items() if mistake is None])
def test_a_short_look_at_a_right_program_finds_the_same(program):
    function, _, factor = TABLE[program]
    (found,) = thresholds("count", function, first_only=True).values()
    assert (found.mistake, found.follows_its_size) == (None, True)
    assert found.law.factor == pytest.approx(factor, rel=0.3)


def test_a_short_look_says_nothing_of_what_it_did_not_ask():
    assert thresholds("count", TABLE["EPS = 1e-9"][0], first_only=True) == {}
    assert thresholds("count", TABLE["1e-14 e"][0], first_only=True) == {}


@pytest.mark.parametrize(
    "function",
    [
        lambda *_: 1,
        lambda *_: None,
        lambda *_: "1",
        lambda *_: 1.0,
        lambda *_: 1 / 0,
        counting(lambda *_: False),  # a tangency is never one
        counting(lambda d, r, *_: int(abs(d - r) * 1e9) % 2 == 0),  # turns again and again
    ],
)
def test_without_a_clear_law_nothing_is_told(function):
    assert OUTSIDE not in thresholds("count", function)


@pytest.mark.parametrize("keep", [lambda *case: case[0], lambda *case: round(case[2], 4)])
def test_what_is_kept_between_calls_has_no_threshold(keep):
    right = TABLE["1e-10 e"][0]

    class Forgetful(Here):
        """A process for each series."""

        def call_many(self, entry, calls, limits):
            known = {}
            self.function = lambda *case: known.setdefault(keep(*case), right(*case))
            return super().call_many(entry, calls, limits)

    assert thresholds("count", None, box=Forgetful(None)) == {}


def test_an_extent_that_only_grows_has_no_threshold():
    class Growing(Here):
        """A process for each series."""

        def call_many(self, entry, calls, limits):
            most = 0.0

            def touches(d, r, _length, extent, _coordinate):
                nonlocal most
                most = max(most, extent)
                return abs(d - r) <= 1e-10 * most

            self.function = counting(touches)
            return super().call_many(entry, calls, limits)

    found = thresholds("count", None, box=Growing(None))
    assert {OUTSIDE, INSIDE} & found.keys() == set()


@pytest.mark.parametrize(
    ("touches", "family"),
    [
        (lambda d, r, *_: abs(d - r) <= 1e-9, "absolute-epsilon"),
        (lambda d, r, *_: abs(d - r) <= 1e-9 * r, "radius-epsilon"),
        (lambda d, r, _l, e, _c: abs(d - r) <= 1e-10 * e, None),
        (lambda d, r, *_: r <= d <= r + 1e-9, None),  # two of them
    ],
)
def test_the_family_of_all_the_borders_together(touches, family):
    assert epsilon_family(tuple(thresholds("count", counting(touches)).values())) == family


@pytest.mark.parametrize("program", ["forgotten end", "largest without its sign"])
def test_half_an_extent_is_taken_for_no_other_length(program):
    def line_count(cx, cy, r, start, end):
        near, far = ((x - cx, y - cy) for x, y in (start, end))
        known = near if program == "forgotten end" else (*near, *far)
        half = max(r, *(map(abs, known) if program == "forgotten end" else known))
        return counting(lambda d, r, *_: abs(d - r) <= 1e-10 * half)(cx, cy, r, start, end)

    assert epsilon_family(tuple(thresholds("count", line_count).values())) is None


def test_a_threshold_on_one_side_is_told_of_that_side():
    found = thresholds("count", counting(lambda d, r, *_: r <= d <= r + 1e-9))
    assert (found[OUTSIDE].mistake, found[INSIDE].mistake) == ("absolute-epsilon", "no-epsilon")


def test_what_may_have_no_threshold_and_has_one():
    right = TABLE["1e-10 e"][0]

    def line_count(cx, cy, r, start, end):
        return None if math.dist(start, end) < 1e-9 else right(cx, cy, r, start, end)

    found = thresholds("count", line_count)
    assert {name: each.mistake for name, each in found.items()} == {
        OUTSIDE: None,
        INSIDE: None,
        NO_LINE: "absolute-epsilon",
    }
    assert thresholds("count", right)[NO_LINE].mistake is None


def accepted(name, file="quadratic.py"):
    """The entry function of an accepted solution."""
    problem, names = find_problem(name), {}
    exec((problem.solutions / "accepted" / file).read_bytes(), names)
    return names[problem.entry]


def nearest(touches=None, counts=lambda *_: True):
    """A `ray_nearest` with its own idea of a tangency, and of which points ahead of the origin count."""

    def ray_nearest(cx, cy, r, origin, direction):
        n = math.hypot(*direction)
        if n == 0:
            return None
        fx, fy = origin[0] - cx, origin[1] - cy
        e = max(r, abs(fx), abs(fy))
        d = abs(direction[0] * fy - direction[1] * fx) / n
        m = -(fx * direction[0] + fy * direction[1]) / n
        if touches(d, r, e) if touches else abs(d - r) <= 1e-10 * e:
            ways = [m]
        elif d > r:
            return None
        else:
            outer = m + math.copysign(math.sqrt((r - d) * (r + d)), m)
            ways = sorted([outer, (fx * fx + fy * fy - r * r) / outer])
        for s in ways:
            if abs(s) <= 1e-10 * e:
                return 0
            if s > 0 and counts(s, e, n):
                return s / n
        return None

    return ray_nearest


@pytest.mark.parametrize(
    ("touches", "mistake", "powers", "factor"),
    [
        (lambda d, r, _: abs(d - r) <= 1e-6, "absolute-epsilon", {}, 1e-6),
        (lambda d, r, _: abs(d - r) <= 1e-9 * r, "radius-epsilon", {"radius": 1}, 1e-9),
        (lambda d, r, e: abs(d - r) <= 1e-5 * e, "loose-epsilon", {"extent": 1}, 1e-5),
        (lambda d, r, e: abs(d - r) <= 3e-14 * e, "tight-epsilon", {"extent": 1}, 3e-14),
        (lambda d, r, e: abs(d - r) <= 1e-10 * e, None, {"extent": 1}, 1e-10),
        (lambda d, r, _: d == r, "no-epsilon", {}, 0.0),
    ],
)
def test_a_ray_that_touches_from_inside_is_told_by_the_number(touches, mistake, powers, factor):
    found = thresholds("ray-nearest", nearest(touches))[INSIDE]
    assert (found.mistake, found.law.powers) == (mistake, powers)
    assert found.law.factor == pytest.approx(factor, rel=0.3)


@pytest.mark.parametrize(
    ("counts", "mistake", "powers", "factor"),
    [
        (lambda s, e, _: s > 1e-6 * e, "loose-epsilon", {"extent": 1}, 1e-6),
        (lambda s, _e, _n: s > 1e-9, "absolute-epsilon", {}, 1e-9),
        (lambda s, _e, n: s / n > 1e-6, "length-epsilon", {"length of D": 1}, 1e-6),
    ],
)
def test_what_is_skipped_just_ahead_of_the_origin(counts, mistake, powers, factor):
    found = thresholds("ray-nearest", nearest(counts=counts))["a point just ahead"]
    assert (found.mistake, found.law.powers) == (mistake, powers)
    assert found.law.factor == pytest.approx(factor, rel=0.3)
    assert "a point just ahead" not in thresholds("ray-nearest", nearest())


@pytest.mark.parametrize(
    ("short", "mistake", "powers", "factor"),
    [
        (lambda length, e, _: length <= 1e-6 * e, "loose-epsilon", {"extent": 1}, 1e-6),
        (lambda length, _e, _c: length <= 1e-9, "absolute-epsilon", {}, 1e-9),
        (lambda length, _e, most: length <= 1e-9 * most, "coordinate-epsilon", {"coordinate": 1}, 1e-9),
    ],
)
def test_how_short_a_segment_is_taken_for_a_point(short, mistake, powers, factor):
    right = accepted("segment")

    def circle_segment(cx, cy, r, start, end):
        e = max(r, *(abs(x - c) for place in (start, end) for x, c in zip(place, (cx, cy), strict=True)))
        if short(math.dist(start, end), e, max(map(abs, (cx, cy, *start, *end)))):
            return [start] if abs(math.dist(start, (cx, cy)) - r) <= 1e-10 * e else []
        return right(cx, cy, r, start, end)

    found = thresholds("segment", circle_segment)["a short AB"]
    assert (found.mistake, found.law.powers) == (mistake, powers)
    assert found.law.factor == pytest.approx(factor, rel=0.3)


@pytest.mark.parametrize("name", ["count", "segment", "ray-nearest"])
@pytest.mark.parametrize("file", ["quadratic.py", "geometric.py", "exact.py"])
def test_every_border_of_an_accepted_solution_is_as_it_should_be(name, file):
    found = thresholds(name, accepted(name, file))
    assert list(found) == [border.about for border in borders(name) if not border.mistaken]
    assert {each.mistake for each in found.values()} == {None}
    assert all(each.follows_its_size for each in found.values() if each.within)


def test_a_problem_without_bands_has_no_borders():
    assert borders("exact-count") == ()
    assert measured((), FunctionRunner(find_problem("exact-count")), Here(None)) == ()


def test_it_takes_two_series_however_many_borders_there_are():
    box = Here(accepted("segment"))
    thresholds("segment", None, box=box)
    assert len(box.series) == 2
    assert sum(box.series) < 1300
    short = Here(accepted("segment"))
    thresholds("segment", None, box=short, first_only=True)
    assert sum(short.series) < 180


@pytest.mark.parametrize("stop", [each for each in Stop if each not in (Stop.ANSWERED, Stop.EXCEPTION)])
@pytest.mark.parametrize("before", [0, 1])
def test_a_submission_that_is_stopped_has_no_thresholds_and_is_not_asked_again(stop, before):
    box = Stopping(accepted("count"), stop, before)
    assert thresholds("count", None, box=box) == {}
    assert len(box.series) == before + 1


class Stopping(Here):
    """Ends the series after so many of them."""

    def __init__(self, function, stop, before):
        super().__init__(function)
        self.stop, self.before = stop, before

    def call_many(self, entry, calls, limits):
        if len(self.series) == self.before:
            self.stops = [self.stop]
        return super().call_many(entry, calls, limits)


@pytest.mark.parametrize("name", ["count", "segment", "ray-nearest"])
def test_the_edge_of_a_probe_is_exact_and_its_gaps_are_rounded_once(name):
    for border in borders(name):
        assert len(border.probes) == 9
        for probe in border.probes:
            if border.within:
                assert Fraction(probe.edge) ** 2 in squares(name, probe.case)
            for share in (1e-16, 3e-12, 2e-7, probe.widest):
                case, gap = probe.at(share * probe.size)
                moved = case
                for place in probe.place:
                    moved = moved[place]
                assert gap == float(abs(Fraction(moved) - Fraction(probe.edge)))


def squares(name, case):
    """The squares of the lengths at which the radius may be at an edge, exactly."""
    cx, cy, _, (ax, ay), (bx, by) = case
    cx, cy, ax, ay, bx, by = map(Fraction, (cx, cy, ax, ay, bx, by))
    if name == "ray-nearest":
        bx, by = ax + bx, ay + by
    fx, fy, dx, dy = ax - cx, ay - cy, bx - ax, by - ay
    found = [fx * fx + fy * fy, (bx - cx) ** 2 + (by - cy) ** 2]
    if dx or dy:
        found.append((dx * fy - dy * fx) ** 2 / (dx * dx + dy * dy))
    return found


@pytest.mark.parametrize("name", ["count", "segment", "ray-nearest"])
def test_the_exact_answer_turns_at_the_band_and_has_turned_at_the_promise(name):
    problem = find_problem(name)
    solve = load_module(problem).solve
    for border in borders(name):
        if not border.within:
            continue
        for probe in border.probes:
            for share, form in ((border.within * 0.8, probe.near), (border.beyond * 1.1, probe.far)):
                case, gap = probe.at(share * probe.size)
                answer, broken = solve(*case)
                target = problem.answer.target(answer, problem.groups[0].tolerance)
                assert (broken, probe.form(problem.answer.right(target), gap)) == (None, form)
            assert solve(*probe.at(1e-9 * probe.size)[0]).broken is not None


def test_borders_come_back_from_plain_values_as_they_were():
    plain = json.loads(json.dumps(as_plain(borders("segment"))))
    assert from_plain(plain) == borders("segment")


def probe(widest):
    """A line through the centre of a circle that grows: it never misses."""
    return Probe((0, 0, 1.0, (-1, 0), (1, 0)), (2,), 1.0, 1, {"size": 1.0}, widest)


def leaving():
    """A line that touches a circle, and crosses it when it grows."""
    return Probe((0, 0, 1.0, (-1, 1), (1, 1)), (2,), 1.0, 1, {"size": 1.0}, 0.1)


@pytest.mark.parametrize(
    ("made", "what"),
    [
        (lambda _: 1 / 0, "the topic's borders cannot be made: ZeroDivisionError"),
        (lambda _: [Border("it", 0, 0, (probe(widest=0.1),))], "answered 'count 2' on both sides"),
        (lambda _: [Border("it", 0, 0, (probe(widest=1e30),))], "is invalid: r has 1e\\+30"),
        (
            lambda _: [Border("it", 0, 0, (leaving(),), mistaken="none")],
            "answered 'count 1' and then 'count 2'",
        ),
    ],
)
def test_a_fault_in_a_topics_borders_is_the_problems(made, what):
    problem = find_problem("count")
    module = load_module(problem)
    with pytest.raises(ProblemError, match=what):
        borders_of(problem, replace(module, topic=Topic(borders=made)))


def test_the_same_submission_has_the_same_thresholds():
    function = TABLE["np.isclose"][0]
    assert thresholds("count", function) == thresholds("count", function)
