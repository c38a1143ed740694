"""Running the attacks of attacks.py on this machine, and saying which of them was held."""

from __future__ import annotations

import contextlib
import json
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any

from attacks import ATTACKS, BREACH, HELD, Attack, Attacked

import judge.sandbox
from judge.sandbox.boundary import BoxFactory, Limits, ProgramResult, Stop
from judge.sandbox.inside import wire
from judge.sandbox.launch import ENVIRONMENT

_MEMORY, _OUTPUT = 64 << 20, 1 << 20
_USUAL = Limits(2.0, 10.0, 256 << 20, _OUTPUT)
_LIMITS = {
    Stop.MEMORY: Limits(2.0, 10.0, _MEMORY, _OUTPUT),
    Stop.CPU: Limits(0.2, 10.0, 256 << 20, _OUTPUT),
    Stop.WALL: Limits(2.0, 0.5, 256 << 20, _OUTPUT),
}
_SHOWN = 200
_LONGEST = 70  # bytes of a folder's path below which that of a socket is not too long for the system
_FIRST_MAPPING = re.compile(r"^([0-9a-f]+)-[0-9a-f]+ r", re.MULTILINE)


def attacked(
    boxes: BoxFactory, packs: Iterable[Path], seen: Callable[[int, int], None] = lambda *_: None
) -> Iterator[Attacked]:
    """Run them all, each in a box of its own; `packs` are the folders of problems and solutions.

    `seen` is told how many of how many are done.

    Raises:
        JudgeError: a box cannot be had.
        OSError: there is no room for what is attacked.
    """
    with targets(packs) as target:
        for count, attack in enumerate(ATTACKS):
            seen(count, len(ATTACKS))
            with boxes(attack.source, f"{attack.name}.py") as box:
                limits = _LIMITS.get(attack.ends[0], _USUAL) if attack.ends else _USUAL
                yield _judged(attack, box.run_program(json.dumps(target).encode(), limits))
    seen(len(ATTACKS), len(ATTACKS))


def _judged(attack: Attack, run: ProgramResult) -> Attacked:
    said = wire.printable(run.stdout[:_SHOWN].decode(errors="replace"))
    held, how = run.stop is Stop.EXITED and BREACH not in said, run.detail or said
    if attack.ends:
        held = run.stop in attack.ends
    elif said.startswith(HELD):
        held, how = True, said.removeprefix(HELD).strip()
    return Attacked(attack.name, attack.tries, held, how)


@contextlib.contextmanager
def targets(packs: Iterable[Path]) -> Iterator[dict[str, Any]]:
    """What there is to attack, made for it and gone afterwards: files, sockets, a process that sleeps."""
    with contextlib.ExitStack() as closing:
        fits = len(os.fsencode(tempfile.gettempdir())) <= _LONGEST
        folder = Path(tempfile.mkdtemp(prefix="judge-attacked-", dir=None if fits else "/tmp"))
        closing.callback(shutil.rmtree, folder, ignore_errors=True)
        folder.chmod(0o777)
        for name, mode in (("private", 0o600), ("open", 0o666)):
            (folder / name).write_text(name)
            (folder / name).chmod(mode)
        (folder / "link").symlink_to(folder / "private")
        listener = closing.enter_context(socket.create_server(("127.0.0.1", 0)))
        unix = closing.enter_context(socket.socket(socket.AF_UNIX))
        unix.bind(str(folder / "socket"))
        (folder / "socket").chmod(0o777)
        unix.listen()
        victim = _sleeper()
        closing.callback(_ended, victim)
        yield {
            "judge_file": judge.sandbox.__file__,
            "packs": [str(path) for path in packs],
            "folder": str(folder),
            "private": str(folder / "private"),
            "open": str(folder / "open"),
            "link": str(folder / "link"),
            "new": str(folder / "new"),
            "name": f"judge-attack-{os.getpid()}",
            "port": listener.getsockname()[1],
            "socket": str(folder / "socket"),
            "victim": victim.pid,
            "address": _address_in(victim.pid),
            "judge": os.getpid(),
            "environment": {
                name: value
                for name, value in os.environ.items()
                if name not in {*ENVIRONMENT, "PWD"}  # bubblewrap says where it is
            },
        }


def _sleeper() -> subprocess.Popen[bytes]:
    """A process that sleeps, and has begun to."""
    command = [sys.executable, "-I", "-c", "import time; print(flush=True); time.sleep(600)"]
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE)
    assert process.stdout is not None
    process.stdout.readline()
    return process


def _ended(process: subprocess.Popen[bytes]) -> None:
    process.send_signal(signal.SIGKILL)
    process.communicate()


def _address_in(pid: int) -> int:
    """An address in that process that can be read; 0 where the system does not say."""
    try:
        maps = Path(f"/proc/{pid}/maps").read_text(encoding="utf-8", errors="replace")
    except OSError:
        return 0
    found = _FIRST_MAPPING.search(maps)
    return int(found[1], 16) if found else 0
