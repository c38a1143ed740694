"""Scenes of equations: the discriminant is what they say, and a double holds every number."""

from __future__ import annotations

from fractions import Fraction

import pytest

from judge.data.draw import Draw, seeded
from judge.geometry.scenes import equations, tried
from judge.geometry.whole import enclosure


def drawn(scene, count=80):
    """What the scene draws from that many seeds."""
    drawn_once = tried(scene, tries=400)
    found = [drawn_once(Draw(seeded(f"equations/{seed}"))) for seed in range(count)]
    assert all(int(float(x)) == x for case in found for x in case if isinstance(x, int))
    return [tuple(map(Fraction, case)) for case in found]


def deltas(scene):
    """b² − a·c as a part of b²."""
    return [(b * b - a * c) / (b * b) for a, b, c in drawn(scene)]


def test_double_roots_and_nearly_double_ones():
    assert set(deltas_or_zero(equations.double(30))) == {0}
    near = deltas(equations.near_double(8, 25))
    assert {delta > 0 for delta in near} == {True, False}
    assert min(map(abs, near)) < Fraction(1, 10**28)
    assert all(0 < delta < Fraction(1, 10**31) for delta in deltas(equations.finest()))


def deltas_or_zero(scene):
    return [b * b - a * c for a, b, c in drawn(scene)]


def test_roots_that_cancel():
    parts = [abs(a * c) / (b * b) for a, b, c in drawn(equations.cancellation(24, 52))]
    assert all(part < Fraction(1, 2**20) for part in parts)


@pytest.mark.parametrize(
    ("scene", "place"), [(equations.b_zero(60), 1), (equations.c_zero(99), 2), (equations.linear(99), 0)]
)
def test_a_number_that_is_zero(scene, place):
    assert {case[place] for case in drawn(scene)} == {0}


def test_numbers_beyond_the_squares_of_doubles():
    for scene in (equations.wide((-596, 560), equations.double(99)), equations.uneven(-590, 590, 9999)):
        sizes = [abs(x) for case in drawn(scene) for x in case if x]
        assert max(sizes) > 2**500
        assert min(sizes) < Fraction(1, 2**500)
        assert max(sizes) <= 2**604


def test_an_interval_beyond_the_doubles_is_wrong_and_no_fault():
    judged = enclosure(Fraction(3), Fraction(1))
    for end in (10**400, 1e308):
        assert judged.why_not((-end, end), "") == "it is inf wide, 1 is allowed"
