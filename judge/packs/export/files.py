"""A test group as files for other tools: a program's input, its answers, and every case with exact values."""

from __future__ import annotations

import json
from collections.abc import Iterator

from judge.data.load import GroupData, ProblemData
from judge.problem import Problem
from judge.run.program import render_group
from judge.values import show
from judge.values.answers import Exact

SCHEMA = 1


def group_files(data: ProblemData, group: GroupData) -> Iterator[tuple[str, str]]:
    """The files of one group: `<group>.in`, `<group>.ans` and `<group>.json`, each as name and text.

    Raises:
        ProblemError: the reference fails on a case.
    """
    name = group.group.name
    answers = [data.exact(case, group.group)[0] for case in group.cases]
    answer = data.problem.answer
    yield f"{name}.in", render_group(data.problem, group.cases).decode()
    yield f"{name}.ans", "".join(f"{show.line(answer, target)}\n" for target in group.targets)
    yield f"{name}.json", _document(data.problem, group, answers)


def _document(problem: Problem, group: GroupData, answers: list[Exact]) -> str:
    """The group's object, a case on each line."""
    head = {
        "schema": SCHEMA,
        "problem": problem.id,
        "group": group.group.name,
        "seed": group.group.seed,
        "entry": problem.entry,
    }
    names = [parameter.name for parameter in problem.parameters]
    cases = [
        json.dumps(
            {
                "input": dict(zip(names, case, strict=True)),
                "expected": show.exact_text(answer),
                "accepted": show.accepted(problem.answer, target),
            }
        )
        for case, answer, target in zip(group.cases, answers, group.targets, strict=True)
    ]
    return json.dumps(head)[:-1] + ', "cases": [\n' + ",\n".join(cases) + "\n]}\n"
