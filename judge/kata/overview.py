"""How far a person has come in each practice set: katas, their levels, skills."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from msgspec import Struct

from judge.kata.levels import LevelStanding
from judge.kata.skills import SkillProgress, SkillState
from judge.kata.standing import Standing, State
from judge.problem import Problem
from judge.problem.model import KataLevel


class Share(Struct, frozen=True):
    """So many of so many."""

    met: int
    of: int


class SetStanding(Struct, frozen=True):
    """One set: its katas, of each level those that have it and passed it, and its skills."""

    name: str
    katas: Share
    levels: Mapping[KataLevel, Share]
    skills: Share


def set_standings(
    names: Sequence[str],
    problems: Sequence[Problem],
    standings: Mapping[str, Standing],
    levels: Sequence[LevelStanding],
    skills: Sequence[SkillProgress],
) -> list[SetStanding]:
    """The sets of these names that any of the problems belongs to, as far as these problems are in them.

    A skill counts in each set that has a problem which asks for it.
    """
    found = []
    for name in names:
        own = {problem.id for problem in problems if name in problem.sets}
        asked = [each for each in skills if any(need.need.problem in own for need in each.needs)]
        if own:
            passed = [standings.get(each, Standing()).state is State.PASSED for each in own]
            found.append(
                SetStanding(
                    name,
                    Share(sum(passed), len(own)),
                    {level: _share(levels, level, own) for level in KataLevel},
                    Share(sum(each.state is SkillState.SHOWN for each in asked), len(asked)),
                )
            )
    return found


def _share(levels: Sequence[LevelStanding], level: KataLevel, problems: set[str]) -> Share:
    there = [each for each in levels if each.level is level and each.problem in problems]
    return Share(sum(each.since is not None for each in there), len(there))
