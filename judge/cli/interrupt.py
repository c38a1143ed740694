"""Ctrl-C before and after all that takes long is imported."""

from __future__ import annotations

import _signal as signal  # type: ignore[import-not-found]  # signal itself takes longer to import
import os

TYPE_CHECKING = False  # typing's is slow to import, and nothing may be slow before Ctrl-C is seen to
if TYPE_CHECKING:
    from types import FrameType
    from typing import NoReturn

INTERRUPTED = 130  # ExitCode.INTERRUPTED, which may not be imported yet


def leave(_number: int, _frame: FrameType | None) -> NoReturn:
    """Ctrl-C while modules are imported, where an exception is now and then lost in the locks of imports."""
    os._exit(INTERRUPTED)  # nothing has been started or written


def imported() -> None:
    """All that takes long is imported: from here on Ctrl-C is an exception, and things are cleared up."""
    if signal.getsignal(signal.SIGINT) is leave:
        signal.signal(signal.SIGINT, signal.default_int_handler)
