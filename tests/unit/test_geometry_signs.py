"""Scenes of whole numbers: what they say of the number that decides holds, and they stay within reach."""

from __future__ import annotations

import pytest

from judge.data.draw import Draw, Rejected, seeded
from judge.geometry import whole
from judge.geometry.scenes import signs, tried

REACHES = 6, 100, 10**9


def drawn(scene, count=120):
    """What the scene draws from that many seeds."""
    found = []
    for seed in range(count):
        try:
            found.append(scene(Draw(seeded(f"signs/{seed}"))))
        except Rejected:
            continue
    assert len(found) > count // 5
    return found


def numbers(case):
    """All the numbers of a case."""
    return [n for part in case for n in (part if isinstance(part, tuple) else (part,))]


@pytest.mark.parametrize("reach", REACHES)
def test_a_point_beside_a_line(reach):
    for off, found in ((0, {0}), (1, {1, 2, -1, -2}), (-3, {3, 6, -3, -6})):
        cases = drawn(signs.beside_line((reach,), off))
        assert {whole.cross(*case) for case in cases} <= found
        assert max(map(abs, numbers(sum(cases, ())))) <= reach


@pytest.mark.parametrize("reach", REACHES)
@pytest.mark.parametrize("off", [0, 1, -2])
def test_a_right_angle(reach, off):
    assert {whole.dot(*case) for case in drawn(signs.right_angles((reach,), off))} == {off}


@pytest.mark.parametrize("reach", REACHES)
@pytest.mark.parametrize("off", [0, 1, -1])
def test_a_point_beside_a_circle(reach, off):
    cases = drawn(signs.beside_circle((reach,), off))
    assert {whole.square((cx, cy), P) - r * r for cx, cy, r, P in cases} == {off}
    if reach == 10**9:
        assert max(r for _, _, r, _ in cases) > 10**8


@pytest.mark.parametrize("close", [False, True])
def test_a_line_that_touches_or_nearly_does(close):
    deltas = [
        whole.discriminant(cx, cy, r, *A, *B).value
        for cx, cy, r, A, B in drawn(tried(signs.cuts(20, close=close)))
    ]
    if not close:
        assert set(deltas) == {0}
    else:
        assert 0 not in deltas
        assert {delta > 0 for delta in deltas} == {True, False}


def test_a_level_line_is_one():
    for A, B, P in drawn(signs.level((4, 100))):
        assert whole.axis_foot(A, B, P) in {(P[0], A[1]), (A[0], P[1])}


def test_a_point_across_a_way():
    for way in ((3, 7), (1, 0), (0, 1), (1, 5), (8, 1)):
        for product in (-7, 0, 1, 12):
            x, y = signs.across(way, product, 2)
            assert way[0] * y - way[1] * x == product
