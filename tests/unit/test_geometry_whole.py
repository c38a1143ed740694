"""Whole numbers without a promise: signs, counts and roots, against the formulas of a school book."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from itertools import product
from random import Random

import pytest

from judge.geometry import whole
from judge.problem.declare import InvalidCase


def sevens(seed: int, count: int):
    """cx, cy, r, ax, ay, bx, by, small whole numbers."""
    random = Random(seed)
    for _ in range(count):
        yield tuple(random.randint(0 if i == 2 else -4, 4) for i in range(7))


def parameters(cx, cy, r, ax, ay, bx, by) -> list[float]:
    """The parameters of the common points, which doubles tell from 0 and 1 here."""
    fx, fy, dx, dy = ax - cx, ay - cy, bx - ax, by - ay
    a, b, c = dx * dx + dy * dy, fx * dx + fy * dy, fx * fx + fy * fy - r * r
    delta = b * b - a * c
    if delta < 0:
        return []
    return sorted({(-b - delta**0.5) / a, (-b + delta**0.5) / a})


def test_exact_counts_of_a_line_and_a_segment():
    for numbers in sevens(8, 3000):
        cx, cy, r, ax, ay, bx, by = numbers
        for k in (1, 10**40):
            case = (cx * k, cy * k, r * k, (ax * k, ay * k), (bx * k, by * k))
            if (ax, ay) == (bx, by):
                assert whole.count_line(*case) is None
                assert whole.count_segment(*case) == ((ax - cx) ** 2 + (ay - cy) ** 2 == r * r)
            else:
                ts = parameters(*numbers)
                assert whole.count_line(*case) == len(ts)
                assert whole.count_segment(*case) == sum(-1e-9 < t < 1 + 1e-9 for t in ts)


def test_one_unit_beside_a_touch_or_an_end_decides_at_any_size():
    k = 10**60
    assert [whole.count_line(0, 0, 5 * k, (-1, 5 * k + i), (1, 5 * k + i)) for i in (-1, 0, 1)] == [2, 1, 0]
    ends = [whole.count_segment(0, 0, 5 * k, (0, 0), (3 * k, 4 * k + i)) for i in (-1, 0, 1)]
    assert ends == [0, 1, 1]


def test_a_discriminant_and_its_width():
    for numbers in sevens(9, 300):
        numbers = tuple(x * 1.1 for x in numbers)
        cx, cy, r, ax, ay, bx, by = map(Fraction, numbers)
        dx, dy, fx, fy = bx - ax, by - ay, ax - cx, ay - cy
        found = whole.discriminant(*numbers)
        reach, k, most = r * r * (dx * dx + dy * dy), dx * fy - dy * fx, abs(dx * fy) + abs(dy * fx)
        assert found.value == reach - k * k
        assert found.sign == (found.value > 0) - (found.value < 0)
        assert found.width == (reach + most * abs(k)) / 2**46 + most**2 / 2**98


def test_first_steps():
    random = Random(11)
    for _ in range(500):
        a, b, p = ((random.randint(-5, 5), random.randint(-5, 5)) for _ in range(3))
        assert whole.square(a, p) == round(abs(complex(*a) - complex(*p)) ** 2)
        if a == b:
            for ask in (whole.cross, whole.dot, whole.axis_foot):
                with pytest.raises(InvalidCase, match="the same point"):
                    ask(a, b, p)
            continue
        turned = (complex(*p) - complex(*a)) / (complex(*b) - complex(*a))
        assert (whole.cross(a, b, p) > 0) == (turned.imag > 1e-9)
        middle, reach = Fraction(1, 4), whole.square(a, b)  # of AB, from its centre
        away = (p[0] - Fraction(a[0] + b[0], 2)) ** 2 + (p[1] - Fraction(a[1] + b[1], 2)) ** 2
        assert whole.dot(a, b, p) == away - middle * reach
        if a[0] == b[0] or a[1] == b[1]:
            foot = whole.axis_foot(a, b, p)
            assert foot == ((a[0], p[1]) if a[0] == b[0] else (p[0], a[1]))
        else:
            with pytest.raises(InvalidCase, match="neither level nor upright"):
                whole.axis_foot(a, b, p)


def test_roots_of_small_equations():
    for a, b, c in product(range(-4, 5), repeat=3):
        found = whole.roots(a, b, c)
        if a == b == c == 0:
            assert found is None
            continue
        delta = b * b - a * c
        if a == 0:
            wanted = [Decimal(-c) / (2 * b)] if b else []
        elif delta < 0:
            wanted = []
        else:
            root = Decimal(delta).sqrt()
            wanted = sorted({(-b - root) / a, (-b + root) / a})
        assert [float(real.x) for real in found] == pytest.approx([float(x) for x in wanted], rel=1e-15)


def test_roots_beyond_doubles_are_no_case():
    with pytest.raises(InvalidCase, match="No double holds"):
        whole.roots(1, 2**53 + 1, 1)
    with pytest.raises(InvalidCase, match="No double holds"):
        whole.roots(1, 2**1030, 1)
    assert [real.x for real in whole.roots(1, -(2**60), 0)] == [0, 2**61]
    with pytest.raises(InvalidCase, match="beyond the range"):
        whole.roots(2.0**-600, 2.0**600, 0)
