"""First steps: gentle, exact, and each of a kind with its picture."""

from __future__ import annotations

import re
from fractions import Fraction
from itertools import product

import pytest

from judge.data import load_data
from judge.data.draw import QuickDraw, Rejected
from judge.data.module import load_module
from judge.drawing.braille import to_braille
from judge.drawing.svg import to_svg
from judge.kata.sets import find_set
from judge.kata.stub import make_stub
from judge.problem.find import find_problem
from judge.problem.topic import Shown
from judge.run.audit import audit
from judge.topics.circles.recipes import steps

STEPS = ["distance-squared", "which-side", "circle-side", "diameter", "axis-foot", "crossings"]
PLAIN = re.compile(r"(?<![a-z])(bands?|epsilons?|tolerances?|extent|discriminant of|floating)(?![a-z])", re.I)


def sign(x):
    return (x > 0) - (x < 0)


def square(p, q):
    return sum((a - b) ** 2 for a, b in zip(p, q, strict=True))


def foot(a, b, p):
    """The foot on any line, as fractions."""
    d = [y - x for x, y in zip(a, b, strict=True)]
    t = Fraction(sum((y - x) * z for x, y, z in zip(a, p, d, strict=True)), square(a, b))
    return tuple(x + t * z for x, z in zip(a, d, strict=True))


def side(a, b, p):
    """Which side P is on, by the height of the line above P's x."""
    if a[0] == b[0]:
        return sign(a[0] - p[0]) * sign(b[1] - a[1])
    height = a[1] + Fraction(b[1] - a[1], b[0] - a[0]) * (p[0] - a[0])
    return sign(p[1] - height) * sign(b[0] - a[0])


def in_circle(centre, radius_squared, p):
    return sign(square(centre, p) - radius_squared)


def middle(a, b):
    return tuple(Fraction(x + y, 2) for x, y in zip(a, b, strict=True))


# Each by another way than the problem's own `solve`.
ANSWERS = {
    "distance-squared": lambda p, q: square(p, (0, 0)) + square(q, (0, 0)) - 2 * (p[0] * q[0] + p[1] * q[1]),
    "which-side": side,
    "circle-side": lambda cx, cy, r, p: in_circle((cx, cy), r * r, p),
    "diameter": lambda a, b, p: in_circle(middle(a, b), Fraction(square(a, b), 4), p),
    "axis-foot": foot,
    "crossings": lambda cx, cy, r, a, b: 1 - in_circle((cx, cy), r * r, foot(a, b, (cx, cy))),
}


@pytest.fixture(autouse=True)
def _no_other_pack(monkeypatch):
    monkeypatch.delenv("JUDGE_PROBLEMS", raising=False)


@pytest.fixture(params=STEPS)
def problem(request):
    return find_problem(request.param)


def test_they_are_the_first_of_the_path_in_order():
    assert [each.id for each in find_set("first-steps").problems] == STEPS
    assert [each.id for each in find_set("path").problems[: len(STEPS)]] == STEPS


def test_each_is_small_and_whole(problem):
    assert len(problem.groups) <= 5
    assert not problem.bands
    assert not problem.answer.measured
    assert {each.type.text for each in problem.parameters} <= {"integer", "integer-point"}
    assert len((problem.folder / "problem.py").read_text(encoding="utf-8").splitlines()) <= 40
    (skill,) = problem.skills
    assert set(skill.groups) == {group.name for group in problem.groups} - {"examples"}


def test_nothing_that_a_beginner_reads_is_of_bands(problem):
    told = [(problem.folder / name).read_text(encoding="utf-8") for name in ("statement.md", "hints.md")]
    for text in [*told, make_stub(problem), *(group.about for group in problem.groups)]:
        assert PLAIN.findall(text) == []


def test_the_answers_are_those_of_another_way(problem):
    data = load_data(problem, cache=False)
    cases = [case for group in data.groups for case in group.cases]
    assert len(cases) > 200
    assert all(load_module(problem).solve(*case).answer == ANSWERS[problem.id](*case) for case in cases)


def test_there_are_cases_of_every_kind(problem):
    data = load_data(problem, cache=False)
    audited = audit(problem, data.module.topic, data.groups, None)
    assert audited.gaps == ()
    decided = {"which-side", "circle-side", "diameter", "crossings"}
    assert (len(audited.buckets) > 8) is (problem.id in decided)


def test_a_case_is_drawn_with_what_decides(problem):
    module = load_module(problem)
    for case in [group.cases[0] for group in load_data(problem, cache=False).groups]:
        values = {
            parameter.name: list(value) if isinstance(value, tuple) else value
            for parameter, value in zip(problem.parameters, case, strict=True)
        }
        exact = module.solve(*case).answer
        given = [0, 0] if isinstance(exact, tuple) else 7
        shown = Shown(problem, values, exact, str(exact), str(given), given, "a case")
        picture = module.topic.picture(shown)
        assert {"input", "wanted", "got", "geometry"} == {fact.label for fact in picture.facts}
        names = " ".join(mark.text for mark in picture.whole.marks)
        assert all(name in names for name, value in values.items() if isinstance(value, list))
        assert ("wanted" in names) is (problem.id == "axis-foot")
        assert PLAIN.findall(picture.description) == []
        assert to_svg(picture).startswith("<svg")
        assert any(piece.text.strip() for line in to_braille(picture) for piece in line)


def figures(recipe, **parameters):
    found = []
    for seed in range(400):
        try:
            found.append(recipe(QuickDraw(str(seed)), **parameters))
        except Rejected:
            continue
    assert len(found) > 20
    return found


@pytest.mark.parametrize("reach", [3, 20, 10**9])
def test_figures_are_what_their_recipes_say_and_within_reach(reach):
    drawn = {
        "line": figures(steps.beside_line, reach=reach, off=[0]),
        "circle": figures(steps.beside_circle, reach=reach, on=True),
        "near": figures(steps.beside_circle, reach=reach, on=False),
        "angle": figures(steps.right_angle, reach=reach, off=[0]),
        "level": figures(steps.level, reach=reach),
        "beyond": figures(steps.level_beyond, reach=reach),
        "level circle": figures(steps.right_angle, reach=reach, off=[0], level=True),
    }
    for figure in [each for every in drawn.values() for each in every]:
        numbers = (*figure.centre, figure.radius, *(x for point in figure.points for x in point))
        assert all(type(x) is int and abs(x) <= reach for x in numbers)
    assert {side(*figure.points) for figure in drawn["line"]} == {0}
    for figure in drawn["circle"]:
        assert in_circle(figure.centre, figure.radius**2, figure.points[0]) == 0
    for figure in drawn["near"]:
        away = square(figure.centre, figure.points[0])
        assert away != figure.radius**2
        assert (figure.radius - 1) ** 2 <= away <= (figure.radius + 1) ** 2
    for figure in (*drawn["angle"], *drawn["level circle"]):
        a, b, p = figure.points
        assert in_circle(middle(a, b), Fraction(square(a, b), 4), p) == 0
    for figure in (*drawn["level"], *drawn["beyond"]):
        a, b, _ = figure.points
        assert a != b
        assert a[0] == b[0] or a[1] == b[1]
    for figure in drawn["beyond"]:
        a, b, p = figure.points
        at = foot(a, b, p)
        assert not any(min(x, y) < z < max(x, y) for x, y, z in zip(a, b, at, strict=True))


def test_the_nearest_of_all_lines_are_found():
    near = figures(steps.nearly, reach=3)
    least = {abs(gap) for gap in map(gap_of, near)}
    small = range(-3, 4)
    every = {
        abs(gap_of_case(cx, cy, r, (ax, ay), (bx, by)))
        for cx, cy, ax, ay, bx, by in product(range(4), range(4), small, small, small, small)
        for r in (1, 2, 3)
        if (ax, ay) != (bx, by)
    }
    assert min(least) == min(every - {0})


def gap_of(figure):
    return gap_of_case(*figure.centre, figure.radius, *figure.points)


def gap_of_case(cx, cy, r, a, b):
    """(d² - r²)/r."""
    k = (b[0] - a[0]) * (cy - a[1]) - (b[1] - a[1]) * (cx - a[0])
    return (Fraction(k * k, square(a, b)) - r * r) / r


def test_broad_figures_have_products_that_doubles_just_fail_to_hold():
    size, least = 10**8, 95 * 10**6
    assert least**2 > 2**53
    lines = figures(steps.beside_line, reach=9, off=[1, -1], broad=size)
    angles = figures(steps.right_angle, reach=9, off=[1, -1], broad=size)
    apart = [figure.points for figure in figures(steps.apart, reach=size)]
    seen = [(a, b, p) for a, b, p in (figure.points for figure in lines) if square(a, b) > 10**6]
    assert {side(*points) for points in seen} == {1, -1}
    pairs = [(a, other) for a, *others in seen for other in others]
    seen = [(a, b, p) for a, b, p in (figure.points for figure in angles) if square(a, b) > 10**6]
    assert {square(a, p) + square(b, p) - square(a, b) for a, b, p in seen} == {
        2,
        -2,
    }  # twice the scalar product
    pairs += [(p, other) for *others, p in seen for other in others]
    pairs += [(p, q) for p, q in apart if square(p, q) > 2 * least**2]
    assert len(pairs) > 300
    assert sum(all(least <= abs(x - y) <= size for x, y in zip(*pair, strict=True)) for pair in pairs) > 300


def test_a_circle_ends_just_below_its_point():
    broad = [each for each in figures(steps.beside_circle, reach=9, on=False, broad=10**8) if each.radius > 9]
    assert len(broad) > 20
    for figure in broad:
        assert square(figure.centre, figure.points[0]) - figure.radius**2 in (1, 4, 9)
        assert 98 * 10**6 <= figure.radius <= 10**8


def test_corners_take_doubled_differences_beyond_64_bits():
    found = [each.points for each in figures(steps.scattered, reach=10**9, points=3, corners=True)]
    doubled = [square((a[0] + b[0], a[1] + b[1]), (2 * p[0], 2 * p[1])) for a, b, p in found]
    assert sum(each >= 2**63 for each in doubled) > 40
    assert all(abs(x) <= 10**9 for points in found for point in points for x in point)
