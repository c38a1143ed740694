"""`--on slurm` and `--on slurm:FILE.toml`: workers as a job array of Slurm, for as long as the command runs.

    jobs = 8                    # how many workers are asked for, 4 where nothing is said
    cores = 1                   # submissions that each judges at once
    host = "login1.cluster"     # the name under which this machine is known to the others
    wait = 600                  # seconds until the first worker must have begun
    options = ["--partition=short", "--time=01:00:00"]      # for sbatch

The scheduler runs on this machine. The keys are made for this run alone, in a folder of the cache, which the
machines must share with this one, as they do the judge.
"""

from __future__ import annotations

import shlex
import shutil
import subprocess
import sys
import tempfile
import time
import tomllib
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from pathlib import Path

import msgspec
from msgspec import Struct

from judge.cluster.keys import Keys, new_keys
from judge.cluster.launch import Helper
from judge.cluster.where import Address
from judge.errors import JudgeError, UsageError, nearest, unwritable
from judge.folders import cache_folder
from judge.reading import read_ordinary

_START = 60.0  # seconds
_ANSWER = 60.0
_OLD = 7 * 86400.0
_OWN = (sys.executable, "-m", "judge")


class Config(Struct, frozen=True, forbid_unknown_fields=True):
    """What a file says, each key as in the text above."""

    jobs: int = 4
    cores: int = 1
    host: str = "0.0.0.0"
    wait: float = 600.0
    options: tuple[str, ...] = ()

    def command(self, address: str, keys: Path) -> list[str]:
        """The command line of sbatch."""
        worker = [*_OWN, "worker", address, "--keys", str(keys), "-j", str(self.cores)]
        return [
            "sbatch",
            "--parsable",
            "--job-name=judge",
            f"--array=1-{self.jobs}",
            f"--cpus-per-task={self.cores}",
            "--output=/dev/null",
            *self.options,
            "--wrap",
            f"exec {shlex.join(worker)}",
        ]


def read_config(path: Path | None) -> Config:
    """What a file says, or what is usual. Raises UsageError."""
    if path is None:
        return Config()
    try:
        table = tomllib.loads(read_ordinary(path).decode())
        for key in table:
            if key not in Config.__struct_fields__:
                near = nearest(key, Config.__struct_fields__)
                known = f"did you mean {near}?" if near else f"keys are {', '.join(Config.__struct_fields__)}"
                raise UsageError(f"there is no key '{key}'", where=str(path), remedy=known)
        config = msgspec.convert(table, Config)
    except OSError as fault:
        raise UsageError(
            f"cannot be read ({(fault.strerror or 'it failed').lower()})", where=str(path)
        ) from fault
    except (UnicodeDecodeError, tomllib.TOMLDecodeError, msgspec.ValidationError) as fault:
        raise UsageError(str(fault), where=str(path)) from fault
    if min(config.jobs, config.cores) < 1 or config.wait < 0:
        raise UsageError("jobs and cores are 1 or more, wait is 0 or more", where=str(path))
    return config


@contextmanager
def started(config: Config) -> Iterator[tuple[Address, Keys]]:
    """A scheduler here, and a job array that will send workers to it.

    Raises:
        JudgeError: the scheduler does not start, or Slurm does not take the job.
    """
    keys = new_keys()
    with ExitStack() as stack:
        folder = stack.enter_context(_shared_folder())
        keys.write(folder)
        command = [
            *_OWN,
            "worker",
            "--scheduler",
            f"tls://{config.host}:0",
            "-j",
            "0",
            "--keys",
            "-",
            "--json",
        ]
        scheduler = Helper("the scheduler", command, keys)
        stack.callback(scheduler.end)
        address = Address.of(str(scheduler.ready(_START)["address"]))
        job = _asked(config.command(str(address), folder)).partition(";")[0].strip()
        stack.callback(_cancel, job)
        yield address, keys


@contextmanager
def _shared_folder() -> Iterator[Path]:
    """A folder of the cache for the keys, which nobody else may open."""
    parent = cache_folder() / "cluster"
    try:
        parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        for left in parent.iterdir():  # by a command that was killed
            if time.time() - left.stat().st_mtime > _OLD:
                shutil.rmtree(left, ignore_errors=True)
        folder = Path(tempfile.mkdtemp(dir=parent))
    except OSError as fault:
        raise unwritable(parent, fault, "let $JUDGE_CACHE name a folder that the machines share") from fault
    try:
        yield folder
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def _asked(command: Sequence[str]) -> str:
    """What a program of Slurm answers. Raises JudgeError where it is not there or refuses."""
    try:
        ended = subprocess.run(
            command, capture_output=True, text=True, errors="replace", timeout=_ANSWER, check=False
        )
    except FileNotFoundError as fault:
        raise JudgeError(f"there is no {command[0]} here", remedy="use --on slurm where Slurm is") from fault
    except (OSError, subprocess.TimeoutExpired) as fault:
        raise JudgeError(f"{command[0]} does not answer") from fault
    if ended.returncode:
        said = (ended.stderr.strip().splitlines() or [f"exit status {ended.returncode}"])[-1]
        raise JudgeError(
            f"{command[0]} refuses: {said}", remedy="see the options in the file that slurm: names"
        )
    return ended.stdout


def _cancel(job: str) -> None:
    """Take the job back; what is left of it ends with its scheduler."""
    try:
        _asked(["scancel", job])
    except JudgeError:
        return
