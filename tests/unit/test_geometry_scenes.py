"""Scenes: what a word says is exact or clear, every number is a double within the bounds, choices replay."""

from __future__ import annotations

from fractions import Fraction

import pytest

from judge.data.draw import Draw, Rejected, seeded
from judge.errors import ProblemError
from judge.geometry import Line, Pair, Sphere
from judge.geometry.crowd import Crowd
from judge.geometry.motion import balls_meeting, wall_meeting
from judge.geometry.polygon import crossings, edges
from judge.geometry.scenes import (
    AXIS,
    BIG,
    DECIMALS,
    FAR,
    HUGE,
    NEAR,
    OFFSET,
    PLAIN,
    SPLIT,
    STEEP,
    TILTED,
    TINY,
    balls,
    closed_up,
    crowds,
    either,
    feet,
    grid,
    lights,
    lines,
    pairs,
    points,
    polygons,
    rays,
    spheres,
    telling,
    uniform,
    walls,
    whole,
)
from judge.problem.declare import InvalidCase

POSES = [PLAIN, AXIS, BIG, HUGE, SPLIT, TINY, OFFSET, STEEP, DECIMALS]


def drawn(scene, cases=40):
    """That many cases; most draws make one."""
    found, seed = [], 0
    while len(found) < cases:
        seed += 1
        assert seed < 6 * cases, "most draws are given up"
        try:
            found.append(scene(Draw(seeded(str(seed)))))
        except Rejected:
            continue
    return found


def flat(case):
    return [number for value in case for number in (value if isinstance(value, tuple) else (value,))]


@pytest.mark.parametrize("pose", POSES)
@pytest.mark.parametrize(
    ("plans", "wanted"),
    [(("touch before after", "touch foot after", "touch ?by ?near"), 1), (("cut before after",), 2)],
)
def test_a_line_touches_exactly_or_cuts_in_every_pose(pose, plans, wanted):
    for case in drawn(lines(*plans, **pose)):
        assert Line.through(*case).count() == wanted, case
        assert all(x == 0 or 1e-30 <= abs(x) <= 2**30 for x in flat(case)), case


@pytest.mark.parametrize("pose", [PLAIN, BIG, HUGE, TINY, OFFSET])
def test_an_end_on_the_circle_is_on_it_exactly(pose):
    for cx, cy, r, A, _ in drawn(lines("chord first in", "chord first after", **pose)):
        x, y = Fraction(A[0]) - Fraction(cx), Fraction(A[1]) - Fraction(cy)
        assert x * x + y * y == Fraction(r) ** 2


@pytest.mark.parametrize(
    ("scene", "decided"),
    [
        (lines("touch~ before after", "touch~ foot by", **NEAR), lambda *case: Line.through(*case).count()),
        (lines("dot~ before after", **NEAR), lambda *case: Line.through(*case).count()),
        (lines("chord first~ in", "through first~ =", **NEAR), lambda *case: Line.through(*case).within()),
        (rays("chord first~", "chord last~", **NEAR), lambda *case: Line.ray(*case).first()),
        (points("on~", **NEAR), lambda *case: Line.point(*case).side()),
        (spheres("touch~ before", "chord first~", **NEAR), lambda *case: Sphere(*case).first()),
        (pairs("outer~", "inner~", "same~", "dot-on~", **NEAR), lambda *case: Pair(*case).lie()),
        (lines("touch~ foot far", **FAR), lambda *case: Line.through(*case).count()),
        (lines("touch~ before after", **TINY), lambda *case: Line.through(*case).count()),
    ],
)
def test_what_is_just_off_is_clear_and_no_more_than_a_millionth_away(scene, decided):
    sizes = []
    for case in drawn(scene):
        decided(*case)  # raises where it is neither exact nor clear
        sizes.append(case)
    assert len({str(case) for case in sizes}) > 30


@pytest.mark.parametrize("pose", [PLAIN, AXIS, BIG, HUGE, TINY, OFFSET])
def test_a_ray_touches_a_sphere_exactly(pose):
    for case in drawn(spheres("touch before", **pose)):
        assert Sphere(*case).meets() == (0,), case


@pytest.mark.parametrize("pose", [PLAIN, AXIS, BIG, HUGE, SPLIT, TINY, OFFSET])
def test_two_circles_touch_exactly(pose):
    for case in drawn(pairs("outer", "inner", **pose)):
        assert Pair(*case).lie().value in ("outer", "inner"), case


@pytest.mark.parametrize(
    ("scene", "way"),
    [
        (lines("cut before after", "miss before after", **TILTED), lambda *case: case),
        (rays("cut before", **{**TILTED, "tilt": (20, 75)}), lambda *case: ((0, 0), case[4])),
        (feet("between", "beyond", **TILTED), lambda A, B, P: (*P, 0, A, B)),
    ],
)
def test_a_tilted_way_is_steeper_than_any_turn(scene, way):
    slopes = []
    for case in drawn(scene):
        *_, A, B = way(*case)
        parts = sorted(abs(Fraction(b) - Fraction(a)) for a, b in zip(A, B, strict=True))
        slopes.append(parts[1] / parts[0])
    assert min(slopes) > 2**11
    assert max(slopes) > 2**40


def test_split_figures_have_differences_that_no_double_holds():
    rounded = 0
    for cx, cy, _, A, _ in drawn(lines("touch before after", **SPLIT)):
        rounded += any(Fraction(a - c) != Fraction(a) - Fraction(c) for a, c in zip(A, (cx, cy), strict=True))
    assert rounded > 30


def test_telling_keeps_the_cases_on_which_a_plain_program_fails():
    def exact(cx, cy, r, A, B):
        return abs(A[1] - cy) == r or abs(A[0] - cx) == r

    def never(*_case):
        return None

    scene = telling(lines("touch foot after", **DECIMALS), exact, never)
    assert all(exact(*case) is not None for case in drawn(scene, 10))
    with pytest.raises(Rejected):
        telling(grid("nn", 3), never, never)(Draw(seeded("1")))


def test_the_same_choices_give_the_same_case_and_either_takes_one():
    scene = either(lines("cut before after", **PLAIN), closed_up("touch by", "miss by"))
    assert scene(Draw(seeded("7"))) == scene(Draw(seeded("7")))
    assert len({repr(scene(Draw(seeded(str(seed))))) for seed in range(30)}) > 20


def test_points_that_are_close_together_are_two_and_their_line_is_exact():
    for cx, cy, r, A, B in drawn(closed_up("touch by")):
        assert A != B
        assert Line.through(cx, cy, r, A, B).count() == 1


def test_small_numbers_meet_by_themselves():
    cases = drawn(grid("nnrpp", 3), 300)
    assert any(case[3] == case[4] for case in cases)
    assert any(case[3] == (0, 0) for case in cases)
    assert any(case[2] == 0 for case in cases)
    assert {type(number) for case in cases for number in flat(case)} == {int, float}


def test_plain_numbers_have_their_shapes_and_reaches():
    for case in drawn(whole("nrpP", 30), 20):
        assert [type(value) for value in case] == [int, int, tuple, tuple]
        assert all(abs(number) <= 2**30 for number in flat(case))
        assert case[1] >= 0
    for case in drawn(uniform("nd", 20, 1e9), 20):
        assert all(abs(number) <= 1e9 for number in flat(case))


def test_feet_lie_where_their_word_says():
    for A, B, P in drawn(feet("beyond", **PLAIN)):
        along = sum((p - a) * (b - a) for a, b, p in zip(A, B, P, strict=True))
        assert not 0 < along < sum((b - a) ** 2 for a, b in zip(A, B, strict=True))
    assert all(A == B for A, B, _ in drawn(feet("same", **PLAIN)))


def test_a_word_that_is_none_is_told_when_it_is_written():
    with pytest.raises(ProblemError, match="'fist' is not a place on a line: before, in, after, first"):
        lines("touch fist after", **PLAIN)
    with pytest.raises(ProblemError, match=r"'tuch' is not a height of a line: .*did you mean 'touch'"):
        rays("tuch before", **PLAIN)
    with pytest.raises(ProblemError, match="is not a way for two circles to lie"):
        pairs("outside", **PLAIN)


def test_a_figure_that_is_nearly_a_touch_is_no_case():
    with pytest.raises(InvalidCase, match="1e-7"):
        Line.through(0, 0, 1, (-2, 1 + 1e-9), (2, 1 + 1e-9)).count()


def numbers(value):
    return [each for part in value for each in numbers(part)] if isinstance(value, tuple) else [value]


@pytest.mark.parametrize("pose", [PLAIN, BIG, {**HUGE, "size": 2**34, "move": 49}, TINY, OFFSET])
@pytest.mark.parametrize(
    ("scene", "plans", "wanted"),
    [
        (
            crowds,
            ["exit2 enter2", "enter2 touch2"],
            lambda *case: max(len(each) for each in Crowd(*case).places()) == 2,
        ),
        (crowds, ["touch0 behind", "exit0"], lambda *case: len(Crowd(*case).places()) == 1),
        (polygons, ["on out out", "on in out in"], lambda *case: 0 in [edge for edge, _ in crossings(*case)]),
        (
            polygons,
            ["tangent out", "brush out"],
            lambda *case: any(edge.meets() == (0,) for edge in edges(*case)),
        ),
        (
            balls,
            ["chord last after", "chord first in", "cut in ="],
            lambda *case: not float(balls_meeting(*case).x),
        ),
        (
            balls,
            ["chord before first", "touch before foot rest"],
            lambda *case: float(balls_meeting(*case).x) == 1,
        ),
        (walls, ["start side", "start cap", "overlap side"], lambda *case: not float(wall_meeting(*case).x)),
        (walls, ["end side", "end cap", "end post"], lambda *case: float(wall_meeting(*case).x) == 1),
        (walls, ["short cap", "away side", "away post"], lambda *case: wall_meeting(*case) is None),
    ],
)
def test_what_happens_where_is_exact_in_every_pose(pose, scene, plans, wanted):
    decided = 0
    for case in drawn(scene(*plans, **pose)):
        assert all(x == 0 or 1e-30 <= abs(x) <= 2**30 for x in numbers(case)), case
        try:
            assert wanted(*case), case
        except InvalidCase:
            continue
        decided += 1
    assert decided >= 20


@pytest.mark.parametrize("make", [crowds, polygons, balls, walls, lights])
def test_a_word_that_is_none_names_the_nearest(make):
    with pytest.raises(ProblemError, match="is not"):
        make("entr side in")
