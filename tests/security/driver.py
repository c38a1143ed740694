"""Runs attacks as whoever starts it and writes one JSON object for each: `driver.py LEVEL < names`.

`driver.py levels` writes what this user can have, one JSON object a level.

LEVEL is an isolation level, or `none` for the positive control: the script in a plain interpreter, in a
temporary folder, with a time-out. The targets of the attacks (files, sockets, a process) are made here, so
that they belong to the user the attacks are run as.
"""

from __future__ import annotations

import contextlib
import ctypes
import json
import os
import resource
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from table import ATTACKS, SCRIPTS

from judge.errors import JudgeError
from judge.sandbox import open_box
from judge.sandbox.available import levels_here
from judge.sandbox.boundary import Limits, Stop
from judge.sandbox.levels import missing

MEMORY, OUTPUT = 256 << 20, 1 << 20
PATIENT = Limits(cpu_seconds=2.0, wall_seconds=6.0, memory_bytes=MEMORY, output_bytes=OUTPUT)
LIMITS = {
    frozenset({Stop.MEMORY}): Limits(10.0, 30.0, MEMORY, OUTPUT),  # some machines hand out pages slowly
    frozenset({Stop.CPU}): Limits(0.2, 6.0, MEMORY, OUTPUT),
    frozenset({Stop.WALL}): Limits(1.0, 0.5, MEMORY, OUTPUT),
}
CONTROL_SECONDS, PATIENCE = 0.7, 20  # for what goes on until it is ended, and for what ends by itself
CONTROL_MEMORY = 1 << 30
SECRET = "EXPECTED-" + "0123abcd"
ENDS = {attack.name: attack.ends for attack in ATTACKS}
CONTROLS = {attack.name: attack.control for attack in ATTACKS}


def possible(level: str) -> bool:
    """Whether this machine gives what a level needs; where the judge denies it, that is our own fault."""
    if missing("strong" if level == "full" else level) or missing(level):
        return False
    bare = ["bwrap", "--unshare-all", "--ro-bind", "/", "/", "true"]
    return level != "full" or subprocess.run(bare, capture_output=True, check=False).returncode == 0


@contextlib.contextmanager
def targets() -> Iterator[dict[str, Any]]:
    """Everything the attacks are aimed at, gone afterwards."""
    folder = Path(tempfile.mkdtemp(prefix="judge-attacked-"))
    folder.chmod(0o777)
    home = Path(tempfile.mkdtemp(prefix="judge-home-"))
    package = Path(sys.modules["judge"].__file__ or "").parent
    private = home / "private.txt"
    private.write_text("private")
    secret = folder / "answers.txt"
    secret.write_text(SECRET)
    (folder / "link").symlink_to(secret)
    with contextlib.ExitStack() as closing:
        closing.callback(shutil.rmtree, folder, ignore_errors=True)
        closing.callback(shutil.rmtree, home, ignore_errors=True)
        listener = closing.enter_context(socket.create_server(("127.0.0.1", 0)))
        for kind, name in ((socket.SOCK_STREAM, "stream"), (socket.SOCK_DGRAM, "datagram")):
            unix = closing.enter_context(socket.socket(socket.AF_UNIX, kind))
            unix.bind(str(folder / name))
            (folder / name).chmod(0o777)
            if kind == socket.SOCK_STREAM:
                unix.listen()
        abstract = closing.enter_context(socket.socket(socket.AF_UNIX))
        abstract.bind(f"\0judge-{os.getpid()}")
        abstract.listen()
        yield {
            "folder": str(folder),
            "secret": str(secret),
            "link": str(folder / "link"),
            "home_file": str(private),
            "judge_pid": os.getpid(),
            "judge_folder": str(package),
            "judge_parent": str(package.parent),
            "judge_file": str(package / "errors.py"),
            "port": listener.getsockname()[1],
            "unix_stream": str(folder / "stream"),
            "unix_datagram": str(folder / "datagram"),
            "unix_abstract": f"judge-{os.getpid()}",
        }


@contextlib.contextmanager
def aimed(target: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """The targets with a fresh victim file and a fresh victim process, which is ours and asleep."""
    folder = Path(target["folder"])
    victim = folder / "victim.txt"
    victim.write_text("victim")
    victim.chmod(0o666)
    buffer = ctypes.create_string_buffer(b"unharmed")  # a forked process has it at the same address
    pid = os.fork()
    if pid == 0:
        time.sleep(20)
        os._exit(0)
    try:
        yield {**target, "victim": str(victim), "victim_pid": pid, "victim_address": ctypes.addressof(buffer)}
    finally:
        os.kill(pid, signal.SIGKILL)
        os.waitpid(pid, 0)
        for left in folder.iterdir():
            if left.name.startswith(("victim", "made", "new")):
                left.rmdir() if left.is_dir() and not left.is_symlink() else left.unlink()


def contained(name: str, level: str, target: dict[str, Any]) -> dict[str, Any]:
    try:
        with open_box(SCRIPTS[name].encode(), f"{name}.py", level=level) as box:
            result = box.run_program(json.dumps(target).encode(), LIMITS.get(ENDS[name], PATIENT))
    except JudgeError as error:
        return {"name": name, "fault": str(error)}
    return {
        "name": name,
        "stop": result.stop.value,
        "output": result.stdout[:2000].decode(errors="replace"),
        "detail": result.detail,
        "errors": result.stderr[-300:].decode(errors="replace"),
    }


def bare(
    name: str, source: str, target: dict[str, Any], seconds: float = PATIENCE, file_bytes: int = 4 << 20
) -> dict[str, Any]:
    """What comes of it in a plain interpreter."""
    if name == "search_memory":
        source = f"known = {SECRET!r}\n{source}"
    with tempfile.TemporaryFile() as given, tempfile.TemporaryFile() as written:
        given.write(json.dumps(target).encode())
        given.seek(0)
        reading, writing = os.pipe()
        os.set_inheritable(reading, True)
        process = subprocess.Popen(
            [sys.executable, "-I", "-c", source],
            stdin=given,
            stdout=written,
            stderr=written,
            cwd=target["folder"],
            env={**os.environ, "JUDGE_TEST_SECRET": "1"},
            close_fds=False,
            start_new_session=True,
            preexec_fn=lambda: (
                resource.setrlimit(resource.RLIMIT_AS, (CONTROL_MEMORY, resource.RLIM_INFINITY)),
                resource.setrlimit(resource.RLIMIT_FSIZE, (file_bytes, resource.RLIM_INFINITY)),
                resource.setrlimit(resource.RLIMIT_CORE, (0, 0)),
            ),
        )
        os.close(reading)
        os.close(writing)
        until = time.monotonic() + seconds
        gone = 0
        while not gone and time.monotonic() < until:
            gone, status, usage = os.wait4(process.pid, os.WNOHANG)
            time.sleep(0.005)
        if not gone:
            os.kill(process.pid, signal.SIGKILL)
            _, status, usage = os.wait4(process.pid, 0)
        process.returncode = status
        size = os.fstat(written.fileno()).st_size
        written.seek(0)
        output = written.read(2000).decode(errors="replace")
    killed = os.WTERMSIG(status) if gone and os.WIFSIGNALED(status) else 0
    return {
        "name": name,
        "ran_on": not gone,
        "signal": killed,
        "output": output,
        "printed": size,
        "peak": usage.ru_maxrss << 10,
        "cpu": usage.ru_utime + usage.ru_stime,
    }


def main(level: str) -> None:
    if level == "levels":
        for row in levels_here():
            print(json.dumps({**vars(row), "possible": possible(row.name)}))
        return
    names = json.load(sys.stdin)
    os.environ["JUDGE_TEST_SECRET"] = "1"
    with targets() as target:
        for name in names:
            with aimed(target) as now:
                seconds = CONTROL_SECONDS if CONTROLS[name] == "runs" else PATIENCE
                if level == "none":
                    found = bare(name, SCRIPTS[name], now, seconds)
                else:
                    found = contained(name, level, now)
            print(json.dumps(found), flush=True)


if __name__ == "__main__":
    main(sys.argv[1])
