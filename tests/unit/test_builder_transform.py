"""What is done to a figure keeps what its recipe built."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction

import pytest

from judge.data.draw import BuilderError, SeededDraw
from judge.topics.circles.figures import figure as t
from judge.topics.circles.signature import flat

FIGURE = t.line((2, -3), 5, (7, 1), (-4, 6))
RAY = t.ray((2, -3), 5, (7, 1), (-11, 5))


def squares(figure):
    """What an isometry keeps: the squared distances of centre and points, and the squared radius."""
    spots = [figure.centre, *figure.points]
    pairs = [(p, q) for i, p in enumerate(spots) for q in spots[:i]]
    lengths = [sum((Fraction(a) - Fraction(b)) ** 2 for a, b in zip(p, q, strict=True)) for p, q in pairs]
    return [*lengths, Fraction(figure.radius) ** 2]


def test_a_case_lists_the_arguments_of_a_call():
    assert flat(FIGURE) == (2, -3, 5, (7, 1), (-4, 6))
    assert flat(RAY) == (2, -3, 5, (7, 1), (-11, 5))
    assert t.swapped(FIGURE).points == ((-4, 6), (7, 1))


def test_the_extent_is_seen_from_the_centre():
    assert FIGURE.extent == 9
    assert RAY.extent == 5
    assert t.line((0, 0), 0.5, (0.25, 0), (0, 0)).extent == Fraction(1, 2)


def test_a_move_leaves_vectors_alone():
    assert flat(t.moved(RAY, 10, -20)) == (12, -23, 5, (17, -19), (-11, 5))


def test_a_move_that_would_round_is_refused():
    small = t.scaled(FIGURE, -40)
    assert t.moved(small, 1, 1).centre[0] == 1 + 2 * 2.0**-40
    with pytest.raises(BuilderError, match="is exact"):
        t.moved(small, 2**30, 0)


@pytest.mark.parametrize("symmetry", range(8))
def test_mirroring_keeps_lengths(symmetry):
    assert squares(t.mirrored(FIGURE, symmetry)) == squares(FIGURE)


def test_the_eight_symmetries_differ_and_turn_vectors_too():
    assert len({t.mirrored(FIGURE, symmetry) for symmetry in range(8)}) == 8
    assert t.mirrored(RAY, 0) == RAY
    assert t.mirrored(RAY, 5).vectors == ((5, 11),)


@pytest.mark.parametrize("exponent", [-1000, -20, -1, 0, 3, 40])
def test_scaling_is_exact(exponent):
    factor = Fraction(2) ** exponent
    scaled = t.scaled(FIGURE, exponent)
    assert squares(scaled) == [square * factor**2 for square in squares(FIGURE)]
    assert all(isinstance(value, int) == (exponent >= 0) for value in scaled.centre)


def test_scaling_into_the_subnormals_is_refused():
    with pytest.raises(BuilderError, match="scales exactly"):
        t.scaled(FIGURE, -1076)


@pytest.mark.parametrize("seed", range(20))
def test_a_turn_rounds_each_number_once(seed):
    turn = t.draw_turn(SeededDraw(f"turn {seed}"))
    turned = t.turned(RAY, turn, divisor=7)
    cosine, sine = Fraction(turn.cosine, turn.norm * 7), Fraction(turn.sine, turn.norm * 7)
    for before, after in zip(
        [RAY.centre, *RAY.points, *RAY.vectors],
        [turned.centre, *turned.points, *turned.vectors],
        strict=True,
    ):
        x, y = before
        assert after == (float(cosine * x - sine * y), float(sine * x + cosine * y))
    assert turned.radius == 5 / 7


def test_a_turn_that_stretches_is_refused():
    with pytest.raises(BuilderError, match="keeps lengths"):
        t.turned(FIGURE, t.Turn(3, 4, 6))


def test_only_integers_are_turned():
    with pytest.raises(BuilderError, match="is an int"):
        t.turned(t.as_floats(FIGURE), t.Turn(3, 4, 5))


MIXED = {int, float}


@pytest.mark.parametrize("numbers", t.NUMBER_TYPES)
def test_retyping_keeps_every_value(numbers):
    typed = t.typed(SeededDraw(numbers), FIGURE, numbers)
    assert typed == FIGURE  # 2 == 2.0
    kinds = {type(value) for value in (*typed.centre, typed.radius, *typed.points[0], *typed.points[1])}
    assert (
        kinds
        in {"int": [{int}], "float": [{float}], "mixed": [MIXED], "any": [{int}, {float}, MIXED]}[numbers]
    )


def test_any_numbers_are_of_each_kind_in_a_third_of_the_figures():
    kinds = Counter(
        frozenset(map(type, (*typed.centre, typed.radius, *typed.points[0], *typed.points[1])))
        for typed in (t.typed(SeededDraw(f"any/{n}"), FIGURE, "any") for n in range(300))
    )
    assert set(kinds) == {frozenset({int}), frozenset({float}), frozenset(MIXED)}
    assert min(kinds.values()) > 70


@pytest.mark.parametrize("number", range(100))
def test_a_mixture_holds_both_types(number):
    typed = t.typed(SeededDraw(f"mixed/{number}"), t.as_floats(FIGURE), "mixed")
    assert {type(v) for v in (*typed.centre, typed.radius, *typed.points[0], *typed.points[1])} == MIXED


def test_retyping_what_no_double_holds_is_refused():
    with pytest.raises(BuilderError, match="is a double"):
        t.as_floats(t.moved(FIGURE, 2**54 + 1, 0))
    with pytest.raises(BuilderError, match="numbers is one of"):
        t.typed(SeededDraw(""), FIGURE, "complex")
