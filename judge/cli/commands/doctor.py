"""`judge doctor`: how well this machine isolates programs, and which languages it has."""

from __future__ import annotations

import os
import platform
import sys

from msgspec import Struct

from judge import __version__
from judge.cli.options import Common, command, opt
from judge.errors import UsageError
from judge.files import cache_folder
from judge.judging.containment import every_hidden_folder, keep_level
from judge.languages.find import found as found_of
from judge.languages.model import languages
from judge.report.published_setter import Doctor
from judge.report.screen import note
from judge.sandbox import Containment
from judge.sandbox.available import levels_here


class DoctorAsk(Struct, frozen=True):
    """What to try on this machine."""

    languages: bool = opt("--languages", "Compile and run the empty program of each language.")


@command("doctor", Doctor, ask=DoctorAsk)
def doctor(ask: DoctorAsk, common: Common) -> Doctor:
    """Say how well submissions are contained on this machine.

    Each level of isolation is tried, and what a better one or another language would need is named. The best
    level is kept: the other commands refuse to judge below it, until judge doctor finds another.
    """
    if common.isolation is not None:
        raise UsageError("judge doctor tries every level", remedy="leave out --isolation")
    hidden = list(every_hidden_folder())
    found = levels_here(hidden)
    best = next((level.name for level in found if level.available), None)
    programs = [found_of(language) for language in languages()]
    if ask.languages and best:
        from judge.languages.smoke import tried

        boxes = Containment(best, hidden)
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
        judge=__version__,
        python=f"{platform.python_version()} at {sys.executable}",
        system=f"{platform.system()} {platform.release()}, {platform.machine()}",
        cores=os.cpu_count() or 1,
        cache=str(cache_folder()),
    )
