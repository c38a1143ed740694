"""Holding a routine of your own code base against the exact reference, in its own tests.

    from judge.testing import judge_problem

    def test_count():
        judge_problem("count").check(my_count)

The routine is called in this process, so it is trusted; `judge run` contains what is not. What it does to
Decimal's context, the state of `random` and of numpy, the recursion limit and the filters of warnings lasts
for a test group and is undone then. With the pytest plug-in of this distribution each test group becomes a
test of its own; see `judge.pytest_plugin`.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property
from pathlib import Path
from textwrap import wrap
from typing import Any

from msgspec import Struct

from judge.data.load import ProblemData, load_data
from judge.errors import UsageError
from judge.judging.inprocess import Held, Routine, check_routine, explain_routine, routine_name
from judge.mistakes.told import told_mistakes
from judge.problem import Problem
from judge.problem.find import find_problem
from judge.problem.model import chosen_groups
from judge.report.tell import tell
from judge.report.words import counted, printable
from judge.run.result import Result

__all__ = ["JudgeGroup", "JudgeProblem", "judge_problem"]

_WIDTH = 100  # columns of a failure's text: numbers are shown in full, and pytest adds its own margin


def judge_problem(name: str, *, problems: Sequence[str | os.PathLike[str]] = ()) -> JudgeProblem:
    """The problem of that name; `problems` are folders of problems to look in first.

    Raises UsageError if there is none and ProblemError if it is broken.
    """
    return JudgeProblem(find_problem(name, [Path(folder) for folder in problems]))


class JudgeProblem:
    """A problem to hold routines against. Its data are built once and cached, as for `judge run`."""

    def __init__(self, problem: Problem) -> None:
        self.problem = problem
        self._found: dict[Any, Result | None] = {}

    def __repr__(self) -> str:
        return f"judge_problem({self.problem.id!r})"

    @property
    def groups(self) -> tuple[str, ...]:
        """The names of its test groups, in their order."""
        return tuple(group.name for group in self.problem.groups)

    def group(self, name: str) -> JudgeGroup:
        """One of its test groups. Raises UsageError if it has none of that name."""
        (group,) = chosen_groups(self.problem, [name])
        return JudgeGroup(self, name, group.about)

    def check(self, routine: Routine, groups: str | Iterable[str] | None = None) -> None:
        """Call `routine` with every case of the groups, all of them where none are named.

        It takes the problem's parameters in their order, numbers as int or float and points as pairs of
        them, and returns what `judge show` says. Wrap another signature:
        `check(lambda x, y, A, B: mine(Point(x, y), [A, B]))`.

        Raises:
            AssertionError: an answer is wrong, or it raised; the text shows the first such case of the first
                such group, what was wanted and got, how many cases of each group fail, the smallest case
                found, and the mistake's name, or the known mistakes that the group should catch.
            UsageError: there is no such group, or none is named: nothing would be held against anything.
            ProblemError: the problem is broken.
        """
        __tracebackhide__ = True  # pytest shows the caller's line
        chosen = self.groups if groups is None else (groups,) if isinstance(groups, str) else tuple(groups)
        chosen_groups(self.problem, chosen)
        if not chosen:
            raise UsageError("no group is named", remedy="leave groups out for all of them")
        judged = check_routine(self.data, routine, chosen)
        failed = next((each for each in judged if each.run.failure is not None), None)
        if failed is not None:
            lines = _lines(self.problem, routine, judged, failed, self._explained(routine))
            rows = (printable(row) for text in lines for row in text.splitlines() or [""])
            text = "\n".join(part for row in rows for part in wrap(row, _WIDTH) or [""])
            raise AssertionError(text) from failed.raised

    def _explained(self, routine: Routine) -> Result | None:
        """The smallest case and the mistake's name, sought once for a routine; None where that went wrong."""
        key = _sameness(routine)
        if key not in self._found:
            try:
                self._found[key] = explain_routine(self.data, routine)
            except Exception:  # what is known of the failure is worth more than what could be
                self._found[key] = None
        return self._found[key]

    @cached_property
    def data(self) -> ProblemData:
        """The cases and what each answer is held against. Raises ProblemError."""
        return load_data(self.problem)


class JudgeGroup(Struct, frozen=True):
    """One test group of a problem, and what it probes in a sentence: what the fixture `judge_group` is."""

    problem: JudgeProblem
    name: str
    about: str

    def __repr__(self) -> str:
        return f"{self.problem!r}.group({self.name!r})"

    def check(self, routine: Routine) -> None:
        """Call `routine` with every case of the group; see `JudgeProblem.check`."""
        __tracebackhide__ = True
        self.problem.check(routine, [self.name])


def _sameness(routine: Routine) -> Any:
    """What is equal for a lambda that every test writes anew, with the same values around it."""
    code = getattr(routine, "__code__", None)
    if code is None:
        return id(routine)
    return code, tuple(id(cell.cell_contents) for cell in routine.__closure__ or ())


def _lines(
    problem: Problem, routine: Routine, judged: Sequence[Held], failed: Held, found: Result | None
) -> Iterator[str]:
    results = [each.run.result() for each in judged]
    wrong = [result for result in results if result.passed < result.cases]
    lost = sum(result.cases - result.passed for result in wrong)
    cases = counted(sum(result.cases for result in results), "case")
    several = len(results) > 1
    groups = f"{len(wrong)} of {counted(len(results), 'group')}, " if several else ""
    name = routine_name(routine)
    yield f"{problem.id}: {name} fails {groups}{lost:,} of {cases}"
    if several:
        yield f"  fails  {', '.join(f'{each.name} {each.passed}/{each.cases}' for each in wrong)}"
    run = failed.run
    first = Result(problem=problem.id, submission=name, verdict=run.verdict, failure=run.failure)
    told = tell(problem, found or first)
    yield from ("", *told.lines)
    if run.group.kills and not told.mistake:
        mistakes = told_mistakes(problem)
        yield f"{run.group.name} should catch"
        for kill in run.group.kills:
            yield f"  {kill}: {mistakes[kill].sentence}" if kill in mistakes else f"  {kill}"
