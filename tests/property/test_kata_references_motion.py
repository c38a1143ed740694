"""Katas of motions and of many circles: exact answers against other formulas in 80 digits.

Roots come from the quadratic's own coefficients, not from the cross product that `solve` takes.
"""

from __future__ import annotations

from collections import Counter
from decimal import Decimal, localcontext
from itertools import islice, pairwise
from math import factorial, prod

import pytest
from references import (
    CLOSE,
    SNAP,
    answers,
    broken_promise,
    cases_of,
    cross,
    dot,
    minus,
    norm,
    number,
    plus,
    reach,
    small_cases,
    solver,
    vec,
)
from sampling import nightly

from judge.values.answers import AnyOf

pytestmark = pytest.mark.slow

# -- moments of motions -------------------------------------------------------------------------------------


def in_time(t, way, slack):
    """The moment, if it is in the time; what is within the slack of an end, along the way, is there."""
    if abs(t) * reach(way) <= slack:
        return Decimal(0)
    late = (t - 1) * reach(way)
    return None if t < 0 or late > slack else t


def balls_meet(p0, p1, r, q0, q1, s):
    """By the squared distance, as the product of both roots over the other one."""
    p0, p1, q0, q1 = (vec(*each) for each in (p0, p1, q0, q1))
    f, total = minus(p0, q0), Decimal(r) + Decimal(s)
    way = minus(minus(p1, q1), f)
    slack = SNAP * max(total, reach(minus(p1, p0), f, minus(q1, p0)))
    if norm(f) - total <= slack:
        return Decimal(0)
    if not any(way):
        return None
    a, b, c = dot(way, way), dot(way, f), dot(f, f) - total * total
    nearest = norm(plus(f, way, -b / a))
    if abs(nearest - total) <= slack:
        return in_time(-b / a, way, slack)
    if nearest > total or b > 0:
        return None
    return in_time(c / (-b + (b * b - a * c).sqrt()), way, slack)


def apart(p, a, b):
    """The squared distance of a point from a segment."""
    wall, f = minus(b, a), minus(p, a)
    square, along = dot(wall, wall), dot(f, wall)
    if along <= 0 or along >= square:
        return min(dot(f, f), dot(minus(p, b), minus(p, b)))
    return cross(wall, f) ** 2 / square


def lowest(p0, way, a, b):
    """When the distance from the segment is least on the whole line; of several moments the first."""
    feet = [-dot(minus(p0, end), way) / dot(way, way) for end in (a, b)]
    wall = minus(b, a)
    turn = cross(way, wall)
    if turn:
        feet.append(cross(minus(a, p0), wall) / turn)
    place = {t: apart(plus(p0, way, t), a, b) for t in feet}
    least = min(place.values())
    return min(t for t in feet if place[t] - least <= CLOSE * least), least.sqrt()


def time_of_impact(p0, p1, r, a, b):
    """By halving: the distance from the segment is convex in time, and falls until it is least."""
    p0, p1, a, b = (vec(*each) for each in (p0, p1, a, b))
    r, way = Decimal(r), minus(p1, p0)
    slack = SNAP * max(r, reach(*(minus(end, place) for end in (a, b) for place in (p0, p1))))
    if apart(p0, a, b).sqrt() - r <= slack:
        return Decimal(0)
    if not any(way):
        return None
    end, least = lowest(p0, way, a, b)
    if abs(least - r) <= slack:
        grazed = [
            -dot(minus(p0, each), way) / dot(way, way)
            for each in (a, b)
            if abs(abs(cross(way, minus(p0, each))) / norm(way) - r) <= slack
        ]
        return in_time(min(grazed, default=end), way, slack)  # none: a point that crosses the wall
    if least > r or end < 0:
        return None
    start = Decimal(0)
    for _ in range(220):
        middle = (start + end) / 2
        near = apart(plus(p0, way, middle), a, b) <= r * r
        start, end = (start, middle) if near else (middle, end)
    return in_time(end, way, slack)


def same_moment(answer, other):
    if answer is None or other is None:
        return answer is other
    return abs(number(answer) - other) <= CLOSE


@pytest.mark.parametrize(
    ("name", "formula"), [("swept-balls", balls_meet), nightly("swept-wall", time_of_impact)]
)
def test_the_exact_moment_is_that_of_another_formula(name, formula):
    kinds = Counter()
    for answer in answers(name, formula, cases_of(name), same_moment):
        kinds["none" if answer is None else "moment" if number(answer) else "start"] += 1
    assert len(kinds) == 3
    assert min(kinds.values()) > 10


def test_a_touch_that_is_none_by_a_hair_is_no_case():
    """An end of the wall is r and 8e-13 of the size away from the way: t may be 1/3 or 0.334."""
    way = (-1303.308078273959, 223328.06271951832), (-45029.38585047667, 151104.2007024586)
    wall = (-15925.562970396388, 199189.48268941295), (-15884.655795283492, 199257.06673356748)
    assert "almost grazes an end" in broken_promise("swept-wall", *way, 7, *wall)
    for r in (6.9, 7.1):
        with localcontext(prec=160):
            assert same_moment(solver("swept-wall")(*way, r, *wall), time_of_impact(*way, r, *wall))


@pytest.mark.parametrize(
    ("case", "broken"),
    [
        (((0, 0), (10, 0), 1, (5, 2), (5, 2), 1), None),
        (((0, 0), (10, 0), 1, (5, 2.0000001), (5, 2.0000001), 1), "almost graze"),
        (((0, 0), (-10, 0), 1, (5, 2.0000001), (5, 2.0000001), 1), None),  # they leave each other
        (((0, 0), (3.0000001, 0), 1, (5, 0), (5, 0), 1), "almost touch at t = 1"),
        (((0, 0), (3, 0), 1, (2.0000001, 0), (7, 0), 1), "almost touch at t = 0"),
        (((0, 0), (3, 0), 1, (1, 0), (4.0001, 0), 1), "The way of one disc"),
    ],
)
def test_what_two_discs_promise(case, broken):
    said = broken_promise("swept-balls", *case)
    assert said is None if broken is None else broken in said


@pytest.mark.parametrize(
    ("case", "broken"),
    [
        (((0, 5), (0, -5), 1, (-3, 0), (3, 0)), None),
        (((0, 5), (0, 1), 1, (-3, 0), (3, 0)), None),
        (((0, 5), (0, 1.0000001), 1, (-3, 0), (3, 0)), "at t = 1"),
        (((0, 1.0000001), (0, 5), 1, (-3, 0), (3, 0)), "at t = 0"),
        (((-5, 1.0000001), (5, 1.0000001), 1, (-3, 0), (3, 0)), "almost grazes an end"),
        (((-5, 3), (5, 3.0001), 1, (-3, 0), (3, 0)), "almost parallel"),
        (((0, 5), (0, 5.001), 1, (-3, 0), (3, 0)), "The way is"),
        (((0, 5), (0, -5), 1, (0, 0), (1e-4, 0)), "The wall is"),
    ],
)
def test_what_a_wall_promises(case, broken):
    said = broken_promise("swept-wall", *case)
    assert said is None if broken is None else broken in said


# -- a ray and many circles ---------------------------------------------------------------------------------


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
    """In Decimals, with the extent as seen from the origin, and what that is in the parameter."""
    circles, origin, way = [vec(*each) for each in circles], vec(*origin), vec(*way)
    e = max(*(reach(minus((x, y), origin)) for x, y, _ in circles), *(r for _, _, r in circles), Decimal(0))
    return circles, origin, way, e, SNAP * e / reach(way)


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
    return runs, slack / SNAP


def same_hits(answer, other):
    wanted, unit = other
    orders = list(answer.answers) if isinstance(answer, AnyOf) else [answer]
    if len(orders) != prod(factorial(len(hits)) for hits in wanted):
        return False
    for order in orders:
        rest = iter(order)
        for hits in wanted:
            left = {(index, tag): t for t, index, tag in hits}
            for real, index, tag in islice(rest, len(hits)):
                if abs(number(real) - left.pop((index, tag))) > CLOSE * unit:
                    return False
        if next(rest, None) is not None:
            return False
    return len({tuple(hit[1:] for hit in order) for order in orders}) == len(orders)


def test_the_hits_are_those_of_another_formula():
    cases = cases_of("enter-exit")
    found = list(answers("enter-exit", all_hits, cases, same_hits))
    assert sum(isinstance(answer, AnyOf) for answer in found) > 20
    counts = {len(circles) for circles, *_ in cases}
    assert (min(counts), max(counts) > 30) == (1, True)


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
    return list(zip(starts, ends, strict=True)), slack


def holds(program, discs, t):
    """Whether the solid that the program's last step makes holds t; its steps are taken away."""
    step = program.pop()
    if step >= 0:
        return bool(discs[step]) and discs[step][0] < t < discs[step][1]
    upper, lower = holds(program, discs, t), holds(program, discs, t)
    return {-1: lower or upper, -2: lower and upper, -3: lower and not upper}[step]


def same_spans(answer, other):
    wanted, slack = other  # any of the ends at one place
    return len(answer) == len(wanted) and all(
        abs(number(real) - end) <= 2 * slack
        for span, ends in zip(answer, wanted, strict=True)
        for real, end in zip(span, ends, strict=True)
    )


def test_the_spans_are_those_of_the_middles_of_all_pieces():
    found = answers("csg", inside_spans, cases_of("csg"), same_spans)
    assert set(map(len, found)) >= {0, 1, 2, 3}


def light(circles, origin, way, lamp):
    """By the roots of both rays, the hit being known to 160 digits."""
    circles, origin, way, lamp = [vec(*each) for each in circles], vec(*origin), vec(*way), vec(*lamp)
    hits = [(t, circle) for circle in circles for t, _ in roots(circle, origin, way, 0) if t > 0]
    if not hits:
        return None
    t, (x, y, _) = min(hits)
    point = plus(origin, way, t)
    normal, there = minus(point, (x, y)), minus(lamp, point)
    if dot(way, normal) * dot(there, normal) > 0:
        return "dark"
    seconds = [s for circle in circles for s, _ in roots(circle, point, there, 0)]
    return "dark" if any(CLOSE < s < 1 for s in seconds) else "lit"


def test_the_light_is_that_of_the_roots_of_both_rays():
    seen = Counter(answers("shadow", light, cases_of("shadow")))
    assert min(seen[each] for each in ("lit", "dark", None)) > 8


def first_hits(circles, origin, way):
    """Every circle's least t >= 0, and what the extent is in the parameter."""
    circles, origin, way, e, slack = scene(circles, origin, way)
    found = []
    for index, circle in enumerate(circles):
        ts = [Decimal(0) if abs(t) * norm(way) <= SNAP * e else t for t, _ in roots(circle, origin, way, e)]
        found += [(t, index) for t in ts if t >= 0][:1]
    return found, slack


def is_first(answer, circles, origin, way):
    """Whether the answer names just the circles that come first, each with its t."""
    found, slack = first_hits(circles, origin, way)
    if answer is None or not found:
        return answer is None and not found
    first = {index: t for t, index in found if t - min(found)[0] <= slack}
    given = dict(answer.answers if isinstance(answer, AnyOf) else [answer])
    return given.keys() == first.keys() and all(
        abs(number(t) - first[index]) <= CLOSE * (slack / SNAP + first[index]) for index, t in given.items()
    )


@pytest.mark.parametrize("name", ["nearest", "beams"])
@pytest.mark.nightly
def test_the_first_circle_of_a_ray_is_that_of_a_loop_over_all_circles(name):
    checked = []
    for (circles, *rays), given in small_cases(name, (None,)):
        asked = rays[0] if name == "nearest" else [(rays[0], way) for way in rays[1]]
        assert len(asked) == len(given)
        with localcontext(prec=80):
            for answer, (origin, way) in islice(zip(given, asked, strict=True), 8):
                assert is_first(answer, circles, origin, way), (circles, origin, way)
                checked.append(answer)
    assert len(checked) >= 150
    assert sum(answer is None for answer in checked) > 10
    assert name == "beams" or sum(isinstance(answer, AnyOf) for answer in checked) > 5


# -- what is against the promise ----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("program", "fault"),
    [
        ((0, 1), "leaves 2 solids"),
        ((0, -1), "less than two solids"),
        ((0, 2, -1), "names 2, and there are 2 discs"),
    ],
)
def test_a_program_that_is_none_is_against_the_promise(program, fault):
    assert fault in broken_promise("csg", [(3, 0, 1), (6, 0, 1)], (0, 0), (1, 0), program)
    assert broken_promise("csg", [(3, 0, 1), (6, 0, 1)], (0, 0), (1, 0), (0, 1, -1)) is None


@pytest.mark.parametrize(
    ("case", "broken"),
    [
        (([(5, 0, 1)], (0, 0), (0, 0), (0, 8)), "D is"),
        (([(5, 0, 0)], (0, 0), (1, 0), (0, 8)), "A radius is"),
        (([(5, 0, 1), (9, 9, 1e-5)], (0, 0), (1, 0), (0, 8)), "A radius is"),
        (([(5, 1, 1)], (0, 0), (1, 0), (0, 8)), "ray's line is almost a tangent"),
        (([(5, 1.0000001, 1)], (0, 0), (1, 0), (0, 8)), "ray's line is almost a tangent"),
        (([(5, 0, 5)], (0, 0), (1, 0), (0, 8)), "O is almost on"),
        (([(5, 0, 1), (0, 8, 2)], (0, 0), (1, 0), (0, 6)), "L is almost on a"),
        (([(5, 0, 1)], (0, 0), (1, 0), (4, 8)), "tangent at P"),
        (([(5, 0, 1)], (0, 0), (1, 0), (4 - 5e-6, 8)), "tangent at P"),
        (([(5, 0, 1)], (0, 0), (1, 0), (4 - 9e-6, 8)), None),
        (([(5, 0, 1), (3, 0, 1)], (0, 0), (1, 0), (0, 8)), None),
        (([(5, 0, 1), (4.5, 0, 0.5)], (0, 0), (1, 0), (0, 8)), "P is almost on another"),
        (([(5, 0, 1), (2, 5, 1)], (0, 0), (1, 0), (-4, 8)), None),
        (([(5, 0, 5), (15, 7, 5)], (2, 0), (1, 0), (3, 4)), None),
        (([(5, 0, 1), (0, 4, 2)], (0, 0), (1, 0), (-4, 6)), None),
        (([(5, 0, 1), (1.2, 4.6, 2.0000001)], (0, 0), (1, 0), (-4, 6)), "line from P to L is almost"),
    ],
)
def test_what_is_nearly_a_tie_is_against_the_promise(case, broken):
    if broken is None:
        with localcontext(prec=160):
            assert solver("shadow")(*case) == light(*case)
    else:
        assert broken in broken_promise("shadow", *case)


def test_the_promise_is_held_for_every_pair_of_hits():
    """Three hits of which two are not at one place are refused, wherever the circles are in the list."""
    circles = [(8.0 + shift, 0.0, 4.0) for shift in (0.0, 4e-7, 8e-7)] + [(16.0, 0.0, 2.0)]

    def broken(circles, way=(1.0, 0.0)):
        return broken_promise("enter-exit", circles, (0.0, 0.0), way)

    for order in ((0, 1, 2, 3), (2, 1, 0, 3), (1, 3, 0, 2)):
        assert "almost the same" in broken([circles[each] for each in order])
    assert broken([circles[each] for each in (0, 0, 3)]) is None
    assert (
        broken([(-8.0, 0.0, 4.0), (-8.0 - 4e-7, 0.0, 4.0), (16.0, 0.0, 2.0)]) is None
    )  # t < 0 binds nothing
    assert "D is (0, 0)" in broken(circles[:1], (0, 0))
    assert "O is almost on" in broken([(4.0 + 1e-9, 0.0, 4.0)])
    assert "almost a tangent" in broken([(8.0, 4.0 + 1e-9, 4.0)])
