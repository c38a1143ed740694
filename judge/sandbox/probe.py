"""Which isolation levels this machine gives, why not a better one, and the command that would raise it."""

from __future__ import annotations

import os
import platform
import sys
from functools import cache
from pathlib import Path

from judge.sandbox import launch

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
    from judge.sandbox import filters
    from judge.sandbox.linux import kernel, landlock

    machine = os.uname().machine
    if machine not in filters.MACHINES:
        return f"there is no table of system calls for {machine}"
    if not kernel.filters_calls(filters.filters(machine, "python").load):
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
