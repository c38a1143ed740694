"""The checklist: what there is to learn, and which runs have shown it.

    problems/skills.toml            [[skills]]
                                    name = "far from the origin"
                                    about = "Subtract first: the square of a large number drowns a small one."
    problems/count/problem.py       group("offset", …, skills="far from the origin")

The groups of one problem that show a skill are a need, met by one run that passed all of them. A skill is
shown as soon as one of its needs was met: who can do it in one problem can do it. It is lost where the latest
run that tried a need that was met fails it. A run that passed no test group at all loses nothing.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from datetime import datetime
from enum import Enum
from pathlib import Path
from typing import NamedTuple

from msgspec import Struct

from judge.errors import ProblemError, nearest
from judge.kata.events import Run
from judge.problem import Problem
from judge.problem.find import problem_roots
from judge.problem.model import group_place
from judge.problem.tables import TomlFile

_FILE = "skills.toml"
_EXPLAIN = f"explain it in {_FILE}"


class Need(Struct, frozen=True):
    """Test groups of one problem that one run must pass together."""

    problem: str
    groups: tuple[str, ...]


class Skill(Struct, frozen=True):
    """Something to be able to do, as a person would tick it off."""

    name: str
    about: str
    needs: tuple[Need, ...]


class _SkillTable(Struct, forbid_unknown_fields=True, frozen=True):
    name: str
    about: str


class _SkillsTable(Struct, forbid_unknown_fields=True, frozen=True):
    skills: list[_SkillTable]


class SkillState(Enum):
    """How far a skill has come; the value is its name in JSON."""

    OPEN = "open"
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
        return SkillState.SHOWN if self.met else SkillState.OPEN

    @property
    def since(self) -> datetime | None:
        """When it was first shown; None if it never was."""
        return min((need.since for need in self.needs if need.since is not None), default=None)

    @property
    def attempts(self) -> int:
        """The runs that it took on the problem where it was first shown, or has taken so far on all."""
        first = [need.attempts for need in self.needs if need.since is not None and need.since == self.since]
        return first[0] if first else sum(need.attempts for need in self.needs)

    @property
    def mistakes(self) -> Counter[str]:
        """The mistakes that stood in its way, and how often."""
        return sum((Counter(need.mistakes) for need in self.needs), Counter())


def skills_of(problems: Iterable[Problem], extra: Sequence[Path] = ()) -> list[Skill]:
    """What these problems show: first the skills of each folder's file, in its order, then their own.

    What is explained nowhere is left out (see `unknown_skills`), and so is what none of them shows. Raises
    ProblemError where a file of skills is broken.
    """
    problems = list(problems)
    abouts = _explained(extra)
    needs: dict[str, list[Need]] = {name: [] for name in abouts}
    for problem in problems:
        for shown in problem.skills:
            if shown.name in needs:
                needs[shown.name].append(Need(problem.id, shown.groups))
    return [Skill(name, about, tuple(needs[name])) for name, about in abouts.items() if needs[name]]


def unknown_skills(problems: Iterable[Problem], extra: Sequence[Path] = ()) -> Iterator[ProblemError]:
    """A fault for each skill that a problem names and nothing explains. Raises as skills_of does."""
    known = list(_explained(extra))
    for problem in problems:
        for shown in problem.skills:
            if shown.name not in known:
                meant = nearest(shown.name, known)
                yield ProblemError(
                    f"no skill is called {shown.name!r}",
                    where=group_place(problem, shown.groups[0]),
                    remedy=f"did you mean {meant!r}?" if meant else _EXPLAIN,
                )


def assess(skills: Iterable[Skill], runs: Iterable[Run], problems: Iterable[Problem]) -> list[SkillProgress]:
    """How each skill of these problems stands after these runs, which are in their order."""
    named = {problem.id: problem for problem in problems}
    of_problem: dict[str, list[_Tried]] = {}
    for run in runs:
        if run.counts and (run.passed or run.failed):
            tried = _Tried(run, frozenset(run.passed), frozenset(run.failed))
            of_problem.setdefault(run.problem, []).append(tried)
    return [
        SkillProgress(
            skill,
            tuple(
                _assess(need, of_problem.get(need.problem, ()), _mistakes_of(need, named[need.problem]))
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
    """The mistakes that the need's groups should catch."""
    return {name for group in problem.groups if group.name in need.groups for name in group.kills}


def _explained(extra: Sequence[Path]) -> dict[str, str]:
    """What each skill is about by its name, of every folder's file; the first of a name wins."""
    found: dict[str, str] = {}
    for root in problem_roots(extra):
        if not (root / _FILE).is_file():
            continue
        file = TomlFile(root / _FILE)
        here: set[str] = set()
        for place, skill in enumerate(file.read(_SkillsTable).skills):
            if skill.name in here:
                raise file.fault(f"{skill.name!r} is there twice", "take one out", "skills", place)
            here.add(skill.name)
            found.setdefault(skill.name, skill.about)
    return found
