"""What this machine has left for submissions: processes and threads, file descriptors, memory.

It is counted once a command, before the first container: what submissions take later is shared out of that.

    left − BASE_TASKS = jobs · (OWN_TASKS + each)      each: the threads of one submission, THREADS at most
"""

from __future__ import annotations

import os
import resource
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from judge.errors import ShortageError

THREADS = 128  # that one submission may have at once
SLACK = 128  # what else the user may start meanwhile, where the kernel counts all of a user's together
LEAST_THREADS = 4
OWN_TASKS = 16  # of the judge for each job: its thread, two containers, what they start
BASE_TASKS = 32  # the judge itself, the reference's container, those of the known mistakes
OWN_FILES = 24  # descriptors for each job, most of them only while a container starts
BASE_FILES = 64
MOST_FILES = 1 << 16  # more are of no use, and some systems refuse to be asked for all
_PLENTY = 1 << 30
_CGROUPS = Path("/sys/fs/cgroup")


class Share(NamedTuple):
    """What one submission may have of threads.

    `each` where the kernel counts those of its container alone; `together` are those of all submissions at
    once, for where it counts them with everything else of the user; `ceiling` is what that may come to.
    """

    each: int = THREADS
    together: int = THREADS + SLACK
    ceiling: int = _PLENTY

    @property
    def short(self) -> bool:
        """Whether that is less than a submission may have elsewhere."""
        return self.each < THREADS


class Room(NamedTuple):
    """How many tasks and descriptors are left, and the limits that say so, in words."""

    tasks: int
    tasks_limit: str
    ceiling: int  # of all tasks of the user
    files: int
    files_limit: str

    def at_once(self, jobs: int) -> tuple[int, str]:
        """How many of so many jobs have room beside each other, one at least; the limit where it is fewer."""
        by_tasks = max(1, (self.tasks - BASE_TASKS) // (OWN_TASKS + THREADS))
        by_files = max(1, (self.files - BASE_FILES) // OWN_FILES)
        if jobs <= min(by_tasks, by_files):
            return jobs, ""
        return (by_tasks, self.tasks_limit) if by_tasks <= by_files else (by_files, self.files_limit)

    def share(self, jobs: int) -> Share:
        """What each of so many submissions at once may have."""
        left = self.tasks - BASE_TASKS - jobs * OWN_TASKS
        return Share(
            max(LEAST_THREADS, min(THREADS, left // jobs)),
            max(LEAST_THREADS, min(jobs * THREADS + SLACK, left)),
            max(LEAST_THREADS, self.ceiling - BASE_TASKS - jobs * OWN_TASKS),
        )


def measure() -> Room:
    """The room that is left now."""
    ceiling = _PLENTY
    bounds = [(_PLENTY, "")]  # of tasks: what is left, and of which limit
    if sys.platform == "linux":
        if os.geteuid() != 0:  # root's own are not bounded, and what it contains has another user each time
            ceiling = resource.getrlimit(resource.RLIMIT_NPROC)[0]
            ceiling = _PLENTY if ceiling == resource.RLIM_INFINITY else ceiling
        if ceiling < _PLENTY:
            bounds.append((ceiling - tasks_of_mine(hidden=True), f"ulimit -u is {ceiling}"))
        bounds += [(left, f"{where} is {most}") for most, left, where in _pids()]
    tasks, tasks_limit = min(bounds, key=lambda bound: bound[0])
    most = resource.getrlimit(resource.RLIMIT_NOFILE)[0]
    files = _PLENTY if most == resource.RLIM_INFINITY else most - _open_files()
    return Room(tasks, tasks_limit, ceiling, files, f"ulimit -n is {most}")


def raise_descriptors() -> None:
    """Take as many descriptors as may be had without asking anybody."""
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    wanted = MOST_FILES if hard == resource.RLIM_INFINITY else min(hard, MOST_FILES)
    if soft == resource.RLIM_INFINITY or soft >= wanted:
        return
    try:
        resource.setrlimit(resource.RLIMIT_NOFILE, (wanted, hard))
    except (ValueError, OSError):  # a system with a bound of its own: what it gives has to do
        return


def tasks_of_mine(*, hidden: bool = False) -> int:
    """The processes and threads of this user; with `hidden` also those that deny being looked at.

    Fork servers and submissions deny it: /proc gives them to root, and only their status tells.
    """
    count, me = 0, os.geteuid()
    for entry in os.scandir("/proc"):
        if entry.name.isdecimal():
            try:
                owner = entry.stat().st_uid
                if owner == me or (hidden and owner == 0 and _is_of(entry.name, me)):
                    count += max(1, os.stat(f"/proc/{entry.name}/task").st_nlink - 2)  # noqa: PTH116 - hot
            except OSError:
                continue  # it has just ended
    return count


def check_memory(wanted: int) -> None:
    """Raise ShortageError if limits on this process leave a submission less address space than it may use.

    It would otherwise be told that it needs too much.
    """
    if sys.platform != "linux":  # elsewhere these limits bind nobody
        return
    data = resource.getrlimit(resource.RLIMIT_DATA)[0]
    space = resource.getrlimit(resource.RLIMIT_AS)[1]  # a container takes all that it may
    for most, option in ((data, "-d"), (space, "-v")):
        if most != resource.RLIM_INFINITY and most < wanted:
            what = f"a submission may use {wanted >> 20} MB of address space, and {most >> 20} MB are allowed"
            raise ShortageError(what, remedy=f"raise the limit (ulimit {option} unlimited)")


def oom_kills() -> int:
    """How many processes the kernel has killed for want of memory since it started; 0 if it does not say."""
    try:
        lines = Path("/proc/vmstat").read_text(encoding="ascii").splitlines()
    except OSError:
        return 0
    return next((int(line.split()[1]) for line in lines if line.startswith("oom_kill ")), 0)


def _is_of(pid: str, user: int) -> bool:
    """Whether a process runs as that user."""
    status = Path(f"/proc/{pid}/status").read_text(encoding="ascii", errors="replace")
    return any(line.split()[1] == str(user) for line in status.splitlines() if line.startswith("Uid:"))


def _pids() -> Iterator[tuple[int, int, str]]:
    """Each control group of this process that bounds its tasks: the bound, what is left of it, its file."""
    for folder in _groups():
        try:
            most = (folder / "pids.max").read_text(encoding="ascii").strip()
            if most != "max":
                now = int((folder / "pids.current").read_text(encoding="ascii"))
                yield int(most), int(most) - now, str(folder / "pids.max")
        except (OSError, ValueError):
            continue


def _groups() -> Iterator[Path]:
    """The folders of the control groups that count its tasks, of either version, from its own to the root."""
    try:
        rows = Path("/proc/self/cgroup").read_text(encoding="utf-8", errors="replace").splitlines()
    except OSError:
        return
    for row in rows:
        number, _, rest = row.partition(":")
        controllers, _, path = rest.partition(":")
        if number == "0":
            mounts = [_CGROUPS, _CGROUPS / "unified"]
        elif "pids" in controllers.split(","):
            mounts = [_CGROUPS / controllers, _CGROUPS / "pids"]
        else:
            continue
        for mount in dict.fromkeys(mounts):
            folder = mount / path.strip("/")
            yield from dict.fromkeys((folder, *folder.parents[: len(folder.relative_to(mount).parts)]))


def _open_files() -> int:
    try:
        return len(os.listdir("/dev/fd"))  # noqa: PTH208 - numbers, not paths
    except OSError:
        return 0
