"""A pose takes a level figure anywhere and keeps what its recipe built."""

from __future__ import annotations

from fractions import Fraction

import pytest

from judge.data.draw import SeededDraw
from judge.errors import ProblemError
from judge.topics.circles.figures import posing
from judge.topics.circles.figures.figure import Turn, line, ray
from judge.topics.circles.signature import flat

FIGURE = line((0, 0), 5, (-9, 3), (7, 3))


def draws(count=40):
    return [SeededDraw(f"posing/{number}") for number in range(count)]


def shape(case):
    """What no turn, move or scaling changes: squared lengths as parts of |AB|², exactly."""
    cx, cy, r, *ends = [
        tuple(map(Fraction, value)) if isinstance(value, tuple) else Fraction(value) for value in case
    ]
    (ax, ay), (bx, by) = ends
    whole = (ax - bx) ** 2 + (ay - by) ** 2
    lengths = [r * r, (ax - cx) ** 2 + (ay - cy) ** 2, (bx - cx) ** 2 + (by - cy) ** 2]
    return [length / whole for length in lengths]


def numbers(case):
    return [number for value in case for number in (value if isinstance(value, tuple) else (value,))]


@pytest.mark.parametrize("poses", [["axis"], ["exact"]])
@pytest.mark.parametrize("scale", [-30, 0, 12])
def test_exact_poses_keep_the_shape(poses, scale):
    cases = [flat(posing.posed(draw, FIGURE, poses=poses, scale=scale)) for draw in draws()]
    assert all(shape(case) == shape(flat(FIGURE)) for case in cases)
    assert len(set(cases)) == len(cases)


def test_any_pose_keeps_the_shape_but_for_rounding():
    for draw in draws():
        case = flat(posing.posed(draw, FIGURE, poses=["any"], scale=-3))
        assert {type(number) for number in numbers(case)} <= {int, float}
        assert all(
            abs(got - wanted) < 1e-14 for got, wanted in zip(shape(case), shape(flat(FIGURE)), strict=True)
        )


def test_an_axis_pose_is_level_or_upright():
    cases = [flat(posing.posed(draw, FIGURE, poses=["axis"])) for draw in draws()]
    assert {(a[0] == b[0], a[1] == b[1]) for *_, a, b in cases} == {(True, False), (False, True)}


def test_every_second_steep_turn_leans_as_asked_for():
    def leans(leaning):
        turns = [posing.slight_turn(draw, leaning) for draw in draws(80)]
        return sum(2**-31 <= abs(Fraction(turn.sine, turn.norm)) <= 2**-26 for turn in turns)

    assert leans((27, 31)) > 40 > leans(())


def test_far_figures_are_moved_exactly():
    for draw in draws():
        case = flat(posing.posed(draw, FIGURE, poses=["exact"], numbers="float", scale=-6, far=27))
        assert shape(case) == shape(flat(FIGURE))
        assert min(abs(case[0]), abs(case[1])) > 2**25
        assert {type(number) for number in numbers(case)} == {float}


def test_a_divisor_shrinks_the_figure():
    big = line((0, 0), 5 * 10**7, (-9 * 10**7, 3 * 10**7), (7 * 10**7, 3 * 10**7))
    for draw in draws(10):
        case = flat(posing.posed(draw, big, poses=["any"], divisor=10**7))
        assert case[2] == 5
        assert all(
            abs(got - wanted) < 1e-14 for got, wanted in zip(shape(case), shape(flat(FIGURE)), strict=True)
        )


def test_only_any_pose_divides_and_poses_have_names():
    with pytest.raises(ProblemError, match="only a figure that is rounded"):
        posing.posed(SeededDraw("x"), FIGURE, poses=["exact"], divisor=10)
    with pytest.raises(ProblemError, match="a pose is one of"):
        posing.posed(SeededDraw("x"), FIGURE, poses=["sideways"])


def test_a_spin_is_exact_and_turns_vectors():
    spun = posing.spun(ray((1, 0), 5, (2, 1), (0, 1)), Turn(3, 4, 5))
    assert flat(spun) == (3, 4, 25, (2, 11), (-4, 3))
    with pytest.raises(ProblemError, match="a turn keeps lengths"):
        posing.spun(FIGURE, Turn(1, 1, 1))


def test_a_rational_chord_is_pythagorean_and_within_size():
    chords = [posing.rational_chord(draw, 60) for draw in draws(200)]
    assert all(offset**2 + half**2 == radius**2 for radius, offset, half in chords)
    assert all(0 < half <= radius <= 60 for radius, _, half in chords)
    assert {offset == 0 for _, offset, _ in chords} == {True, False}


def test_a_hair_keeps_its_bounds():
    for draw in draws(200):
        gap, divisor = posing.hair(draw, 7, within=False, bits=6)
        assert Fraction(2, 10**7) <= Fraction(gap, 7 * divisor) < Fraction(128, 10**7)
        gap, divisor = posing.hair(draw, 7, within=True, bits=1)
        assert Fraction(1, 10**13) <= Fraction(gap, 7 * divisor) <= Fraction(3, 10**13)
