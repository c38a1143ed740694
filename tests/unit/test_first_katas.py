"""Programs that nobody derived from mistakes.py: thresholds next to band and promise, other ways, int64."""

from __future__ import annotations

import pytest

from judge.data import load_data
from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.run.execute import run_submission

ON_CIRCLE = """
from math import hypot

def on_circle(cx, cy, r, P):
    fx, fy = P[0] - cx, P[1] - cy
    gap = hypot(fx, fy) - r
    if abs(gap) <= WIDTH * max(r, abs(fx), abs(fy)):
        return 0
    return 1 if gap > 0 else -1
"""
BEFORE = """
from math import hypot, sqrt

def ENTRY(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    length = hypot(dx, dy)
    if length == 0:
        return None
    ax, ay, bx, by = A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy
    side = (dx * ay - dy * ax) / length
    x, y = cx - side * dy / length, cy + side * dx / length
    gap = r - abs(side)
    touch = abs(gap) <= WIDTH * EXTENT
    half = 0 if touch or gap < 0 else sqrt(gap * (r + abs(side)))
    hx, hy = half * dx / length, half * dy / length
"""
EXTENT = "max(r, abs(ax), abs(ay), abs(bx), abs(by))"
CHORD = BEFORE.replace("ENTRY", "chord_length") + "    return 2 * half if touch or gap > 0 else None\n"
POINTS = (
    BEFORE.replace("ENTRY", "line_points")
    + """
    if touch:
        return [(x, y)]
    return [(x - hx, y - hy), (x + hx, y + hy)] if gap > 0 else []
"""
)
KATAS = {"on-circle": ON_CIRCLE, "chord": CHORD, "line-points": POINTS}


def verdict(name, source):
    problem = find_problem(name)
    return run_submission(problem, load_data(problem), source.encode(), "mine.py").verdict


@pytest.mark.parametrize("name", KATAS)
@pytest.mark.parametrize("width", ["1.1e-12", "1e-11", "1e-9", "9.5e-8"])
def test_any_threshold_in_the_gap_is_right(name, width):
    assert verdict(name, KATAS[name].replace("WIDTH", width).replace("EXTENT", EXTENT)) is Verdict.AC


@pytest.mark.parametrize("name", KATAS)
@pytest.mark.parametrize("width", ["1e-15", "5e-13", "9e-13", "1.2e-7", "1.5e-7", "2e-7"])
def test_a_threshold_just_outside_of_it_is_not(name, width):
    assert verdict(name, KATAS[name].replace("WIDTH", width).replace("EXTENT", EXTENT)) is Verdict.WA


@pytest.mark.parametrize("name", ["chord", "line-points"])
@pytest.mark.parametrize(
    "extent",
    [
        "r",
        "hypot(dx, dy)",
        "max(r, abs(ax), abs(ay))",
        "max(r, abs(bx), abs(by))",
        "max(r, abs(ax), abs(bx))",
        "max(r, abs(ay), abs(by))",
        "max(r, ax, ay, bx, by)",
        "(1 + max(r, abs(ax), abs(ay), abs(bx), abs(by)))",
        "max(map(abs, (cx, cy, r, *A, *B)))",
    ],
)
def test_another_length_than_the_extent_is_wrong(name, extent):
    assert verdict(name, KATAS[name].replace("WIDTH", "1e-10").replace("EXTENT", extent)) is Verdict.WA


FOOT = """
def foot(A, B, C):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if NONE:
        return None
    t = ((C[0] - A[0]) * dx + (C[1] - A[1]) * dy) / (dx * dx + dy * dy)
    return t, (A[0] + t * dx, A[1] + t * dy)
"""
DISTANCE = """
from math import hypot

def distance(A, B, P):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if NONE:
        return None
    return abs(dx * (A[1] - P[1]) - dy * (A[0] - P[0])) / hypot(dx, dy)
"""
NORMAL = """
from math import hypot

def normal_form(A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if NONE:
        return None
    a, b = -dy / hypot(dx, dy), dx / hypot(dx, dy)
    return a, b, -a * B[0] - b * B[1]
"""
LINES = {"foot": FOOT, "distance": DISTANCE, "normal-form": NORMAL}
NONES = [
    "abs(dx) < 1e-12 and abs(dy) < 1e-12",
    "abs(dx) + abs(dy) <= 1e-13 * max(abs(A[0]), abs(A[1]))",
    "dx == 0 or dy == 0",
    "False",
]


@pytest.mark.parametrize("name", LINES)
def test_only_equal_points_are_no_line(name):
    assert verdict(name, LINES[name].replace("NONE", "dx == 0 and dy == 0")) is Verdict.AC
    for none in NONES:
        assert verdict(name, LINES[name].replace("NONE", none)) in (Verdict.WA, Verdict.RTE), none


WHOLE_FOOT = """import numpy as np
def foot(A, B, C):
    a, b, c = map(np.array, (A, B, C))
    d = b - a
    if not d.any():
        return None
    t = float((c - a) @ d) / float(d @ d)
    return t, tuple(a + t * d)
"""
WHOLE_CIRCLE = """import numpy as np
def on_circle(cx, cy, r, P):
    v = np.array([cx, cy, r, *P])
    x, y = v[3] - v[0], v[4] - v[1]
    area, e = x * x + y * y - v[2] * v[2], float(max(v[2], abs(x), abs(y)))
    if abs(float(area)) <= 2e-10 * e * e:
        return 0
    return 1 if area > 0 else -1
"""
FLOATS = "\nfloats = lambda values: np.array(values, dtype=float)\ndef "


@pytest.mark.parametrize(("name", "source"), [("foot", WHOLE_FOOT), ("on-circle", WHOLE_CIRCLE)])
def test_64_bits_are_too_few(name, source):
    assert verdict(name, source) is Verdict.WA
    assert verdict(name, source.replace("np.array", "floats").replace("\ndef ", FLOATS, 1)) is Verdict.AC
