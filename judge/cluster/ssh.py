"""`--on ssh:HOSTS.txt`: workers started on machines that OpenSSH reaches, for as long as the command runs.

    # one machine a line: a name that ssh knows, how many submissions at once, where judge is
    lab01.example.org 4
    ada@lab02         8  /opt/judge/bin/judge

The first machine is the scheduler too. The keys are made for this run alone, and never lie in a file.
"""

from __future__ import annotations

import re
import shlex
import socket
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, closing, contextmanager
from pathlib import Path

from msgspec import Struct

from judge.cluster.keys import Keys, new_keys
from judge.cluster.launch import Helper
from judge.cluster.reach import unreached
from judge.cluster.where import Address
from judge.errors import JudgeError, UsageError
from judge.reading import read_ordinary

_NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.@:%-]*")  # none that ssh would read as an option
_MOST = 256
_OPTIONS = ("-T", "-o", "BatchMode=yes", "-o", "ConnectTimeout=10", "-o", "ServerAliveInterval=15")
_START = 90.0  # seconds
_REACH = 3.0


class Host(Struct, frozen=True):
    """A machine: its name for ssh, how many submissions it judges at once (None: one a core), its judge."""

    name: str
    slots: int | None = None
    judge: str = "judge"

    def command(self, address: str, *, scheduler: bool) -> list[str]:
        """The command line that starts its workers, or the scheduler."""
        words = [self.judge, "worker", address, "--keys", "-", "--json"]
        if scheduler:
            words.append("--scheduler")
        elif self.slots is not None:
            words += ["-j", str(self.slots)]
        return ["ssh", *_OPTIONS, self.name, shlex.join(words)]

    def tunnel(self, port: int, there: Address) -> list[str]:
        """The command line that leads from a port of this machine to the scheduler, by way of that one."""
        way = f"127.0.0.1:{port}:{there.host}:{there.port}"
        return ["ssh", *_OPTIONS, "-o", "ExitOnForwardFailure=yes", "-N", "-L", way, self.name]


def read_hosts(path: Path) -> list[Host]:
    """The machines of a file. Raises UsageError, with the line's number."""
    try:
        text = read_ordinary(path).decode()
    except OSError as fault:
        reason = (fault.strerror or "it failed").lower()
        raise UsageError(f"cannot be read ({reason})", where=str(path)) from fault
    except UnicodeDecodeError as fault:
        raise UsageError("is not text in UTF-8", where=str(path)) from fault
    hosts: list[Host] = []
    for number, content in enumerate(text.splitlines(), 1):
        words = content.partition("#")[0].split()
        if words:
            hosts.append(_host(words, f"{path}:{number}"))
            if hosts[-1].name in {host.name for host in hosts[:-1]}:
                what = f"{hosts[-1].name} is named twice"
                raise UsageError(
                    what, where=f"{path}:{number}", remedy="give it more submissions at once instead"
                )
    if not hosts:
        raise UsageError(
            "names no machine", where=str(path), remedy="give one a line, as 'lab01.example.org 4'"
        )
    return hosts


def _host(words: list[str], where: str) -> Host:
    form = "a line is HOST, HOST N or HOST N PATH-OF-JUDGE"
    if len(words) > 3 or not _NAME.fullmatch(words[0]):
        raise UsageError(f"'{' '.join(words)}' is no machine", where=where, remedy=form)
    if len(words) > 1 and not (words[1].isdecimal() and 1 <= int(words[1]) <= _MOST):
        raise UsageError(f"'{words[1]}' is not a number from 1 to {_MOST}", where=where, remedy=form)
    slots = int(words[1]) if len(words) > 1 else None
    return Host(words[0], slots, words[2] if len(words) > 2 else "judge")


@contextmanager
def started(path: Path, say: Callable[[str], None]) -> Iterator[tuple[Address, Keys]]:
    """Workers on the machines of a file, and how their scheduler is reached.

    Raises:
        UsageError: the file is not as it must be.
        JudgeError: the first machine cannot be reached. Of the others that is only said.
    """
    hosts, keys = read_hosts(path), new_keys()
    with ExitStack() as stack:
        helpers: list[Helper] = []
        stack.callback(_end, helpers)
        helpers.append(Helper(hosts[0].name, hosts[0].command("tls://0.0.0.0:0", scheduler=True), keys))
        there = str(helpers[0].ready(_START)["address"])
        workers = [Helper(host.name, host.command(there, scheduler=False), keys) for host in hosts]
        helpers += workers
        for worker in workers:
            try:
                worker.ready(_START)
            except JudgeError as fault:
                say(f"goes on without {fault}")
        address = Address.of(there)
        if unreached(address, _REACH):
            port = _free_port()
            helpers.append(Helper(f"the way to {hosts[0].name}", hosts[0].tunnel(port, address)))
            address = Address("tls", "127.0.0.1", port)
            _wait_for(address, hosts[0].name)
        yield address, keys


def _end(helpers: list[Helper]) -> None:
    for helper in helpers:
        helper.let_go()
    for helper in reversed(helpers):
        helper.end()


def _wait_for(address: Address, name: str) -> None:
    for _ in range(40):
        if not unreached(address, _REACH):
            return
        time.sleep(0.25)
    raise JudgeError(f"{name} cannot be reached through ssh", remedy="allow it to forward ports")


def _free_port() -> int:
    with closing(socket.socket()) as free:
        free.bind(("127.0.0.1", 0))
        return int(free.getsockname()[1])
