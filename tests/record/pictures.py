"""Digests of pictures: of two cases of every group, drawn with its answer, with none and with another's."""

from __future__ import annotations

from hashlib import sha256

from judge.data import load_data
from judge.data.module import load_module
from judge.drawing.braille import to_braille
from judge.drawing.svg import to_svg
from judge.problem.find import find_problem
from judge.problem.topic import Shown
from judge.values.reread import reread

_CASES = 2  # of each group


def record(kata: str) -> dict[str, dict[str, str]]:
    """The digests of a kata's pictures, by group and case; none where it has no pictures."""
    problem = find_problem(kata)
    data = load_data(problem)
    module = load_module(problem)
    found: dict[str, dict[str, str]] = {}
    if module.topic.picture is None:
        return found
    for group in data.groups:
        if group.group.size is not None:
            continue  # a big case is not shown
        tolerance = group.group.tolerance
        solved = [(case, module.solve(*case).answer) for case in group.cases[:_CASES]]
        wanted = [problem.answer.wanted(problem.answer.target(exact, tolerance)) for _, exact in solved]
        for place, (case, exact) in enumerate(solved):
            values = {each.name: value for each, value in zip(problem.parameters, case, strict=True)}
            answers = {"right": wanted[place], "none": "None", "wrong": wanted[place - 1]}
            for kind, got in answers.items():
                if kind != "right" and got == wanted[place]:
                    continue
                given = reread(problem.answer, got)
                picture = module.topic.picture(
                    Shown(problem, values, exact, wanted[place], got, given, "a case")
                )
                key = f"{kata}/{group.group.name}/{place} {kind}"
                if picture is None:
                    found[key] = {"svg": "no picture"}
                    continue
                rows = ["".join(piece.text for piece in row) for row in to_braille(picture)]
                found[key] = {"svg": _digest(to_svg(picture)), "braille": _digest("\n".join(rows))}
    return found


def _digest(text: str) -> str:
    return sha256(text.encode()).hexdigest()[:12]
