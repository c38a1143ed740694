"""CircleLine against plain rational algebra, Bands on the very edges of the bands."""

from __future__ import annotations

import math
import random
from fractions import Fraction

import pytest

from judge.exact import Surd, integers
from judge.topics.circles.bands import Bands
from judge.topics.circles.line import CircleLine

BANDS = Bands(Fraction(1, 5), Fraction(2, 5))


def random_number(source: random.Random):
    return source.choice(
        (source.randint(-3, 3), source.uniform(-1e9, 1e9), math.ldexp(source.randint(-99, 99), -50))
    )


def test_count_and_points_satisfy_both_equations():
    """The other form of the discriminant, and a·t² + 2b·t + c = 0 in Q(√d), coefficient by coefficient."""
    source, counts = random.Random(1), {None: 0, 0: 0, 1: 0, 2: 0}
    for _ in range(600):
        cx, cy, r, *ends = (random_number(source) for _ in range(7))
        line = CircleLine.through(cx, cy, abs(r), tuple(ends[:2]), tuple(ends[2:]))
        cx, cy, r, ax, ay, bx, by = map(Fraction, (cx, cy, r, *ends))
        dx, dy, fx, fy = bx - ax, by - ay, ax - cx, ay - cy
        a, b, c = dx * dx + dy * dy, fx * dx + fy * dy, fx * fx + fy * fy - r * r
        other = b * b - a * c
        assert line.count() == (None if a == 0 else 1 if other == 0 else 2 if other > 0 else 0)
        counts[line.count()] += 1
        for which in (-1, 1) if line.count() else ():
            t, point = line.root(which), line.point(which)
            u, v = Fraction(t.p, t.s), Fraction(t.q, t.s)
            assert a * (u * u + v * v * t.d) + 2 * b * u + c == 0
            assert 2 * a * u * v + 2 * b * v == 0
            assert point == (t * dx + ax, t * dy + ay)
    assert counts[0] > 50
    assert counts[2] > 50


def test_integers_share_one_power_of_two():
    assert integers(0.5, 3, 0.125) == ([4, 24, 1], 3)
    assert integers(5e-324, 1) == ([1, 2**1074], 1074)
    for bad in (math.nan, math.inf, True, "1", Fraction(1, 2), None):
        with pytest.raises((ValueError, TypeError)):
            integers(1.5, bad)


def test_the_bands_of_a_line_are_closed_and_end_exactly():
    """The line 4x = 3y through the origin lies at the rational distance 4x/5 from (x, 0)."""
    on_edge = set()
    for x in range(60):
        line = CircleLine.through(x, 0, 10, (0, 0), (3, 4))
        away = abs(Fraction(4 * x, 5) - 10)
        assert BANDS.count(line) == (1 if 5 * away <= line.extent else 2 if 4 * x < 50 else 0)
        assert (BANDS.broken_count(line) is not None) == (line.extent < 5 * away < 2 * line.extent)
        on_edge |= {width for width in (1, 2) if 5 * away == width * line.extent}
    assert on_edge == {1, 2}


@pytest.mark.parametrize(
    ("start", "on", "broken", "t"),
    [
        *((2, 1, 0, None), (3, 1, 0, None), (3.5, 1, 1, None), (4, 1, 0, 0), (5, 1, 0, 0), (6, 1, 0, 0)),
        *((6.5, 0, 1, None), (7, 0, 0, None), (8, 0, 0, None)),
    ],
)
def test_the_bands_of_an_end_are_closed_and_end_exactly(start, on, broken, t):
    """The extent is 5: the root x = 5 is at the start from 4 to 6, and no case has it up to 1 farther."""
    line = CircleLine.ray(0, 0, 5, (start, 0), (9, 0))
    bands = Bands(Fraction(1) / max(5, Fraction(start)), Fraction(2) / max(5, Fraction(start)))
    assert (bands.ray(line) is not None) == bool(on)
    assert (bands.broken_ray(line) is not None) == bool(broken)
    assert bands.end(line, 1) == t


def test_a_point_for_a_segment_and_for_a_circle():
    assert BANDS.segment(CircleLine.through(1, 2, 2.5, (3.5, 2), (3.5, 2))) == (0,)
    assert BANDS.segment(CircleLine.through(1, 2, 2.5, (70, 2), (70, 2))) == ()
    through = CircleLine.through(1, 1, 0, (0, 0), (2, 2))
    assert (through.count(), through.point(0)) == (1, (Surd(1), Surd(1)))
    assert CircleLine.through(1, 1, 0, (0, 0), (2, 3)).count() == 0
