"""A cluster on this machine, for tests: `judge worker` as people start it."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

TESTS = Path(__file__).parent
HERE = "tcp://127.0.0.1:0"


@contextmanager
def served(*words: str, **environment: str) -> Iterator[tuple[dict[str, Any], subprocess.Popen[str]]]:
    """`judge worker WORDS --json`, ready, and what it told then; it is ended as Ctrl-C ends it."""
    command = [sys.executable, "-m", "judge", "worker", *words, "--json"]
    path = os.pathsep.join([str(TESTS.parent), str(TESTS)])  # workers import what tests have them do
    settings = {**os.environ, "PYTHONPATH": path, **environment}
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=settings) as process:
        try:
            yield json.loads(process.stdout.readline()), process
        finally:
            if process.poll() is None:
                process.send_signal(signal.SIGINT)


def below(process: subprocess.Popen[str]) -> dict[int, str]:
    """The processes that a process has started, and those that these have: their command lines."""
    found, last = {process.pid: ""}, 0
    while len(found) > last:
        last = len(found)
        for folder in Path("/proc").glob("[0-9]*"):
            try:
                parent = int(folder.joinpath("stat").read_text().rpartition(")")[2].split()[1])
                if parent in found:
                    line = folder.joinpath("cmdline").read_bytes().replace(b"\0", b" ")
                    found.setdefault(int(folder.name), line.decode(errors="replace"))
            except OSError:
                continue
    del found[process.pid]
    return found


def workers(process: subprocess.Popen[str]) -> list[int]:
    """The processes that judge, below `judge worker`."""
    return [pid for pid, line in below(process).items() if "spawn_main" in line]
