"""Katas of many circles: exact answers against a plain loop over all circles in 80 digits."""

from __future__ import annotations

from decimal import Decimal, localcontext
from itertools import chain, islice
from pathlib import Path

import pytest

from judge.data.build import build_cases
from judge.data.model import reseeded
from judge.data.module import load_module
from judge.problem.load import load_problem
from judge.values import AnyOf

PROBLEMS = Path(__file__).parents[2] / "problems"
ANSWERS = 1000  # of single rays or circles
DIGITS = 80
SNAP = Decimal("1e-12")
CLOSE = Decimal("1e-60")


def hits(circles, origin, way):
    """Every circle's least t >= 0, by the roots themselves; and the extent by |D|∞."""
    (ox, oy), (dx, dy) = origin, way
    e = max(max(r, abs(x - ox), abs(y - oy)) for x, y, r in circles)
    a = Decimal(dx * dx + dy * dy)
    found = []
    for index, (x, y, r) in enumerate(circles):
        fx, fy = ox - x, oy - y
        b = Decimal(fx * dx + fy * dy)
        d = abs(Decimal(dx * fy - dy * fx)) / a.sqrt()
        if d - r > SNAP * e:
            continue
        half = ((Decimal(r) ** 2 - d * d) / a).sqrt() if r - d > SNAP * e else Decimal(0)
        for t in (-b / a - half, -b / a + half):
            if abs(t) * a.sqrt() <= SNAP * e:
                t = Decimal(0)
            if t >= 0:
                found.append((t, index))
                break
    return found, Decimal(e) / max(abs(dx), abs(dy))


def decimal(surd):
    return (Decimal(surd.p) + Decimal(surd.q) * Decimal(surd.d).sqrt()) / Decimal(surd.s)


def is_first(answer, circles, origin, way):
    """Whether the answer names just the circles that come first, each with its t."""
    found, unit = hits(circles, origin, way)
    if answer is None or not found:
        return answer is None and not found
    least = min(found)[0]
    first = {index: t for t, index in found if t - least <= SNAP * unit}
    given = dict(answer.answers if isinstance(answer, AnyOf) else [answer])
    return given.keys() == first.keys() and all(
        abs(decimal(t.x) - first[index]) <= CLOSE * (unit + first[index]) for index, t in given.items()
    )


def rays_of(name, case):
    if name == "nearest":
        circles, rays = case
        return [(circles, *ray) for ray in rays]
    circles, origin, ways = case
    return [(circles, origin, way) for way in ways]


def solved(name, seed):
    """The cases of all groups that are not big, with their exact answers."""
    problem = load_problem(PROBLEMS / name)
    module = load_module(problem)
    for group in problem.groups:
        if group.size is None and group.builder != "examples":
            yield from islice(build_cases(problem, module, reseeded(group, seed)), 12)


@pytest.mark.parametrize("name", ["nearest", "beams"])
def test_the_first_circle_of_a_ray_is_that_of_a_loop_over_all_circles(name):
    checked = []
    with localcontext(prec=DIGITS):
        for case, answers in chain.from_iterable(solved(name, seed) for seed in (None, 1, 2, 3)):
            asked = rays_of(name, case)
            assert len(asked) == len(answers)
            for answer, (circles, origin, way) in islice(zip(answers, asked, strict=True), 8):
                assert is_first(answer, circles, origin, way), (case, origin, way)
                checked.append(answer)
    assert len(checked) >= ANSWERS
    assert sum(answer is None for answer in checked) > 50
    assert name == "beams" or sum(isinstance(answer, AnyOf) for answer in checked) > 5


def test_a_count_in_arrays_is_that_of_each_circle_alone():
    checked = []
    with localcontext(prec=DIGITS):
        for (cx, cy, r, start, end), counts in chain.from_iterable(
            solved("vector", seed) for seed in (None, 1)
        ):
            (ax, ay), (bx, by) = (tuple(map(Decimal, point)) for point in (start, end))
            dx, dy = bx - ax, by - ay
            assert len(counts) == len(cx)
            for x, y, radius, given in zip(
                *(map(Decimal, each) for each in (cx, cy, r)), counts, strict=True
            ):
                gap = abs(dx * (ay - y) - dy * (ax - x)) / (dx * dx + dy * dy).sqrt() - radius
                e = max(radius, abs(ax - x), abs(ay - y), abs(bx - x), abs(by - y))
                assert given == (1 if abs(gap) <= SNAP * e else 0 if gap > 0 else 2)
                checked.append(given)
    assert len(checked) >= ANSWERS
    assert set(checked) == {0, 1, 2}
