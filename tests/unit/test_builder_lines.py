"""The integer recipes build what they say, at every size they are used at."""

from __future__ import annotations

from math import gcd, isqrt

import pytest

from judge.data.draw import BuilderError, Rejected, SeededDraw
from judge.topics.circles.figures import lines
from judge.topics.circles.figures.figure import line
from judge.topics.circles.figures.numbers import is_prime

SIZES = [20, 10**3, 10**6, 10**40]


def figures(recipe, *arguments, count=25):
    """The first figures of a recipe for successive seeds, rejected choices left out."""
    found = []
    for seed in range(1000):
        try:
            found.append(recipe(SeededDraw(f"{recipe.__name__}/{arguments}/{seed}"), *arguments))
        except Rejected:
            continue
        if len(found) == count:
            return found
    raise AssertionError(f"{recipe.__name__} made {len(found)} figures of 1000")


def kind_of(figure):
    """Independent of the recipes: the sign of b'² − a·c."""
    (ax, ay), (bx, by), (cx, cy) = *figure.points, figure.centre
    dx, dy, fx, fy = bx - ax, by - ay, ax - cx, ay - cy
    a, b, c = dx * dx + dy * dy, fx * dx + fy * dy, fx * fx + fy * fy - figure.radius**2
    assert a > 0
    delta = b * b - a * c
    return lines.HIT if delta > 0 else lines.MISS if delta < 0 else lines.TANGENT


def test_the_discriminant_is_that_of_the_quadratic():
    assert lines.discriminant(line((0, 0), 29, (0, 41), (1, 42))) == 1
    assert lines.discriminant(line((0, 0), 70, (0, 99), (1, 100))) == -1
    assert lines.discriminant(line((6, 12), 5, (4, 1), (5, 4))) == 25 * 10 - 5 * 5


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("recipe", [lines.tangent, lines.rational_tangent])
def test_tangents_are_tangents(recipe, size):
    for figure in figures(recipe, size):
        assert kind_of(figure) == lines.TANGENT
        assert figure.extent <= 8 * size


def test_a_rational_tangents_foot_is_mostly_no_grid_point():
    on_grid = 0
    for figure in figures(lines.rational_tangent, 10**4):
        (ax, ay), (bx, by), (cx, cy) = *figure.points, figure.centre
        dx, dy = bx - ax, by - ay
        on_grid += ((cx - ax) * dx + (cy - ay) * dy) * dx % (dx * dx + dy * dy) == 0
    assert on_grid <= 5


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("kind", lines.KINDS)
@pytest.mark.parametrize("recipe", [lines.plain, lines.axis_parallel])
def test_plain_lines_are_of_the_kind_asked_for(recipe, kind, size):
    assert {kind_of(figure) for figure in figures(recipe, size, kind)} == {kind}


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("kind", [lines.TANGENT, lines.MISS])
def test_a_point_circle_has_radius_zero(kind, size):
    for figure in figures(lines.point_circle, size, kind):
        assert figure.radius == 0
        assert kind_of(figure) == kind


@pytest.mark.parametrize("size", [100, 10**4, 10**9, 10**100])
@pytest.mark.parametrize("root", [1, 3])
def test_just_hit_is_as_near_as_it_says(size, root):
    for figure in figures(lines.just_hit, size, root):
        assert lines.discriminant(figure) == root**2
        assert kind_of(figure) == lines.HIT


@pytest.mark.parametrize("size", [10, 10**3, 10**6, 10**8])
def test_just_miss_is_as_near_as_it_says(size):
    for figure in figures(lines.just_miss, size):
        assert lines.discriminant(figure) == -1
        assert kind_of(figure) == lines.MISS


@pytest.mark.parametrize("size", [10**3, 10**9, 10**100])
@pytest.mark.parametrize("kind", [lines.HIT, lines.MISS])
def test_the_least_gap_shrinks_with_the_size(kind, size):
    for figure in figures(lines.least_gap_at_any_size, size, kind):
        gap = lines.discriminant(figure)
        assert kind_of(figure) == kind
        assert 1 <= abs(gap) <= 81
        assert figure.extent >= size // 2000


@pytest.mark.parametrize("size", [20, 10**3, 10**30])
def test_off_the_segment_crosses_the_line_only(size):
    for figure in figures(lines.off_the_segment, size):
        assert kind_of(figure) == lines.HIT
        (ax, ay), (bx, by), (cx, cy) = *figure.points, figure.centre
        dx, dy = bx - ax, by - ay
        squares = [(x - cx) ** 2 + (y - cy) ** 2 - figure.radius**2 for x, y in ((ax, ay), (bx, by))]
        outside = all(square > 0 for square in squares)
        assert outside or all(square < 0 for square in squares)
        if outside:  # the foot is not between A and B either
            along = (cx - ax) * dx + (cy - ay) * dy
            assert along < 0 or along > dx * dx + dy * dy


def test_one_point_has_no_line():
    drawn = figures(lines.one_point, 100)
    assert all(figure.points[0] == figure.points[1] for figure in drawn)
    assert any(figure.radius == 0 for figure in drawn)
    assert any(figure.radius and figure.points[0] == figure.centre for figure in drawn)
    on_circle = [
        figure
        for figure in drawn
        if figure.radius
        and sum((p - c) ** 2 for p, c in zip(figure.points[0], figure.centre, strict=True))
        == figure.radius**2
    ]
    assert on_circle


@pytest.mark.parametrize("seed", range(30))
def test_with_cross_reaches_every_cross_product(seed):
    draw = SeededDraw(f"cross {seed}")
    dx, dy = lines.primitive(draw.integer(-999, 999), draw.integer(1, 999))
    cross, steps = draw.integer(-(10**9), 10**9), draw.integer(-5, 5)
    fx, fy = lines.with_cross((dx, dy), cross, steps)
    assert dx * fy - dy * fx == cross
    assert abs(fx * dx + fy * dy - steps * (dx * dx + dy * dy)) * 2 <= dx * dx + dy * dy


@pytest.mark.parametrize("size", [40, 10**3, 10**6])
def test_a_small_gap_is_neither_one_nor_a_square_on_a_circle_of_prime_radius(size):
    made = figures(lines.small_gap, size, 30)
    gaps = {lines.discriminant(figure) for figure in made}
    assert all(2 <= abs(gap) <= 30 and isqrt(abs(gap)) ** 2 != abs(gap) for gap in gaps)
    assert min(gaps) < 0 < max(gaps)
    assert all(is_prime(figure.radius) for figure in made)


@pytest.mark.parametrize("kind", lines.KINDS)
@pytest.mark.parametrize("along", [100, 10**30])
def test_a_slid_line_has_its_points_far_along_it(kind, along):
    for figure in figures(lines.slid, 50, along, kind):
        assert kind_of(figure) == kind
        (ax, ay), (bx, by) = figure.points
        cx, cy = figure.centre
        dx, dy = bx - ax, by - ay
        assert abs((ax - cx) * dx + (ay - cy) * dy) >= (along // 8 - 1) * (dx * dx + dy * dy)


def test_with_cross_refuses_a_direction_with_a_common_factor():
    assert gcd(4, 6) == 2
    with pytest.raises(BuilderError, match="primitive"):
        lines.with_cross((4, 6), 3)


def test_a_recipe_that_breaks_its_word_says_so():
    with pytest.raises(BuilderError, match="the line is a miss, not a hit"):
        lines.require_kind(line((0, 0), 1, (0, 0), (1, 0)), lines.MISS)
