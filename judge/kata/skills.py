"""The checklist: what there is to learn, and which runs have shown it.

    problems/skills.toml
        [[skills]]
        name = "clamp to an end"
        about = "The nearest root that is not behind the origin."
        needs = [{ problem = "count", groups = ["near-hit", "near-miss"] }]

A need is met by one run that passed all of its groups; a skill is shown when each of its needs was met, and
lost where the latest run that tried a need fails it. A run that passed no test group at all loses nothing.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Mapping, Sequence
from datetime import datetime
from enum import Enum
from pathlib import Path
from typing import NamedTuple

from msgspec import Struct

from judge.errors import UsageError
from judge.kata.history import Run
from judge.kata.tables import Table, unlike_any
from judge.problem import Problem
from judge.problem.find import find_problem, problem_roots

_FILE = "skills.toml"


class Need(Struct, forbid_unknown_fields=True, frozen=True):
    """Test groups of one problem that one run must pass together."""

    problem: str
    groups: tuple[str, ...]


class Skill(Struct, forbid_unknown_fields=True, frozen=True):
    """Something to be able to do, as a person would tick it off."""

    name: str
    about: str
    needs: tuple[Need, ...]

    def within(self, problems: Collection[str]) -> Skill | None:
        """What of it these problems show; None if nothing."""
        needs = tuple(need for need in self.needs if need.problem in problems)
        return Skill(self.name, self.about, needs) if needs else None


class _SkillsTable(Struct, forbid_unknown_fields=True, frozen=True):
    skills: list[Skill]


class SkillState(Enum):
    """How far a skill has come; the value is its name in JSON."""

    OPEN = "open"
    PART = "part"  # some of its needs were met
    SHOWN = "shown"
    LOST = "lost"  # a need that was met is failed by the latest run


class NeedProgress(Struct, frozen=True):
    """One need: when it was first met, and the groups that the latest run to try them fails.

    `attempts` are the runs that tried it, up to the first that met it.
    """

    need: Need
    since: datetime | None
    failing: tuple[str, ...]
    attempts: int
    mistakes: Mapping[str, int]

    @property
    def lost(self) -> bool:
        """Whether it was met once and no longer is."""
        return self.since is not None and bool(self.failing)


class SkillProgress(Struct, frozen=True):
    """One skill and how each of its needs stands."""

    skill: Skill
    needs: tuple[NeedProgress, ...]

    @property
    def met(self) -> int:
        """How many of the needs were met."""
        return sum(need.since is not None for need in self.needs)

    @property
    def state(self) -> SkillState:
        """How far it has come."""
        if any(need.lost for need in self.needs):
            return SkillState.LOST
        if self.met == len(self.needs):
            return SkillState.SHOWN
        return SkillState.PART if self.met else SkillState.OPEN

    @property
    def since(self) -> datetime | None:
        """When it was first shown; None if it never was."""
        dates = [need.since for need in self.needs if need.since is not None]
        return max(dates) if len(dates) == len(self.needs) else None

    @property
    def attempts(self) -> int:
        """The runs that it took, or has taken so far."""
        return sum(need.attempts for need in self.needs)

    @property
    def mistakes(self) -> Counter[str]:
        """The mistakes that stood in its way, and how often."""
        return sum((Counter(need.mistakes) for need in self.needs), Counter())


def load_skills(extra: Sequence[Path] = ()) -> tuple[list[Skill], dict[str, Problem]]:
    """The skills of every folder of problems, in the files' order, and the problems that show them by name.

    Raises:
        ProblemError: a file is broken, or names a problem or a group that is not there.
    """
    skills: list[Skill] = []
    problems: dict[str, Problem] = {}
    for root in problem_roots(extra):
        if (root / _FILE).is_file():
            skills += _load(Table(root / _FILE), extra, problems)
    return skills, problems


def assess(
    skills: Iterable[Skill], runs: Iterable[Run], problems: Mapping[str, Problem]
) -> list[SkillProgress]:
    """How each skill stands after these runs, which are in their order."""
    of_problem: dict[str, list[_Tried]] = {}
    for run in runs:
        if run.counts and (run.passed or run.failed):
            tried = _Tried(run, frozenset(run.passed), frozenset(run.failed))
            of_problem.setdefault(run.problem, []).append(tried)
    return [
        SkillProgress(
            skill,
            tuple(
                _assess(need, of_problem.get(need.problem, ()), _mistakes_of(need, problems[need.problem]))
                for need in skill.needs
            ),
        )
        for skill in skills
    ]


class _Tried(NamedTuple):
    """A run with its test groups as sets: every need asks for them, and there may be thousands of runs."""

    run: Run
    passed: frozenset[str]
    failed: frozenset[str]


def _assess(need: Need, tries: Iterable[_Tried], mistakes: Collection[str]) -> NeedProgress:
    groups = frozenset(need.groups)
    since: datetime | None = None
    missed: frozenset[str] = frozenset()
    attempts = 0
    made: Counter[str] = Counter()
    for run, passed, failed in tries:
        fails = groups & failed
        if not fails and groups.isdisjoint(passed):  # it was judged on other groups only
            continue
        attempts += since is None
        if run.passed:  # a file that is begun anew passes nothing yet, and takes nothing away
            missed = fails
        if since is None and groups <= passed:
            since = run.when
        if fails and run.mistake:
            made.update(name for name in mistake_names(run) if name in mistakes)
    failing = tuple(group for group in need.groups if group in missed)
    return NeedProgress(need, since, failing, attempts, made)


def mistake_names(run: Run) -> list[str]:
    """The mistakes that explained the run, none, one or two."""
    return run.mistake.split(" + ") if run.mistake else []


def _mistakes_of(need: Need, problem: Problem) -> set[str]:
    """The mistakes that the need's groups are there for."""
    return {name for group in problem.groups if group.name in need.groups for name in group.kills}


def _load(file: Table, extra: Sequence[Path], problems: dict[str, Problem]) -> list[Skill]:
    table = file.read(_SkillsTable)
    for place, skill in enumerate(table.skills):
        if skill.name in [other.name for other in table.skills[:place]]:
            raise file.fault(f"{skill.name!r} is there twice", "take one out", "skills", place)
        if not skill.needs:
            what = f"{skill.name!r} needs nothing"
            raise file.fault(what, "name the test groups that show it", "skills", place, "needs")
        for need in skill.needs:
            _check(file, place, need, extra, problems)
    return table.skills


def _check(file: Table, place: int, need: Need, extra: Sequence[Path], problems: dict[str, Problem]) -> None:
    try:
        if need.problem not in problems:
            problems[need.problem] = find_problem(need.problem, extra)
    except UsageError as fault:
        raise file.fault(fault.what, fault.remedy or "", "skills", place, "needs") from fault
    names = [group.name for group in problems[need.problem].groups]
    for group in need.groups:
        if group not in names:
            what = f"{need.problem} has no group {group!r}"
            raise file.fault(what, unlike_any(group, names), "skills", place, "needs")
    if not need.groups:
        raise file.fault("a need names no group", "name at least one", "skills", place, "needs")
