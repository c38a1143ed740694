"""First steps: gentle, exact, and each of a kind with its picture."""

from __future__ import annotations

import re
from fractions import Fraction

import pytest

from judge.data import load_data
from judge.data.module import load_module
from judge.drawing.braille import to_braille
from judge.drawing.svg import to_svg
from judge.kata.sets import find_set
from judge.kata.stub import make_stub
from judge.problem.find import find_problem
from judge.problem.topic import Shown

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
def _own_pack_and_cache(monkeypatch, built):
    monkeypatch.delenv("JUDGE_PROBLEMS", raising=False)
    monkeypatch.setenv("JUDGE_CACHE", str(built))


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


@pytest.mark.slow
def test_the_answers_are_those_of_another_way(problem):
    data = load_data(problem)
    cases = [case for group in data.groups for case in group.cases]
    assert len(cases) > 200
    assert all(load_module(problem).solve(*case).answer == ANSWERS[problem.id](*case) for case in cases)


def test_a_case_is_drawn_with_what_decides(problem):
    module = load_module(problem)
    for case in [group.cases[0] for group in load_data(problem).groups]:
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


def test_whole_numbers_are_beside_a_line_or_a_circle_by_next_to_nothing_and_large():
    def cases(name, group):
        (data,) = (each for each in load_data(find_problem(name)).groups if each.group.name == group)
        return data.cases

    close = cases("circle-side", "close")
    assert all((r - 1) ** 2 <= square((cx, cy), p) <= (r + 1) ** 2 for cx, cy, r, p in close)
    assert sum(r > 95 * 10**6 for _, _, r, _ in close) > 50
    lines = [(a, b, p) for a, b, p in cases("which-side", "close") if square(a, b) > 10**16]
    assert len(lines) > 50
    assert all(abs(height(*points)) < 1e-7 for points in lines)
    angles = [(a, b, p) for a, b, p in cases("diameter", "close") if square(a, b) > 10**16]
    assert len(angles) > 50
    assert all(abs(square(a, p) + square(b, p) - square(a, b)) <= 10 for a, b, p in angles)
    for a, b, p in cases("axis-foot", "beyond"):
        at = foot(a, b, p)
        assert not any(min(x, y) < z < max(x, y) for x, y, z in zip(a, b, at, strict=True))
    corners = cases("diameter", "middling")
    doubled = [square((a[0] + b[0], a[1] + b[1]), (2 * p[0], 2 * p[1])) for a, b, p in corners]
    assert sum(each >= 2**63 for each in doubled) > 40


def height(a, b, p):
    """How far P is from the line."""
    k = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
    return k / square(a, b) ** 0.5
