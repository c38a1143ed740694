"""A test group as files for other tools: a program's input, its answers, and every case with exact values."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

from judge.compare.answers import Answer, Count, Parameter
from judge.compare.targets import to_json
from judge.compare.text import render
from judge.data.model import GroupData, ProblemData
from judge.exact import Surd
from judge.problem import Case, Problem
from judge.run.program import render_group

SCHEMA = 1
_DIGITS = 40  # of an irrational number's decimal text, correctly rounded


def group_files(data: ProblemData, group: GroupData) -> Iterator[tuple[str, str]]:
    """The files of one group: `<group>.in`, `<group>.ans` and `<group>.json`, each as name and text.

    Raises:
        ProblemError: the reference fails on a case.
    """
    name = group.group.name
    answers = [data.exact(case, group.group)[0] for case in group.cases]
    kind = data.problem.answer
    yield f"{name}.in", render_group(group.cases).decode()
    yield f"{name}.ans", "".join(f"{render(kind, answer)}\n" for answer in answers)
    yield f"{name}.json", _document(data.problem, group, answers)


def _document(problem: Problem, group: GroupData, answers: list[Answer]) -> str:
    """The group's object, a case on each line."""
    head = {
        "schema": SCHEMA,
        "problem": problem.id,
        "group": group.group.name,
        "seed": group.group.seed,
        "entry": problem.entry,
    }
    cases = [
        json.dumps({"input": _named(problem, case), "expected": exact_text(answer), "accepted": accepted})
        for case, answer, accepted in zip(group.cases, answers, _intervals(group), strict=True)
    ]
    return json.dumps(head)[:-1] + ', "cases": [\n' + ",\n".join(cases) + "\n]}\n"


def _named(problem: Problem, case: Case) -> dict[str, Any]:
    return {parameter.name: value for parameter, value in zip(problem.parameters, case, strict=True)}


def exact_text(answer: Answer) -> Any:
    """An exact answer as JSON: a count as it is, other numbers as decimal text of up to 40 digits."""
    if isinstance(answer, Count):
        return answer.value
    if isinstance(answer, Parameter):
        return None if answer.t is None else _decimal(answer.t)
    return [[_decimal(x), _decimal(y)] for x, y in answer.points]


def _decimal(value: Surd) -> str:
    return value.decimal(_DIGITS)


def _intervals(group: GroupData) -> Iterator[Any]:
    """What each case accepts: its count, or the least and the greatest double for each number."""
    for target in group.targets:
        yield _ends(to_json(target))


def _ends(plain: Any) -> Any:
    """Of every number [low, high, nearest, residual, ulp] within `plain` the first two."""
    if not isinstance(plain, list | tuple):
        return plain
    if plain and isinstance(plain[0], list | tuple):
        return [_ends(part) for part in plain]
    return list(plain[:2])
