"""Seeded choices: the same for ever, and spread evenly."""

from __future__ import annotations

from collections import Counter

import pytest

from judge.data.draw import Rejected, SeededDraw


def test_a_seed_gives_the_same_choices_for_ever():
    draw = SeededDraw("7/tangent/0/0")
    assert [draw.integer(0, 99) for _ in range(8)] == [57, 6, 70, 57, 42, 91, 40, 45]
    assert draw.integer(-(10**20), 10**20) == 69281910163037784728


def test_other_seeds_give_other_choices():
    drawn = {tuple(SeededDraw(f"7/tangent/0/{n}").integer(0, 10**9) for _ in range(2)) for n in range(100)}
    assert len(drawn) == 100


@pytest.mark.parametrize(("low", "high"), [(0, 0), (5, 5), (-3, 3), (0, 255), (-(10**40), 10**40)])
def test_integers_stay_within_both_ends(low, high):
    draw = SeededDraw(f"{low}")
    drawn = [draw.integer(low, high) for _ in range(300)]
    assert min(drawn) >= low
    assert max(drawn) <= high
    if high - low < 10:
        assert set(drawn) == set(range(low, high + 1))


def test_integers_are_evenly_spread():
    draw = SeededDraw("even")
    counts = Counter(draw.integer(0, 4) for _ in range(5000))
    assert all(850 < counts[value] < 1150 for value in range(5))


def test_choices_wider_than_a_block_of_bits():
    draw = SeededDraw("wide")
    drawn = draw.integer(0, 2**4000 - 1)
    assert drawn.bit_length() > 3900
    assert drawn != draw.integer(0, 2**4000 - 1)


def test_choice_sign_and_boolean_reach_everything():
    draw = SeededDraw("all")
    assert {draw.choice("abc") for _ in range(60)} == {"a", "b", "c"}
    assert {draw.sign() for _ in range(60)} == {-1, 1}
    assert {draw.boolean() for _ in range(60)} == {False, True}


def test_impossible_choices_are_refused():
    draw = SeededDraw("none")
    with pytest.raises(ValueError, match="no integer from 1 to 0"):
        draw.integer(1, 0)
    with pytest.raises(ValueError, match="nothing to choose from"):
        draw.choice([])
    with pytest.raises(Rejected):
        draw.reject()
