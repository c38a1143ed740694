"""`judge doctor`: how well this machine isolates programs, and which languages it has."""

from __future__ import annotations

import os
import platform
import sys
from typing import TYPE_CHECKING, Annotated

from msgspec import Struct

from judge import __version__
from judge.cli.options import Common, command, opt, takes
from judge.errors import UsageError
from judge.files import cache_folder
from judge.judging.containment import every_hidden_folder, keep_level
from judge.languages.find import Found
from judge.languages.find import found as found_of
from judge.languages.model import languages
from judge.report.published_setter import AttackRow, Attacks, Doctor, LanguageRow, LevelRow
from judge.report.screen import note
from judge.report.wait import progress
from judge.sandbox import Boxes, levels

if TYPE_CHECKING:
    from judge.sandbox.probe import Level


class DoctorAsk(Struct, frozen=True):
    """What to try on this machine."""

    languages: Annotated[
        bool, opt("--languages", help="Compile and run the empty program of each language.")
    ] = False
    attack: Annotated[bool, opt("--attack", help="Run harmless attacks, and say which were held.")] = False


@command("doctor", Doctor)
@takes(DoctorAsk, "ask")
def doctor(ask: DoctorAsk, common: Common) -> Doctor:
    """Say how well submissions are contained on this machine.

    Each level of isolation is tried, and what a better one or another language would need is named. The best
    level is kept: the other commands refuse to judge below it, until judge doctor finds another.

    With --attack, submissions try what none may: read your files, use the network, start and signal
    processes, fill memory and disk, never end. They are harmless where they succeed. --isolation names the
    level.

    Exit status: 0, or 1 where an attack was not held.
    """
    if common.isolation is not None and not ask.attack:
        raise UsageError("--isolation goes with --attack", remedy="leave it out")
    found = levels(every_hidden_folder())
    best = next((level.name for level in found if level.available), None)
    others = [found_of(language) for language in languages()]
    if ask.languages and best:
        others = _tried(others, best)
    _keep(found)
    return Doctor(
        best,
        levels=tuple(LevelRow(**level._asdict()) for level in found),
        languages=tuple(LanguageRow(**each._asdict()) for each in others),
        attacks=_attacked(common.isolation or best) if ask.attack else None,
        judge=__version__,
        python=f"{platform.python_version()} at {sys.executable}",
        system=f"{platform.system()} {platform.release()}, {platform.machine()}",
        cores=os.cpu_count() or 1,
        cache=str(cache_folder()),
    )


def _attacked(level: str | None) -> Attacks:
    """Run the attacks. Raises UsageError where nothing can be run, or not at that level."""
    from judge.sandbox.attacking import attacked

    if level is None:
        raise UsageError("Nothing can be run here", remedy="see judge doctor")
    hidden = list(every_hidden_folder())
    with progress("attacking") as seen:
        found = attacked(Boxes(level, hidden), hidden, seen or (lambda *_: None))
        rows = (AttackRow(each.attack.name, each.attack.tries, each.held, each.how) for each in found)
        return Attacks(level, tuple(rows))


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

    boxes = Boxes(level, every_hidden_folder())
    return [tried(language, each, boxes) for language, each in zip(languages(), others, strict=True)]
