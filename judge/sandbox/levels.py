"""Levels of isolation: at which one submissions are held, when another may be taken, why one cannot be had.

A container that does not start is refused for good at its level, or for want of something that passes. Only
the first may lead to a weaker level, so that whatever is in doubt counts as the second.
"""

from __future__ import annotations

import errno
import os
import platform
import sys
import time
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import TypeVar

from judge.errors import JudgeError, ShortageError, UsageError, nearest, shortage_code, shortage_of
from judge.sandbox.boundary import LEVELS
from judge.sandbox.inside.again import PASSING, PAUSES

C = TypeVar("C")

_DOCTOR = "let 'judge doctor' look again"
_BUBBLEWRAP = "bwrap: "
_NO_MORE_NAMESPACES = "max_*_namespaces exceeded"  # what bubblewrap makes of ENOSPC
_MEMORY = ("memoryerror", "out of memory")  # what Python says, and bubblewrap
_DOUBTFUL_TRIES = 2
_TRIES = len(PAUSES) + 1

_USER_NAMESPACES = {  # what forbids them, by its key, and the value that does not
    "kernel.unprivileged_userns_clone": ("0", 1),
    "kernel.apparmor_restrict_unprivileged_userns": ("1", 0),
    "user.max_user_namespaces": ("0", 15000),
}
_INSTALL = {"apt-get": "install", "dnf": "install", "apk": "add", "pacman": "-S", "zypper": "install"}


class StartError(JudgeError):
    """A container did not start; the text is the reason.

    `tries` says how often it may be tried in all, `lasting` whether it counts as refused for good after that,
    and `shortage` what a person is told where it does not.
    """

    def __init__(self, reason: str, tries: int = _TRIES, *, lasting: bool = False, code: int = 0) -> None:
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


class Levels:
    """The level of a command: the best there is, or the one demanded.

    A level that is refused for good leads to the next one, and is not tried again; `refused` says why. A
    level that was had is demanded from then on, and so is one that was kept. `limits` is taken only where it
    is demanded, or where the machine has no sandbox at all.
    """

    def __init__(self, demanded: str | None = None, kept: str | None = None, had: str | None = None) -> None:
        """Raises UsageError where no level is called as the one demanded.

        Args:
            demanded: the level to be had.
            kept: the level that was found here before; below it nothing may be run.
            had: a level that this command has had before.
        """
        if demanded is not None and demanded not in LEVELS:
            near = nearest(demanded, LEVELS)
            remedy = f"did you mean {near}?" if near else f"levels are {', '.join(LEVELS)}"
            raise UsageError(f"there is no isolation level {demanded}", remedy=remedy)
        self.refused: dict[str, str] = {}
        self._demanded = demanded
        self._kept = kept
        self._had = had

    @property
    def level(self) -> str:
        """The one that was had, or else the first to try. Raises UsageError and JudgeError as `open`."""
        return self._had or self._from(self._demanded or LEVELS[0])

    def open(self, start: Callable[[str], C], wait: Callable[[float], object] = time.sleep) -> C:
        """What `start` gives for the level; it raises StartError where it cannot.

        What may pass is tried again, after a while.

        Raises:
            UsageError: the level was demanded, or was found here before, and is refused for good.
            JudgeError: it was had in this command, or there is none below it.
            ShortageError: there is no room for it now.
        """
        level, tries = self.level, 0
        while True:
            try:
                opened = start(level)
            except StartError as refusal:
                tries += 1
                if tries < refusal.tries:
                    wait(PAUSES[tries - 1])
                elif refusal.lasting:
                    level, tries = self._below(level, refusal.what), 0
                else:
                    raise refusal.shortage from refusal
            else:
                self._had = self._had or level
                return opened

    def _from(self, level: str) -> str:
        """This level, or where it is known that it cannot be had the next one."""
        reason = self.refused.get(level) or missing(level)
        return self._below(level, reason) if reason else level

    def _below(self, level: str, reason: str) -> str:
        """The level to try now that this one is refused for good."""
        from judge.sandbox import launch

        if level == "full" and launch.bind_proc(reason):
            return level
        way = remedy(level, reason)
        if level == self._had:
            raise JudgeError(f"isolation {level} was had and is now refused: {reason}", remedy=way)
        if level == self._demanded:
            raise UsageError(f"isolation {level} cannot be had here: {reason}", remedy=way)
        if level == self._kept:
            what = f"isolation {level}, which 'judge doctor' found here, cannot be had: {reason}"
            raise UsageError(what, remedy=f"{way}, or {_DOCTOR}" if way else _DOCTOR)
        following = LEVELS[LEVELS.index(level) + 1 :]
        if not following or (following[0] == "limits" and not missing(level)):
            raise JudgeError(f"no container can be started: {reason}", remedy="see 'judge doctor'")
        self.refused[level] = reason
        return self._from(following[0])


@cache
def missing(level: str) -> str:
    """What this machine lacks for a level, as far as that can be told without trying; "" if nothing."""
    if level == "limits":
        return ""
    if sys.platform != "linux":
        return f"{platform.system()} has no sandbox that the judge knows"
    from judge.sandbox import filters, launch

    if level == "full":  # more shows when it starts: looking here would cost every run some milliseconds
        return "" if launch.bubblewrap_path() else "bubblewrap is not installed"
    from judge.sandbox.inside import linux

    machine = os.uname().machine
    if machine not in filters.MACHINES:
        return f"there is no table of system calls for {machine}"
    if not linux.filters_calls(filters.filters(machine, "python").load):
        return "the kernel does not filter system calls (seccomp)"
    return "" if linux.abi() else "the kernel has no landlock (Linux 5.13 or newer with lsm=landlock)"


def remedy(level: str, refusal: str) -> str:
    """The command that would raise the level, as well as it can be told."""
    if sys.platform != "linux":
        return "run the judge on Linux"
    if level == "full" and "not installed" in refusal:
        from shutil import which

        manager = next((name for name in _INSTALL if which(name)), None)
        return f"sudo {manager} {_INSTALL[manager]} bubblewrap" if manager else "install bubblewrap"
    if level == "full":
        for key, (bad, good) in _USER_NAMESPACES.items():
            if _setting(key) == bad:
                return f"sudo sysctl {key}={good}"
        return "in a Docker container: docker run --cap-add SYS_ADMIN --security-opt seccomp=unconfined"
    if "landlock" in refusal:
        return "boot Linux 5.13 or newer with landlock in its lsm= list"
    return ""


def of_code(code: int, what: str, tries: int = _DOUBTFUL_TRIES) -> StartError:
    """The refusal behind an errno; where that names no shortage it lasts after so many tries."""
    if code in PASSING:
        return StartError(what, code=code)
    if shortage_code(OSError(code, "")):  # a full disk, a limit on the size of files: none passes that soon
        return StartError(what, 1, code=code)
    return StartError(what, tries, lasting=True)


def of_end(complaint: str, status: int) -> StartError:
    """The refusal of one that ended before; `complaint` is all that was said, as by bubblewrap.

    `status` is as `Popen.returncode`.
    """
    import signal  # which is in no browser's tab, where this module is too

    lines = complaint.strip().splitlines()
    if not lines:
        if status == -signal.SIGSYS:
            return StartError("a filter of system calls around the judge kills it", 1, lasting=True)
        how = f"killed by signal {-status}" if status < 0 else f"exit status {status}"
        return StartError(f"it ended without a word ({how})")
    said = complaint.casefold()
    if _NO_MORE_NAMESPACES in said and not _forbidden():
        return StartError(lines[-1])
    return of_code(_code_in(said), lines[-1], 1 if lines[-1].startswith(_BUBBLEWRAP) else _DOUBTFUL_TRIES)


def _code_in(said: str) -> int:
    """The errno of a shortage that the words tell of; 0 where they tell of none."""
    if any(word in said for word in _MEMORY):
        return errno.ENOMEM
    return next((code for code in sorted(PASSING) if os.strerror(code).casefold() in said), 0)


def _forbidden() -> bool:
    """Whether no namespace of some kind may be made at all, which does not pass."""
    kinds = ("user", "mnt", "pid", "net", "ipc", "uts")
    return any(_setting(f"user.max_{kind}_namespaces") == "0" for kind in kinds)


def _setting(key: str) -> str:
    """A setting of the kernel; "" where there is none."""
    try:
        return Path("/proc/sys", *key.split(".")).read_text(encoding="ascii").strip()
    except OSError:
        return ""
