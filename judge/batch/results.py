"""The results behind rows, as `judge run` has them: for JUnit and the cases of a page."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import msgspec
from msgspec.structs import replace

from judge.batch.model import Row
from judge.mistakes.told import told_mistakes
from judge.problem import Problem
from judge.report.junit import junit
from judge.run.execute import judge_fault
from judge.run.published import result_of
from judge.run.result import Result


def advice_of(problem: Problem) -> dict[str, str]:
    """What is told of each of the problem's mistakes, by name."""
    return {name: told.advice for name, told in told_mistakes(problem).items()}


def results_of(rows: Iterable[Row], problems: Mapping[str, Problem]) -> list[Result]:
    """The result of each row, called by its file within the class's folder.

    `problems` are those that are there; a row of another one is read without points and advice.
    """
    points = {name: {group.name: group.points for group in each.groups} for name, each in problems.items()}
    advice = {name: advice_of(each) for name, each in problems.items()}
    return [_result(row, points.get(row.problem, {}), advice.get(row.problem, {})) for row in rows]


def batch_junit(rows: Iterable[Row], problems: Mapping[str, Problem]) -> bytes:
    """JUnit XML with a suite for each hand-in."""
    return junit(results_of(rows, problems))


def _result(row: Row, points: Mapping[str, int], advice: Mapping[str, str]) -> Result:
    try:
        return replace(result_of(row.result, points, advice), submission=row.file)
    except (
        msgspec.MsgspecError,
        KeyError,
        ValueError,
        TypeError,
    ) as fault:  # kept by a judge of another form
        return judge_fault(row.problem, row.file, f"its result cannot be read ({fault})")
