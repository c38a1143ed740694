"""The cases whose pictures are kept, and drawing one; `python tests/golden/picture_cases.py` renews them."""

from __future__ import annotations

from pathlib import Path

from judge.data.module import load_module
from judge.drawing.svg import to_svg
from judge.problem.load import load_problem
from judge.problem.topic import Shown
from judge.values.reread import reread

ROOT = Path(__file__).parent.parent.parent
FOLDER = Path(__file__).parent / "pictures"
HUGE = 10**100
FAR = 2**27

# name: problem, case, the submission's answer in the words that a person is shown
CASES = {
    "tangent": ("count", (0, 0, 5, (-7, 1), (1, 7)), "2"),
    "near-miss": ("count", (0.0, 0.0, 1.0, (-2.0, 1.000000002), (3.0, 1.000000002)), "1"),
    "offset": ("count", (FAR, FAR, 5, (FAR - 7, FAR + 1), (FAR + 1, FAR + 7)), "0"),
    "segment-end": ("segment", (0, 0, 1, (3, 0.5), (0.8660254137844386, 0.5)), "[(0.8660254, 0.5)]"),
    "extra-point": ("segment", (0, 0, 5, (-7, 5), (7, 5)), "[(0.0, 5.0), (0.0, 5.0)]"),
    "point-given-wrong": (
        "segment",
        (0, 0, 5, (-7, 2), (7, -1)),
        "[(-4.7631449, 1.5206739), (4.968023, -0.5645764)]",
    ),
    "ray-on-circle": ("ray-nearest", (0, 0, 5, (3, 4), (-1, -2)), "4.4"),
    "exact-hairline": ("exact-count", (0, 0, HUGE**2, (0, HUGE**2 - 1), (HUGE**2, HUGE**2 - 1)), "1"),
    "tangents": ("tangents", (2, 2, 2, (-3, 0)), "[(2.0, 0.0), (0.6, 3.4)]"),
    "nearly-on": ("tangents", (0.0, 0.0, 1.0, (0.0, 1.0000002)), "[(0.0, 1.0000002)]"),
    "two-circles": ("circle-circle", (0, 0, 5, 6, 2, 3), "[(3.9, -1.8)]"),
    "nearly-touching": ("circle-circle", (0.0, 0.0, 1.0, 3.0, 0.0, 1.9999996), "[(1.0, 0.0)]"),
    "common-tangents": ("common-tangents", (1, 1, 1, 6, 2, 2), "[(0.6, 1.9), (1.0, 0.0), (1.4, 1.0)]"),
    "many-hits": (
        "enter-exit",
        (((5, 0, 1), (6, 0, 1), (2, 2, 2), (-3, 1, 4)), (0, 0), (1, 0)),
        "[(0.8729833, 3, 'exit'), (4.0, 0, 'enter'), (5.0, 1, 'exit'), (6.0, 0, 'enter'), (7.0, 1, 'exit')]",
    ),
    "spans": (
        "csg",
        (((5, 0, 2), (6, 1, 1.5), (9, -2, 2), (0, 3, 3.5)), (0, 0), (2, 0), (0, 1, -3, 2, -1, 3, -1)),
        "[(0.0, 0.9013878), (1.5, 3.5)]",
    ),
    "in-the-dark": ("shadow", (((5, 0, 1), (2, 4, 1), (8, 6, 2)), (0, 0), (1, 0), (0, 8)), "lit"),
    "lit-from-inside": ("shadow", (((0, 0, 5), (1, -2, 1)), (1, 0), (1, 1), (0, 3)), "dark"),
    "hits-nearly-touch": (
        "enter-exit",
        (((5.0, 1.0, 0.9999997), (2.0, -1.0, 2.0)), (0.0, 0.0), (3.0, 0.0)),
        "[(1.2440169, 1, 'exit'), (1.6666667, 0, 'touch')]",
    ),
    "normal": ("normal", (0, 0, 5, (1, 2), (3, 1)), "(0.6, 0.8)"),
    "normal-at-a-touch": ("normal", (0, 0, 5, (-9, 5), (2, 0)), "(0.0, 5.0)"),
    "reflected": ("reflect", (0, 0, 5, (-10, 3), (4, 0)), "((-4.0, 3.0), (2.56, 1.92))"),
    "reflected-inside": ("reflect", (0, 0, 5, (1, 2), (3, 1)), "((4.0, 3.0), (1.5, 0.5))"),
    "polygon": (
        "polygon",
        (0, 0, 5, [(-6, -6), (6, -6), (8, 3), (0, 5), (-6, 1)]),
        "[(2, (4.0, 3.0)), (2, (0.0, 5.0)), (3, (0.0, 5.0))]",
    ),
    "polygon-corner": (
        "polygon",
        (0.0, 0.0, 1.0, [(0.0, 1.0000004), (2.0, 2.0), (-2.0, 2.0)]),
        "[(0, (0.0, 1.0000004))]",
    ),
    "hostile": ("segment", (0, 0, 5, (-7, 2), (7, -1)), "<script>\"'&\x00\x1b[2J]]>\ud800\u202e"),
    "distance": ("distance", ((0, 0), (3, 4), (5, 0)), "2.5"),
    "foot": ("foot", ((0, 0), (3, 4), (2, 5)), "(1.0, (3.0, 4.0))"),
    "normals": ("normal-form", ((3, 0), (1, 5)), "(0.928, 0.371, -2.78)"),
    "on-circle": ("on-circle", (0, 0, 5, (3, 4.000002)), "0"),
    "moving-discs": ("swept-balls", ((0, 0), (10, 2), 2, (9, 6), (5, -4), 1), "0.61"),
    "nearly-grazing": (
        "swept-balls",
        ((0.0, 0.0), (8.0, 0.0), 1, (4.0, 2.0000004), (4.0, 2.0000004), 1),
        "0.5",
    ),
    "fast-disc": ("swept-balls", ((-500, 3), (700, -2), 1, (20, 0), (20, 30), 2), "0.43"),
    "wall-end": ("swept-wall", ((-13, 8), (9, -3), 4, (0, 0), (9, 2)), "0.58"),
    "wall-grazed": ("swept-wall", ((-9.0, 3.0000004), (9.0, 3.0000004), 3, (0.0, 0.0), (4.0, -3.0)), "0.5"),
    "wall-fast": ("swept-wall", ((-300, 800), (310, -700), 2, (-9, 0), (9, 0)), "0.53"),
    "chord": ("chord", (0, 0, 5, (-6, 3), (6, 3)), "4.0"),
    "silhouette": (
        "silhouette",
        (((0, 0, 1), (0.2, 0.995, 1), (0, 1.005, 1), (0.3, 1.02, 1), (0, 1.005, 1)), (-5, 0), (1, 0), 0.01),
        "[1, 1, 0, 0, 1]",
    ),
    "sphere": ("sphere", ((0, 0, 0), 5, (1, 2, 3), (3, -1, 0.5)), "(0.82, (0.69, 0.24, 0.68))"),
    "nearest": (
        "nearest",
        (((30, 4, 8), (12, -3, 4), (20, 20, 6)), (((0, 0), (5, 5)), ((0, 0), (3, 0)))),
        "[(2, 3.15147187), (0, 7.69059898)]",
    ),
    "beams": (
        "beams",
        (((20, 5, 5), (40, 0, 20)), (0, 0), ((4, -1), (1, 0), (4, 1))),
        "[(1, 5.2), None, (0, 3.8)]",
    ),
    "vector": ("vector", ((0.0, 9.0), (3.0, 4.0), (3.0, 2.0), (0, 0), (5, 0)), "[1, 2]"),
}


def wanted_words(problem, exact):
    return problem.answer.wanted(problem.answer.target(exact, problem.groups[0].tolerance))


def picture_of(problem, case, got, module=None, heading="a case"):
    module = module or load_module(problem)
    exact = module.solve(*case).answer
    values = {parameter.name: value for parameter, value in zip(problem.parameters, case, strict=True)}
    given = reread(problem.answer, got)
    words = wanted_words(problem, exact)
    return module.topic.picture(Shown(problem, values, exact, words, got, given, heading))


def drawn(name):
    problem, case, got = CASES[name]
    return to_svg(picture_of(load_problem(ROOT / "problems" / problem), case, got, heading=name))


if __name__ == "__main__":
    for each in CASES:
        (FOLDER / f"{each}.svg").write_text(drawn(each), encoding="utf-8", newline="\n")
