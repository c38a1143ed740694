"""The ray recipes build what they say: held against plain fractions."""

from __future__ import annotations

from fractions import Fraction

import pytest

from judge.data.draw import Rejected, SeededDraw
from judge.errors import ProblemError
from judge.topics.circles.recipes import rays
from judge.topics.circles.signature import flat

EXACT = ["axis", "exact"]


def made(recipe, count=60, **parameters):
    """Cases of a recipe, those it rejects left out."""
    cases = []
    for number in range(count):
        try:
            cases.append(flat(recipe(SeededDraw(f"rays/{number}"), **parameters)))
        except Rejected:
            continue
    assert len(cases) >= count // 4
    return cases


def terms(case):
    """a, b, c, Δ' of the quadratic in t, in fractions."""
    cx, cy, r, (ox, oy), (dx, dy) = case
    fx, fy = Fraction(ox) - Fraction(cx), Fraction(oy) - Fraction(cy)
    dx, dy = Fraction(dx), Fraction(dy)
    a, b, c = dx * dx + dy * dy, fx * dx + fy * dy, fx * fx + fy * fy - Fraction(r) ** 2
    return a, b, c, b * b - a * c


def roots_ahead(case):
    """How many roots are at t > 0 and how many at t = 0, without bands."""
    a, b, c, delta = terms(case)
    if a == 0 or delta < 0:
        return 0, 0
    if delta == 0:
        return int(b < 0), int(b == 0)
    if c == 0:
        return int(b < 0), 1
    return (1, 0) if c < 0 else (2 * int(b < 0), 0)


@pytest.mark.parametrize(
    ("where", "wanted"),
    [("ahead", (2, 0)), ("inside", (1, 0)), ("from-foot", (1, 0)), ("behind", (0, 0)), ("beside", (0, 0))],
)
def test_across_has_its_roots_where_its_place_says(where, wanted):
    cases = made(rays.across, where=[where], size=30, poses=["axis", "exact", "any"])
    assert {roots_ahead(case) for case in cases} == {wanted}


def test_the_foot_is_where_a_from_foot_ray_starts():
    assert {terms(case)[1] for case in made(rays.across, where=["from-foot"], size=30, poses=EXACT)} == {0}


def test_a_stretch_changes_nothing_but_the_direction():
    plain = made(rays.across, where=["ahead"], size=30, poses=EXACT)
    stretched = made(rays.across, where=["ahead"], size=30, poses=EXACT, stretch=[-10, 10])
    factors = set()
    for one, other in zip(plain, stretched, strict=True):
        assert one[:4] == other[:4]
        factors |= {Fraction(new) / Fraction(old) for old, new in zip(one[4], other[4], strict=True) if old}
    assert len(factors) > 10
    assert max(factors) <= 2**10
    assert min(factors) >= Fraction(1, 2**10)


@pytest.mark.parametrize(("where", "wanted"), [("ahead", (1, 0)), ("behind", (0, 0)), ("at-origin", (0, 1))])
def test_tangents_are_exact_and_their_contact_is_in_its_place(where, wanted):
    cases = made(rays.tangent, where=[where], size=30, poses=EXACT)
    assert {terms(case)[3] for case in cases} == {0}
    assert {roots_ahead(case) for case in cases} == {wanted}


@pytest.mark.parametrize(("side", "wanted"), [("hit", (2, 0)), ("miss", (0, 0))])
@pytest.mark.parametrize("within", [False, True])
def test_near_tangents_are_on_their_side(side, wanted, within):
    cases = made(rays.near_tangent, sides=[side], within=within, bits=4, size=1000)
    assert {roots_ahead(case) for case in cases} == {wanted}


@pytest.mark.parametrize(("where", "wanted"), [("in", (1, 1)), ("out", (0, 1))])
def test_the_origin_is_on_the_circle(where, wanted):
    cases = made(rays.origin_on_circle, where=[where], size=60, poses=EXACT)
    assert {terms(case)[2] for case in cases} == {0}
    assert {roots_ahead(case) for case in cases} == {wanted}


@pytest.mark.parametrize(("where", "wanted"), [("past", (0, 0)), ("inside", (1, 0))])
@pytest.mark.parametrize("within", [False, True])
def test_the_origin_is_just_off_the_circle(where, wanted, within):
    cases = made(rays.origin_near_circle, where=[where], within=within, bits=4, size=500)
    assert {roots_ahead(case) for case in cases} == {wanted}
    for case in cases:
        _, _, c, _ = terms(case)
        away = abs(float(c)) / 2 / float(case[2]) ** 2  # ||f| − r| / r, by the first order
        assert (1e-14 < away < 1e-12) if within else (1e-8 < away < 1e-5)


def test_a_null_direction_is_null_wherever_the_origin_is():
    places = ["on", "inside", "outside", "point"]
    signs = {}
    for where in places:
        cases = made(rays.null_direction, where=[where], size=30, poses=EXACT)
        assert {case[4] for case in cases} == {(0, 0)}
        signs[where] = {(c > 0) - (c < 0) for c in (terms(case)[2] for case in cases)}
    assert signs == {"on": {0}, "inside": {-1}, "outside": {1}, "point": {0}}


@pytest.mark.parametrize(
    ("where", "wanted"), [("ahead", (1, 0)), ("behind", (0, 0)), ("off", (0, 0)), ("at-origin", (0, 1))]
)
def test_a_circle_may_be_a_point(where, wanted):
    cases = made(rays.point_circle, where=[where], size=30, poses=EXACT)
    assert {case[2] for case in cases} == {0}
    assert {roots_ahead(case) for case in cases} == {wanted}


@pytest.mark.parametrize(("where", "wanted"), [("through", (2, 0)), ("beside", (0, 0))])
def test_a_far_circle_is_far_ahead(where, wanted):
    cases = made(rays.far_circle, where=[where], size=100, ratio=[10**6, 10**6], poses=["any"])
    assert {roots_ahead(case) for case in cases} == {wanted}


def test_a_lopsided_ray_starts_far_away_along_an_axis():
    places = set()
    for cx, cy, r, (ox, oy), direction in made(rays.lopsided, size=50, ratio=[20000, 40000]):
        fx, fy = Fraction(ox) - Fraction(cx), Fraction(oy) - Fraction(cy)
        far, near = (fx, fy) if abs(fx) > abs(fy) else (fy, fx)
        assert abs(far) >= 20000 * abs(near)
        assert Fraction(9, 10**14) < abs(abs(near) - Fraction(r)) / abs(far) < Fraction(4, 10**13)
        assert fx * Fraction(direction[0]) + fy * Fraction(direction[1]) < 0
        places.add((far == fx, far > 0))
    assert len(places) == 4


def test_a_tangent_off_the_grid_touches_where_no_double_is():
    rounded = 0
    for cx, cy, r, origin, direction in made(rays.tangent_off_the_grid, size=600, scale=-6, far=27):
        fx, fy = Fraction(origin[0]) - Fraction(cx), Fraction(origin[1]) - Fraction(cy)
        dx, dy = map(Fraction, direction)
        a, b = dx * dx + dy * dy, fx * dx + fy * dy
        assert b < 0
        assert (dx * fy - dy * fx) ** 2 == Fraction(r) ** 2 * a
        foot = Fraction(origin[0]) - b / a * dx
        assert abs(foot) > 2**25
        rounded += Fraction(float(foot)) != foot
    assert rounded > 10


def test_a_scaled_cancellation_is_the_same_figure():
    (plain,) = (made(rays.cancellation, size=1000, numbers="float", count=200)[:1],)
    (small,) = (made(rays.cancellation, size=1000, numbers="float", scale=-30, count=200)[:1],)
    assert [value * 2.0**-30 for value in plain[0][:3]] == list(small[0][:3])


def test_cancellation_has_a_power_that_is_tiny_and_a_chord_that_is_long():
    cases = made(rays.cancellation, size=1000, numbers="int", count=200)
    sides = set()
    for case in cases:
        a, b, c, delta = terms(case)
        assert 0 < abs(c) <= 2 * case[2] + 1
        assert 2 * delta >= a * case[2] ** 2
        assert (b < 0) == (c > 0)
        sides.add(c > 0)
    assert sides == {True, False}


def test_the_conditioning_is_that_of_the_nearer_root_ahead():
    assert rays.well_conditioned(1, 0, -2)
    assert not rays.well_conditioned(1, 0, -1.000001)
    assert rays.well_conditioned(1, 0, -0.999999)  # its root ahead is the far one
    assert not rays.well_conditioned(1, 0, 0.999999)
    assert rays.well_conditioned(1, 0, 1.000001)  # nothing ahead
    assert rays.well_conditioned(1, 1, -1e-9)  # a tangency is its foot
    assert not rays.well_conditioned(1, 1 - 1e-12, -1)


def test_the_grid_and_the_uniform_box_keep_their_size():
    cases = made(rays.grid, size=3, count=300)
    assert {value for case in cases for value in (*case[:2], *case[3], *case[4])} == set(range(-3, 4))
    assert {roots_ahead(case) for case in cases} >= {(0, 0), (0, 1), (1, 0), (1, 1), (2, 0)}
    boxed = made(rays.uniform, size=2**30, numbers="mixed")
    assert {type(value) for case in boxed for value in case[:3]} == {int, float}


def test_an_unknown_place_is_a_fault_of_the_problem():
    with pytest.raises(ProblemError, match="'nowhere' is a place"):
        rays.across(SeededDraw("x"), where=["nowhere"], size=9, poses=EXACT)


@pytest.mark.parametrize(("where", "wanted"), [("miss", (0, 0)), ("past", (0, 0)), ("inside", (1, 0))])
def test_a_small_circle_far_away_is_nearly_met_exactly(where, wanted):
    cases = made(rays.near_far_away, where=[where], distance=27)
    assert {roots_ahead(case) for case in cases} == {wanted}
    assert all(min(map(abs, case[:2])) >= 2**26 and case[2] <= 1 for case in cases)
