"""`judge progress`: what your runs, answers and hacks have shown."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from datetime import datetime
from pathlib import Path
from typing import Any

import click

from judge.cli.kata import tell_faults
from judge.cli.kept import history_at
from judge.cli.options import db_option, json_option, problems_option, write_json
from judge.errors import ExitCode
from judge.kata.checklist import Section, find_row, unknown_skills
from judge.kata.events import Hack
from judge.kata.hacks import hack_shares
from judge.kata.progress import Covered, Progress, RowProgress, SkillProgress, read_progress
from judge.kata.sets import USUAL, find_set, set_names
from judge.problem.find import sound_problems
from judge.report.hacking import share_lines
from judge.report.layout import Style
from judge.report.learned import Parts, all_lines, question_lines, set_lines, sets_lines
from judge.report.screen import note, out

SCHEMA = 1


@click.command("progress")
@click.argument("name", metavar="[SET]", default=USUAL)
@click.option("--all", "whole", is_flag=True, help="List every skill, kata and question.")
@click.option("--question", "one", metavar="ID", help="Show one question, and what ticks it.")
@json_option
@db_option
@problems_option
def command(
    name: str, whole: bool, one: str | None, as_json: bool, db: Path | None, folders: tuple[Path, ...]
) -> ExitCode:
    """Show what you can do so far.

    A skill is ticked when one run passes all its test groups in one kata of the SET. The tick goes if your
    latest run fails one of them. A kata counts once it is accepted; for an interview, the interview level is
    enough.

    The questions are those of an interview. One is ticked by the katas it names, by its skills, by its cards
    (judge quiz), or by a wrong program that you broke (judge hack).
    """
    chosen = find_set(name, folders)
    tell_faults(chosen)
    problems, _ = sound_problems(folders)
    with history_at(db, reading=True) as history:
        found, faults = read_progress(history, problems, folders)
        hacks = history.events(Hack)
    for fault in (*unknown_skills(chosen.problems, folders), *faults):
        note(str(fault), Style.BAD)
    screen = out()
    if one:
        rows = {row.row.id: (section, row) for section, own in found.sections for row in own}
        section, row = rows[find_row(one, [row.row for _, row in rows.values()]).id]
        if as_json:
            write_json({"schema": SCHEMA, **_row(section, row)})
        else:
            screen.show(question_lines(row, screen.width))
        return ExitCode.ACCEPTED
    ids = [problem.id for problem in chosen.problems]
    own = found.within(ids)
    parts = [each for each in own.sections if chosen.name in (USUAL, *each[0].sets)] or own.sections
    shares = hack_shares(chosen.problems, hacks)
    if as_json:
        broken = [
            {"problem": each.problem, "programs": each.programs, "broken": _dates(each.broken)}
            for each in shares
        ]
        write_json({"schema": SCHEMA, "set": chosen.name, **_as_object(own, parts), "hacks": broken})
        return ExitCode.ACCEPTED
    names = [each for each in set_names(folders) if each != USUAL] if chosen.name == USUAL else []
    members = {each: [problem.id for problem in chosen.problems if each in problem.sets] for each in names}
    sets = {each: inside for each, inside in members.items() if inside}
    if whole:
        screen.show(all_lines(chosen.title, own, parts, screen.width))
    elif len(sets) > 1:
        screen.show(sets_lines(chosen.title, sets, own, screen.width))
    else:
        screen.show(set_lines(chosen.title, ids, own, parts, screen.width))
    screen.show(share_lines(shares, screen.width))
    return ExitCode.ACCEPTED


def _as_object(progress: Progress, parts: Parts) -> dict[str, Any]:
    made = sum(progress.mistakes.values(), Counter())
    return {
        "skills": [_skill(skill) for skill in progress.skills],
        "levels": [_level(level) for level in progress.levels],
        "mistakes": dict(made.most_common()),
        "rows": [_row(section, row) for section, rows in parts for row in rows],
    }


def _row(section: Section, progress: RowProgress) -> dict[str, Any]:
    return {
        "row": progress.row.id,
        "section": section.title,
        "ask": progress.row.ask,
        "state": progress.state.value,
        "since": _date(progress.since),
        "by": [
            {
                "kind": each.kind.value,
                "name": each.name,
                "since": _date(each.since),
                "lost": each.lost,
                "drill": each.drill,
            }
            for each in progress.evidence
        ],
    }


def _skill(progress: SkillProgress) -> dict[str, Any]:
    return {
        "name": progress.skill.name,
        "about": progress.skill.about,
        "state": progress.state.value,
        "since": _date(progress.since),
        "attempts": progress.attempts,
        "mistakes": dict(progress.mistakes.most_common()),
        "needs": [
            {
                "problem": need.problem,
                "groups": list(need.groups),
                "since": _date(need.since),
                "failing": list(need.failing),
                "attempts": need.attempts,
            }
            for need in progress.needs
        ],
    }


def _level(level: Covered) -> dict[str, Any]:
    return {
        "problem": level.problem,
        "level": level.level.value if level.level else None,
        "groups": len(level.groups),
        "best": level.best,
        "since": _date(level.since),
    }


def _dates(found: Mapping[str, datetime]) -> dict[str, str]:
    return {name: when.isoformat() for name, when in found.items()}


def _date(when: datetime | None) -> str | None:
    return when.isoformat() if when else None
