"""The plain program with a tolerance is right on every valid case, and without one it is wrong on some."""

from __future__ import annotations

from random import Random

import pytest

from judge.geometry import Line
from judge.geometry.plain import AHEAD, AT_ORIGIN, MISS, first_hit

TRIPLES = [(3, 4, 5), (-15, 8, 17), (20, -21, 29), (-696, -697, 985)]


def exactly(*case) -> str:
    ray = Line.ray(*case)
    which = ray.first()
    if which is None:
        return MISS
    return AHEAD if ray.time(which).x else AT_ORIGIN


def on_the_circle(seed: int, count: int):
    """Rays in any direction from a point exactly on a circle, with coordinates of about 45 bits."""
    random = Random(seed)
    for _ in range(count):
        p, q, n = random.choice(TRIPLES)
        k, m = random.randint(1, 2**34), random.randint(0, 2**44)
        unit = 2.0 ** random.choice((0, -20, -90))
        origin = ((p * k + m) * unit, (q * k - m) * unit)
        yield m * unit, -m * unit, n * k * unit, origin, (random.randint(-99, 99), random.randint(-99, 99))


def test_the_tolerant_program_agrees_with_the_exact_ray():
    random = Random(1)
    cases = list(on_the_circle(2, 500))
    for _ in range(1500):
        cx, cy, ox, oy, dx, dy = (random.randint(-4, 4) for _ in range(6))
        cases.append((cx, cy, random.randint(0, 4), (ox, oy), (dx, dy)))
    seen = set()
    for case in cases:
        wanted = exactly(*case)
        seen.add(wanted)
        assert first_hit(*case, tolerance=1e-10) == wanted
        assert first_hit(*case, tolerance=1e-8) == wanted
    assert seen == {MISS, AT_ORIGIN, AHEAD}


def test_the_tolerant_program_sees_turned_touches():
    random, blind = Random(4), 0
    for _ in range(300):
        p, q, n = random.choice(TRIPLES)
        k, m = random.randint(2**30, 2**34), random.randint(1, 2**36)
        case = 0, 0, n * k * 2.0**-20, ((p * k - q * m) * 2.0**-20, (q * k + p * m) * 2.0**-20), (q, -p)
        assert first_hit(*case, tolerance=1e-10) == exactly(*case) == AHEAD
        blind += first_hit(*case) == MISS
    assert blind > 10


def test_without_a_tolerance_an_origin_on_the_circle_is_often_missed():
    cases = list(on_the_circle(3, 400))
    wrong = [case for case in cases if first_hit(*case) != first_hit(*case, tolerance=1e-10)]
    assert len(cases) // 20 < len(wrong) < len(cases)
    assert all(exactly(*case) in (AT_ORIGIN, MISS) for case in wrong)


@pytest.mark.parametrize(
    ("case", "found"),
    [
        ((0, 0, 5, (-10, 3), (1, 0)), AHEAD),
        ((0, 0, 5, (10, 3), (1, 0)), MISS),
        ((0, 0, 5, (3, 4), (-1, 0)), AT_ORIGIN),
        ((0, 0, 5, (-9, 5), (1, 0)), AHEAD),
        ((0, 0, 5, (-9, 6), (1, 0)), MISS),
        ((0, 0, 5, (3, 4), (0, 0)), MISS),
    ],
)
def test_small_rays(case, found):
    assert first_hit(*case) == found
