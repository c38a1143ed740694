"""A dask scheduler and its workers on this machine, as people start them; only TLS is set up by a file."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

TESTS = Path(__file__).parent
_QUIET = ("--dashboard-address", "127.0.0.1:0")
_KNOWN = "Registered to: "  # what a worker writes


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
        waited(lambda: self.file.exists() and bool(self.file.read_text()))
        self.address = json.loads(self.file.read_text())["address"]

    def add(self, workers: int, threads: int = 1, **settings: str) -> subprocess.Popen[bytes]:
        """Start workers, and wait until the scheduler knows them."""
        log = self._folder / "dask.log"
        known = log.read_text().count(_KNOWN) + workers
        words = ("--nworkers", workers, "--nthreads", threads, "--local-directory", self._folder)
        process = self._started("worker", "--scheduler-file", self.file, *words, *_QUIET, **settings)
        waited(lambda: log.read_text().count(_KNOWN) >= known)
        return process

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


def waited(look: Callable[[], bool]) -> None:
    """Wait until it is so, for as long as a busy machine may need."""
    until = time.monotonic() + 120
    while not look():
        assert time.monotonic() < until, "it has not started"
        time.sleep(0.05)


@contextmanager
def served(folder: Path, workers: int, **settings: str) -> Iterator[Cluster]:
    """A cluster of so many workers of one thread; they end with it."""
    with ExitStack() as stack:
        cluster = Cluster(stack, folder, **settings)
        if workers:
            cluster.add(workers)
        yield cluster
