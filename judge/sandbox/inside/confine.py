"""Giving up rights, in the order in which the kernel allows it.

    the seed                 death with the parent
    a fork server, once      other user (root only) → death with the parent → no new privileges
                             → landlock → big filter
    a child, each time       resource limits → small filter

What is started from a file of its own, a compiler or what it made, has limits of its own too.

A credential change clears the death signal, so that comes after it. Landlock and seccomp are inherited.
"""

from __future__ import annotations

import os
import resource
import sys

from judge.sandbox.inside import wire

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

LINUX = sys.platform == "linux"
if LINUX:
    from judge.sandbox.inside import linux
_SIGKILL = 9


class Confinement:
    """This process confined for good, and what each of its children still has to do."""

    def __init__(self, config: dict[str, Any]) -> None:
        """Give up everything the fork server does not need. Raises OSError where the kernel refuses."""
        self._server = os.getpid()
        self._small: Callable[[], None] | None = None  # load a child's own filter
        _once_only_limits(config.get("descriptors", wire.MOST_DESCRIPTORS))
        if LINUX:
            self._on_linux(config)

    def _on_linux(self, config: dict[str, Any]) -> None:
        if config["level"] == "full" and "home" in config and not linux.abi():
            os.chmod(config["home"], 0o555)  # noqa: PTH101 - nothing else would keep files out of it
        if config["uid"] is not None:
            passed_on = config.get("passes_on", False)  # to a compiler that lies in a private home
            _become(config["uid"], config["reads_all"], passed_on=passed_on)
        die_with(config["parent"])
        linux.prctl(linux.PR_SET_NO_NEW_PRIVS, 1)
        linux.prctl(linux.PR_SET_CHILD_SUBREAPER, 1)  # what a child leaves behind comes to us, to be ended
        if config["level"] == "limits":
            return
        if linux.abi():
            runnable, filled = config.get("runnable"), config.get("filled", ())
            linux.restrict(config["readable"], config["writable"], runnable, filled)
        server, child, pid_at, load = config["filters"]
        self._small = lambda: linux.load_filter(load, own_filter(child, pid_at))
        linux.load_filter(load, bytearray(server))

    def confine_child(self, limits: dict[str, int], *, starts: bool = False) -> None:
        """Confine a fresh child before anything foreign runs in it. Raises OSError.

        `limits` are those of resources by name; `starts` tells that it becomes another program.
        """
        if starts or self._small is None:
            os.setpgid(0, 0)  # so that what it forks can be ended with it
        for name, value in limits.items():
            _limit(getattr(resource, name), value)
        die_with(self._server)
        if self._small is not None:
            self._small()


def die_with(parent: int | None) -> None:
    """End with this parent, also where it is dead by now; None where another sees to that.

    A fork does not inherit it. Elsewhere than on Linux the hang-up has to do.
    """
    if LINUX:
        linux.prctl(linux.PR_SET_PDEATHSIG, _SIGKILL)
        linux.prctl(linux.PR_SET_DUMPABLE, 0)
    if parent not in (None, os.getppid()):
        os._exit(1)


def own_filter(rows: bytes, pid_at: tuple[int, ...]) -> bytearray:
    """A child's filter with the pid of this process where one goes."""
    own = bytearray(rows)
    for place in pid_at:
        own[place : place + 4] = os.getpid().to_bytes(4, "little")
    return own


def _once_only_limits(descriptors: int) -> None:
    _limit(resource.RLIMIT_CORE, 0)
    _limit(resource.RLIMIT_NOFILE, descriptors)
    if LINUX:
        for name in ("MEMLOCK", "MSGQUEUE", "NICE", "RTPRIO"):
            _limit(getattr(resource, f"RLIMIT_{name}"), 0)
    # The stack grows to the hard limit only from here on: read at exec, it would be every thread's size.
    _limit(resource.RLIMIT_STACK, resource.getrlimit(resource.RLIMIT_STACK)[1])


def _limit(which: int, value: int) -> None:
    hard = resource.getrlimit(which)[1]
    if hard != resource.RLIM_INFINITY:
        value = min(value, hard)
    try:
        resource.setrlimit(which, (value, value))
    except (ValueError, OSError):
        if LINUX:  # macOS knows some limits and refuses to set them
            raise


def _become(uid: int, reads_all: bool, *, passed_on: bool) -> None:
    """Become a user that owns nothing here; `reads_all` keeps the right to pass folders closed to others.

    That right is needed where the interpreter lies in a private home; landlock still says for which files.
    """
    os.setgroups([])
    os.setresgid(uid, uid, uid)
    linux.prctl(linux.PR_SET_KEEPCAPS, int(reads_all))
    os.setresuid(uid, uid, uid)
    linux.keep_only(linux.CAP_DAC_READ_SEARCH if reads_all else None, passed_on=passed_on)
