"""What holds submissions here: the folders hidden from them, and the level of isolation that `judge doctor`
found on this machine, kept for the commands that come after it."""

from __future__ import annotations

import os
from contextlib import suppress
from datetime import date
from pathlib import Path

from judge import __version__
from judge.cache import DISK, digest
from judge.errors import JudgeError
from judge.files import cache_folder
from judge.judging import RunOptions
from judge.languages.boxes import AnyBoxes
from judge.languages.signature import signature_of
from judge.problem import Problem
from judge.problem.find import problem_roots
from judge.sandbox import LEVELS, Containment, room


def contained(problem: Problem, options: RunOptions, jobs: int = 1, had: str | None = None) -> AnyBoxes:
    """What opens containers for submissions to the problem; see `Session`. Raises UsageError."""
    room.raise_descriptors()
    least = None if options.isolation else kept_level()
    share, hidden = room.measure().share(jobs), hidden_folders(problem)
    boxes = Containment(options.isolation, hidden, least=least, had=had, share=share)
    signature = signature_of(problem)
    return AnyBoxes(boxes, None if options.program and signature.is_run else signature)


def hidden_folders(problem: Problem) -> tuple[Path, ...]:
    """What a submission to the problem must not see; the cache is made first, or it could not be covered."""
    cache = cache_folder()
    with suppress(OSError):  # whoever builds the data says so
        cache.mkdir(parents=True, exist_ok=True)
    folder, solutions = problem.folder, problem.solutions  # they may be links to elsewhere than their parents
    return folder, solutions, folder.parent, solutions.parent, cache


def every_hidden_folder() -> tuple[Path, ...]:
    """What a submission to any problem that can be found must not see; nothing of packs that are broken."""
    try:
        roots = problem_roots()
    except JudgeError:
        roots = []
    return (*roots, *(root.parent / "solutions" for root in roots), cache_folder())


def keep_level(level: str) -> str | None:
    """Keep it, in place of what was found before; a note for the person if that fails."""
    return DISK.write(*_place("level"), level, "levels of isolation")


def kept_level() -> str | None:
    """The level found by this version of the judge for this user, on this machine with this kernel."""
    level = DISK.read(*_place("level"), str)
    return level if level in LEVELS else None


def first_today() -> bool:
    """Whether this is asked for the first time today; where nothing can be kept, it is every time."""
    today, place = date.today().isoformat(), _place("asked")
    if DISK.read(*place, str) == today:
        return False
    DISK.write(*place, today)
    return True


def _place(what: str) -> tuple[str, str]:
    """Its name and key. A cache that machines share keeps one of each machine and user."""
    system = os.uname()
    place = digest(f"{system.nodename}\0{os.geteuid()}".encode())[:8]
    return f"isolation/{what}-{place}", digest(f"{__version__}\0{system}".encode())
