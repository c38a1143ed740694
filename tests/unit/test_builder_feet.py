"""Recipes for a line with a point beside it, a circle with a point, and chords: what they say, they make."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest

from judge.data.draw import Rejected, SeededDraw
from judge.problem.load import load_problem
from judge.topics.circles import FOOT, NORMAL, POINT, CircleLine, Part, circle_and_point, line_and_point
from judge.topics.circles.bands import Bands
from judge.topics.circles.recipes import chords, feet, points
from judge.topics.circles.signature import line_alone, line_of, read

ROOT = Path(__file__).parents[2]
POSES = ("axis", "exact", "any", "steep")
EXACT = ("axis", "exact")
BANDS = Bands(Fraction(1, 10**12), Fraction(1, 10**7))


def drawn(recipe, count=60, **parameters):
    """So many figures of a recipe."""
    found = []
    for seed in range(20 * count):
        try:
            found.append(recipe(SeededDraw(f"{recipe.__name__}/{seed}"), **parameters))
        except Rejected:
            continue
        if len(found) == count:
            return found
    raise AssertionError(f"{recipe.__name__} gives up too often")


def line_in(figure):
    return CircleLine.through(*figure.centre, figure.radius, *figure.points)


@pytest.mark.parametrize(
    ("kind", "holds"),
    [
        ("before", lambda t: t < 0),
        ("after", lambda t: t > 1),
        ("between", lambda t: 0 <= t <= 1),
        ("at-end", lambda t: t == 0),
    ],
)
def test_the_foot_is_where_it_was_asked_for(kind, holds):
    for figure in drawn(feet.beside, feet=(kind,), size=60, poses=EXACT):
        assert holds(line_in(figure).root(0))
        assert line_in(figure).k != 0


def test_a_point_on_the_line_is_its_own_foot():
    for figure in drawn(feet.beside, feet=("before", "between"), size=60, poses=EXACT, on=True):
        assert line_in(figure).k == 0


def test_close_points_are_as_close_as_asked_for_and_two():
    for figure in drawn(feet.beside, feet=("between",), size=300, poses=POSES, close=(20, 50), scales=(-30,)):
        line = line_in(figure)
        assert 0 < line.a < Fraction(line.extent, 2**17) ** 2


def test_a_thin_triangle_is_one_whose_product_doubles_hold():
    for figure in drawn(feet.thin, size=1 << 20):
        line = line_in(figure)
        assert 1 <= abs(line.k) <= 9
        assert line.extent < 1 << 22
        assert line.shift == 0


def test_remote_feet_are_hardly_ever_doubles():
    between, far = 0, 10**9
    for figure in drawn(feet.remote, size=3, far=far, finest=8):
        a, b, c = (tuple(map(Fraction, point)) for point in (*figure.points, figure.centre))
        assert a != b
        assert all(far // 2 - 3 <= abs(x) <= far + 3 for point in (a, b, c) for x in point)
        assert max(abs(x - y) for one in (a, b) for x, y in zip(one, c, strict=True)) <= 6
        root = line_in(figure).root(0)
        foot = [x + Fraction(root.p, root.s) * (y - x) for x, y in zip(a, b, strict=True)]
        between += any(Fraction(float(x)) != x for x in foot)
    assert between > 20


def test_corners_leave_64_bits():
    figures = drawn(feet.uniform, size=1 << 30)
    assert sum(line_in(figure).a >= 1 << 63 for figure in figures) > 5
    wide = [figure for figure in drawn(points.whole, count=90) if CircleAt(figure).square >= 1 << 63]
    assert {figure.radius == 0 for figure in wide} == {True, False}


class CircleAt:
    """A circle and a point in integers."""

    def __init__(self, figure):
        self.line = CircleLine.through(*circle_and_point(figure), figure.points[0])
        self.square = (self.line.ax - self.line.cx) ** 2 + (self.line.ay - self.line.cy) ** 2

    @property
    def side(self):
        return BANDS.side(self.line)


@pytest.mark.parametrize(("kind", "side"), [("inside", -1), ("on", 0), ("outside", 1)])
def test_a_point_is_on_the_side_that_was_asked_for(kind, side):
    for figure in drawn(points.around, where=(kind,), size=60, poses=("axis", "exact", "any")):
        assert CircleAt(figure).side == side


def test_a_point_circle_is_met_and_missed():
    sides = {CircleAt(each).side for each in drawn(points.point_circle, size=60, poses=EXACT)}
    assert sides == {0, 1}


def test_whole_points_are_on_the_circle_or_nearly():
    figures = drawn(points.whole, count=90)
    assert all(isinstance(x, int) or x.is_integer() for figure in figures for x in figure.points[0])
    assert {CircleAt(figure).side for figure in figures} == {-1, 0, 1}
    off = [CircleAt(figure).square - int(figure.radius) ** 2 for figure in figures]
    assert {1, -1, 0} <= set(off)


def test_hardly_beside_the_centre_is_no_diameter():
    figures = drawn(chords.diameter, size=60, poses=("axis",), beside=(4000, 25000))
    beside = [figure for figure in figures if line_in(figure).k != 0]
    assert len(figures) > len(beside) > 10
    for figure in beside:
        line = line_in(figure)
        assert line.k**2 == line.a * 2 ** (2 * line.shift)
        assert 4000 <= figure.radius <= 25000


def test_a_diameter_goes_through_the_centre():
    for figure in drawn(chords.diameter, size=60, poses=EXACT):
        assert line_in(figure).k == 0
        assert line_in(figure).chord() == 2 * Fraction(figure.radius)


def test_a_spread_line_cuts_the_circle_however_close_its_points_are():
    for low, high in ((-50, -40), (0, 3), (15, 20)):
        for figure in drawn(chords.spread, size=60, octaves=(low, high), poses=POSES):
            line = line_in(figure)
            assert line.a > 0
            assert line.delta > 0
            assert Fraction(line.extent, 2**12) ** 2 > line.a or high > 0


def test_a_case_is_read_by_its_part():
    assert read(Part.POINT, (1, 2, 3, (4, 5))) == ((1, 2), 3, (4, 5), (4, 5))
    assert read(Part.FOOT, ((1, 2), (3, 4), (5, 6))) == ((5, 6), 0, (1, 2), (3, 4))
    assert read(Part.NORMAL, ((1, 2), (3, 4))) == ((0, 0), 0, (1, 2), (3, 4))
    for part in Part:
        assert read(part, (1, 2)) is None
        assert line_of(part, ()) is None
    assert line_of(Part.RAY, (0, 0, 1, (2, 3), (1, 0))).dx == 1


def test_a_figure_becomes_the_case_of_each_kind():
    (figure,) = drawn(feet.grid, count=1, size=3)
    assert line_and_point(figure) == (*figure.points, figure.centre)
    assert line_alone(figure) == figure.points
    assert circle_and_point(figure) == (*figure.centre, 0, figure.points[0])


def test_distance_height_and_normal_are_of_the_left():
    line = CircleLine.through(0, 0, 0, (3, 0), (3, 5))
    assert (line.distance(), line.height()) == (3, 3)
    assert line.left_normal() == (-1, 0)
    assert CircleLine.through(0, 0, 0, (3, 5), (3, 0)).height() == -3
    assert CircleLine.through(1, 1, 0, (0, 0), (0, 0)).distance() == 0


@pytest.mark.parametrize(("topic", "name"), [(FOOT, "distance"), (FOOT, "foot"), (NORMAL, "normal-form")])
def test_a_threshold_for_no_line_is_measured_in_nine_figures(topic, name):
    (border,) = topic.borders(load_problem(ROOT / "problems" / name))
    assert (border.about, border.within, len(border.probes)) == ("no line", 0, 9)


def test_a_threshold_for_a_point_is_measured_in_nine_figures():
    (border,) = POINT.borders(load_problem(ROOT / "problems" / "on-circle"))
    assert (border.about, len(border.probes)) == ("a point", 9)


def test_a_line_has_no_mirror_images_where_left_counts():
    assert NORMAL.images is None
    assert FOOT.images is not None
