"""A process that has imported the judge and forks for every command line, which takes a few milliseconds.

It reads requests from standard input, a JSON object a line, and answers each with one on standard output:
{"status": 2, "outside": ["open /etc/x"], "left": []}. A status is negative where a signal ended the command
line; `outside` lists what it tried to write outside its own folders, which is refused; `left` are the
processes that it has left behind, which are ended.

A stream of a command line is a file's path, or one of the words below.
"""

from __future__ import annotations

import atexit
import fcntl
import gc
import importlib
import json
import os
import pty
import select
import signal
import stat
import sys
import tempfile
import termios
import threading
import time
import traceback
from pathlib import Path
from typing import Any, NoReturn

from judge.sandbox.inside import linux

CLOSED, FULL, NULL, GONE, TERMINAL = "closed", "full", "null", "gone", "terminal"
KEPT = "kept"  # a word for the file of the case's own
PATIENCE = 300  # seconds after which a command line is said not to end; nothing takes a tenth of it
_TO_END = 20  # seconds for what a command line has started: it ends at once when that has ended
_OWN_FAULT = 99  # the status of a child of which we made no command line
_HIGH = 64  # our own descriptors are above, out of the way of what the judge opens
_WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND
_CHANGES = {  # audited events, and which of their arguments are paths that are changed
    **dict.fromkeys(("os.mkdir", "os.remove", "os.rmdir", "os.truncate", "os.chmod", "os.chown"), (0,)),
    **dict.fromkeys(("os.utime", "os.mkfifo", "os.mknod", "sqlite3.connect"), (0,)),
    "os.rename": (0, 1),
    "os.link": (1,),
    "os.symlink": (1,),
}
_OF_LINKS = ("os.rename", "os.remove", "os.link", "os.symlink")
_AHEAD = ("hypothesis", "hypothesis.internal.conjecture.engine", "jinja2", "rich.progress", "sqlite3")


def main() -> None:
    """Serve until there is nothing more to read."""
    _import_ahead()
    linux.prctl(linux.PR_SET_CHILD_SUBREAPER, 1)  # what a command line leaves behind comes to us
    answers = os.fdopen(fcntl.fcntl(1, fcntl.F_DUPFD_CLOEXEC, _HIGH), "w")
    for line in sys.stdin.buffer:
        answers.write(json.dumps(_serve(json.loads(line))) + "\n")
        answers.flush()


def _import_ahead() -> None:
    from judge.cli.table import COMMANDS

    for name in (*_AHEAD, *(f"judge.cli.commands.{entry.module}" for entry in COMMANDS.values())):
        importlib.import_module(name)
    for path in (Path(sys.modules["judge"].__path__[0])).rglob("*.py"):
        apart = {"inside", "__main__", "katas"} & {*path.parts}
        if not apart and "testing" not in path.stem:
            parts = path.relative_to(Path(sys.modules["judge"].__path__[0]).parent).with_suffix("").parts
            importlib.import_module(".".join(parts).removesuffix(".__init__"))
    gc.collect()
    gc.freeze()


def _serve(request: dict[str, Any]) -> dict[str, Any]:
    master, slave = pty.openpty() if TERMINAL in request["streams"] else (-1, -1)
    report = tempfile.TemporaryFile()  # noqa: SIM115 - closed below
    child = os.fork()
    if child == 0:
        try:
            _become(request, slave, report.fileno())
        finally:
            os._exit(_OWN_FAULT)
    if slave >= 0:
        os.close(slave)
    status = _wait(child, master, request)
    report.seek(0)
    outside = sorted(set(report.read().decode(errors="replace").splitlines()))
    report.close()
    return {"status": os.waitstatus_to_exitcode(status), "outside": outside, "left": _left()}


def _left() -> list[str]:
    """End the processes that a command line has left behind, once they had time to end by themselves."""
    until = time.monotonic() + _TO_END
    left = []
    while True:
        try:
            gone = os.waitpid(-1, os.WNOHANG)[0]
        except ChildProcessError:
            return left
        if not gone and time.monotonic() < until:
            time.sleep(0.005)
        elif not gone:
            me = Path(f"/proc/self/task/{os.getpid()}/children")
            for pid in me.read_text().split():
                left.append(
                    Path(f"/proc/{pid}/cmdline").read_bytes().replace(b"\0", b" ").decode(errors="replace")
                )
                os.kill(int(pid), signal.SIGKILL)
                os.waitpid(int(pid), 0)


def _wait(child: int, master: int, request: dict[str, Any]) -> int:
    """The child's wait status; what it writes to its terminal is kept, and it is interrupted in time."""
    ended = os.pidfd_open(child)
    due = time.monotonic() + request["interrupt"] if request["interrupt"] is not None else None
    look = select.poll()
    look.register(ended, select.POLLIN)
    if master >= 0:
        os.write(master, request["typed"].encode())
        look.register(master, select.POLLIN)
    with Path(request["shown"]).open("wb") as shown:
        while True:
            rest = None if due is None else max(0.0, due - time.monotonic()) * 1000
            found = dict(look.poll(rest))
            if not found and due is not None:
                os.kill(child, signal.SIGINT)
                due = None
            if master in found:
                try:
                    shown.write(os.read(master, 65536))
                except OSError:  # nobody has it open any more
                    look.unregister(master)
            elif ended in found:
                break
    for descriptor in (ended, master):
        if descriptor >= 0:
            os.close(descriptor)
    return os.waitpid(child, 0)[1]


def _become(request: dict[str, Any], slave: int, report: int) -> NoReturn:
    """Be the command line, in the forked child."""
    os.setsid()
    signal.signal(signal.SIGALRM, signal.SIG_DFL)
    signal.alarm(PATIENCE)
    report = fcntl.fcntl(report, fcntl.F_DUPFD_CLOEXEC, _HIGH)
    if slave >= 0:
        slave = fcntl.fcntl(slave, fcntl.F_DUPFD_CLOEXEC, _HIGH)
        fcntl.ioctl(slave, termios.TIOCSCTTY, 0)
    os.chdir(request["folder"])
    if request["gone"]:
        Path(request["folder"]).rmdir()
    for number, kind in enumerate(request["streams"]):
        _point(number, NULL if kind == CLOSED else kind, slave)
    for number, kind in enumerate(request["streams"]):
        if kind == CLOSED:
            os.close(number)
    words, settings = request["words"], request["settings"]
    os.environ.clear()
    os.environ.update(settings)
    tempfile.tempdir = None
    time.tzset()
    _reopen(request["streams"], request["encoding"])
    sys.argv = ["judge", *words]
    _guard(request["roots"], report)
    _leave(_status())


def _status() -> int:
    """The exit status of the command line, as the interpreter would have it."""
    from judge.cli import main as judge

    try:
        judge()
    except SystemExit as left:
        return left.code if isinstance(left.code, int) else 0 if left.code is None else 1
    except BaseException:
        traceback.print_exc()
    return 1


def _leave(status: int) -> NoReturn:
    """End as the interpreter does, but for taking its modules apart, which would copy all memory."""
    threading._shutdown()
    atexit._run_exitfuncs()
    for stream in (sys.stdout, sys.stderr):
        try:
            if stream is not None:
                stream.flush()
        except (OSError, ValueError):
            status = 120
    os._exit(status)


def _point(number: int, kind: str, slave: int) -> None:
    """Make a standard stream what the request says."""
    if kind == TERMINAL:
        os.dup2(slave, number)
        return
    if kind == GONE:
        reading, opened = os.pipe()
        os.close(reading)
    else:
        path = {FULL: "/dev/full", NULL: os.devnull}.get(kind, kind)
        opened = os.open(path, os.O_RDONLY if number == 0 else os.O_WRONLY | os.O_CREAT, 0o600)
    os.dup2(opened, number)
    if opened > 2:
        os.close(opened)


def _reopen(streams: list[str], encoding: str) -> None:
    """The interpreter's own streams, as they are at its start."""
    for number, (name, mode) in enumerate((("stdin", "r"), ("stdout", "w"), ("stderr", "w"))):
        errors = "backslashreplace" if name == "stderr" else "strict"
        stream = None
        if streams[number] != CLOSED:
            stream = open(number, mode, encoding=encoding, errors=errors, closefd=False)  # noqa: SIM115
        setattr(sys, name, stream)
        setattr(sys, f"__{name}__", stream)


def _is_device(path: Any) -> bool:
    try:
        return stat.S_ISCHR(Path(path).stat().st_mode)
    except (OSError, TypeError, ValueError):
        return False


def _guard(folders: list[str], report: int) -> None:
    """Refuse and report every change of a file outside these folders; devices may be opened.

    Whatever it would fetch is refused too.
    """
    roots = [os.path.realpath(folder) for folder in folders]

    def allowed(path: Any, *, itself: bool, making: bool) -> bool:
        """`itself`: a link is changed, not what it leads to. `making`: a folder."""
        if isinstance(path, int):
            return True
        try:
            folder, name = os.path.split(os.fsdecode(path))
            real = f"{os.path.realpath(folder)}/{name}" if itself else os.path.realpath(path)
        except (TypeError, ValueError):  # no name of a file
            return True
        if not Path(real).parent.is_dir() or (making and os.path.lexists(path)):  # that fails by itself
            return True
        return any(real == root or real.startswith(root + os.sep) for root in roots)

    def look(event: str, arguments: tuple[Any, ...]) -> None:
        if event == "urllib.Request":
            raise PermissionError(13, "the fuzz has no network")
        if event == "open":
            path, _, flags = arguments
            if not flags & _WRITING or isinstance(path, int):
                return
            paths = [] if _is_device(path) else [path]
        else:
            paths = [arguments[index] for index in _CHANGES.get(event, ())]
        for path in paths:
            if not allowed(path, itself=event in _OF_LINKS, making=event == "os.mkdir"):
                os.write(report, f"{event} {os.fsdecode(path)!r}\n".encode(errors="backslashreplace"))
                raise PermissionError(13, "outside the folders of the fuzz", os.fsdecode(path))

    sys.addaudithook(look)


if __name__ == "__main__":
    main()
