"""The cases whose pictures are kept, and drawing one; `python tests/golden/picture_cases.py` renews them."""

from __future__ import annotations

import ast
from pathlib import Path
from typing import Any

from judge.drawing.svg import panel_svg
from judge.problem.declare import Shown
from judge.problem.load import load_problem
from judge.problem.module import load_module
from judge.values import check, show

ROOT = Path(__file__).parent.parent.parent
FOLDER = Path(__file__).parent / "pictures"
HUGE = 10**100
FAR = 2**27

# name: problem, case, the submission's answer in the words that a person is shown
CASES = {
    "near-miss": ("count", (0.0, 0.0, 1.0, (-2.0, 1.000001), (3.0, 1.000001)), "1"),
    "offset": ("count", (FAR, FAR, 5, (FAR - 7, FAR + 1), (FAR + 1, FAR + 7)), "0"),
    "segment-end": ("segment", (0, 0, 1, (3, 0.5), (0.8660264, 0.5)), "[(0.8660254, 0.5)]"),
    "extra-point": ("segment", (0, 0, 5, (-7, 5), (7, 5)), "[(0.0, 5.0), (0.0, 5.0)]"),
    "exact-hairline": ("exact-count", (0, 0, HUGE**2, (0, HUGE**2 - 1), (HUGE**2, HUGE**2 - 1)), "1"),
    "many-hits": (
        "enter-exit",
        (((5, 0, 1), (6, 0, 1), (2, 2, 2), (-3, 1, 4)), (0, 0), (1, 0)),
        "[(0.8729833, 3, 'exit'), (4.0, 0, 'enter'), (5.0, 1, 'exit'), (6.0, 0, 'enter'), (7.0, 1, 'exit')]",
    ),
    "fast-disc": ("swept-balls", ((-500, 3), (700, -2), 1, (20, 0), (20, 30), 2), "0.43"),
    "polygon-corner": (
        "polygon",
        (0.0, 0.0, 1.0, [(0.0, 1.0000004), (2.0, 2.0), (-2.0, 2.0)]),
        "[(0, (0.0, 1.0000004))]",
    ),
    "sphere": ("sphere", ((0, 0, 0), 5, (1, 2, 3), (3, -1, 0.5)), "(0.82, (0.69, 0.24, 0.68))"),
    "hostile": ("segment", (0, 0, 5, (-7, 2), (7, -1)), "<script>\"'&\x00\x1b[2J]]>\ud800\u202e"),
}


def given_by(text: str) -> Any:
    """The answer that a person is shown in these words, as JSON; None where it is no answer."""
    try:
        return plain(ast.literal_eval(text))
    except (SyntaxError, ValueError):
        return None


def plain(value: Any) -> Any:
    if isinstance(value, list | tuple):
        return [plain(each) for each in value]
    return {"word": value} if isinstance(value, str) else value


def wanted_words(problem, exact):
    return show.wanted(problem.answer, check.target(problem.answer, exact, problem.groups[0].tolerance))


def picture_of(problem, case, got, module=None):
    module = module or load_module(problem)
    exact = module.solve(*case)
    values = {parameter.name: value for parameter, value in zip(problem.parameters, case, strict=True)}
    given = given_by(got)
    words = wanted_words(problem, exact)
    return module.hooks.picture(Shown(problem, values, exact, words, got, given))


def picture(name):
    problem, case, got = CASES[name]
    return picture_of(load_problem(ROOT / "problems" / problem), case, got)


def to_svg(drawn):
    """The panels of a picture, one below the other."""
    return "".join(f"{panel_svg(panel, 'p', drawn.description, alone=True)}\n" for panel in drawn.panels)


if __name__ == "__main__":
    for each in CASES:
        (FOLDER / f"{each}.svg").write_text(to_svg(picture(each)), encoding="utf-8", newline="\n")
