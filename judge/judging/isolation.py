"""The isolation level that `judge doctor` found on this machine, kept for the commands that come after it."""

from __future__ import annotations

import os
from datetime import date

from judge import __version__
from judge.digest import digest_of
from judge.files import cache_folder
from judge.kept import KeptFile
from judge.sandbox import LEVELS


def keep_level(level: str) -> str | None:
    """Keep it, in place of what was found before; a note for the person if that fails."""
    return _file().write({"level": level})


def kept_level() -> str | None:
    """The level found by this version of the judge for this user, on this machine with this kernel."""
    found = _file().read()
    level = found.get("level") if isinstance(found, dict) else None
    return level if level in LEVELS else None


def first_today() -> bool:
    """Whether this is asked for the first time today; where nothing can be kept, it is every time."""
    file = _file("asked")
    today = date.today().isoformat()
    if file.read() == today:
        return False
    file.write(today)
    return True


def _file(what: str = "level") -> KeptFile:
    """The machine and the user are in its stem, so that a cache that machines share keeps a level of each."""
    system = os.uname()
    place = _digest(system.nodename, str(os.geteuid()))[:8]
    key = _digest(__version__, system.sysname, system.release, system.version, system.machine)
    return KeptFile(cache_folder, "isolation", f"{what}-{place}-", key, "levels of isolation")


def _digest(*parts: str) -> str:
    return digest_of("\0".join(parts).encode())[:32]
