"""The recipes at the edges: each share is measured anew, in fractions, of the case as it comes out."""

from __future__ import annotations

from fractions import Fraction
from math import hypot, isqrt, log10

import pytest

from judge.data.draw import BuilderError, Rejected, SeededDraw
from judge.topics.circles.figures import edges as at
from judge.topics.circles.figures.figure import line, ray
from judge.topics.circles.line import CircleLine
from judge.topics.circles.recipes import edges, endpoints, whole
from judge.topics.circles.signature import flat

POSES = ["axis", "exact", "any", "steep"]
RANGES = {
    "snap": (Fraction(9, 10**13), Fraction(1, 10**12)),
    "clear": (Fraction(101, 10**9), Fraction(3, 10**7)),
    "within": (Fraction(1, 10**15), Fraction(1, 10**12)),
    "beyond": (Fraction(101, 10**9), Fraction(1, 10)),
}


def made(recipe, count=60, **parameters):
    """Figures of a recipe, those it rejects left out."""
    figures = []
    for number in range(count):
        try:
            figures.append(recipe(SeededDraw(f"edges/{number}"), **parameters))
        except Rejected:
            continue
    assert len(figures) >= count // 5
    return figures


def seen(figure):
    return at.seen(figure)


def tangency(figure):
    """(d − r) / e as a fraction near enough, by isqrt at 200 bits."""
    found = seen(figure)
    distance = isqrt_fraction(Fraction(found.k * found.k, found.a))
    return (distance - found.r) / found.extent


def isqrt_fraction(x, bits=400):
    return Fraction(isqrt((x.numerator << (2 * bits)) // x.denominator), 1 << bits)


def roots(figure):
    """The two roots as lengths along the line, from the first point, as shares of the extent."""
    found = seen(figure)
    length, root = isqrt_fraction(Fraction(found.a)), isqrt_fraction(Fraction(found.delta))
    return [(-found.b + sign * root) / length / found.extent for sign in (-1, 1)], length / found.extent


@pytest.mark.parametrize("name", RANGES)
@pytest.mark.parametrize("side", ["hit", "miss"])
@pytest.mark.parametrize("recipe", [edges.tangent, edges.ray_tangent])
def test_a_tangency_is_off_by_its_share(name, side, recipe):
    low, high = RANGES[name]
    for figure in made(recipe, sides=[side], edges=[name], poses=POSES, scales=[0, -98, 17]):
        gap = tangency(figure)
        assert (gap < 0) == (side == "hit")
        assert low <= abs(gap) <= high


@pytest.mark.parametrize("name", RANGES)
@pytest.mark.parametrize("side", ["on", "beyond"])
def test_an_end_is_off_by_its_share(name, side):
    low, high = RANGES[name]
    others = ["inward", "across", "outward", "far", "short", "tiny"]
    for figure in made(edges.end, sides=[side], others=others, edges=[name], poses=POSES):
        places, length = roots(figure)
        ends = [*places] + [length - place for place in places]
        assert any(low <= (place if side == "on" else -place) <= high for place in ends)


@pytest.mark.parametrize("name", RANGES)
@pytest.mark.parametrize("side", ["inside", "outside"])
def test_a_point_is_off_by_its_share(name, side):
    low, high = RANGES[name]
    for figure in made(edges.point, sides=[side], edges=[name], poses=POSES):
        found = seen(figure)
        away = isqrt_fraction(Fraction((found.ax - found.cx) ** 2 + (found.ay - found.cy) ** 2))
        gap = (away - found.r) / found.extent
        assert (gap < 0) == (side == "inside")
        assert low <= abs(gap) <= high


@pytest.mark.parametrize("name", RANGES)
@pytest.mark.parametrize("side", ["ahead", "behind"])
@pytest.mark.parametrize("look", ["in", "out"])
def test_an_origin_is_off_by_its_share(name, side, look):
    low, high = RANGES[name]
    for figure in made(edges.origin, sides=[side], looks=[look], edges=[name], poses=POSES, stretch=[-9, 9]):
        (first, second), _ = roots(figure)
        near, far = (first, second) if look == "in" else (second, first)
        assert low <= (near if side == "ahead" else -near) <= high
        assert (far > 0) == (look == "in")


def test_shares_fill_their_range_by_magnitude():
    edge = at.EDGES["clear"]
    shares = [edge.share(SeededDraw(f"share/{n}")) / edge.units for n in range(2000)]
    assert 1.01e-7 < min(shares) < 1.03e-7
    assert 2.9e-7 < max(shares) < 3e-7
    assert 0.10 < sum(share < 1.2e-7 for share in shares) / 2000 < 0.25
    wide = at.EDGES["beyond"]
    decades = {int(log10(wide.share(SeededDraw(f"wide/{n}")) / wide.units)) for n in range(400)}
    assert len(decades) >= 5


@pytest.mark.parametrize("bits", [(4, 10), (30, 40), (48, 50)])
def test_close_points_are_as_close_as_said(bits):
    low, high = bits
    for figure in made(edges.tangent, sides=["hit"], edges=["snap"], poses=["any"], close=bits):
        (ax, ay), (bx, by) = figure.points
        share = hypot(bx - ax, by - ay) / float(figure.extent)
        assert 2.0**-high / 2 <= share <= 2.0**-low * 3


def test_a_foot_is_between_the_points_where_that_is_asked():
    for figure in made(edges.tangent, sides=["hit", "miss"], edges=["clear"], poses=POSES, around=True):
        found = seen(figure)
        assert -found.a < found.b < 0


def test_every_quantity_is_the_extent_of_some_tangency():
    largest = set()
    for figure in made(edges.tangent, 300, sides=["hit", "miss"], edges=["snap", "clear"], poses=["any"]):
        cx, cy, r, (ax, ay), (bx, by) = flat(figure)
        spans = {"r": r, "ax": abs(ax - cx), "ay": abs(ay - cy), "bx": abs(bx - cx), "by": abs(by - cy)}
        largest.add(max(spans, key=spans.get))
    assert largest == {"r", "ax", "ay", "bx", "by"}


def test_a_speck_is_a_point_but_for_its_radius():
    for figure in made(edges.SEGMENTS["speck"], where=["within", "off"], size=60, poses=["axis", "any"]):
        assert 0 < Fraction(figure.radius) < figure.extent / 10**12
    with pytest.raises(BuilderError, match="a speck is nearly a point"):
        edges.speck(endpoints.uniform, SeededDraw(""), size=9, numbers="int")


def test_what_is_no_edge_and_no_side_is_refused():
    with pytest.raises(BuilderError, match="'hair' is an edge, one of snap, clear"):
        edges.point(SeededDraw(""), sides=["inside"], edges=["hair"], poses=["axis"])
    with pytest.raises(BuilderError, match="'left' is a side, one of hit, miss"):
        edges.tangent(SeededDraw(""), sides=["left"], edges=["snap"], poses=["axis"])


def test_a_line_along_the_radius_has_no_edge_to_touch():
    edge = at.EDGES["clear"]
    with pytest.raises(Rejected):
        at.tangent_off(SeededDraw(""), line((0, 0), 1, (1, 0), (2, 0)), edge, "miss")
    with pytest.raises(Rejected):
        at.root_off(SeededDraw(""), ray((0, 0), 1, (0, 1), (1, 0)), edge, 0, 1)


WHOLE = {
    "near-hit": ("hit", whole.whole_line),
    "near-miss": ("miss", whole.whole_line),
}


@pytest.mark.parametrize("kind", WHOLE)
def test_whole_lines_are_nearly_tangent_in_ints(kind):
    low, high = RANGES["clear"]
    side, recipe = WHOLE[kind]
    for figure in made(recipe, 120, kinds=[kind]):
        gap = tangency(figure)
        assert low <= abs(gap) <= high
        assert (gap < 0) == (side == "hit")


ALL_WHOLE = [
    (whole.whole_line, ["tangent", "hit", "miss", "near-hit", "near-miss"]),
    (
        whole.whole_segment,
        ["tangent", "hit", "miss", "near-hit", "near-miss", "on", "stop", "pass", "short", "point"],
    ),
    (
        whole.whole_ray,
        ["tangent", "hit", "miss", "near-hit", "near-miss", "on", "inside", "past", "ahead", "leaving"],
    ),
]


@pytest.mark.parametrize(("recipe", "kinds"), ALL_WHOLE)
def test_whole_numbers_are_ints_up_to_the_bounds(recipe, kinds):
    largest = 0
    for kind in kinds:
        for figure in made(recipe, 150, kinds=[kind]):
            numbers = [
                *figure.centre,
                figure.radius,
                *(x for p in (*figure.points, *figure.vectors) for x in p),
            ]
            assert {type(number) for number in numbers} == {int}
            assert max(map(abs, numbers)) <= whole.BOUND
            largest = max(largest, *map(abs, numbers))
    assert largest > 0.9 * whole.BOUND


def test_a_whole_tangent_is_one():
    for figure in made(whole.whole_segment, kinds=["tangent"]):
        assert isinstance(seen(figure), CircleLine)
        assert seen(figure).delta == 0
