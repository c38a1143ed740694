"""`judge why`: what the test groups of a problem probe, and the mistakes they should catch."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import click

from judge.cli.allowed import growth_rule, own_rules
from judge.cli.fitting import problem_meant
from judge.cli.options import json_option, problems_option, write_json
from judge.errors import ExitCode
from judge.mistakes.told import Told, aimed_groups, told_mistakes
from judge.problem import Group
from judge.problem.choose import chosen_groups
from judge.problem.level import KataLevel
from judge.report.screen import out
from judge.report.why import only_there, why_lines

SCHEMA = 1


@click.command("why")
@click.argument("name", metavar="PROBLEM|FILE")
@click.argument("group", metavar="[GROUP]", required=False)
@json_option
@problems_option
def command(name: str, group: str | None, as_json: bool, folders: tuple[Path, ...]) -> ExitCode:
    """Say what the test groups probe, and which mistakes they should catch.

    With a GROUP, only that one. A FILE stands for the problem that it is to solve.
    """
    problem = problem_meant(name, "why", folders, None)
    groups = aimed_groups(problem, tuple(chosen_groups(problem, (group,) if group else ())))
    mistakes = told_mistakes(problem)
    if as_json:
        described = [_as_object(each, mistakes) for each in groups]
        levels = {"levels": [_level(level, groups) for level in problem.levels]} if problem.levels else {}
        head = {"schema": SCHEMA, "problem": problem.id, **levels, **growth_rule(problem.growth, groups)}
        write_json({**head, "groups": described})
        return ExitCode.ACCEPTED
    screen = out()
    screen.show(why_lines(problem, groups, mistakes, screen.width))
    return ExitCode.ACCEPTED


def _as_object(group: Group, known: Mapping[str, Told]) -> dict[str, Any]:
    """The published object of one group; a mistake that nobody has described has no explanation."""
    mistakes = []
    for name in group.kills:
        told = known.get(name)
        line = {"right": told.line.right, "wrong": told.line.wrong} if told and told.line else None
        mistakes.append({"name": name, "explanation": told.sentence if told else None, "line": line})
    level = {"level": group.level.value} if group.level else {}
    return {"name": group.name, "about": group.about, **level, **own_rules(group), "mistakes": mistakes}


def _level(level: KataLevel, groups: Sequence[Group]) -> dict[str, Any]:
    """The published object of one level, with the mistakes that only its groups here should catch."""
    own = [group.name for group in groups if group.level is level]
    return {
        "level": level.value,
        "meaning": level.meaning,
        "groups": len(own),
        "only": only_there(level, groups),
    }
