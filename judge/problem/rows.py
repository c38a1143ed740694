"""The test groups that a problem.py declares, checked: `group(...)` rows into the problem's groups.

The group of the statement's examples comes first. Of 100 points those that no row names are shared evenly,
and the first groups take the remainder.
"""

from __future__ import annotations

import json
from collections import defaultdict
from collections.abc import Iterator
from math import isfinite
from typing import Any, NoReturn

from msgspec.structs import replace

from judge.errors import ProblemError
from judge.files import read_ordinary
from judge.problem.declare import Declared
from judge.problem.model import (
    EXAMPLES,
    FULL_SCORE,
    Group,
    GroupLimits,
    GrowthRule,
    KataLevel,
    Problem,
    ShownSkill,
)
from judge.problem.module import load_module
from judge.problem.names import is_name
from judge.values.answers import Tolerance

_MOST_CASES = 1_000_000
_MOST_SIZE = 10**9
_LIMITS = ("cpu_seconds", "wall_seconds")


def with_rows(problem: Problem, tolerance: Tolerance | None, slope: float | None) -> Problem:
    """The problem with its groups, their skills and the rule of growth; it is run for that.

    `tolerance` is that of a group which has none of its own, `slope` that of growth. Raises ProblemError.
    """
    rows = load_module(problem).rows
    checks = _Rows(problem, tolerance)
    groups = [checks.group(level, row) for level, row in rows]
    levels = {level for level, _ in rows}
    if len(levels) == 1 and None not in levels:
        what = f"every group is in {' and '.join(level.name for level in levels if level)}"
        checks.fault(rows[0][1], what, "declare groups of both, or all of them in GROUPS")
    if not problem.examples:
        raise ProblemError(
            "there are no worked examples",
            where=f"{problem.id}/statement.md",
            remedy=f"add a line >>> {problem.entry}(…) and the answer below it",
        )
    usual = tolerance or next((group.tolerance for group in groups), Tolerance())
    examples = Group(
        name=EXAMPLES,
        about="The worked examples of the statement.",
        count=len(problem.examples),
        points=0,
        tolerance=usual,
        seed=problem.id,
        level=None if levels == {None} else KataLevel.INTERVIEW,
    )
    points = dict(
        zip((EXAMPLES, *(row.name for _, row in rows)), (None, *(row.points for _, row in rows)), strict=True)
    )
    shares = _shares(problem, points)
    kills = _pinned_kills(problem)
    done = tuple(
        replace(group, points=shares[group.name], kills=kills.get(group.name, ()))
        for group in (examples, *groups)
    )
    skills: defaultdict[str, list[str]] = defaultdict(list)
    for _, row in rows:
        for skill in row.skills:
            skills[skill].append(row.name)
    shown = tuple(ShownSkill(skill, tuple(names)) for skill, names in skills.items())
    return replace(problem, groups=done, skills=shown, growth=_growth(problem, done, slope))


class _Rows:
    """The checks of one problem's rows."""

    def __init__(self, problem: Problem, tolerance: Tolerance | None) -> None:
        self._problem = problem
        self._tolerance = tolerance
        self._names = {EXAMPLES}

    def fault(self, row: Declared, what: str, remedy: str) -> NoReturn:
        """Refuse a row."""
        raise ProblemError(what, where=f"{self._problem.id}/problem.py:{row.line}", remedy=remedy)

    def group(self, level: KataLevel | None, row: Declared) -> Group:
        """The group of a row."""
        for what, remedy in self._faults(row):
            self.fault(row, what, remedy)
        self._names.add(row.name)
        return Group(
            name=row.name,
            about=row.about,
            count=row.cases,
            points=0,
            tolerance=self._tolerance_of(row),
            seed=self._problem.id,
            line=row.line,
            size=row.size,
            time_limit=row.time_limit,
            limits=self._limits(row),
            neighbours=row.turns,
            level=level,
        )

    def _faults(self, row: Any) -> Iterator[tuple[str, str]]:
        # Whatever a setter writes may stand in a row.
        if not isinstance(row.name, str) or not is_name(row.name):
            yield f"{row.name!r} is no name for a group", "use small letters, digits and single hyphens"
        if row.name in self._names:
            remedy = "the examples come by themselves" if row.name == EXAMPLES else "rename or remove one"
            yield f"there are two groups {row.name!r}", remedy
        if not isinstance(row.about, str) or not row.about.strip():
            yield f"group {row.name!r} does not say what it probes", "write one sentence"
        if not callable(row.draw):
            yield f"group {row.name!r} draws from {row.draw!r}", "give a function that takes a draw"
        if type(row.cases) is not int or not 1 <= row.cases <= _MOST_CASES:
            yield f"group {row.name!r} has {row.cases!r} cases", f"give 1 to {_MOST_CASES}"
        if row.points is not None and (type(row.points) is not int or not 0 <= row.points <= FULL_SCORE):
            yield f"group {row.name!r} has {row.points!r} points", f"give 0 to {FULL_SCORE}"
        for at, skill in enumerate(row.skills):
            if not isinstance(skill, str) or not skill.strip():
                yield f"a skill of {row.name!r} has no name", "write what the group shows in a few words"
            if skill in row.skills[:at]:
                yield f"{row.name!r} shows {skill!r} twice", "remove one"
        if row.size is not None and (type(row.size) is not int or not 1 <= row.size <= _MOST_SIZE):
            yield f"group {row.name!r} has the size {row.size!r}", f"give 1 to {_MOST_SIZE}"
        if row.size is not None and row.turns:
            yield f"the cases of {row.name!r} are big and cannot take turns", "remove turns"
        if row.time_limit is not None and self._problem.time is None:
            yield f"{row.name!r} is timed beside a reference solution", "add a [time] table that names one"
        if row.time_limit is not None and not 1 <= row.time_limit <= 1e6:
            yield f"the time limit of {row.name!r} is {row.time_limit!r}", "give a multiple above 1"
        for key, value in (row.limits or {}).items():
            if key not in _LIMITS:
                yield f"group {row.name!r} has no limit {key!r}", f"the keys are {', '.join(_LIMITS)}"
            if not isinstance(value, int | float) or not isfinite(value) or not 0 < value <= 1e6:
                yield f"{key} = {value!r} allows nothing", "give a number above 0"

    def _tolerance_of(self, row: Declared) -> Tolerance:
        if not self._problem.answer.measured:
            if row.tolerance is not None:
                self.fault(
                    row, "an answer without real numbers is right or wrong and has no tolerance", "remove it"
                )
            return Tolerance()
        tolerance = row.tolerance or self._tolerance
        if tolerance is None:
            self.fault(row, f"group {row.name!r} has no tolerance", "add tolerance = { … } to problem.toml")
        if min(tolerance.extent, tolerance.relative, tolerance.zero, tolerance.ulps) < 0:
            self.fault(row, "the tolerance is negative", "give 0 or more")
        if not (tolerance.extent or tolerance.relative or tolerance.ulps):
            self.fault(row, "the tolerance is 0, which no double can meet", "give relative, extent or ulps")
        return tolerance

    def _limits(self, row: Declared) -> GroupLimits | None:
        if row.limits is None:
            return None
        usual = self._problem.limits
        cpu = float(row.limits.get("cpu_seconds", usual.cpu_seconds))
        wall = float(row.limits.get("wall_seconds", usual.wall_seconds * cpu / usual.cpu_seconds))
        return replace(usual, cpu_seconds=cpu, wall_seconds=wall)


def _shares(problem: Problem, given: dict[str, int | None]) -> dict[str, int]:
    """Each group's points."""
    left = FULL_SCORE - sum(points for points in given.values() if points is not None)
    open_ = [name for name, points in given.items() if points is None]
    if left < 0:
        raise ProblemError(
            f"the groups' points sum to {FULL_SCORE - left}",
            where=f"{problem.id}/problem.py",
            remedy=f"make them sum to {FULL_SCORE} at most: what is left is shared",
        )
    each, rest = divmod(left, len(open_))
    shared = {name: each + (at < rest) for at, name in enumerate(open_)}
    return {name: shared[name] if points is None else points for name, points in given.items()}


def _growth(problem: Problem, groups: tuple[Group, ...], slope: float | None) -> GrowthRule | None:
    """The rule of growth: over the groups whose cases are big, the smallest first."""
    if slope is None:
        return None
    sized = sorted((group for group in groups if group.size), key=lambda group: group.size or 0)
    if len({group.size for group in sized}) < 2:
        what = "growth needs groups of two different sizes"
        raise ProblemError(what, where=f"{problem.id}/problem.py", remedy="add a group with size = …")
    return GrowthRule(tuple(group.name for group in sized), slope)


def _pinned_kills(problem: Problem) -> dict[str, tuple[str, ...]]:
    """The mistakes that each group catches, by pins.json; a file that is none is verify's to tell."""
    try:
        pins: Any = json.loads(read_ordinary(problem.folder / "pins.json"))
        return {name: tuple(map(str, pin["kills"])) for name, pin in pins.items()}
    except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError):
        return {}
