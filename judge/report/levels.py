"""How far a submission came on the two levels of its kata, in words."""

from __future__ import annotations

from collections.abc import Sequence

from judge.problem.model import KataLevel
from judge.report.values import counted
from judge.run.result import LevelResult


def levels_text(levels: Sequence[LevelResult]) -> str:
    """`interview level passed; production level: 22 of 36 groups`, what is passed first.

    Empty where no level was passed: the verdict says it all. So it does where all are, which is accepted.
    """
    passed = [each for each in levels if each.passed]
    if not passed or len(passed) == len(levels):
        return ""
    rest = [each for each in levels if not each.passed]
    return "; ".join([*(f"{level_name(each.level)} passed" for each in passed), *map(_short, rest)])


def level_name(level: KataLevel) -> str:
    """`interview level`."""
    return f"{level.value} level"


def level_share(result: LevelResult) -> str:
    """`passed`, `22 of 36 groups`, or that it was not judged."""
    if result.passed:
        return "passed"
    if not result.run:
        return "not judged"
    judged = f", {result.run} judged" if result.run < result.groups else ""
    return f"{result.accepted} of {counted(result.groups, 'group')}{judged}"


def _short(result: LevelResult) -> str:
    name = level_name(result.level)
    return f"{name}: {level_share(result)}" if result.run else f"{name} not judged"
