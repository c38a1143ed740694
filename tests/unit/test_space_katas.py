"""Thresholds and extents next to the bands of sphere and silhouette."""

from __future__ import annotations

import pytest
from sampling import daily

from judge.data import load_data
from judge.data.module import load_module
from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.run.execute import run_submission

pytestmark = pytest.mark.slow

SPHERE = (find_problem("sphere").solutions / "accepted" / "foot_and_half_chord.py").read_text()
SILHOUETTE = (find_problem("silhouette").solutions / "accepted" / "state_machine.py").read_text()
EXTENT = "max(r, abs(fx), abs(fy), abs(fz))"
FRAME = "max(r, abs(fx), abs(fy))"


def replaced(text, **changes):
    for old, new in changes.items():
        assert old in text
        text = text.replace(old, new)
    return text


def sphere(touch="1e-10", start="1e-10", extent=EXTENT):
    changes = {f"1e-10 * {EXTENT}": extent}
    changes |= {f"gap {sign}near": f"gap {sign}{touch} * near" for sign in ("< -", "> ")}
    way = "way * max(map(abs, D)) / length"  # along the axis that the ray follows most
    changes |= {f"way {sign}near": f"{way} {sign}{start} * near" for sign in (">= -", "> ")}
    return "sphere", replaced(SPHERE, **changes)


def silhouette(width="1e-10", extent=FRAME):
    return "silhouette", replaced(SILHOUETTE, **{f"1e-10 * {FRAME}": f"{width} * {extent}"})


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


SPHERES = ["r", f"(1 + {EXTENT})", "max(r, fx, fy, fz)", "max(r, *map(abs, (*C, *O)))"]
FRAMES = ["r", f"(1 + {FRAME})", "max(r, fx, fy)", "max(map(abs, (x, y, *O)))"]


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
