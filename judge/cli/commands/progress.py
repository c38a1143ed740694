"""`judge progress`: the checklists of skills and of questions, ticked off by what the history has."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import click

from judge.cli.kata import tell_faults
from judge.cli.kept import history_at
from judge.cli.options import db_option, json_option, problems_option, write_json
from judge.cli.table import COMMANDS
from judge.errors import ExitCode
from judge.kata.assessed import assessed_rows
from judge.kata.checklist import RowProgress, Section, by_section, find_row, in_set, read_checklist
from judge.kata.events import Hack, Run
from judge.kata.hacks import HackShare, hack_shares
from judge.kata.history import History
from judge.kata.levels import LevelStanding, level_standings
from judge.kata.overview import SetStanding, set_standings
from judge.kata.sets import USUAL, find_set, set_names
from judge.kata.skills import (
    NeedProgress,
    SkillProgress,
    assess,
    mistake_names,
    skills_of,
    unknown_skills,
)
from judge.kata.standing import standings
from judge.problem import Problem
from judge.problem.find import sound_problems
from judge.report.checklist import ready_lines, row_lines, section_lines
from judge.report.hacking import share_lines
from judge.report.layout import Style, line
from judge.report.overview import overview_lines
from judge.report.screen import note, out
from judge.report.skills import progress_lines
from judge.report.standings import standing_lines

SCHEMA = 1


@click.command("progress")
@click.argument("name", metavar="[SET]", default=USUAL)
@click.option("--all", "whole", is_flag=True, help="Every skill and kata, of all sets too.")
@click.option("--rows", "every", is_flag=True, help="Every question of the checklist, with what drills it.")
@click.option("--row", "one", metavar="ROW", help="That question alone, with all that may tick it.")
@json_option
@db_option
@problems_option
def command(
    name: str,
    whole: bool,
    every: bool,
    one: str | None,
    as_json: bool,
    db: Path | None,
    folders: tuple[Path, ...],
) -> ExitCode:
    """Tick off the skills that your runs have shown.

    A skill is shown once a run has passed all test groups it needs on one problem of the SET that asks for
    it; the date is that of the first time. It is lost where the latest run fails such a group again.
    Beside it are the runs that it took, and the mistakes that were named on the way. Below are the katas that
    have levels: when a run first passed the interview level and the production level, or how much of them.
    Then comes the share of the wrong programs that you broke with 'judge hack'.

    Of all sets together only these shares are shown, a row a set, unless --all is asked for.

    Last are the questions of the checklist, first those to be ready for an interview. One is ticked by the
    katas it names, by its skills, by its cards (judge quiz), or by a known mistake that you broke.
    """
    chosen = find_set(name, folders)
    if every or one:
        return _questions(chosen.name, one, as_json, db, folders)
    tell_faults(chosen)
    for fault in unknown_skills(chosen.problems, folders):
        note(str(fault), Style.BAD)
    names = {problem.id for problem in chosen.problems}
    with history_at(db, reading=True) as history:
        runs = [run for run in history.runs() if run.problem in names]
        hacks = history.events(Hack)
        parts = _parts(history, chosen.name, folders)
    assessed = assess(skills_of(chosen.problems, folders), runs, chosen.problems)
    levels = level_standings(chosen.problems, runs)
    shares = hack_shares(chosen.problems, hacks)
    mistakes = Counter(mistake for run in runs if run.counts for mistake in mistake_names(run))
    if as_json:
        write_json(
            {
                "schema": SCHEMA,
                "set": chosen.name,
                "skills": [_as_object(skill) for skill in assessed],
                "levels": [_level(level) for level in levels],
                "mistakes": dict(mistakes.most_common()),
                "hacks": [_share(share) for share in shares],
                "rows": [_row(section, row) for section, rows in parts for row in rows],
            }
        )
        return ExitCode.ACCEPTED
    screen = out()
    shared = chosen.name == USUAL and not whole
    sets = _sets(chosen.problems, runs, levels, assessed, folders) if shared else []
    if len(sets) > 1:
        screen.show(overview_lines(chosen.title, sets, assessed, mistakes, screen.width))
    else:
        screen.show(progress_lines(chosen.title, assessed, mistakes, screen.width))
        if told := list(standing_lines(levels, screen.width)):
            screen.show([line(), *told])
    if shares:
        screen.show([line(), *share_lines(shares, screen.width)])
    if questions := list(ready_lines(parts, screen.width)):
        screen.show([line(), *questions])
    return ExitCode.ACCEPTED


def _sets(
    problems: Sequence[Problem],
    runs: Sequence[Run],
    levels: Sequence[LevelStanding],
    skills: Sequence[SkillProgress],
    folders: Sequence[Path],
) -> list[SetStanding]:
    names = [name for name in set_names(folders) if name != USUAL]
    return set_standings(names, problems, standings(runs), levels, skills)


def _parts(history: History, name: str, folders: Sequence[Path]) -> list[tuple[Section, list[RowProgress]]]:
    """The sections of the checklist that belong to the set, or all where none does; faults are but notes."""
    problems, _ = sound_problems(folders)
    checklist, rows, faults = assessed_rows(history, problems, folders, COMMANDS)
    for fault in faults:
        note(str(fault), Style.BAD)
    within = in_set(checklist, name, USUAL)
    return by_section(within if within.rows else checklist, rows)


def _questions(
    name: str, one: str | None, as_json: bool, db: Path | None, folders: Sequence[Path]
) -> ExitCode:
    """Every question of the set, or one."""
    with history_at(db, reading=True) as history:
        parts = _parts(history, USUAL if one else name, folders)
    found = [(section, row) for section, rows in parts for row in rows]
    if one:
        wanted = find_row(one, read_checklist(folders)).id
        found = [(section, row) for section, row in found if row.row.id == wanted]
    screen = out()
    if as_json:
        for section, row in found:
            write_json({"schema": SCHEMA, **_row(section, row)})
    elif one:
        for _, row in found:
            screen.show(row_lines(row, screen.width))
    else:
        for place, (section, rows) in enumerate(parts):
            screen.show([*([line()] if place else []), *section_lines(section, rows, screen.width)])
    return ExitCode.ACCEPTED


def _row(section: Section, progress: RowProgress) -> dict[str, Any]:
    return {
        "row": progress.row.id,
        "section": section.title,
        "ask": progress.row.ask,
        "state": progress.state.value,
        "since": progress.since.isoformat() if progress.since else None,
        "by": [
            {
                "kind": each.kind.value,
                "name": each.name,
                "since": each.since.isoformat() if each.since else None,
                "lost": each.lost,
                "drill": each.drill,
            }
            for each in progress.evidence
        ],
    }


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


def _share(share: HackShare) -> dict[str, Any]:
    broken = {name: when.isoformat() for name, when in share.broken.items()}
    return {"problem": share.problem, "programs": share.programs, "broken": broken}


def _need(progress: NeedProgress) -> dict[str, Any]:
    return {
        "problem": progress.need.problem,
        "groups": list(progress.need.groups),
        "since": progress.since.isoformat() if progress.since else None,
        "failing": list(progress.failing),
        "attempts": progress.attempts,
    }
