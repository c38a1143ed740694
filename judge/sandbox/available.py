"""Which isolation levels this machine gives, tried one by one, and what a submission sees at each."""

from __future__ import annotations

import os
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from judge.errors import JudgeError, ShortageError
from judge.sandbox import places, visible
from judge.sandbox.boundary import LEVELS, Limits, Stop
from judge.sandbox.factory import Containment

MEANING = {
    "full": "bubblewrap's namespaces, landlock, a system call filter and resource limits",
    "strong": "landlock, a system call filter and resource limits; only the existence of files shows",
    "limits": "resource limits only: a submission can read what you can read",
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
_DEEDS = b"""
import ctypes, socket
for deed, act in {
    "open a socket": socket.socket,
    "start a process": lambda: os.fork() or os._exit(0),
    "signal its parent": lambda: os.kill(os.getppid(), 0),
    "write a file": lambda: os.open("/tmp", os.O_TMPFILE | os.O_WRONLY),
    "let others trace it": lambda: {0: "done"}[ctypes.CDLL(None).prctl(4, 1, 0, 0, 0)],
}.items():
    try:
        act()
    except (OSError, KeyError):
        continue
    print(deed, file=sys.stderr)
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


def levels_here(hide: Iterable[Path] = ()) -> tuple[Level, ...]:
    """Try each level, the best first, with a submission that does what it may not.

    It looks for the judge, its problems and solutions, `hide`, the home of whoever asks, and for who has an
    account; above `limits` it tries what only filters of system calls deny.
    """
    hide = tuple(hide)
    found = visible.visible(hide)
    home = places.real(os.path.expanduser("~"))  # noqa: PTH111 - Path's raises where there is none
    private = [] if home == "/" or places.within(home, found.folders) else [home]
    wanted = "\0".join([*found.unseen, *private, "/etc/passwd"])
    return tuple(_try(name, hide, wanted.encode(errors="surrogateescape")) for name in LEVELS)


def _try(name: str, hide: Iterable[Path], wanted: bytes) -> Level:
    try:
        with Containment(name, hide)(_LOOK if name == LEVELS[-1] else _LOOK + _DEEDS, "look.py") as box:
            looked = box.run_program(wanted, _LOOKING)
    except JudgeError as error:
        lasting = not isinstance(error, ShortageError)
        return Level(name, False, MEANING[name], error.what, error.remedy or "", lasting)
    seen, deed = (text.decode(errors="replace").partition("\n")[0] for text in (looked.stdout, looked.stderr))
    why = f"a submission could {deed}" if deed else ""
    if looked.stop is not Stop.ANSWERED:
        why = f"a program that looks around failed: {looked.detail}"
    return Level(name, not why, MEANING[name], why, visible=None if why else seen)
