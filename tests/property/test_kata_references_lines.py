"""Katas of a line: exact answers against other formulas in 80 digits and more, on shipped and fresh cases."""

from __future__ import annotations

from collections import Counter
from decimal import Decimal, localcontext
from fractions import Fraction

import pytest
from references import SNAP, alike, answers, cases_of, dot, minus, norm, number, plus, reach, small_cases, vec
from sampling import daily

pytestmark = pytest.mark.slow


def distance(a, b, p):
    """By the foot, which costs digits that there are."""
    return None if a == b else norm(minus(vec(*p), foot(a, b, p)[1]))


def foot(a, b, c):
    """By Cramer's rule: where A + t·D meets the perpendicular through C."""
    (ax, ay), (bx, by), (cx, cy) = vec(*a), vec(*b), vec(*c)
    dx, dy = bx - ax, by - ay
    if not dx and not dy:
        return None
    # dy·x − dx·y = dy·Ax − dx·Ay and dx·x + dy·y = dx·Cx + dy·Cy
    line, across = dy * ax - dx * ay, dx * cx + dy * cy
    bottom = dx * dx + dy * dy
    x, y = (line * dy + across * dx) / bottom, (dy * across - dx * line) / bottom
    t = (x - ax) / dx if abs(dx) > abs(dy) else (y - ay) / dy
    return t, (x, y)


def normal_form(a, b):
    """By the unit vector of B − A turned to the left; c by the point B."""
    d = minus(vec(*b), vec(*a))
    if d == (0, 0):
        return None
    turned = -d[1] / norm(d), d[0] / norm(d)
    return *turned, -dot(turned, vec(*b))


def on_circle(cx, cy, r, p):
    """By the length itself."""
    f, r = minus(vec(*p), vec(cx, cy)), Decimal(r)
    gap = norm(f) - r
    if abs(gap) <= SNAP * max(r, reach(f)):
        return 0
    return 1 if gap > 0 else -1


def quadratic(cx, cy, r, a, b):
    """The common points by b² − a·c, in order of t; None for A == B."""
    c, d = vec(cx, cy), minus(vec(*b), vec(*a))
    if d == (0, 0):
        return None
    f, r = minus(vec(*a), c), Decimal(r)
    square, along = dot(d, d), dot(f, d)
    if abs(norm(plus(f, d, -along / square)) - r) <= SNAP * max(r, reach(f, minus(vec(*b), c))):
        roots = [-along / square]
    else:
        under = along * along - square * (dot(f, f) - r * r)
        half = under.sqrt() if under > 0 else None
        roots = [] if half is None else [(-along - half) / square, (-along + half) / square]
    return [plus(plus(c, f), d, t) for t in roots]


def chord(*case):
    """How far the common points are apart."""
    points = quadratic(*case)
    return norm(minus(points[0], points[-1])) if points else None


def count(*case):
    """How many they are."""
    points = quadratic(*case)
    return None if points is None else len(points)


HAIR = Decimal("1e-150")  # of t, in 400 digits; what is not exact is 1e-7 and more


def times(cx, cy, r, a, d):
    """The t of a + t·d on the circle by b² − a·c, in order; d is not 0."""
    f, square = minus(vec(*a), vec(cx, cy)), dot(d, d)
    middle = -dot(f, d) / square
    under = middle * middle - (dot(f, f) - Decimal(r) ** 2) / square
    if abs(under) <= HAIR * (middle * middle + Decimal(r) ** 2 / square + 1):
        return [middle]
    return [] if under < 0 else [middle - under.sqrt(), middle + under.sqrt()]


def segment(cx, cy, r, a, b):
    """By the t from 0 to 1."""
    if a == b:
        f = minus(vec(*a), vec(cx, cy))
        return [vec(*a)] if abs(norm(f) - Decimal(r)) <= HAIR * (norm(f) + 1) else []
    d = minus(vec(*b), vec(*a))
    return [plus(vec(*a), d, t) for t in times(cx, cy, r, a, d) if -HAIR <= t <= 1 + HAIR]


def ray(cx, cy, r, o, d):
    """The least t from 0 on."""
    d = vec(*d)
    if d == (0, 0):
        return None
    ahead = [t for t in times(cx, cy, r, o, d) if t >= -HAIR * (abs(t) + 1)]
    return ahead[0] if ahead else None


PLAIN = {
    "count": count,
    "segment": segment,
    "ray-nearest": ray,
    "chord": chord,
    "distance": distance,
    "foot": foot,
    "line-points": quadratic,
    "normal-form": normal_form,
    "on-circle": on_circle,
}


def digits_to_spare(formula):
    def spare(*case):
        with localcontext(prec=400):
            return formula(*case)

    return spare


def closely(answer, other):
    with localcontext(prec=400):
        return alike(answer, other, Decimal("1e-75"))


@pytest.mark.parametrize("name", daily(PLAIN, ["chord", "foot", "on-circle", "segment"]))
def test_the_exact_answer_is_that_of_another_formula(name):
    found = answers(name, digits_to_spare(PLAIN[name]), cases_of(name), closely)
    assert len({str(answer) for answer in found}) >= 3


# -- without bands: where 80 digits do not tell, they grow until they do ------------------------------------


def exact_segment(cx, cy, r, a, b):
    """The roots in t themselves, in four times the digits of the largest number, and 80 more."""
    digits = max(len(str(abs(x))) for x in (cx, cy, r, *a, *b))
    with localcontext(prec=8 * digits + 80):
        hair = Decimal(10) ** -(4 * digits + 40)
        d, f = vec(b[0] - a[0], b[1] - a[1]), vec(a[0] - cx, a[1] - cy)
        square = dot(d, d)
        if not square:
            return int(abs(norm(f) - r) < hair)
        middle = -dot(f, d) / square
        at = plus(f, d, middle)
        half = (Decimal(r) ** 2 - dot(at, at)) / square
        if half < -hair:
            return 0
        if half <= hair:
            return int(-hair <= middle <= 1 + hair)
        return sum(-hair <= t <= 1 + hair for t in (middle - half.sqrt(), middle + half.sqrt()))


def quadratic_roots(a, b, c):
    """By completing the square; in as many digits as doubles of 2**±600 and their products have, and more."""
    with localcontext(prec=1000):
        a, b, c = vec(a, b, c)
        if not a:
            return (None if not c else []) if not b else [-c / b / 2]
        middle, square = -b / a, (b / a) ** 2 - c / a
        if abs(square) <= Decimal("1e-500") * (b / a) ** 2:
            return [middle]
        return [] if square < 0 else [middle - square.sqrt(), middle + square.sqrt()]


def discriminant(*case):
    """b² − a·c and the width that the statement allows, in as many digits as doubles of 1e-30 have."""
    with localcontext(prec=1000):
        cx, cy, r, ax, ay, bx, by = vec(*case)
        dx, dy, fx, fy = bx - ax, by - ay, ax - cx, ay - cy
        a, b, c = dx * dx + dy * dy, fx * dx + fy * dy, fx * fx + fy * fy - r * r
        k, whole = abs(dx * fy - dy * fx), abs(dx * fy) + abs(dy * fx)
        return b * b - a * c, (r * r * a + whole * k) / 2**46 + whole * whole / 2**98


def sign(*case):
    """Of b² − a·c."""
    delta, _ = discriminant(*case)
    return (delta > 0) - (delta < 0)


def equal_enclosure(exact, other):
    return tuple(map(Fraction, other)) == exact.why_not.args


def equal_roots(exact, other):
    """Alike to 80 digits, each root by itself."""
    if exact is None or other is None:
        return exact is other
    with localcontext(prec=1000):
        found = [number(each) for each in exact]
        hairs = [Decimal("1e-80") * (abs(x) or max(map(abs, other))) for x in found]
        pairs = zip(found, other, hairs, strict=True)
        return all(abs(x - y) <= hair for x, y, hair in pairs) and found == sorted(found)


BANDLESS = {  # the other formula, whether an exact answer is alike, and how many different answers
    "exact-segment": (exact_segment, alike, 3),
    "adaptive": (sign, alike, 3),
    "error-bound": (discriminant, equal_enclosure, 100),
    "stable-roots": (quadratic_roots, equal_roots, 100),
}


@pytest.mark.parametrize("name", daily(BANDLESS, ["exact-segment", "error-bound"]))
def test_without_bands_it_is_so_to_the_last_digit(name):
    formula, same, kinds = BANDLESS[name]
    found = Counter(map(str, answers(name, formula, cases_of(name), same)))
    assert len(found) >= kinds


def by_b_and_c(cx, cy, r, a, b):
    """The sign of b² − a·c, and 1."""
    (dx, dy), (fx, fy) = (b[0] - a[0], b[1] - a[1]), (a[0] - cx, a[1] - cy)
    if dx == dy == 0:
        return None
    along, power = fx * dx + fy * dy, fx * fx + fy * fy - r * r
    gap = along * along - (dx * dx + dy * dy) * power
    return 1 + (gap > 0) - (gap < 0)


def projected(a, b, p):
    """A + t·D with t = (P − A)·D / D·D."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    t = Fraction((p[0] - a[0]) * dx + (p[1] - a[1]) * dy, dx * dx + dy * dy)
    return a[0] + t * dx, a[1] + t * dy


def signed(x):
    return (x > 0) - (x < 0)


WHOLE = {
    "exact-count": by_b_and_c,
    "crossings": by_b_and_c,
    "axis-foot": projected,
    "distance-squared": lambda p, q: sum(x * (x - 2 * y) + y * y for x, y in zip(p, q, strict=True)),
    "which-side": lambda a, b, p: signed(
        a[0] * b[1] - a[1] * b[0] + b[0] * p[1] - b[1] * p[0] + p[0] * a[1] - p[1] * a[0]
    ),
    "circle-side": lambda cx, cy, r, p: signed(
        p[0] * (p[0] - 2 * cx) + p[1] * (p[1] - 2 * cy) + cx * cx + cy * cy - r * r
    ),
    "diameter": lambda a, b, p: signed(
        sum((2 * z - x - y) ** 2 - (x - y) ** 2 for x, y, z in zip(a, b, p, strict=True))
    ),
}


@pytest.mark.parametrize("name", daily(WHOLE, ["exact-count", "diameter"]))
def test_whole_numbers_give_the_same_in_another_formula(name):
    found = list(answers(name, WHOLE[name], cases_of(name)))
    assert len(set(map(str, found))) >= 3


def test_counts_in_arrays_are_those_of_each_circle_alone():
    seen = Counter()
    for (cx, cy, r, start, end), counts in small_cases("vector", (None,)):
        assert len(counts) == len(cx)
        with localcontext(prec=80):
            (ax, ay), (bx, by) = vec(*start), vec(*end)
            dx, dy = bx - ax, by - ay
            for x, y, radius, given in zip(vec(*cx), vec(*cy), vec(*r), counts, strict=True):
                gap = abs(dx * (ay - y) - dy * (ax - x)) / (dx * dx + dy * dy).sqrt() - radius
                e = max(radius, abs(ax - x), abs(ay - y), abs(bx - x), abs(by - y))
                assert given == (1 if abs(gap) <= SNAP * e else 0 if gap > 0 else 2)
                seen[given] += 1
    assert seen.total() >= 100
    assert set(seen) == {0, 1, 2}
