"""Programs for sphere and silhouette that nobody derived from mistakes.py: thresholds next to the bands."""

from __future__ import annotations

import pytest

from judge.data import load_data
from judge.data.draw import Rejected, SeededDraw
from judge.data.module import load_module
from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.run.execute import run_submission
from judge.topics.spheres import SphereRay

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


def verdict(name, source):
    problem = find_problem(name)
    return run_submission(problem, load_data(problem), source.encode(), "mine.py").verdict


def sphere(touch="1e-10", start="1e-10", extent=WHOLE):
    source = SPHERE.replace("TOUCH", touch).replace("START", start).replace("EXTENT", extent)
    return verdict("sphere", source)


def silhouette(width="1e-10", extent=FRAME):
    return verdict("silhouette", SILHOUETTE.replace("WIDTH", width).replace("EXTENT", extent))


@pytest.mark.parametrize("width", ["1.1e-12", "1e-11", "1e-9", "9.5e-8"])
def test_any_threshold_in_the_gap_is_right(width):
    assert sphere(touch=width) is Verdict.AC
    assert sphere(start=width) is Verdict.AC
    assert silhouette(width) is Verdict.AC


@pytest.mark.parametrize("width", ["1e-15", "5e-13", "9e-13", "1.2e-7", "1.5e-7", "2e-7"])
def test_a_threshold_just_outside_of_it_is_not(width):
    assert sphere(touch=width) is Verdict.WA
    assert silhouette(width) is Verdict.WA


@pytest.mark.parametrize("width", ["1.2e-7", "1.5e-7", "2e-7"])
def test_an_origin_just_off_the_sphere_is_not_on_it(width):
    assert sphere(start=width) is Verdict.WA


@pytest.mark.parametrize(
    "extent", ["r", "(1 + max(r, *map(abs, f)))", "max(r, *f)", "max(r, *map(abs, (*C, *O)))"]
)
def test_another_extent_is_not_right_for_the_sphere(extent):
    assert sphere("9e-8", extent=extent) is Verdict.WA or sphere("1.2e-12", extent=extent) is Verdict.WA


@pytest.mark.parametrize(
    "extent", ["r", "(1 + max(r, abs(fx), abs(fy)))", "max(r, fx, fy)", "max(map(abs, (x, y, *O)))"]
)
def test_another_extent_is_not_right_for_the_silhouette(extent):
    assert silhouette("9e-8", extent) is Verdict.WA or silhouette("1.2e-12", extent) is Verdict.WA


@pytest.mark.parametrize("pose", ["axis", "exact", "any"])
def test_a_recipe_of_space_uses_all_three_axes(pose):
    module = load_module(find_problem("sphere"))
    build = module.builders["across"]
    tilted = built = 0
    for seed in range(99):
        try:
            case = build(SeededDraw(f"{pose}/{seed}"), where=["ahead"], size=20, poses=[pose])
        except Rejected:
            continue
        ray = SphereRay.of(*case)
        assert module.solve(*case).broken is None
        assert sum(part * part for part in ray.f) > ray.r**2 > 0
        built += 1
        tilted += all(ray.d)
    assert built > 40
    assert tilted == 0 if pose == "axis" else tilted > built / 2


def test_a_promise_says_what_is_broken():
    solve = load_module(find_problem("sphere")).solve
    told = {
        ((0, 0, 0), 1, (-9.0, 1 + 1e-9, 0), (1, 0, 0)): "less the radius is inside the forbidden band",
        ((0, 0, 0), 1, (-1 - 1e-9, 0, 0), (1, 0, 0)): "to the ray's origin is inside the forbidden band",
        ((0, 0, 0), 1, (-90000, 0, 0), (1, 0, 0)): "the radius is not 0, but too small",
    }
    for case, words in told.items():
        assert words in solve(*case).broken
    solve = load_module(find_problem("silhouette")).solve
    told = {
        (((0, 0, 1),), (0, 0), (0, 0), 0.1): "there is no line",
        (((0, 1, 1),), (0, 0), (1, 0), 0.1): "the circle of the first frame is touched",
        (((0, 0, 1), (0, 0.75 + 1e-9, 1)), (0, 0), (1, 0), 0.25): "in frame 2 the distance less a threshold",
    }
    for case, words in told.items():
        assert words in solve(*case).broken
