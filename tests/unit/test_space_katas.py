"""Programs for sphere and silhouette that nobody derived from mistakes.py: thresholds next to the bands."""

from __future__ import annotations

import pytest
from sampling import daily

from judge.data import load_data
from judge.data.module import load_module
from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.run.execute import run_submission

pytestmark = pytest.mark.slow

SPHERE = """
from math import hypot, sqrt

def ray_sphere(C, r, O, D):
    length = hypot(*D)
    if length == 0 or r == 0:
        return None
    f, u = [o - c for o, c in zip(O, C)], [x / length for x in D]
    e = EXTENT
    d = hypot(u[1] * f[2] - u[2] * f[1], u[2] * f[0] - u[0] * f[2], u[0] * f[1] - u[1] * f[0])
    if d > r + TOUCH * e:
        return None
    m = -sum(x * y for x, y in zip(f, u))
    half = sqrt((r - d) * (r + d)) if d < r - TOUCH * e else 0
    for way, side in ((m - half, 1), (m + half, -1)):
        if way * max(map(abs, D)) >= -START * e * length:
            snapped = way * max(map(abs, D)) <= START * e * length
            return (0 if snapped else way / length), [side * (x + way * y) / r for x, y in zip(f, u)]
    return None
"""
SILHOUETTE = """
from math import hypot

def steady_hits(circles, O, D, h):
    shown = []
    for x, y, r in circles:
        fx, fy = O[0] - x, O[1] - y
        d = abs(D[0] * fy - D[1] * fx) / hypot(*D)
        w = WIDTH * EXTENT
        if not shown:
            shown.append(int(d < r))
        else:
            shown.append(int(d <= r * (1 + h) + w if shown[-1] else d < r * (1 - h) - w))
    return shown
"""
WHOLE = "max(r, *map(abs, f))"
FRAME = "max(r, abs(fx), abs(fy))"


def sphere(touch="1e-10", start="1e-10", extent="max(r, *map(abs, f))"):
    return "sphere", SPHERE.replace("TOUCH", touch).replace("START", start).replace("EXTENT", extent)


def silhouette(width="1e-10", extent="max(r, abs(fx), abs(fy))"):
    return "silhouette", SILHOUETTE.replace("WIDTH", width).replace("EXTENT", extent)


def verdict(name, source):
    problem = find_problem(name)
    return run_submission(problem, load_data(problem), source.encode(), "mine.py").verdict


@pytest.mark.parametrize("width", daily(["1.1e-12", "1e-11", "1e-9", "9.5e-8"], ["9.5e-8"]))
def test_any_threshold_in_the_gap_is_right(width):
    for program in (sphere(touch=width), sphere(start=width), silhouette(width)):
        assert verdict(*program) is Verdict.AC


@pytest.mark.parametrize("width", daily(["1e-15", "5e-13", "9e-13", "1.2e-7", "1.5e-7", "2e-7"], ["9e-13"]))
def test_a_threshold_just_outside_of_it_is_not(width):
    programs = [sphere(touch=width), silhouette(width)]
    if float(width) > 1e-7:
        programs.append(sphere(start=width))  # an origin just off the sphere is not on it
    for program in programs:
        assert verdict(*program) is Verdict.WA


SPHERES = ["r", "(1 + max(r, *map(abs, f)))", "max(r, *f)", "max(r, *map(abs, (*C, *O)))"]
FRAMES = ["r", "(1 + max(r, abs(fx), abs(fy)))", "max(r, fx, fy)", "max(map(abs, (x, y, *O)))"]


@pytest.mark.nightly
@pytest.mark.parametrize(
    ("program", "extent"), [*((sphere, each) for each in SPHERES), *((silhouette, each) for each in FRAMES)]
)
def test_another_extent_is_not_right(program, extent):
    assert Verdict.WA in [verdict(*program(width, extent=extent)) for width in ("9e-8", "1.2e-12")]


@pytest.mark.parametrize(
    ("name", "case", "words"),
    [
        ("sphere", ((0, 0, 0), 1, (-9.0, 1 + 1e-9, 0), (1, 0, 0)), "less the radius is inside the forbidden"),
        (
            "sphere",
            ((0, 0, 0), 1, (-1 - 1e-9, 0, 0), (1, 0, 0)),
            "to the ray's origin is inside the forbidden",
        ),
        ("sphere", ((0, 0, 0), 1, (-90000, 0, 0), (1, 0, 0)), "the radius is not 0, but too small"),
        ("silhouette", (((0, 0, 1),), (0, 0), (0, 0), 0.1), "there is no line"),
        ("silhouette", (((0, 1, 1),), (0, 0), (1, 0), 0.1), "the circle of the first frame is touched"),
        (
            "silhouette",
            (((0, 0, 1), (0, 0.75 + 1e-9, 1)), (0, 0), (1, 0), 0.25),
            "in frame 2 the distance less a threshold",
        ),
    ],
)
def test_a_promise_says_what_is_broken(name, case, words):
    assert words in load_module(find_problem(name)).solve(*case).broken
