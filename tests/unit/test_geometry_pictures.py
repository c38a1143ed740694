"""What a picture says and shows: what decides, where the lens looks, which of a sequence is drawn."""

from __future__ import annotations

import re

import pytest

from judge.data.draw import Draw, seeded
from judge.drawing.shapes import Role
from judge.problem.declare import Shown
from judge.problem.find import find_problem
from judge.problem.module import load_module

NEAR = 3e-7


def drawn(kata, *case, given=None):
    problem = find_problem(kata)
    module = load_module(problem)
    exact = module.solve(*case)
    values = {parameter.name: value for parameter, value in zip(problem.parameters, case, strict=True)}
    shown = Shown(problem, values, exact, "what is right", None if given is None else "what is wrong", given)
    return module.hooks.picture(shown)


def geometry(picture):
    return picture.description.partition("; ")[2]


@pytest.mark.parametrize(
    ("kata", "case", "words"),
    [
        ("count", (0, 0, 1, (-1, 1), (1, 1)), "the line touches the circle exactly; e = 1"),
        ("count", (0, 0, 1, (-1, 1 + NEAR), (1, 1 + NEAR)), "the line misses the circle by 3e-7·e"),
        ("segment", (0, 0, 5, (3, 4), (9, 4)), "A is exactly on the circle; e = 9"),
        ("on-circle", (0, 0, 1, (1 - NEAR, 0)), "P is inside the circle by 3e-7·e"),
        ("circle-circle", (0, 0, 1, 3, 0, 2), "the circles touch exactly from outside"),
        (
            "circle-circle",
            (0, 0, 1, 1 - NEAR, 0, 2),
            "one circle is inside the other and away from it by 1.5e-7·e",
        ),
        ("enter-exit", (((3, 0, 1), (5, 0, 1)), (0, 0), (1, 0)), "two hits are at exactly the same place"),
        ("swept-wall", ((0, 5), (0, 3), 3, (-9, 0), (9, 0)), "disc and wall touch exactly at t = 1"),
        ("swept-balls", ((-5, 2), (5, 2), 1, (0, 0), (0, 0), 1), "the discs graze exactly"),
        (
            "sphere",
            ((0, 0, 0), 5, (-9, 3, 4), (1, 0, 0)),
            "the plane through C and the ray, the line touches",
        ),
        (
            "exact-count",
            (0, 0, 10**40, (0, 10**40 + 1), (1, 10**40 + 1)),
            "the line misses the circle by 1e-40·e",
        ),
        ("polygon", (0, 0, 1, [(-2, 1), (2, 1), (0, 5)]), "the line of an edge touches the circle exactly"),
        ("polygon", (0, 0, 1, [(2, 1), (4, 1), (3, 5)]), "the line of an edge touches the circle exactly"),
    ],
)
def test_what_decides_is_said(kata, case, words):
    assert words in geometry(drawn(kata, *case))


def test_the_lens_shows_what_nearly_touches_and_nothing_that_touches_exactly():
    assert drawn("count", 0, 0, 1, (-1, 1), (1, 1)).lens is None
    lens = drawn("count", 0, 0, 1, (-1, 1 + NEAR), (1, 1 + NEAR)).lens
    assert [bar.upright for bar in lens.bars] == [True, False]
    assert lens.title.endswith(" across, not to scale")


def test_an_error_is_seen_before_a_near_touch():
    line = 0, 0, 1, (-2, 1 - NEAR), (2, 1 - NEAR)
    (first, _), (second, _) = (
        (float(x.x), float(y.x)) for x, y in load_module(find_problem("line-points")).solve(*line)
    )
    lens = drawn("line-points", *line, given=[[first, 1 - NEAR], [second + 1e-6, 1 - NEAR]]).lens
    assert lens.title.startswith("Lens: the answer's error")
    assert lens.note.startswith("got 2 is")


def test_the_first_wrong_frame_row_and_ray_are_drawn():
    frames = [(0, 5, 1), (0, 0, 1), (0, 5, 1)]
    assert geometry(drawn("silhouette", frames, (0, 0), (1, 0), 0.25, given=[0, 1, 1])).startswith(
        "frame 2 of 3: 0 is right, not 1"
    )
    rows = [0.0, 0.0], [5.0, 0.0], [1.0, 1.0], (0, 0), (1, 0)
    assert geometry(drawn("vector", *rows, given=[0, 1])).startswith("circle 1 of 2: 2 is right, not 1")
    rays = [(5, 0, 1), (0, 5, 1)], [((0, 0), (1, 0)), ((0, 0), (0, 1))]
    found = drawn("nearest", *rays, given=[[0, 4.0], [0, 4.0]])
    assert geometry(found).startswith("ray 1 of 2")
    assert {mark.text for mark in found.whole.marks if mark.role is Role.WANTED} == {
        "expected circle 1, got circle 0"
    }


@pytest.mark.parametrize("kata", ["normal", "reflect"])
def test_vectors_are_arrows_of_their_roles(kata):
    case = 0, 0, 5, (-9, 3), (1, 0)
    given = [0.0, 1.0] if kata == "normal" else [[-4.0, 3.0], [0.0, 1.0]]
    roles = {stroke.role for stroke in drawn(kata, *case, given=given).whole.strokes if stroke.arrow}
    assert {Role.WANTED, Role.GOT} <= roles


def test_a_moving_disc_is_seen_at_its_start_at_its_end_and_at_each_answer():
    strokes = drawn("swept-balls", (-9, 0), (9, 0), 1, (0, 0), (0, 0), 1, given=0.25).whole.strokes
    rings = [stroke.role for stroke in strokes if len(stroke.dots) > 20 and not stroke.filled]
    assert rings.count(Role.WANTED) == rings.count(Role.GOT) == 2
    assert Role.SHAPE in rings
    assert Role.BEYOND in rings


def plain(words, start, along, *, line):
    """What a plain program finds: (t, circle, tag) of every hit, from the words of a quiz card."""
    found = []
    for label, x, y, r in re.findall(r"circle (\w): centre \((-?\d+), (-?\d+)\), radius (\d+)", words):
        fx, fy = start[0] - int(x), start[1] - int(y)
        a, b = along[0] ** 2 + along[1] ** 2, fx * along[0] + fy * along[1]
        delta = b * b - a * (fx * fx + fy * fy - int(r) ** 2)
        roots = [] if delta < 0 else [0] if delta == 0 else [-(delta**0.5), delta**0.5]
        tags = "t" if delta == 0 else "io"
        found += [((root - b) / a, label, tag) for root, tag in zip(roots, tags, strict=False)]
    return sorted(each for each in found if line or each[0] >= 0)


@pytest.mark.parametrize(
    ("kata", "form"),
    [("ray-nearest", "first-hit"), ("ray-nearest", "order"), ("line-points", "tags"), ("enter-exit", "tags")],
)
def test_a_quiz_figure_has_the_answer_that_a_plain_program_finds(kata, form):
    module = load_module(find_problem(kata))
    seen = set()
    for seed in range(60):
        made = module.hooks.puzzle(form, Draw(seeded(f"quiz {seed}")), module.solve)
        *_, way = made.given
        x, y, u, v = map(int, re.findall(r"-?\d+", way))
        line = kata == "line-points"
        hits = plain("\n".join(made.given), (x, y), (u - x, v - y) if line else (u, v), line=line)
        labels = tuple(dict.fromkeys(label for _, label, _ in hits))
        right = {"first-hit": labels[:1], "order": labels, "tags": tuple(tag for *_, tag in hits)}[form]
        assert made.answer == right, made.given
        seen.add(right)
    assert len(seen) >= 4
    assert module.hooks.puzzle("no such form", Draw(seeded("quiz")), module.solve) is None
