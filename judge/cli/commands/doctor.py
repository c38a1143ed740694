"""`judge doctor`: what this machine gives, and what would raise it."""

from __future__ import annotations

import os
import platform
import sys
from typing import Any

import click

from judge import __version__
from judge.cli.options import json_option, write_json
from judge.data.cache import cache_folder
from judge.errors import ExitCode
from judge.report.doctor import doctor_lines
from judge.report.screen import out
from judge.sandbox import levels

SCHEMA = 1


@click.command("doctor")
@json_option
def command(as_json: bool) -> ExitCode:
    """Say how well submissions are contained on this machine.

    Each isolation level is tried with an empty submission; what is missing for a better one is named, with
    the command that would help.

    Exit status: 0 always; the level that is used without --isolation is the first that works.
    """
    found = levels()
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


def _as_object(facts: dict[str, str], found: tuple[Any, ...]) -> dict[str, Any]:
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
            }
            for level in found
        ],
        **facts,
    }
