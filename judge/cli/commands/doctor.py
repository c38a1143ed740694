"""`judge doctor`: how well this machine isolates programs, and which languages it has."""

from __future__ import annotations

import os
import platform
import sys
from pathlib import Path

from msgspec import Struct

from judge.cli.options import Common, command, opt
from judge.errors import UsageError
from judge.files import cache_folder
from judge.judging.containment import every_hidden_folder, keep_level
from judge.languages.find import found as found_of
from judge.languages.model import languages
from judge.report.published_setter import Attacks, Doctor
from judge.report.screen import note
from judge.report.wait import progress
from judge.sandbox import Boxes, levels
from judge.version import __version__


class DoctorAsk(Struct, frozen=True):
    """What to try on this machine."""

    languages: bool = opt("--languages", "Compile and run the empty program of each language.")
    attack: bool = opt("--attack", "Run harmless attacks, and say which were held.")


@command("doctor", Doctor, ask=DoctorAsk)
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
    hidden = list(every_hidden_folder())
    found = levels(hidden)
    best = next((level.name for level in found if level.available), None)
    programs = [found_of(language) for language in languages()]
    if ask.languages and best:
        from judge.languages.smoke import tried

        boxes = Boxes(best, hidden)
        programs = [tried(*each, boxes) for each in zip(languages(), programs, strict=True)]
    lasting = next((level for level in found if level.available or not level.lasting), None)
    if lasting is not None and lasting.available:  # no better one was only short of something just now
        failed = keep_level(lasting.name)
        if failed:
            note(failed)
    return Doctor(
        best,
        levels=tuple(found),
        languages=tuple(programs),
        attacks=_attacked(common.isolation or best, hidden) if ask.attack else None,
        judge=__version__,
        python=f"{platform.python_version()} at {sys.executable}",
        system=f"{platform.system()} {platform.release()}, {platform.machine()}",
        cores=os.cpu_count() or 1,
        cache=str(cache_folder()),
    )


def _attacked(level: str | None, hidden: list[Path]) -> Attacks:
    """Run the attacks. Raises UsageError where nothing can be run, or not at that level."""
    from judge.sandbox.attacking import attacked

    if level is None:
        raise UsageError("Nothing can be run here", remedy="see judge doctor")
    with progress("attacking") as seen:
        return Attacks(level, tuple(attacked(Boxes(level, hidden), hidden, seen or (lambda *_: None))))
