"""`judge why`: what the test groups of a problem probe, and the mistakes they should catch."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click

from judge.cli.options import json_option, problems_option, write_json
from judge.errors import ExitCode
from judge.problem import Group
from judge.problem.choose import chosen_groups
from judge.problem.find import find_problem
from judge.problem.solutions import known_mistakes
from judge.report.screen import out
from judge.report.why import why_lines

SCHEMA = 1


@click.command("why")
@click.argument("name", metavar="PROBLEM")
@click.argument("group", metavar="[GROUP]", required=False)
@json_option
@problems_option
def command(name: str, group: str | None, as_json: bool, folders: tuple[Path, ...]) -> ExitCode:
    """Say what the test groups probe, and which mistakes they should catch.

    With a GROUP, only that one.
    """
    problem = find_problem(name, folders)
    groups = chosen_groups(problem, (group,) if group else ())
    sentences: dict[str, str] = {}
    for mistake in known_mistakes(problem):  # the usual program of a mistake comes before its variants
        sentences.setdefault(mistake.name, mistake.sentence)
    if as_json:
        described = [_as_object(each, sentences) for each in groups]
        write_json({"schema": SCHEMA, "problem": problem.id, "groups": described})
        return ExitCode.ACCEPTED
    screen = out()
    screen.show(why_lines(problem, groups, sentences, screen.width))
    return ExitCode.ACCEPTED


def _as_object(group: Group, sentences: Mapping[str, str]) -> dict[str, Any]:
    """The published object of one group; a mistake without a program has no explanation."""
    mistakes = [{"name": name, "explanation": sentences.get(name)} for name in group.kills]
    return {"name": group.name, "about": group.about, "mistakes": mistakes}
