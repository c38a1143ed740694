"""A dask scheduler and its workers on this machine, as people start them; only TLS is set up by a file."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

TESTS = Path(__file__).parent
_QUIET = ("--dashboard-address", "127.0.0.1:0")


class Cluster:
    """`file` names its scheduler; what is started ends with `stack`."""

    def __init__(self, stack: ExitStack, folder: Path, **settings: str) -> None:
        """`settings` are added to the environment of the processes."""
        path = os.pathsep.join([str(TESTS.parent), str(TESTS)])  # workers import what tests have them do
        self._environment = {**os.environ, "PYTHONPATH": path, **settings}
        self._stack = stack
        self._folder = folder
        self.file = folder / "scheduler.json"
        self.scheduler = self._started(
            *("scheduler", "--scheduler-file", self.file, "--host", "127.0.0.1", "--port", 0, *_QUIET)
        )
        until = time.monotonic() + 60
        while not self.file.exists():
            assert time.monotonic() < until, "no scheduler has started"
            time.sleep(0.05)
        self.address = json.loads(self.file.read_text())["address"]

    def add(self, workers: int, threads: int = 1, **settings: str) -> subprocess.Popen[bytes]:
        """Start workers."""
        words = ("--nworkers", workers, "--nthreads", threads, "--local-directory", self._folder)
        return self._started("worker", "--scheduler-file", self.file, *words, *_QUIET, **settings)

    def _started(self, *words: object, **settings: str) -> subprocess.Popen[bytes]:
        with (self._folder / "dask.log").open("ab") as log:
            process = subprocess.Popen(
                [sys.executable, "-m", "dask", *map(str, words)],
                stdout=log,
                stderr=log,
                env={**self._environment, **settings},
            )
        self._stack.callback(process.wait)
        self._stack.callback(process.terminate)
        return process


@contextmanager
def served(folder: Path, workers: int, **settings: str) -> Iterator[Cluster]:
    """A cluster of so many workers of one thread, none of which need be ready; they end with it."""
    with ExitStack() as stack:
        cluster = Cluster(stack, folder, **settings)
        if workers:
            cluster.add(workers)
        yield cluster
