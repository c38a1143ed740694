"""`judge list`: the problems that can be found."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from judge.cli.options import json_option, problems_option, write_json
from judge.errors import ExitCode
from judge.problem import Problem
from judge.problem.find import sound_problems
from judge.report.layout import Style
from judge.report.problems import cases, list_lines
from judge.report.screen import note, out

SCHEMA = 1


@click.command("list")
@json_option
@problems_option
def command(as_json: bool, folders: tuple[Path, ...]) -> ExitCode:
    """List the problems.

    The easiest is first. A broken problem is named on standard error, and the others are listed.
    """
    problems, faults = sound_problems(folders)
    if as_json:
        for problem in problems:
            write_json(as_object(problem))
    elif problems:
        screen = out()
        screen.show(list_lines(problems, screen.width))
    for fault in faults:
        note(str(fault), Style.BAD)
    return ExitCode.FAULT if faults else ExitCode.ACCEPTED


def as_object(problem: Problem) -> dict[str, Any]:
    """The published object of one problem in a list."""
    return {
        "schema": SCHEMA,
        "problem": problem.id,
        "title": problem.title,
        "tier": problem.tier.value,
        "summary": problem.summary,
        "entry": problem.entry,
        "groups": len(problem.groups),
        "cases": cases(problem),
        "points": sum(group.points for group in problem.groups),
    }
