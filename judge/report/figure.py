"""The figure of a statement, figure.svg: its first example that can be drawn, with the answer."""

from __future__ import annotations

from judge.drawing.svg import panel_svg
from judge.problem import Problem
from judge.problem.declare import Shown
from judge.problem.module import load_module
from judge.values import show

FIGURE = "figure.svg"


def figure(problem: Problem) -> str | None:
    """The SVG; None where the problem draws none of its examples."""
    module = load_module(problem)
    draw = module.hooks.picture
    if draw is None:
        return None
    names = [parameter.name for parameter in problem.parameters]
    for example in problem.examples:
        values = dict(zip(names, example.case, strict=True))
        exact = module.solve(*example.case)
        picture = draw(Shown(problem, values, exact, str(show.exact_text(exact)), None, heading="example"))
        if picture is not None:
            return panel_svg(picture.whole, "figure", picture.description, alone=True) + "\n"
    return None
