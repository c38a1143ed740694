"""`judge progress`: the checklist of skills, ticked off by the runs so far."""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import Any

import click

from judge.cli.kata import tell_faults
from judge.cli.options import db_option, json_option, problems_option, write_json
from judge.errors import ExitCode
from judge.kata.history import History
from judge.kata.levels import LevelStanding, level_standings
from judge.kata.sets import USUAL, find_set
from judge.kata.skills import (
    NeedProgress,
    SkillProgress,
    assess,
    mistake_names,
    skills_of,
    unknown_skills,
)
from judge.report.layout import Style, line
from judge.report.screen import note, out
from judge.report.skills import progress_lines
from judge.report.standings import standing_lines

SCHEMA = 1


@click.command("progress")
@click.argument("name", metavar="[SET]", default=USUAL)
@json_option
@db_option
@problems_option
def command(name: str, as_json: bool, db: Path | None, folders: tuple[Path, ...]) -> ExitCode:
    """Tick off the skills that your runs have shown.

    A skill is shown once a run has passed all test groups it needs on one problem of the SET that asks for
    it; the date is that of the first time. It is lost where the latest run fails such a group again.
    Beside it are the runs that it took, and the mistakes that were named on the way. Below are the katas that
    have levels: when a run first passed the interview level and the production level, or how much of them.
    """
    chosen = find_set(name, folders)
    tell_faults(chosen)
    for fault in unknown_skills(chosen.problems, folders):
        note(str(fault), Style.BAD)
    names = {problem.id for problem in chosen.problems}
    with History.open(db, reading=True) as history:
        runs = [run for run in history.runs() if run.problem in names]
    assessed = assess(skills_of(chosen.problems, folders), runs, chosen.problems)
    levels = level_standings(chosen.problems, runs)
    mistakes = Counter(mistake for run in runs if run.counts for mistake in mistake_names(run))
    if as_json:
        write_json(
            {
                "schema": SCHEMA,
                "set": chosen.name,
                "skills": [_as_object(skill) for skill in assessed],
                "levels": [_level(level) for level in levels],
                "mistakes": dict(mistakes.most_common()),
            }
        )
        return ExitCode.ACCEPTED
    screen = out()
    screen.show(progress_lines(chosen.title, assessed, mistakes, screen.width))
    if told := list(standing_lines(levels, screen.width)):
        screen.show([line(), *told])
    return ExitCode.ACCEPTED


def _as_object(progress: SkillProgress) -> dict[str, Any]:
    return {
        "name": progress.skill.name,
        "about": progress.skill.about,
        "state": progress.state.value,
        "since": progress.since.isoformat() if progress.since else None,
        "attempts": progress.attempts,
        "mistakes": dict(progress.mistakes.most_common()),
        "needs": [_need(need) for need in progress.needs],
    }


def _level(standing: LevelStanding) -> dict[str, Any]:
    return {
        "problem": standing.problem,
        "level": standing.level.value,
        "groups": standing.groups,
        "best": standing.best,
        "since": standing.since.isoformat() if standing.since else None,
    }


def _need(progress: NeedProgress) -> dict[str, Any]:
    return {
        "problem": progress.need.problem,
        "groups": list(progress.need.groups),
        "since": progress.since.isoformat() if progress.since else None,
        "failing": list(progress.failing),
        "attempts": progress.attempts,
    }
