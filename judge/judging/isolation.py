"""The isolation level that `judge doctor` found on this machine, kept for the commands that come after it."""

from __future__ import annotations

import os
from datetime import date

from judge import __version__
from judge.cache import DISK, digest
from judge.sandbox import LEVELS


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
    place = _digest(system.nodename, str(os.geteuid()))[:8]
    key = _digest(__version__, system.sysname, system.release, system.version, system.machine)
    return f"isolation/{what}-{place}", key


def _digest(*parts: str) -> str:
    return digest("\0".join(parts).encode())
