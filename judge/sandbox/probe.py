"""Which isolation levels this machine gives, why not a better one, and the command that would raise it."""

from __future__ import annotations

import platform
import sys
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from judge.errors import JudgeError, ShortageError
from judge.sandbox import concealed, launch, roots
from judge.sandbox.boundary import LEVELS, Limits, Stop
from judge.sandbox.factory import Boxes

MEANING = {
    "full": "bubblewrap's namespaces, landlock, a system call filter and resource limits",
    "strong": "landlock, a system call filter and resource limits; only the existence of files shows",
    "limits": "resource limits only: a submission can read what you can read",
}
_USER_NAMESPACES = {
    "/proc/sys/kernel/unprivileged_userns_clone": ("0", "sudo sysctl kernel.unprivileged_userns_clone=1"),
    "/proc/sys/kernel/apparmor_restrict_unprivileged_userns": (
        "1",
        "sudo sysctl kernel.apparmor_restrict_unprivileged_userns=0",
    ),
    "/proc/sys/user/max_user_namespaces": ("0", "sudo sysctl user.max_user_namespaces=15000"),
}
_INSTALL = {
    "apt-get": "apt-get install bubblewrap",
    "dnf": "dnf install bubblewrap",
    "apk": "apk add bubblewrap",
    "pacman": "pacman -S bubblewrap",
    "zypper": "zypper install bubblewrap",
}
_LOOK = b"""
import os, sys
for path in sys.stdin.buffer.read().split(b"\\0"):
    try:
        found = os.listdir(path) if os.path.isdir(path) else [open(path)]
    except OSError:
        continue
    if found:
        sys.stdout.buffer.write(path + b"\\n")
"""
_LOOKING = Limits(cpu_seconds=10.0, wall_seconds=30.0, memory_bytes=1 << 28, output_bytes=1 << 22)


@dataclass(frozen=True)
class Level:
    """What is known of one level on this machine; a key of `judge doctor --json` is a field.

    `visible` is what a submission could read there of what none may see: a path, "" for nothing, None where
    it was not tried.
    """

    name: str
    available: bool
    meaning: str
    why_not: str = ""
    remedy: str = ""  # a command, or what else would have to change
    lasting: bool = True  # False where it is a passing shortage that denies it
    visible: str | None = None


def levels(hide: Iterable[Path] = ()) -> tuple[Level, ...]:
    """Try each level, the best first, with a submission that looks for the judge, its problems and solutions.

    `hide` are more folders that it looks for.
    """
    hide = tuple(hide)
    found = roots.find_roots(hide)
    others = concealed.ours(found.searched, (*found.folders, *found.files))
    wanted = "\0".join([*found.unseen, *others])
    return tuple(_try(name, hide, wanted.encode(errors="surrogateescape")) for name in LEVELS)


def _try(name: str, hide: Iterable[Path], wanted: bytes) -> Level:
    try:
        with Boxes(name, hide)(_LOOK, "look.py") as box:
            looked = box.run_program(wanted, _LOOKING)
    except JudgeError as error:
        lasting = not isinstance(error, ShortageError)
        return Level(name, False, MEANING[name], error.what, error.remedy or "", lasting)
    if looked.stop is not Stop.ANSWERED:
        return Level(name, False, MEANING[name], f"a program that looks around failed: {looked.detail}")
    return Level(name, True, MEANING[name], visible=looked.stdout.decode(errors="replace").partition("\n")[0])


@cache
def missing(level: str) -> str:
    """What this machine lacks for a level, as far as that can be told without trying; "" if nothing."""
    if level == "limits":
        return ""
    if sys.platform != "linux":
        return f"{platform.system()} has no sandbox that the judge knows"
    if level == "full" and not launch.bubblewrap_path():
        return "bubblewrap is not installed"
    if level == "full":
        return ""  # the rest shows when it starts: looking here would cost every run some milliseconds
    from judge.sandbox.linux import landlock, seccomp, syscalls

    if not syscalls.supported(syscalls.machine()):
        return f"there is no table of system calls for {syscalls.machine()}"
    if not seccomp.available():
        return "the kernel does not filter system calls (seccomp)"
    return "" if landlock.abi() else "the kernel has no landlock (Linux 5.13 or newer with lsm=landlock)"


def remedy(level: str, refusal: str) -> str:
    """The command that would raise the level, as well as it can be told."""
    if sys.platform != "linux":
        return "run the judge on Linux"
    if level == "full" and "not installed" in refusal:
        from shutil import which

        manager = next((name for name in _INSTALL if which(name)), None)
        return f"sudo {_INSTALL[manager]}" if manager else "install bubblewrap"
    if level == "full":
        for path, (bad, command) in _USER_NAMESPACES.items():
            if Path(path).exists() and Path(path).read_text(encoding="ascii").strip() == bad:
                return command
        return "in a Docker container: docker run --cap-add SYS_ADMIN --security-opt seccomp=unconfined"
    if "landlock" in refusal:
        return "boot Linux 5.13 or newer with landlock in its lsm= list"
    return ""
