"""Recipes of motions do what they say, and every border lies where a threshold can be measured."""

from __future__ import annotations

from pathlib import Path

import pytest

from judge.data.draw import Rejected, SeededDraw
from judge.data.module import load_module
from judge.problem.load import load_problem
from judge.topics.circles.motion import ball_recipes, wall_recipes

PROBLEMS = Path(__file__).parents[2] / "problems"
POSES = ("axis", "exact", "any")
COUNT = 40


def drawn(recipe, seed, **parameters):
    """So many figures of a recipe."""
    figures = []
    for number in range(60 * COUNT):
        try:
            figures.append(recipe(SeededDraw(f"{seed} {number}"), **parameters))
        except Rejected:
            continue
        if len(figures) == COUNT:
            return figures
    raise AssertionError("too many are rejected")


def moments(name, cases):
    """When they touch in each case, as doubles; every one keeps the promise."""
    solve = load_module(load_problem(PROBLEMS / name)).solve
    answers = [solve(*case) for case in cases]
    assert {solved.broken for solved in answers} == {None}
    return [None if solved.answer is None else float(solved.answer.x) for solved in answers]


def kind_of(t):
    return "none" if t is None else "start" if t == 0 else "in time"


@pytest.mark.parametrize(
    ("kinds", "wanted"),
    [
        (["hit", "fast", "rush", "graze"], {"in time"}),
        (["short", "pass", "away", "graze-late", "graze-behind", "rest-apart"], {"none"}),
        (["overlap", "touching", "rest-overlap", "rest-touching"], {"start"}),
    ],
)
@pytest.mark.parametrize("drift", ["any", "still", "along", "against", "alone"])
def test_two_discs_do_what_their_kind_says(kinds, wanted, drift):
    for kind in kinds:
        figures = drawn(ball_recipes.balls, kind, kinds=[kind], size=40, poses=POSES, drifts=[drift])
        found = moments("swept-balls", map(ball_recipes.two_balls, figures))
        assert {kind_of(t) for t in found} == wanted, kind


@pytest.mark.parametrize(
    ("kinds", "at", "wanted"),
    [
        (["hit", "straight", "fast"], ["side", "cap", "post"], {"in time"}),
        (["graze"], ["cap", "post"], {"in time"}),
        (["slide", "flat"], ["side"], {"in time"}),
        (["short", "away", "rest"], ["side", "cap", "post"], {"none"}),
        (["graze-late", "graze-behind"], ["cap", "post"], {"none"}),
        (["beside"], ["side"], {"none"}),
        (["overlap", "touching"], ["side", "cap", "post"], {"start"}),
    ],
)
def test_a_disc_and_a_wall_do_what_their_kind_says(kinds, at, wanted):
    for kind in kinds:
        for place in at:
            figures = drawn(wall_recipes.wall, kind, kinds=[kind], at=[place], size=30, poses=POSES)
            found = moments("swept-wall", map(wall_recipes.wall_case, figures))
            assert {kind_of(t) for t in found} == wanted, (kind, place)


@pytest.mark.parametrize("kind", ["graze", "start", "end"])
@pytest.mark.parametrize("edge", ["snap", "clear", "within", "beyond"])
def test_an_edge_has_cases_on_both_sides(kind, edge):
    """A window that a figure misses is a fault of the recipe, which it raises."""
    given = {"kinds": [kind], "edges": [edge], "poses": POSES, "scales": [0, -20]}
    balls = drawn(ball_recipes.edge, kind, **given)
    walls = drawn(wall_recipes.edge, kind, at=["side", "cap"], **given)
    for name, cases in (
        ("swept-balls", map(ball_recipes.two_balls, balls)),
        ("swept-wall", map(wall_recipes.wall_case, walls)),
    ):
        found = {kind_of(t) for t in moments(name, cases)}
        assert len(found) > 1 or edge in ("snap", "within"), (name, found)


@pytest.mark.parametrize("name", ["swept-balls", "swept-wall"])
def test_an_answer_turns_at_every_border(name):
    problem = load_problem(PROBLEMS / name)
    module = load_module(problem)
    found = module.topic.borders(problem)
    assert [border.about for border in found] == ["a graze", "a touch at the start", "a touch at the end"]
    for border in found:
        assert len(border.probes) == 9
        assert len({tuple(probe.sizes.values()) for probe in border.probes}) == 9
        for probe in border.probes:
            for share, touches in ((0, True), (border.within / 2, True), (2 * border.beyond, False)):
                case, _ = probe.at(share * probe.size)
                solved = module.solve(*case)
                assert solved.broken is None, (border.about, case)
                assert (solved.answer is not None) is touches, (border.about, case)
            case, _ = probe.at(probe.widest * probe.size)
            assert module.solve(*case).broken is None, (border.about, case)
