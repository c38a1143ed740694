"""Work for executors to do, known by its name in every process: each item says what becomes of its worker.

An item is `FOLDER WHAT NAME`; the folder remembers what has happened already.
"""

from __future__ import annotations

import os
import signal
import time
from pathlib import Path

from judge.errors import UsageError


def work(item: str) -> str:
    """The item's name in capitals, unless it is to be something worse."""
    place, what, name = item.split(" ")
    folder = Path(place)
    (folder / f"{name}.{os.getpid()}").touch()
    if what == "held":
        _wait_for(folder / "release")
    elif what == "once" and not (folder / f"{name}.died").exists():
        (folder / f"{name}.died").touch()
        _die()
    elif what == "always":
        _die()
    elif what == "killed":
        os.kill(os.getpid(), signal.SIGKILL)
    elif what == "faulty":
        raise ArithmeticError(name)
    elif what == "usage":
        raise UsageError("isolation full cannot be had here")
    elif what == "forever":
        time.sleep(600)
    return name.upper()


def _die() -> None:
    """As the executor's kind of worker dies: a process by SIGKILL; of a thread that can only be said."""
    if os.environ.get("EXECUTED_BY") == str(os.getpid()):
        raise ChildProcessError("killed by SIGKILL")
    os.kill(os.getpid(), signal.SIGKILL)


def _wait_for(path: Path) -> None:
    for _ in range(3000):
        if path.exists():
            return
        time.sleep(0.01)
