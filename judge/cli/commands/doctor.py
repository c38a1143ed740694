"""`judge doctor`: what this machine gives, and what would raise it."""

from __future__ import annotations

import os
import platform
import sys
from typing import TYPE_CHECKING, Any

import click
from msgspec import Struct

from judge import __version__
from judge.cli.judging_options import isolation_option
from judge.cli.options import json_option, write_json
from judge.errors import ExitCode, UsageError
from judge.folders import cache_folder
from judge.judging.containment import every_hidden_folder
from judge.judging.isolation import keep_level
from judge.languages.find import Found
from judge.languages.find import found as found_of
from judge.languages.model import languages
from judge.report.doctor import attack_lines, doctor_lines
from judge.report.progress import progress
from judge.report.screen import note, out
from judge.sandbox import levels

if TYPE_CHECKING:
    from judge.sandbox.attacking import Attacked
    from judge.sandbox.probe import Level

SCHEMA = 1


@click.command("doctor")
@click.option(
    "--languages", "tries", is_flag=True, help="Compile and run the empty program of each language."
)
@click.option("--attack", "attacks", is_flag=True, help="Run harmless attacks, and say which were stopped.")
@isolation_option
@json_option
def command(tries: bool, attacks: bool, level: str | None, as_json: bool) -> ExitCode:
    """Say how well submissions are contained on this machine.

    Each isolation level is tried with a submission that looks for the judge, its problems and its
    solutions. If something is missing for a better level, or for another language than Python, you see the
    command that helps. --languages also compiles and runs an empty program in each, which takes seconds.
    The best level is remembered: other commands refuse to judge below it, until `judge doctor` finds
    another or --isolation asks for one.

    With --attack, submissions try what they must not do: read the judge's files and yours, use the network,
    start and signal processes, fill memory and disk, never end. They do no harm if they succeed. They run
    at the level that is used, or at the one that --isolation names.

    Exit status: 0, or 1 if an attack succeeded.
    """
    if level is not None and not attacks:
        raise UsageError("--isolation goes with --attack", remedy="leave it out")
    found = levels(every_hidden_folder())
    best = next((level.name for level in found if level.available), None)
    others = [found_of(language) for language in languages()]
    if tries and best:
        others = _tried(others, best)
    _keep(found)
    made = _attacked(level or best) if attacks else None
    facts = {
        "judge": __version__,
        "python": f"{platform.python_version()} at {sys.executable}",
        "system": f"{platform.system()} {platform.release()}, {platform.machine()}",
        "cores": str(os.cpu_count() or 1),
        "cache": str(cache_folder()),
    }
    if as_json:
        write_json(_as_object(facts, best, found, others, made))
    elif made is not None:
        screen = out()
        screen.show(attack_lines(made.level, made.each, screen.width))
    else:
        screen = out()
        screen.show(doctor_lines(facts, found, others, screen.width))
    broken = made is not None and not all(each.held for each in made.each)
    return ExitCode.NOT_ACCEPTED if broken else ExitCode.ACCEPTED


class _Attacks(Struct, frozen=True):
    """What came of the attacks, and the level that they were made at."""

    level: str
    each: tuple[Attacked, ...]


def _attacked(level: str | None) -> _Attacks:
    """Run the attacks. Raises UsageError where nothing can be run, or not at that level."""
    from judge.sandbox import Boxes
    from judge.sandbox.attacking import attacked

    if level is None:
        raise UsageError("nothing can be run here", remedy="see 'judge doctor'")
    hidden = list(every_hidden_folder())
    boxes = Boxes(level, hidden)
    with progress("attacking") as seen:
        return _Attacks(level, tuple(attacked(boxes, hidden, seen or (lambda *_: None))))


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
    facts: dict[str, str],
    best: str | None,
    found: tuple[Level, ...],
    others: list[Found],
    made: _Attacks | None,
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
        "attacks": None
        if made is None
        else {
            "isolation": made.level,
            "attacks": [
                {"name": each.attack.name, "tries": each.attack.tries, "held": each.held, "how": each.how}
                for each in made.each
            ],
        },
        **facts,
    }
