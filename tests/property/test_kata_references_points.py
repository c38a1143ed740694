"""Katas of points on circles and spheres: exact answers against other formulas in 80 digits.

The points are found by other ways than `solve` goes, and ordered by the sign of a cross product.
"""

from __future__ import annotations

from decimal import Decimal

import pytest
from references import (
    SNAP,
    answers,
    broken_promise,
    cases_of,
    cross,
    dot,
    minus,
    norm,
    plus,
    reach,
    solver,
    times,
    vec,
)
from sampling import daily

from judge.exact import Surd

pytestmark = pytest.mark.slow

# -- of two circles, and of a circle and a point ------------------------------------------------------------


def left_first(points, start, end):
    """Two points, the one left of start→end before the other."""
    way = minus(end, start)
    return sorted(points, key=lambda point: -cross(way, minus(point, start)))


def beside(centre, u, along, height):
    """The two points as far along u, and as far to its sides."""
    return [plus(plus(centre, u, along), (-u[1], u[0]), side) for side in (height, -height)]


def tangent_points(cx, cy, r, point):
    """By the half-angle at C: the tangent of it is the root of (d − r)/(d + r)."""
    c, p, r = vec(cx, cy), vec(*point), Decimal(r)
    f = minus(p, c)
    d, e = norm(f), max(r, reach(f))
    if r == 0:
        return [c]
    if abs(d - r) <= SNAP * e:
        return [p]
    if d < r:
        return []
    half = ((d - r) / (d + r)).sqrt()
    cosine, sine = (1 - half * half) / (1 + half * half), 2 * half / (1 + half * half)
    return left_first(beside(c, times(1 / d, f), r * cosine, r * sine), p, c)


def circle_circle(cx1, cy1, r1, cx2, cy2, r2):
    """By Heron: the triangle's height over C1C2 from its area, and Pythagoras for how far along it is."""
    c, other, (p, q) = vec(cx1, cy1), vec(cx2, cy2), vec(r1, r2)
    v = minus(other, c)
    d, e = norm(v), max(p, q, reach(v))
    if d <= SNAP * e:
        if p == q == 0:
            return [c]
        return None if abs(p - q) <= SNAP * e else []
    if abs(d - p - q) <= SNAP * e or abs(d - abs(p - q)) <= SNAP * e:
        return [plus(c, v, (p if abs(d - p - q) <= SNAP * e or p > q else -p) / d)]
    half = (d + p + q) / 2
    square = half * (half - d) * (half - p) * (half - q)  # of the area
    if square < 0:
        return []
    height = 2 * square.sqrt() / d
    along = max(Decimal(0), (p - height) * (p + height)).sqrt() * (1 if d * d + p * p >= q * q else -1)
    return left_first(beside(c, times(1 / d, v), along, height), c, other)


def common_tangents(cx1, cy1, r1, cx2, cy2, r2):
    """By the point where two tangents meet: the middle of their chord is its inverse."""
    c, other, (p, q) = vec(cx1, cy1), vec(cx2, cy2), vec(r1, r2)
    v = minus(other, c)
    d, e = norm(v), max(p, q, reach(v))
    found = []
    for signed in (-q, q):
        total = p + signed
        if abs(d - abs(total)) <= SNAP * e:
            found.append(plus(c, v, (p if total > 0 else -p) / d))
        elif d > abs(total):
            along = p * p / (p / total * d) if total else Decimal(0)
            half = (p * p - along * along).sqrt()
            found += left_first(beside(c, times(1 / d, v), along, half), c, other)
    return found


LENGTHS = {
    "tangents": (tangent_points, {0, 1, 2}),
    "circle-circle": (circle_circle, {0, 1, 2, None}),
    "common-tangents": (common_tangents, {0, 1, 2, 3, 4}),
}


@pytest.mark.parametrize("name", LENGTHS)
def test_the_points_are_those_of_another_formula(name):
    formula, lengths = LENGTHS[name]
    found = answers(name, formula, cases_of(name))
    assert {None if answer is None else len(answer) for answer in found} == lengths


# -- where a circle is hit: O − C across the ray, and half the chord along it -------------------------------


def first_hit(cx, cy, r, origin, direction):
    """(P − C, D as a unit, -1 entering, 0 touching or 1 leaving) of the first point, or None."""
    f, d, r = minus(vec(*origin), vec(cx, cy)), vec(*direction), Decimal(r)
    if r == 0 or d == (0, 0):
        return None
    e, u = max(r, reach(f)), times(1 / norm(d), d)
    across = cross(u, f)
    foot = (-across * u[1], across * u[0])
    if abs(abs(across) - r) <= SNAP * e:
        ways = [(Decimal(0), 0)]
    elif abs(across) > r:
        ways = []
    else:
        half = ((r - across) * (r + across)).sqrt()
        ways = [(-half, -1), (half, 1)]
    for way, how in ways:
        if way - dot(f, u) >= -SNAP * e:
            return plus(foot, u, way), u, how
    return None


def hit_normal(*case):
    """By the direction of P − C, whatever its length is."""
    hit = first_hit(*case)
    if hit is None:
        return None
    point, u, how = hit
    side = -1 if how > 0 else 1
    assert how == 0 or side * dot(point, u) < 0, "it faces the ray"
    return times(side / norm(point), point)


def reflect(cx, cy, r, origin, direction):
    """By the mirror image of O − P, as far from the line through C and P as O is, on its other side."""
    hit = first_hit(cx, cy, r, origin, direction)
    if hit is None:
        return None
    point, _, how = hit
    d, at = vec(*direction), plus(point, vec(cx, cy))
    if how == 0:
        return at, d
    # The line through C and P holds the foot of −D; what is reflected is as far beyond it.
    foot = dot(point, d) / dot(point, point)
    return at, plus(plus(d, point, -foot), point, -foot)


def boundary_hits(cx, cy, r, corners):
    """By the distance of C along an edge: it crosses where that passes r, or dips below it in between."""
    seen = [minus(vec(*corner), vec(cx, cy)) for corner in corners]
    r, e = Decimal(r), max(Decimal(r), reach(*seen))
    slack, found = SNAP * e, []
    for edge, start in enumerate(seen):
        way = minus(seen[edge + 1 - len(seen)], start)
        long = norm(way)
        u = times(1 / long, way)
        nearest = -dot(start, u)
        low = norm(plus(start, u, nearest))
        steps = [Decimal(0)] if abs(low - r) <= slack else []
        if low < r - slack:
            half = ((r - low) * (r + low)).sqrt()
            steps = [-half, half]
        found += [
            (edge, plus(plus(start, u, nearest + step), vec(cx, cy)))
            for step in steps
            if -slack <= nearest + step and nearest + step < long - slack
        ]
    return found


def ray_sphere(centre, radius, origin, way):
    """By the foot itself and the angle of the point about the centre; the side by the sign of N·D."""
    c, o, d, r = vec(*centre), vec(*origin), vec(*way), Decimal(radius)
    if not any(d) or not r:
        return None
    f = minus(o, c)
    e, u = max(r, reach(f)), times(1 / norm(d), d)
    foot = plus(f, u, -dot(f, u))
    if abs(norm(foot) - r) <= SNAP * e:
        points = [foot]
    elif norm(foot) > r:
        return None
    else:
        cosine = norm(foot) / r
        sine = (1 - cosine * cosine).sqrt()
        points = [plus(foot, u, side * r * sine) for side in (-1, 1)]
    for point in points:
        t = dot(minus(point, f), d) / dot(d, d)
        snapped = abs(t) * reach(d) <= SNAP * e
        if t < 0 and not snapped:
            continue
        outward = times(1 / norm(point), point)
        leaves = len(points) == 2 and dot(outward, d) > 0
        return (Decimal(0) if snapped else t), (times(-1, outward) if leaves else outward)
    return None


def steady_hits(circles, origin, way, share):
    """By the foot on the line; what was shown last is looked for backwards from each frame."""
    o, d, h = vec(*origin), vec(*way), Decimal(share)
    said = []
    for x, y, radius in circles:
        f, r = minus(o, vec(x, y)), Decimal(radius)
        distance, room = norm(plus(f, d, -dot(f, d) / dot(d, d))), SNAP * max(r, reach(f))
        if not said:
            said.append(int(distance < r))
        else:
            below, above = distance < r * (1 - h) - room, distance > r * (1 + h) + room
            said.append(1 if below else 0 if above else None)
    return [next(word for word in said[at::-1] if word is not None) for at in range(len(said))]


HITS = {
    "normal": hit_normal,
    "reflect": reflect,
    "polygon": boundary_hits,
    "sphere": ray_sphere,
    "silhouette": steady_hits,
}


@pytest.mark.parametrize("name", daily(HITS, ["normal", "polygon", "sphere"]))
def test_the_hits_are_those_of_another_formula(name):
    found = list(answers(name, HITS[name], cases_of(name)))
    assert len(set(map(str, found))) >= 90
    assert (None in found) == (name in ("normal", "reflect", "sphere"))


def test_a_tiny_circle_is_against_the_promise():
    solve = solver("normal")
    x, y = solve(0, 0, 5, (-10, 3), (1, 0))
    assert (x.x, y.x) == (Surd(-4, 0, 0, 5), Surd(3, 0, 0, 5))
    assert broken_promise("normal", 0, 0, 1e-5, (1, 0), (-1, 0))


def test_what_a_polygon_promises_is_held_against_every_edge():
    assert "An edge is 0·e" in broken_promise("polygon", 0, 0, 1, ((3, 3), (0, 0), (0.0, 0)))
    short = ((0, 0), (1e-23, 0), (3, 0))
    assert "It must be at least 1e-9·e" in broken_promise("polygon", 46, -11, 725, short)
    assert broken_promise("polygon", 0, 0, 1, ((0, 0), (1e-5, 0), (3, 3))) is None
    nearly = ((1.00000001, 0.0), (2.0, 0.5), (2.0, -0.5))
    assert "A corner is almost on the circle" in broken_promise("polygon", 0.0, 0.0, 1.0, nearly)
    # The last edge's line touches beyond the corner, the second's nearly does.
    assert broken_promise("polygon", 0, 0, 1, ((1, 1), (3, 3), (1, 3))) is None
    touching = ((1, 1), (1.0000001, 3), (-4, 3))
    assert "An edge is almost a tangent" in broken_promise("polygon", 0, 0, 1, touching)


def test_a_corner_is_met_once_whichever_edges_find_it():
    solve = solver("polygon")
    for corners, edges in (
        (((3, 4), (9, 4), (9, 9)), [0]),
        (((9, 9), (3, 4), (9, 4)), [1]),
        (((9, 4), (9, 9), (3, 4)), [2]),
        (((0, 0), (3, 4), (6, 8), (9, 0)), [1, 3]),
        (((3, 4), (-3, 4), (0, 9)), [0, 1]),
    ):
        assert [edge for edge, _ in solve(0, 0, 5, corners)] == edges
