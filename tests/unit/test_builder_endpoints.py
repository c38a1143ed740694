"""The segment recipes build what they say: held against a plain count in fractions."""

from __future__ import annotations

from fractions import Fraction

import pytest

from judge.data.draw import Rejected, SeededDraw
from judge.errors import ProblemError
from judge.topics.circles.recipes import endpoints
from judge.topics.circles.signature import flat

EXACT = ["axis", "exact"]


def made(recipe, count=60, **parameters):
    """Cases of a recipe, those it rejects left out."""
    cases = []
    for number in range(count):
        try:
            cases.append(flat(recipe(SeededDraw(f"endpoints/{number}"), **parameters)))
        except Rejected:
            continue
    assert len(cases) >= count // 2
    return cases


def local(case):
    """A and B seen from the centre and the radius, in fractions."""
    cx, cy, r, a, b = case
    return (
        *((Fraction(x) - Fraction(cx), Fraction(y) - Fraction(cy)) for x, y in (a, b)),
        Fraction(r),
    )


def terms(case):
    """a, b, c, Δ' of the quadratic in t."""
    (ax, ay), (bx, by), r = local(case)
    dx, dy = bx - ax, by - ay
    a, b, c = dx * dx + dy * dy, ax * dx + ay * dy, ax * ax + ay * ay - r * r
    return a, b, c, b * b - a * c


def exact_count(case):
    """The common points on the closed segment, without bands, by the signs of the quadratic at 0 and 1."""
    a, b, c, delta = terms(case)
    if a == 0:
        return int(c == 0)
    if delta < 0:
        return 0
    if delta == 0:
        return int(0 <= -b <= a)
    at_end, vertex_inside = a + 2 * b + c, 0 < -b < a
    if c * at_end < 0:
        return 1
    if c == 0 or at_end == 0:
        other = 0 < -2 * b <= a if c == 0 else 0 <= c < a  # the roots' sum is −2b/a, their product c/a
        return 1 + int(other)
    return 2 if c > 0 and vertex_inside else 0


def extent(case):
    (ax, ay), (bx, by), r = local(case)
    return max(r, *map(abs, (ax, ay, bx, by)))


def gap(case):
    """|d − r| as a part of the extent."""
    a, _, _, delta = terms(case)
    _, _, r = local(case)
    distance = float(r * r - delta / a) ** 0.5
    return abs(float(delta / a)) / (distance + float(r)) / float(extent(case))


@pytest.mark.parametrize(
    ("where", "wanted"),
    [
        ("through", 2),
        ("entering", 1),
        ("leaving", 1),
        ("from-foot", 1),
        ("inside", 0),
        ("before", 0),
        ("after", 0),
        ("beside", 0),
    ],
)
def test_across_has_as_many_points_as_its_place_says(where, wanted):
    cases = made(endpoints.across, where=[where], size=30, poses=["axis", "exact", "any"])
    assert {exact_count(case) for case in cases} == {wanted}
    deltas = {terms(case)[3] > 0 for case in cases}
    assert deltas == {where != "beside"}


def test_the_foot_is_where_a_from_foot_segment_starts():
    cases = made(endpoints.across, where=["from-foot"], size=30, poses=EXACT)
    assert all(terms(case)[1] == 0 for case in cases)


@pytest.mark.parametrize(("where", "wanted"), [("within", 1), ("at-end", 1), ("beyond", 0)])
def test_tangents_are_exact_and_their_contact_is_in_its_place(where, wanted):
    cases = made(endpoints.tangent, where=[where], size=30, poses=EXACT)
    assert {terms(case)[3] for case in cases} == {0}
    assert {exact_count(case) for case in cases} == {wanted}


def test_turned_tangents_are_tangents_within_rounding_but_not_exactly():
    cases = made(endpoints.tangent, where=["within"], size=1000, poses=["any"])
    assert all(gap(case) < 1e-13 for case in cases)
    assert sum(terms(case)[3] != 0 for case in cases) > len(cases) // 2


@pytest.mark.parametrize(("side", "wanted"), [("hit", 2), ("miss", 0)])
def test_near_tangents_keep_just_out_of_the_promise(side, wanted):
    cases = made(endpoints.near_tangent, sides=[side], bits=4, size=1000)
    assert {exact_count(case) for case in cases} == {wanted}
    gaps = [gap(case) for case in cases]
    assert min(gaps) > 1.9e-7
    assert min(gaps) < 1e-6
    assert max(gaps) < 1e-5


def test_banded_tangents_are_within_the_band_by_much_more_than_rounding():
    gaps = [gap(case) for case in made(endpoints.near_tangent, sides=["hit", "miss"], within=True, size=1000)]
    assert min(gaps) > 9e-14
    assert max(gaps) < 9.9e-13


@pytest.mark.parametrize(("where", "wanted"), [("inward", 1), ("across", 2), ("outward", 1), ("both", 2)])
def test_an_end_is_on_the_circle(where, wanted):
    cases = made(endpoints.end_on_circle, where=[where], size=60, poses=EXACT)
    assert {exact_count(case) for case in cases} == {wanted}
    assert all(terms(case)[2] == 0 or sum(terms(case)[:3]) + terms(case)[1] == 0 for case in cases)


@pytest.mark.parametrize(("where", "wanted"), [("short", 0), ("touching", 1), ("inside", 0), ("out", 1)])
def test_an_end_just_misses_or_just_passes_the_circle(where, wanted):
    cases = made(endpoints.end_near_circle, where=[where], bits=4, size=500)
    assert {exact_count(case) for case in cases} == {wanted}
    assert {exact_count(reverse(case)) for case in cases} == {wanted}


def reverse(case):
    return (*case[:3], case[4], case[3])


def test_off_by_one_ends_are_integers_next_to_the_circle():
    cases = made(endpoints.end_off_by_one, size=2**20, numbers="int")
    powers = set()
    for case in cases:
        a, b, c, _ = terms(case)
        powers.add(min(c, a + 2 * b + c, key=abs))
        assert all(type(value) is int for value in (*case[:3], *case[3], *case[4]))
    assert powers == {-1, 1}


def test_a_lopsided_tangent_is_off_by_most_of_the_band_of_one_coordinate():
    cases = made(endpoints.lopsided, size=50, ratio=[20000, 40000], count=200)
    shapes = set()
    for cx, cy, r, a, b in cases:
        seen = [Fraction(p[i]) - Fraction(c) for p in (a, b) for i, c in ((0, cx), (1, cy))]
        far = max(seen, key=abs)
        assert sorted(map(abs, seen))[-2] * 10000 < abs(far)
        same = 1 if a[1] == b[1] else 0
        change = abs(abs(seen[same]) - Fraction(r)) / abs(far)
        assert Fraction(9, 10**14) < change < Fraction(4, 10**13)
        shapes.add((seen.index(far), far > 0, abs(seen[same]) > r))
    assert len(shapes) == 16


@pytest.mark.parametrize(
    ("where", "wanted"), [("on", 1), ("inside", 0), ("outside", 0), ("centre", 0), ("point", 1)]
)
def test_a_point_is_a_segment(where, wanted):
    cases = made(endpoints.point_segment, where=[where], size=30, poses=EXACT)
    assert all(case[3] == case[4] for case in cases)
    assert {exact_count(case) for case in cases} == {wanted}


@pytest.mark.parametrize(("where", "wanted"), [("within", 1), ("at-end", 1), ("beyond", 0), ("off", 0)])
def test_a_circle_may_be_a_point(where, wanted):
    cases = made(endpoints.point_circle, where=[where], size=30, poses=EXACT)
    assert {case[2] for case in cases} == {0}
    assert {exact_count(case) for case in cases} == {wanted}


@pytest.mark.parametrize(("where", "counts"), [("tangent", {0, 1, 2}), ("through", {2}), ("beside", {0})])
def test_a_far_circle_is_tiny(where, counts):
    cases = made(endpoints.far_circle, where=[where], size=100, ratio=[10**6, 10**6], poses=["any"])
    assert {exact_count(case) for case in cases} <= counts
    assert all(extent(case) > 7 * 10**5 * Fraction(case[2]) for case in cases)


@pytest.mark.parametrize(("where", "wanted"), [("tangent", {0, 2}), ("short", {0, 1}), ("touching", {1, 2})])
def test_one_end_is_far_away(where, wanted):
    cases = made(endpoints.one_far_end, where=[where], size=500, ratio=[10**5, 5 * 10**5])
    assert {exact_count(case) for case in cases} <= wanted
    for case in cases:
        (ax, ay), (bx, by), r = local(case)
        near, far = sorted((max(abs(ax), abs(ay)), max(abs(bx), abs(by))))
        assert near < 10 * r
        assert far > 5 * 10**4 * r
        if where == "tangent":
            assert 9e-14 < gap(case) < 9.9e-13


@pytest.mark.parametrize("where", ["tangent", "across", "short", "touching"])
def test_a_short_segment_is_short_and_still_longer_than_the_band(where):
    cases = made(endpoints.short, where=[where], size=500, scale=-30)
    for case in cases:
        a, _, _, _ = terms(case)
        assert 1e-5 < float(a) ** 0.5 / float(extent(case)) < 3e-4
    if where == "across":
        assert {exact_count(case) for case in cases} == {1}
    if where == "tangent":
        assert all(9e-14 < gap(case) < 9.9e-13 for case in cases)


@pytest.mark.parametrize(("within", "low", "high"), [(True, 9e-14, 9.9e-13), (False, 1.9e-7, 1e-5)])
def test_a_point_is_just_off_the_circle(within, low, high):
    cases = made(endpoints.point_near_circle, sides=["inside", "outside"], within=within, bits=4, size=1000)
    for case in cases:
        (ax, ay), _, r = local(case)
        assert case[3] == case[4]
        # | |A − C| − r | = | |A − C|² − r² | / (|A − C| + r)
        assert low < float(abs(ax * ax + ay * ay - r * r) / (2 * r) / extent(case)) < high


@pytest.mark.parametrize(
    ("where", "wanted"), [("hit", 2), ("miss", 0), ("stop", 0), ("pass", 1), ("point", 0)]
)
def test_a_small_circle_far_away_is_nearly_met_exactly(where, wanted):
    cases = made(endpoints.near_far_away, where=[where], distance=27)
    assert {exact_count(case) for case in cases} == {wanted}
    assert all(min(map(abs, case[:2])) >= 2**26 and case[2] <= 1 for case in cases)


def test_the_grid_and_the_uniform_box_keep_their_size():
    cases = made(endpoints.grid, size=3, count=300)
    assert {value for case in cases for value in (*case[:2], *case[3], *case[4])} == set(range(-3, 4))
    assert {exact_count(case) for case in cases} == {0, 1, 2}
    boxed = made(endpoints.uniform, size=2**30, numbers="mixed")
    assert {type(value) for case in boxed for value in case[:3]} == {int, float}


def test_an_unknown_place_is_a_fault_of_the_problem():
    with pytest.raises(ProblemError, match="'nowhere' is a place"):
        endpoints.across(SeededDraw("x"), where=["nowhere"], size=9, poses=EXACT)
