"""Why a container did not start: because it never will at this level, or because of a shortage that passes.

Only the first may lead to a weaker level, so that whatever is in doubt counts as the second.
"""

from __future__ import annotations

import errno
import os
import signal
from pathlib import Path

from judge.errors import JudgeError, ShortageError, shortage_code, shortage_of
from judge.sandbox.inside.again import PASSING, PAUSES

_BUBBLEWRAP = "bwrap: "
_NO_MORE_NAMESPACES = "max_*_namespaces exceeded"  # what bubblewrap makes of ENOSPC
_NAMESPACES = Path("/proc/sys/user")
_MEMORY = ("memoryerror", "out of memory")  # what Python says, and bubblewrap
_SLOW_TRIES = 2  # each takes as long as the patience with it
_DOUBTFUL_TRIES = 2
_TRIES = len(PAUSES) + 1


class NotStarted(JudgeError):  # noqa: N818 - it is caught, to try again or at the next level
    """A container did not start; the text is the reason.

    `tries` says how often it may be tried in all, `lasting` whether it counts as refused for good after that,
    and `shortage` what a person is told where it does not.
    """

    def __init__(self, reason: str, tries: int, *, lasting: bool = False, code: int = 0) -> None:
        super().__init__(reason)
        self.tries = tries
        self.lasting = lasting
        self._code = code

    @property
    def shortage(self) -> ShortageError:
        """The fault that costs one submission."""
        if self._code:
            return shortage_of(self._code, "no container could be started")
        remedy = "use a smaller -j if the machine is busy; see 'judge doctor'"
        return ShortageError(f"no container could be started: {self.what}", remedy=remedy)


def of_fault(fault: Exception, command: str = "") -> NotStarted | None:
    """The refusal behind a fault on the judge's own side; None for one that is nobody's shortage.

    `command` is the program that was to be started, where it had come to that.
    """
    code = shortage_code(fault) or (fault.errno if isinstance(fault, OSError) else 0) or 0
    if code in PASSING:
        return NotStarted(os.strerror(code), _TRIES, code=code)
    if shortage_code(fault):  # a full disk, a limit on the size of files: neither passes that soon
        return NotStarted(os.strerror(code), 1, code=code)
    if command:
        return NotStarted(f"{command} cannot be started: {os.strerror(code)}", 1, lasting=True)
    return None


def of_silence(seconds: float) -> NotStarted:
    """The refusal of one that was not ready in time."""
    return NotStarted(f"it was not ready after {seconds:g} s", _SLOW_TRIES)


def of_end(complaint: str, status: int) -> NotStarted:
    """The refusal of one that ended; `complaint` is all that it said, `status` as `Popen.returncode`."""
    lines = complaint.strip().splitlines()
    if not lines:
        if status == -signal.SIGSYS:
            return NotStarted("a filter of system calls around the judge kills it", 1, lasting=True)
        how = f"killed by signal {-status}" if status < 0 else f"exit status {status}"
        return NotStarted(f"it ended without a word ({how})", _TRIES)
    said = complaint.casefold()
    code = _code_in(said)
    if code or (_NO_MORE_NAMESPACES in said and not _forbidden()):
        return NotStarted(lines[-1], _TRIES, code=code)
    known = lines[-1].startswith(_BUBBLEWRAP)
    return NotStarted(lines[-1], 1 if known else _DOUBTFUL_TRIES, lasting=True)


def _code_in(said: str) -> int:
    """The errno of a shortage that the words tell of; 0 where they tell of none."""
    if any(word in said for word in _MEMORY):
        return errno.ENOMEM
    return next((code for code in sorted(PASSING) if os.strerror(code).casefold() in said), 0)


def _forbidden() -> bool:
    """Whether no namespace of some kind may be made at all, which does not pass."""
    for name in ("user", "mnt", "pid", "net", "ipc", "uts"):
        try:
            if (_NAMESPACES / f"max_{name}_namespaces").read_text(encoding="ascii").strip() == "0":
                return True
        except OSError:
            continue
    return False
