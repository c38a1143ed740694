"""What a program's file may be, and why one cannot be read, in a few words."""

from __future__ import annotations

import os

from judge.errors import UsageError

LARGEST = 4 * 2**20  # bytes; no person writes more
NOT_FOLLOWED = "which is not followed; --follow-links follows it"
LED_OUT = f"it is a link out of the folder, {NOT_FOLLOWED}"
DANGLING = "it is a link to a file that is not there"
ENVIRONMENT = "pyvenv.cfg"  # what a virtual environment's folder holds


def within_limit(source: bytes, name: str) -> bytes:
    """The same bytes. Raises UsageError where they are more than a program has."""
    if len(source) > LARGEST:
        raise UsageError(f"this file is larger than {LARGEST // 2**20} MB", where=name)
    return source


def is_dangling(name: str | os.PathLike[str]) -> bool:
    """Whether there is only a link of that name, which leads nowhere."""
    return os.path.islink(name) and not os.path.exists(name)  # noqa: PTH110, PTH114 - of any name


def why_unreadable(fault: OSError) -> str:
    """Why a file that is there cannot be read."""
    return f"cannot be read ({(fault.strerror or 'it failed').lower()})"
