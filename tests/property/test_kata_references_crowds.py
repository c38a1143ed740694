"""Katas of many circles and a ray: exact answers against another formula in 80 digits.

The roots come from the quadratic's own coefficients, not from the cross product that `solve` takes.
"""

from __future__ import annotations

from collections import Counter
from decimal import Decimal, localcontext
from itertools import chain, islice, pairwise
from pathlib import Path

import pytest

from judge.data import load_data
from judge.data.module import load_module
from judge.exact import Surd
from judge.problem.load import load_problem
from judge.values import Run

PROBLEMS = Path(__file__).parents[2] / "problems"
CASES = 1000
DIGITS = 80
SNAP = Decimal("1e-12")
CLOSE = Decimal("1e-60")  # of a case's size


def exact(*numbers):
    return tuple(Decimal(x) for x in numbers)  # of an int or a double, without rounding


def minus(p, q):
    return p[0] - q[0], p[1] - q[1]


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1]


def extent(circles, *places):
    """The largest radius, or coordinate of a centre or another place as seen from the first place."""
    origin, *others = places
    reach = [max(map(abs, minus(place, origin))) for place in (*others, *((x, y) for x, y, _ in circles))]
    return max(*reach, *(r for _, _, r in circles))


def roots(circle, origin, way, e):
    """The parameters and sides of the line's hits with one circle, by a·t² + 2·b·t + c = 0."""
    x, y, r = circle
    f = minus(origin, (x, y))
    a, b, c = dot(way, way), dot(f, way), dot(f, f) - r * r
    distance = max(Decimal(0), dot(f, f) - b * b / a).sqrt()
    if abs(distance - r) <= SNAP * e:
        return [(-b / a, "touch")]
    if distance > r:
        return []
    far = -b - (b * b - a * c).sqrt() if b > 0 else -b + (b * b - a * c).sqrt()
    first, last = sorted((far / a, c / far if far else Decimal(0)))
    return [(first, "enter"), (last, "exit")]


def scene(circles, origin, way):
    circles, origin, way = [exact(*each) for each in circles], exact(*origin), exact(*way)
    e = extent(circles, origin)
    return circles, origin, way, e, SNAP * e / max(map(abs, way))


def all_hits(circles, origin, way):
    circles, origin, way, e, slack = scene(circles, origin, way)
    hits = [
        (Decimal(0) if abs(t) <= slack else t, index, tag)
        for index, circle in enumerate(circles)
        for t, tag in roots(circle, origin, way, e)
        if t >= -slack
    ]
    runs = []
    for hit in sorted(hits):
        if runs and hit[0] - runs[-1][0][0] <= slack:
            runs[-1].append(hit)
        else:
            runs.append([hit])
    return runs


def number(real):
    root = Surd.of(real.x)
    return (root.p + root.q * Decimal(root.d).sqrt()) / root.s


def same_hits(answer, wanted, unit):
    runs = [list(each.items) if isinstance(each, Run) else [each] for each in answer]
    if [len(run) for run in runs] != [len(run) for run in wanted]:
        return False
    for run, hits in zip(runs, wanted, strict=True):
        left = {(index, tag): t for t, index, tag in hits}
        for real, index, tag in run:
            if abs(number(real) - left.pop((index, tag))) > CLOSE * unit:
                return False
    return True


def cases_of(problem):
    """A thousand of the problem's own cases."""
    data = (load_data(problem, seed=seed, cache=False) for seed in (None, 1))
    return list(islice(chain.from_iterable(g.cases for each in data for g in each.groups), CASES))


def test_the_hits_are_those_of_another_formula():
    problem = load_problem(PROBLEMS / "enter-exit")
    solve = load_module(problem).solve
    ties = 0
    for case in cases_of(problem):
        solved = solve(*case)
        assert solved.broken is None
        with localcontext(prec=2 * DIGITS):
            unit = scene(*case)[-1] / SNAP
            assert same_hits(solved.answer, all_hits(*case), unit), case
        ties += any(isinstance(each, Run) for each in solved.answer)
    assert ties > 100


def inside_spans(circles, origin, way, program):
    """By the middles of the pieces between all ends, asked one by one, the program read backwards."""
    circles, origin, way, e, slack = scene(circles, origin, way)
    discs = [[t for t, tag in roots(circle, origin, way, e) if tag != "touch"] for circle in circles]
    cuts = [Decimal(0)]
    for end in sorted(end for disc in discs for end in disc):
        if end - cuts[-1] > slack:
            cuts.append(end)
    inside = [holds(list(program), discs, (p + q) / 2) for p, q in pairwise(cuts)]
    starts = [cuts[at] for at, here in enumerate(inside) if here and not (at and inside[at - 1])]
    ends = [cuts[at + 1] for at, here in enumerate(inside) if here and not any(inside[at + 1 : at + 2])]
    return list(zip(starts, ends, strict=True))


def holds(program, discs, t):
    """Whether the solid that the program's last step makes holds t; its steps are taken away."""
    step = program.pop()
    if step >= 0:
        return bool(discs[step]) and discs[step][0] < t < discs[step][1]
    upper, lower = holds(program, discs, t), holds(program, discs, t)
    return {-1: lower or upper, -2: lower and upper, -3: lower and not upper}[step]


def test_the_spans_are_those_of_the_middles_of_all_pieces():
    problem = load_problem(PROBLEMS / "csg")
    solve = load_module(problem).solve
    counts = set()
    for case in cases_of(problem):
        solved = solve(*case)
        assert solved.broken is None
        with localcontext(prec=2 * DIGITS):
            wanted, unit = inside_spans(*case), scene(*case[:3])[-1] / SNAP
            assert len(solved.answer) == len(wanted), case
            for span, ends in zip(solved.answer, wanted, strict=True):
                for real, end in zip(span, ends, strict=True):
                    assert abs(number(real) - end) <= 2 * SNAP * unit, case  # any of the ends at one place
        counts.add(len(wanted))
    assert counts >= {0, 1, 2, 3}


@pytest.mark.parametrize(
    ("program", "fault"),
    [
        ((0, 1), "leaves 2 solids"),
        ((0, -1), "less than two solids"),
        ((-3,), "less than two solids"),
        ((0, 2, -1), "names 2, and there are 2 discs"),
    ],
)
def test_a_program_that_is_none_is_against_the_promise(program, fault):
    solve = load_module(load_problem(PROBLEMS / "csg")).solve
    assert fault in solve([(3, 0, 1), (6, 0, 1)], (0, 0), (1, 0), program).broken
    assert solve([(3, 0, 1), (6, 0, 1)], (0, 0), (1, 0), (0, 1, -1)).broken is None


def light(circles, origin, way, lamp):
    """By the roots of both rays, the hit being known to 160 digits."""
    circles, origin, way, lamp = [exact(*each) for each in circles], exact(*origin), exact(*way), exact(*lamp)
    hits = [(t, circle) for circle in circles for t, _ in roots(circle, origin, way, 0) if t > 0]
    if not hits:
        return None
    t, (x, y, _) = min(hits)
    point = origin[0] + t * way[0], origin[1] + t * way[1]
    normal, there = minus(point, (x, y)), minus(lamp, point)
    if dot(way, normal) * dot(there, normal) > 0:
        return "dark"
    seconds = [s for circle in circles for s, _ in roots(circle, point, there, 0)]
    return "dark" if any(CLOSE < s < 1 for s in seconds) else "lit"


def test_the_light_is_that_of_the_roots_of_both_rays():
    problem = load_problem(PROBLEMS / "shadow")
    solve = load_module(problem).solve
    seen = Counter()
    for case in cases_of(problem):
        solved = solve(*case)
        assert solved.broken is None
        with localcontext(prec=2 * DIGITS):
            assert solved.answer == light(*case), case
        seen[solved.answer] += 1
    assert min(seen[each] for each in ("lit", "dark", None)) > 30


@pytest.mark.parametrize(
    ("case", "broken"),
    [
        (([(5, 0, 1)], (0, 0), (0, 0), (0, 8)), "D is"),
        (([(5, 0, 0)], (0, 0), (1, 0), (0, 8)), "radius"),
        (([(5, 0, 1), (9, 9, 1e-5)], (0, 0), (1, 0), (0, 8)), "radius"),
        (([(5, 1, 1)], (0, 0), (1, 0), (0, 8)), "ray nearly touches"),
        (([(5, 0, 5)], (0, 0), (1, 0), (0, 8)), "origin"),
        (([(5, 0, 1), (0, 8, 2)], (0, 0), (1, 0), (0, 6)), "light is nearly on"),
        (([(5, 0, 1)], (0, 0), (1, 0), (4, 8)), "level"),
        (([(5, 0, 1), (3, 0, 1)], (0, 0), (1, 0), (0, 8)), None),
        (([(5, 0, 1), (4.5, 0, 0.5)], (0, 0), (1, 0), (0, 8)), "another circle"),
        (([(5, 0, 1), (2, 5, 1)], (0, 0), (1, 0), (-4, 8)), None),
        (([(5, 0, 1), (1, 4, 1)], (0, 0), (1, 0), (0, 4)), "light is nearly on"),
        (([(5, 0, 1), (-4, 5, 2)], (0, 0), (1, 0), (-2, 6.000001)), None),
        (([(5, 0, 1), (1, 8, 4)], (0, 0), (1, 0), (1, 3)), None),
        (([(7, 0, 5), (-2, 7, 3)], (0, 0), (1, 0), (-6, 6)), None),
        (([(5, 0, 1), (3.2, 4.6, 4)], (0, 0), (1, 0), (-4, 6)), None),
        (([(5, 0, 5), (15, 7, 5)], (2, 0), (1, 0), (3, 4)), None),
        (([(8, 0, 5), (0, 7, 1)], (0, 0), (1, 0), (-1, 3)), None),
        (([(5, 0, 1), (0, 4, 2)], (0, 0), (1, 0), (-4, 6)), None),
        (([(5, 0, 2), (-1, 5, 1)], (0, 0), (1, 0), (-1, 8)), None),
        (([(8, 0, 5), (3, 8, 5)], (0, 0), (1, 0), (-2, 10)), None),
        (([(5, 0, 1), (1.2, 4.6, 2.0000001)], (0, 0), (1, 0), (-4, 6)), "way to the light nearly touches"),
    ],
)
def test_what_is_nearly_a_tie_is_against_the_promise(case, broken):
    solved = load_module(load_problem(PROBLEMS / "shadow")).solve(*case)
    if broken is None:
        with localcontext(prec=2 * DIGITS):
            assert (solved.broken, solved.answer) == (None, light(*case))
    else:
        assert broken in solved.broken


@pytest.mark.parametrize("name", ["enter-exit", "csg", "shadow"])
def test_the_mirror_images_of_a_case_are_cases(name):
    """The images that stress judges have the answers that `solve` gives them."""
    problem = load_problem(PROBLEMS / name)
    module = load_module(problem)
    seen = 0
    for group in load_data(problem, cache=False).groups:
        for case, target in islice(zip(group.cases, group.targets, strict=True), 6):
            for image, changed in module.topic.images(problem, case, target, _Chance(), 3):
                solved = module.solve(*image)
                assert solved.broken is None
                assert problem.answer.target(solved.answer, group.group.tolerance) == changed
                seen += 1
    assert seen > 100


class _Chance:
    def integer(self, low, high):
        return low


def test_the_promise_is_held_for_every_pair_of_hits():
    """Three hits of which two are not at one place are refused, wherever the circles are in the list."""
    solve = load_module(load_problem(PROBLEMS / "enter-exit")).solve
    near = 0.9e-12 * 16
    circles = [(8.0 + shift, 0.0, 4.0) for shift in (0.0, near, 2 * near)] + [(16.0, 0.0, 2.0)]
    for order in ((0, 1, 2, 3), (2, 1, 0, 3), (1, 3, 0, 2)):
        assert solve([circles[each] for each in order], (0.0, 0.0), (1.0, 0.0)).broken is not None
    assert solve([circles[each] for each in (0, 1, 3)], (0.0, 0.0), (1.0, 0.0)).broken is None
    assert solve(circles[:1], (0, 0), (0, 0)).broken == "D is (0, 0)"
    assert "origin" in solve([(4.0 + 1e-9, 0.0, 4.0)], (0.0, 0.0), (1.0, 0.0)).broken
    assert solve([(8.0, 4.0 + 1e-9, 4.0)], (0.0, 0.0), (1.0, 0.0)).broken is not None


def test_figures_of_every_kind_are_there():
    counts = {len(case[0]) for case in cases_of(load_problem(PROBLEMS / "enter-exit"))}
    assert min(counts) == 1
    assert max(counts) > 30
