"""Takes a fork server's right to start processes away, asks it for everything, and gives the right back."""

from __future__ import annotations

import json
import os
import resource
import sys
import threading
from collections.abc import Callable
from contextlib import closing
from pathlib import Path
from typing import Any

from processes import below

from judge.errors import ShortageError
from judge.sandbox import Containment, open_box
from judge.sandbox.boundary import Limits

LIMITS = Limits(cpu_seconds=5.0, wall_seconds=20.0, memory_bytes=256 << 20, output_bytes=1 << 20)
SOURCE = b"def f(n):\n    return n\n"


def fork_server(pid: int) -> int:
    """The last of a line of processes, each the only child of the one before."""
    while children := [child for child, process in below(pid).items() if process.parent == pid]:
        (pid,) = children
    return pid


def allow(server: int, count: int) -> None:
    """Bound what it may have; where root gave it a user of its own, as that user."""
    status = Path(f"/proc/{server}/status").read_text().splitlines()
    user = next(line.split()[1] for line in status if line.startswith("Uid:"))
    child = os.fork()
    if child == 0:
        if os.geteuid() == 0:
            os.setgroups([])
            os.setresgid(*[int(user)] * 3)
            os.setresuid(*[int(user)] * 3)
        resource.prlimit(server, resource.RLIMIT_NPROC, (count, HARD))
        os._exit(0)
    assert os.waitpid(child, 0)[1] == 0


def told(act: Callable[[], Any]) -> str:
    try:
        return str(act())
    except ShortageError as fault:
        wanted = "no further process or thread can be started; use a smaller -j"
        return "a shortage" if wanted in str(fault) else str(fault)


def answers(box: Any) -> list[Any]:
    return [reply.answer for reply in box.call("f", [(1,)], LIMITS).replies]


def looked(level: str) -> str:
    """What comes of a look at a source where nothing can fork a server for it."""
    with closing(Containment(level).kept()) as boxes:
        with boxes(SOURCE, "f.py") as box:
            assert answers(box) == [1]
            seed = box._here()._seed._process.pid  # type: ignore[attr-defined]
        allow(fork_server(seed), 0)
        return told(lambda: boxes(SOURCE, "f.py").inspect())


def main(level: str) -> None:
    found: dict[str, Any] = {}
    if os.geteuid() == 0 and level == "strong":
        found["inspect"] = looked(level)
    with open_box(SOURCE, "f.py", level=level) as box:
        assert answers(box) == [1]
        server = fork_server(box._here()._seed._process.pid)
        allow(server, 0)
        soon = threading.Timer(0.1, allow, (server, MOST))
        soon.start()
        found["for a moment"] = answers(box)
        soon.join()
        allow(server, 0)
        found["calls"] = told(lambda: answers(box))
        found["afterwards"] = answers(box)
    print(json.dumps(found))


if __name__ == "__main__":
    MOST, HARD = resource.getrlimit(resource.RLIMIT_NPROC)
    main(sys.argv[1])
