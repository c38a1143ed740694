"""Doing again what the machine has no room for just now, for a bounded time."""

from __future__ import annotations

import errno
import time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import TypeVar

    T = TypeVar("T")

PAUSES = (0.05, 0.2, 0.5, 1.0)  # seconds between the tries
# What passes: a limit that neighbours have reached, memory, a program file that is being replaced.
PASSING = frozenset((errno.EAGAIN, errno.EMFILE, errno.ENFILE, errno.ENOMEM, errno.ETXTBSY, errno.EUSERS))


def again(act: Callable[[], T]) -> T:
    """What `act` gives; tried again where it raises an OSError that may pass."""
    for pause in PAUSES:
        try:
            return act()
        except OSError as fault:
            if fault.errno not in PASSING:
                raise
        time.sleep(pause)
    return act()
