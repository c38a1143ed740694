"""CircleLine against plain rational algebra and flint, Bands on the very edges of the bands."""

from __future__ import annotations

import math
import random
from fractions import Fraction

import flint
import pytest

from judge.exact import Surd, integers
from judge.topics.circles.bands import Bands
from judge.topics.circles.line import CircleLine

SNAP, CLEAR = Fraction(1, 10**12), Fraction(1, 10**7)
BANDS = Bands(SNAP, CLEAR)


def random_number(source: random.Random):
    kind = source.randrange(4)
    if kind == 0:
        return source.randint(-3, 3)
    if kind == 1:
        return source.randint(-(10**9), 10**9)
    if kind == 2:
        return source.uniform(-1e9, 1e9)
    return math.ldexp(source.randint(-1000, 1000), source.randint(-60, 30))


def random_case(source: random.Random):
    cx, cy, r, ax, ay, bx, by = (random_number(source) for _ in range(7))
    return cx, cy, abs(r), (ax, ay), (bx, by)


def quadratic(cx, cy, r, start, direction):
    """a, b, c of a·t² + 2b·t + c = 0 in Fractions: the other form of the discriminant."""
    dx, dy = map(Fraction, direction)
    fx, fy = Fraction(start[0]) - Fraction(cx), Fraction(start[1]) - Fraction(cy)
    return dx * dx + dy * dy, fx * dx + fy * dy, fx * fx + fy * fy - Fraction(r) ** 2


def test_count_and_points_satisfy_both_equations():
    source = random.Random(1)
    hits = 0
    for _ in range(1500):
        cx, cy, r, start, end = case = random_case(source)
        line = CircleLine.through(*case)
        direction = Fraction(end[0]) - Fraction(start[0]), Fraction(end[1]) - Fraction(start[1])
        a, b, c = quadratic(cx, cy, r, start, direction)
        if a == 0:
            assert line.degenerate
            assert line.count() is None
            assert line.point(0) == (Surd.of(start[0]), Surd.of(start[1]))
            continue
        other = b * b - a * c
        assert line.count() == (1 if other == 0 else 2 if other > 0 else 0)
        assert line.root(0) == -b / a
        if other < 0:
            with pytest.raises(ValueError, match="misses"):
                line.root(1)
            continue
        hits += 1
        assert line.root(-1) <= line.root(0) <= line.root(1)
        for which in (-1, 1):
            check_root(line.root(which), line.point(which), start, direction, (a, b, c))
    assert hits > 300


def check_root(t, point, start, direction, coefficients):
    """a·t² + 2b·t + c = 0 and P = A + t·D hold in the field Q(√d), coefficient by coefficient."""
    a, b, c = coefficients
    u, v = Fraction(t.p, t.s), Fraction(t.q, t.s)
    assert a * (u * u + v * v * t.d) + 2 * b * u + c == 0
    assert 2 * a * u * v + 2 * b * v == 0
    for coordinate, origin, step in zip(point, start, direction, strict=True):
        assert coordinate == t * step + Fraction(origin)


def test_scaling_by_a_power_of_two_changes_nothing_else():
    source = random.Random(3)
    for _ in range(200):
        cx, cy, r, ax, ay, bx, by = (source.randint(-1000, 1000) for _ in range(7))
        case = (cx, cy, abs(r), (ax, ay), (bx, by))
        scale = 2.0 ** source.randint(-900, 900)
        small = (cx * scale, cy * scale, abs(r) * scale, (ax * scale, ay * scale), (bx * scale, by * scale))
        one, two = CircleLine.through(*case), CircleLine.through(*small)
        assert one.count() == two.count()
        assert BANDS.segment(one) == BANDS.segment(two)
        if one.count() == 2:
            assert one.root(1) == two.root(1)
            assert one.point(1)[0] * Fraction(scale) == two.point(1)[0]
        assert one.extent_length() * Fraction(scale) == two.extent_length()


def test_integers_share_one_power_of_two():
    assert integers(3, -4) == ([3, -4], 0)
    assert integers(0.5, 3, 0.125) == ([4, 24, 1], 3)
    assert integers(2.0**60, 1) == ([2**60, 1], 0)
    values, shift = integers(5e-324, 1)
    assert (values, shift) == ([1, 2**1074], 1074)
    for bad in (math.nan, math.inf):
        with pytest.raises(ValueError, match="finite"):
            integers(1, bad)
    for bad in (True, "1", Fraction(1, 2), None):
        with pytest.raises(TypeError):
            integers(1.5, bad)


def test_unusual_input_is_refused():
    with pytest.raises(ValueError, match="radius"):
        CircleLine.through(0, 0, -1, (0, 0), (1, 1))
    with pytest.raises(ValueError, match="which"):
        CircleLine.through(0, 0, 1, (0, 0), (1, 1)).root(2)
    with pytest.raises(ValueError, match="snap"):
        Bands(CLEAR, SNAP)


# -- on the very edge: circles on the x axis give rational distances -------------------------------------


RADIUS = 2**50


def level(position: Fraction, height: Fraction, width: int) -> CircleLine:
    """A level line from a dyadic place to the right; a circle about the origin, its radius the extent."""
    scale = max(position.denominator, height.denominator)
    r, ax, ay, dx = (int(each * scale) for each in (RADIUS, position, height, width))
    a, k = dx * dx, dx * ay
    return CircleLine(0, 0, r, ax, ay, dx, 0, scale.bit_length() - 1, r, a, ax * dx, k, r * r * a - k * k)


STEP = Fraction(1, 2**80)


@pytest.mark.parametrize("side", [1, -1])
def test_tangency_band_is_closed_and_ends_exactly(side):
    bands = Bands(Fraction(1, 2**40), Fraction(1, 2**23))
    snap, clear = bands.snap * RADIUS, bands.clear * RADIUS
    expected_outside = 0 if side > 0 else 2
    cases = [
        (Fraction(0), 1, False),
        (snap - STEP, 1, False),
        (snap, 1, False),
        (snap + STEP, expected_outside, True),
        (clear - STEP, expected_outside, True),
        (clear, expected_outside, False),
        (clear + STEP, expected_outside, False),
    ]
    for distance, count, broken in cases:
        line = level(Fraction(-1), RADIUS + side * distance, 2)
        assert bands.count(line) == count, distance
        assert (bands.broken_count(line) is not None) == broken, distance


def test_ends_band_is_closed_and_ends_exactly():
    bands = Bands(Fraction(1, 2**40), Fraction(1, 2**23))
    snap, clear = bands.snap * RADIUS, bands.clear * RADIUS
    for beyond, on, broken in [
        (-clear - STEP, True, False),
        (-clear, True, False),
        (-clear + STEP, True, True),
        (-snap - STEP, True, True),
        (-snap, True, False),
        (Fraction(0), True, False),
        (snap, True, False),
        (snap + STEP, False, True),
        (clear - STEP, False, True),
        (clear, False, False),
    ]:
        # The root x = RADIUS lies `beyond` before the start …
        line = level(RADIUS + beyond, Fraction(0), 2 * RADIUS)
        assert (1 in bands.segment(line)) == on, beyond
        assert (bands.broken_segment(line) is not None) == broken, beyond
        # … and so for a ray, where a root at the origin is exactly t = 0.
        near = abs(beyond) <= snap
        assert bands.end(line, 1) == (0 if near else None)
        assert bands.ray(line) == (Surd(0) if near else line.root(1) if on else None)
        assert (bands.broken_ray(line) is not None) == broken
        # The root x = −RADIUS lies `beyond` after the end.
        line = level(-3 * RADIUS - beyond, Fraction(0), 2 * RADIUS)
        assert (-1 in bands.segment(line)) == on, beyond
        assert bands.end(line, -1) == (1 if near else None)
        assert (bands.broken_segment(line) is not None) == broken, beyond


def test_ends_band_with_irrational_roots_agrees_with_a_high_precision_float():
    source = random.Random(5)
    seen = set()
    flint.ctx.prec = 400
    for _ in range(400):
        dx, dy = source.randint(-50, 50), source.randint(1, 50)
        r = source.randint(5, 99)
        line0 = CircleLine.ray(0, 0, r, (source.randint(-4, 4), 0), (dx, dy))
        root = line0.root(1)
        slack = source.choice((0.5, 0.99, 1.01, 2.0, 5e4, 9e4, 1.1e5)) * source.choice((-1, 1))
        # Move the origin along the line to just before or after that root, as doubles.
        t = root + Fraction(slack) * SNAP * r / Fraction(math.hypot(dx, dy))
        origin = (float(t * dx + line0.ax), float(t * dy))
        line = CircleLine.ray(0, 0, r, origin, (dx, dy))
        if BANDS.count(line) != 2:
            continue
        t = line.root(1)
        away = (flint.arb(t.p) + t.q * flint.arb(t.d).sqrt()) / t.s * flint.arb(line.a).sqrt()
        snapped = abs(away) <= flint.arb(line.extent) / 10**12
        broken = not snapped and bool(abs(away) < flint.arb(line.extent) / 10**7)
        seen.add((bool(snapped), broken))
        assert (BANDS.ray(line) == 0) == bool(snapped)
        assert (BANDS.broken_ray(line) is not None) == broken
    assert seen == {(True, False), (False, True), (False, False)}


def test_a_pythagorean_line_meets_the_edge_exactly():
    """The line 4x = 3y through the origin lies at the rational distance 4x/5 from (x, 0)."""
    bands = Bands(Fraction(1, 5), Fraction(2, 5))
    on_edge = set()
    for x in range(60):
        line = CircleLine.through(x, 0, 10, (0, 0), (3, 4))
        extent = line.extent
        away = abs(Fraction(4 * x, 5) - 10)
        assert bands.count(line) == (1 if 5 * away <= extent else 2 if 4 * x < 50 else 0)
        assert (bands.broken_count(line) is not None) == (extent < 5 * away < 2 * extent)
        on_edge |= {width for width in (1, 2) if 5 * away == width * extent}
    assert on_edge == {1, 2}


@pytest.mark.parametrize("r", [0, 1, 2.5])
def test_degenerate_segment_is_its_point(r):
    on = CircleLine.through(1, 2, r, (1 + r, 2), (1 + r, 2))
    assert BANDS.segment(on) == (0,)
    assert on.point(0) == (Surd.of(1 + r), Surd(2))
    assert BANDS.count(on) is None
    assert BANDS.broken_segment(on) is None
    off = CircleLine.through(1, 2, r, (7, 2), (7, 2))
    assert BANDS.segment(off) == ()
    assert BANDS.broken_segment(off) is None
    near = CircleLine.through(0, 0, 1, (1 + 1e-9, 0), (1 + 1e-9, 0))
    assert BANDS.segment(near) == ()
    assert "forbidden band" in BANDS.broken_segment(near)
    inside = CircleLine.through(0, 0, 1, (1 - 5e-13, 0), (1 - 5e-13, 0))
    assert BANDS.segment(inside) == (0,)


def test_a_circle_of_radius_zero_is_a_point():
    through = CircleLine.through(1, 1, 0, (0, 0), (2, 2))
    assert BANDS.count(through) == 1
    assert BANDS.segment(through) == (0,)
    assert through.point(0) == (1, 1)
    beside = CircleLine.through(1, 1, 0, (0, 0), (2, 3))
    assert BANDS.count(beside) == 0
    assert BANDS.segment(beside) == ()
    beyond = CircleLine.through(3, 3, 0, (0, 0), (2, 2))
    assert (BANDS.count(beyond), BANDS.segment(beyond)) == (1, ())


@pytest.mark.parametrize(
    ("r", "origin", "direction", "t"),
    [
        (5, (-13, 0), (2, 0), 4),
        (5, (0, 0), (2, 0), Fraction(5, 2)),
        (5, (3, 4), (1, 0), 0),
        (5, (-3, 4), (1, 0), 0),
        (5, (7, 0), (1, 0), None),
        (5, (-7, 5), (1, 0), 7),
        (5, (7, 5), (1, 0), None),
        (5, (0, 5), (1, 0), 0),
        (5, (0, 6), (1, 0), None),
        (5, (0, 0), (0, 0), None),
        (0, (0, 0), (1, 0), 0),
        # A root a hair behind the origin is at the origin, and is the nearest.
        (1, (math.nextafter(-1, 2), 0), (1, 0), 0),
        (1, (math.nextafter(1, 2), 0), (1, 0), 0),
    ],
)
def test_rays(r, origin, direction, t):
    assert BANDS.ray(CircleLine.ray(0, 0, r, origin, direction)) == t


def test_extents():
    line = CircleLine.through(1, 0.5, 2, (4, 0), (1, -9.25))
    assert line.extent_length() == Fraction(39, 4)
    for start, end, extent in (
        ((1, 2), (3, 4), 5),
        ((-7, 2), (3, 4), 8),
        ((1, 12), (3, 4), 11),
        ((1, 2), (-8, 4), 9),
    ):
        assert CircleLine.through(1, 1, 5, start, end).extent_length() == extent
    for origin, extent in (((1, 2), 5), ((8, 2), 7)):
        assert CircleLine.ray(1, 1, 5, origin, (30, 40)).extent_length() == extent
    for way, extent in (((3, 1), Surd(0, 7, 10, 20)), ((3, 4), Fraction(7, 10)), ((0, 0), 0)):
        assert CircleLine.ray(1, 1, 2, (4.5, 0), way).extent_parameter() == extent


def test_bands_agree_with_the_definition_at_random():
    """Widths so large that every branch is met, against distances in 60-digit arithmetic."""
    source = random.Random(9)
    bands = Bands(Fraction(1, 10), Fraction(3, 10))
    flint.ctx.prec = 300
    for _ in range(1500):
        numbers = [source.randint(-12, 12) for _ in range(7)]
        line = CircleLine.through(*numbers[:2], abs(numbers[2]), tuple(numbers[3:5]), tuple(numbers[5:]))
        if line.degenerate:
            continue
        e, length = flint.arb(line.extent), flint.arb(line.a).sqrt()
        away = abs(flint.arb(abs(line.k)) / length - line.r)
        if (away * 10).overlaps(e) or (away * 10).overlaps(3 * e):
            continue  # an exact edge, which has its own test
        touches = bool(away * 10 < e)
        assert bands.count(line) == (1 if touches else line.count())
        assert (bands.broken_count(line) is not None) == (not touches and bool(away * 10 < 3 * e))
        roots = [0] if touches else [-1, 1] if line.delta > 0 else []
        wanted = []
        for which in roots:
            t = line.root(which)
            at = (flint.arb(t.p) + t.q * flint.arb(t.d).sqrt()) / t.s * length
            if at > -e / 10 and at < length + e / 10:
                wanted.append(which)
            elif (at * 10).overlaps(-e) or ((at - length) * 10).overlaps(e):
                wanted.append(which)  # touches the closed band's edge exactly
        assert list(bands.segment(line)) == wanted, numbers
