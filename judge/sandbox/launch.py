"""Starting a container's seed at a level: the command line, the environment, the user a server becomes.

    full     bubblewrap → seed as pid 1 of its own namespaces → one fork server, landlock and seccomp inside
    strong   seed → fork servers, landlock and seccomp
    limits   seed → fork servers, resource limits only

Each needs less of the machine than the one above it.
"""

from __future__ import annotations

import marshal
import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

from judge.errors import JudgeError
from judge.sandbox.filters import filters
from judge.sandbox.parcels import BOOTSTRAP
from judge.sandbox.places import open_to_all
from judge.sandbox.room import Share, tasks_of_mine
from judge.sandbox.visible import Visible

PLAIN = {"PATH": "/usr/bin:/bin", "LANG": "C.UTF-8", "TZ": "UTC"}  # of all that is started
ENVIRONMENT = {
    **PLAIN,
    "ONLINE_JUDGE": "1",  # as other judges set it: templates ask
    "PYTHONHASHSEED": "0",  # a verdict must not depend on the order of a set
    "OPENBLAS_NUM_THREADS": "1",
    "OMP_NUM_THREADS": "1",
    "MKL_NUM_THREADS": "1",
    "NUMEXPR_NUM_THREADS": "1",
    "VECLIB_MAXIMUM_THREADS": "1",
    "MALLOC_ARENA_MAX": "2",  # threads of a submission would each reserve 64 MB of its address space
}
SCRATCH = "/scratch"
_PROCESS = Path("/proc/self")
_AT_HOME = ("HOME", "TMPDIR", "MPLCONFIGDIR")  # matplotlib's import ends without a folder that looks writable
_HOME_BYTES = 4096  # nothing is ever written there; 0 would be no limit
RESULT = "out"  # the folder in it that a compiler's result goes to
SCRATCH_BYTES = 256 << 20
_RANDOM = "/dev/urandom"
_STREAMS = {  # as every Linux has them
    "/dev/fd": "/proc/self/fd",
    "/dev/stdin": "/proc/self/fd/0",
    "/dev/stdout": "/proc/self/fd/1",
    "/dev/stderr": "/proc/self/fd/2",
}
_proc = ["--proc"]  # of the box's own processes alone
_UIDS = 0x7000_0000  # where no real user lives
_INTERPRETER = ("-s", "-P", "-S", "-B", "-X", "utf8")  # -I would also ignore PYTHONHASHSEED


class Workplace(NamedTuple):
    """What a container has besides the interpreter of its server: that of a compiler, or of what it made.

    `shown` are folders of this machine by the names they have inside at `full`; below that they keep their
    own. `scratch` is a folder of this machine that may be filled; at `full` an empty one of SCRATCH_BYTES is
    filled instead. `runnable` are real paths from which programs may be started, `reads` others it needs.
    """

    profile: str = "python"  # of judge.sandbox.filters
    shown: tuple[tuple[str, str], ...] = ()
    scratch: str = ""
    runnable: tuple[str, ...] = ()
    reads: tuple[str, ...] = ()
    descriptors: int = 64
    random: bool = True  # whether there is /dev/urandom

    def where(self, name: str, level: str) -> str:
        """The path inside of one of the folders shown, or of `SCRATCH`."""
        if level == "full":
            return name
        return self.scratch if name == SCRATCH else dict(self.shown)[name]


_OF_PYTHON = Workplace()


class LaunchPlan(NamedTuple):
    """How to start the seed of a fork server; `config` is what the server is told besides its source.

    `hidden` is what must not be visible, and where nothing of ours may be, for the region: nothing that
    outlives the look keeps these names. At `limits` nothing is hidden.
    """

    command: tuple[str, ...]
    environment: dict[str, str]
    config: dict[str, Any]
    hidden: bytes

    @property
    def seed(self) -> tuple[object, ...]:
        """What is the same of all servers that may have one seed."""
        return self.command, self.environment, "folders" in self.config

    @property
    def alone(self) -> bool:
        """Whether all that a seed starts share its namespaces."""
        return bool(self.config["level"] == "full")


def plan(
    level: str,
    name: str,
    visible: Visible,
    share: Share,
    make_home: Callable[[], str],
    place: Workplace = _OF_PYTHON,
) -> LaunchPlan:
    """The plan for `level`; the descriptors of its code and of its channel are its command's last words.

    `place` is another where it is no Python; that has a home, an empty folder of this machine, at `full` one
    inside: it may be listed, and only `limits` lets anybody write there. Raises OSError where a folder cannot
    be made or handed over.
    """
    full = level == "full"
    unseen = ((), ()) if level == "limits" else (visible.unseen, visible.searched)
    uid, hidden = _spare_uid(), marshal.dumps(unseen)
    closed = uid is not None and not open_to_all((*place.runnable, *place.reads), below=full)
    python = (visible.executable, *_INTERPRETER, "-c", BOOTSTRAP)
    config: dict[str, Any] = {
        "level": level,
        "name": name,
        "uid": uid,
        "reads_all": uid is not None and (closed or not visible.outsiders_may_read(below=full)),
        "parent": None if full else os.getpid(),
        "path": list(visible.imports),
        "readable": [*visible.folders, *visible.files, _RANDOM] if full else visible.readable(),
        "writable": ["/dev/null"],
        "environment": {},
        "threads": threads(level, share, alone=uid is not None),
        "cores": os.cpu_count() or 1,
        "unseen": len(hidden),
    }
    if level != "limits":
        config["filters"] = tuple(filters(os.uname().machine, place.profile))
    if place is _OF_PYTHON:
        own = SCRATCH if full else make_home()
        config["environment"] = dict.fromkeys(_AT_HOME, own)
        config["readable"].append(own)
        config["home"] = own
    else:
        own = place.scratch
        shown = [place.where(name, level) for name, _ in place.shown]
        readable = [*config["readable"], *shown]
        config["readable"] = [path for path in readable if place.random or path != _RANDOM]
        config["runnable"] = [*visible.around(place.runnable), *shown, *_loaders()]
        config["filled"] = [place.where(SCRATCH, level)] if own else []
        config["folders"] = [f"{folder}/{RESULT}" for folder in config["filled"]]
        config["descriptors"] = place.descriptors
        config["passes_on"] = closed
    if full:
        command = (*_bubblewrap(visible, uid, config["reads_all"], place), "--", *python)
        return LaunchPlan(command, {"PATH": os.environ.get("PATH", os.defpath)}, config, hidden)
    if own and uid is not None:
        os.chown(own, uid, uid)
    return LaunchPlan(python, ENVIRONMENT, config, hidden)


def _loaders() -> list[str]:
    """The programs that the kernel starts so that they load a program's libraries."""
    found = (path for folder in ("/lib", "/lib64") for path in Path(folder).glob("ld-*.so*"))
    return [os.path.realpath(path) for path in found]


def bind_proc(refusal: str) -> bool:
    """Whether `full` may be tried again, from now on with this machine's /proc.

    So it is where a container around the judge lets nobody mount one.
    """
    if "Can't mount proc" not in refusal or _proc != ["--proc"]:
        return False
    _proc[:] = ["--ro-bind", "/proc"]
    return True


def bubblewrap_path() -> str | None:
    """Where bubblewrap is installed."""
    for folder in os.get_exec_path():
        path = os.path.join(folder, "bwrap")  # noqa: PTH118 - as long as there is no folder it is no Path
        if os.access(path, os.X_OK) and os.path.isfile(path):  # noqa: PTH113
            return path
    return None


def _bubblewrap(visible: Visible, uid: int | None, reads_all: bool, place: Workplace) -> list[str]:
    arguments = [bubblewrap_path() or "bwrap", "--die-with-parent", "--new-session", "--as-pid-1"]
    arguments += ["--clearenv", "--unshare-ipc", "--unshare-pid", "--unshare-net", "--unshare-uts"]
    arguments += ["--unshare-cgroup-try", "--hostname", "box", "--cap-drop", "ALL"]
    if uid is None:
        arguments += ["--unshare-user", "--uid", "65534", "--gid", "65534"]
    else:  # real root: kernel uid 0 would be exempt from RLIMIT_NPROC, so it changes its user inside instead
        kept = ["CAP_SETUID", "CAP_SETGID", *(["CAP_DAC_READ_SEARCH"] if reads_all else [])]
        arguments += [part for capability in kept for part in ("--cap-add", capability)]
    for key, value in ENVIRONMENT.items():
        arguments += ["--setenv", key, value]
    made: set[str] = set()
    for path in (*visible.folders, *visible.files):
        arguments += [*_parents(path, made), "--ro-bind", path, path]
    for path, target in visible.links:
        arguments += [*_parents(path, made), "--symlink", target, path]
    for path in visible.hidden:
        arguments += ["--perms", "0555", "--tmpfs", path, "--remount-ro", path]
    arguments += _parents("/dev/null", made)
    for device in ("/dev/null", _RANDOM) if place.random else ("/dev/null",):
        arguments += ["--dev-bind", device, device]
    arguments += [*_proc, "/proc"]  # landlock lets nobody list or read it
    for name, target in _STREAMS.items():
        arguments += ["--symlink", target, name]
    for name, folder in place.shown:
        arguments += ["--ro-bind", folder, name]
    if place is _OF_PYTHON or place.scratch:
        size = _HOME_BYTES if place is _OF_PYTHON else SCRATCH_BYTES
        arguments += ["--perms", "1777", "--size", str(size), "--tmpfs", SCRATCH]
    return [*arguments, "--chdir", "/", "--remount-ro", "/"]


def _parents(path: str, made: set[str]) -> list[str]:
    """Make the folders above a mount readable for everybody, also below a private home."""
    arguments: list[str] = []
    for parent in reversed(Path(path).parents):
        if str(parent) != "/" and str(parent) not in made:
            made.add(str(parent))
            arguments += ["--perms", "0755", "--dir", str(parent)]
    return arguments


def _spare_uid() -> int | None:
    """A user nobody is, another each time, for root to become; None for who may not change their user."""
    if sys.platform != "linux" or os.geteuid() != 0 or not _may_change_user():
        return None
    wanted = _UIDS + int.from_bytes(os.urandom(3), "little")
    top = 0
    for line in _of_proc("uid_map"):
        first, _, length = map(int, line.split())
        if first <= wanted < first + length:
            return wanted
        top = max(top, first + length - 1)
    return top if top > 1000 else None


def _may_change_user() -> bool:
    """Whether this root has CAP_SETGID and CAP_SETUID, which some containers take away."""
    effective = next(line.split()[1] for line in _of_proc("status") if line.startswith("CapEff"))
    return int(effective, 16) >> 6 & 0b11 == 0b11


def _of_proc(name: str) -> list[str]:
    """The lines that the kernel has of this process. Raises JudgeError where it shows none."""
    try:
        return (_PROCESS / name).read_text(encoding="ascii", errors="replace").splitlines()
    except FileNotFoundError as fault:
        remedy = "mount it: mount -t proc proc /proc"
        raise JudgeError("nothing can be judged where there is no /proc", remedy=remedy) from fault


def threads(level: str, share: Share, *, alone: bool) -> int:
    """RLIMIT_NPROC that leaves a submission its threads; the kernel counts those of the whole user.

    `alone` says that it has a user to itself.
    """
    if sys.platform != "linux":
        return 0
    if alone or level == "full":
        return share.each + (2 if alone else 3)  # itself, its server, and the seed of the same user
    return max(1, min(tasks_of_mine() + share.together, share.ceiling))
