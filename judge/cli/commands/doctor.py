"""`judge doctor`: what this machine gives, and what would raise it."""

from __future__ import annotations

import os
import platform
import sys
from typing import TYPE_CHECKING, Any

import click

from judge import __version__
from judge.cli.options import json_option, write_json
from judge.errors import ExitCode
from judge.folders import cache_folder
from judge.judging.containment import every_hidden_folder
from judge.judging.isolation import keep_level
from judge.languages.find import Found
from judge.languages.find import found as found_of
from judge.languages.model import languages
from judge.report.doctor import doctor_lines
from judge.report.screen import note, out
from judge.sandbox import levels

if TYPE_CHECKING:
    from judge.sandbox.probe import Level

SCHEMA = 1


@click.command("doctor")
@click.option(
    "--languages", "tries", is_flag=True, help="Compile and run the empty program of each language."
)
@json_option
def command(tries: bool, as_json: bool) -> ExitCode:
    """Say how well submissions are contained on this machine.

    Each isolation level is tried with a submission that looks for the judge, its problems and its solutions.
    What is missing for a better level, or for another language than Python, is named with the command that
    would help. With --languages the empty program of each is compiled and run there, which takes seconds.
    The best level is kept: from then on the other commands refuse to judge below it, until `judge doctor`
    finds another or --isolation asks for one.

    Exit status: 0 always; the level that is used without --isolation is the first that works.
    """
    found = levels(every_hidden_folder())
    best = next((level.name for level in found if level.available), None)
    others = [found_of(language) for language in languages()]
    if tries and best:
        others = _tried(others, best)
    _keep(found)
    facts = {
        "judge": __version__,
        "python": f"{platform.python_version()} at {sys.executable}",
        "system": f"{platform.system()} {platform.release()}, {platform.machine()}",
        "cores": str(os.cpu_count() or 1),
        "cache": str(cache_folder()),
    }
    if as_json:
        write_json(_as_object(facts, best, found, others))
    else:
        screen = out()
        screen.show(doctor_lines(facts, found, others, screen.width))
    return ExitCode.ACCEPTED


def _keep(found: tuple[Level, ...]) -> None:
    """Keep the best level, unless a better one was only short of something just now."""
    best = next((level for level in found if level.available or not level.lasting), None)
    if best is not None and best.available:
        failed = keep_level(best.name)
        if failed:
            note(failed)


def _tried(others: list[Found], level: str) -> list[Found]:
    """The same languages, with what came of their empty programs."""
    from judge.languages.smoke import tried
    from judge.sandbox import Boxes

    boxes = Boxes(level, every_hidden_folder())
    return [tried(language, each, boxes) for language, each in zip(languages(), others, strict=True)]


def _as_object(
    facts: dict[str, str], best: str | None, found: tuple[Level, ...], others: list[Found]
) -> dict[str, Any]:
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
        "languages": [
            {
                "name": each.name,
                "version": each.version or None,
                "missing": each.missing or None,
                "works": each.works,
                "why_not": each.why_not or None,
                "remedy": each.remedy or None,
            }
            for each in others
        ],
        **facts,
    }
