"""`judge doctor`: what this machine gives, and what would raise it."""

from __future__ import annotations

import os
import platform
import sys
from typing import TYPE_CHECKING, Any

import click

from judge import __version__
from judge.cli.options import json_option, write_json
from judge.data.cache import cache_folder
from judge.errors import ExitCode
from judge.judging.containment import every_hidden_folder
from judge.judging.isolation import keep_level
from judge.report.doctor import doctor_lines
from judge.report.screen import note, out
from judge.sandbox import levels

if TYPE_CHECKING:
    from judge.sandbox.probe import Level

SCHEMA = 1


@click.command("doctor")
@json_option
def command(as_json: bool) -> ExitCode:
    """Say how well submissions are contained on this machine.

    Each isolation level is tried with a submission that looks for the judge, its problems and its solutions.
    What is missing for a better level is named, with the command that would help. The best one is kept: from
    then on the other commands refuse to judge below it, until `judge doctor` finds another or --isolation
    asks for one.

    Exit status: 0 always; the level that is used without --isolation is the first that works.
    """
    found = levels(every_hidden_folder())
    _keep(found)
    facts = {
        "judge": __version__,
        "python": f"{platform.python_version()} at {sys.executable}",
        "system": f"{platform.system()} {platform.release()}, {platform.machine()}",
        "cores": str(os.cpu_count() or 1),
        "cache": str(cache_folder()),
    }
    if as_json:
        write_json(_as_object(facts, found))
    else:
        screen = out()
        screen.show(doctor_lines(facts, found, screen.width))
    return ExitCode.ACCEPTED


def _keep(found: tuple[Level, ...]) -> None:
    """Keep the best level, unless a better one was only short of something just now."""
    best = next((level for level in found if level.available or not level.lasting), None)
    if best is not None and best.available:
        failed = keep_level(best.name)
        if failed:
            note(failed)


def _as_object(facts: dict[str, str], found: tuple[Level, ...]) -> dict[str, Any]:
    best = next((level.name for level in found if level.available), None)
    return {
        "schema": SCHEMA,
        "isolation": best,
        "levels": [
            {
                "name": level.name,
                "available": level.available,
                "meaning": level.meaning,
                "why_not": level.why_not or None,
                "remedy": level.remedy or None,
                "hides": None if level.visible is None else not level.visible,
                "visible": level.visible or None,
            }
            for level in found
        ],
        **facts,
    }
