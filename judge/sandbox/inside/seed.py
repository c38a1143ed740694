"""The seed: trusted code only. It forks a server for each container, which gives up its rights by itself.

    start ─┬─ OPEN   fork → confine → look around → "ready" → serve
           └─ …      any number of times; below `full` there may be several servers at once

Each server is another user where that can be, and has a channel, a memory and a home of its own. At `full`,
where all that a seed starts share their namespaces, the next one is forked once nothing of the last is left.
"""

from __future__ import annotations

import _sitebuiltins
import _socket
import builtins
import gc
import marshal
import os
import sys
import time

from judge.sandbox.inside import again, unseen, wire
from judge.sandbox.inside.confine import Confinement, die_with
from judge.sandbox.inside.server import SHORTEST_WAIT_NS, SWEEP_SECONDS, ExecServer, Server
from judge.sandbox.inside.source import sealed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, NoReturn


def start(channel: int, config: dict[str, Any]) -> NoReturn:
    """Fork a server whenever the judge opens one, until it hangs up."""
    kind = ExecServer if "folders" in config else Server
    line = wire.Channel(_socket.socket(fileno=channel))
    die_with(config["parent"])
    sys.path[:] = config["path"]
    _fill_finders()
    for word in ("exit", "quit"):  # -S leaves them out
        setattr(builtins, word, _sitebuiltins.Quitter(word, "Ctrl-D"))
    for name in [name for name in sys.modules if name.partition(".")[0] == "judge"]:
        del sys.modules[name]
    me = os.getpid()
    gc.freeze()
    while True:
        frame, given = line.receive(descriptors=3)
        if not frame:
            os._exit(0)
        _reap()
        if config["level"] == "full" and _left(config.get("home")):
            os._exit(1)
        if len(given) == 3 and again.again(os.fork) == 0:
            line.close()
            _confined(given, me, kind).serve()
        for number in given:
            os.close(number)


def _reap() -> bool:
    """Forget the children that have ended; whether others are left, or what has become one."""
    try:
        while os.waitpid(-1, os.WNOHANG)[0]:
            continue
    except ChildProcessError:
        return False
    return True


def _left(home: str | None) -> bool:
    """Whether anything is left in these namespaces of the server before, which has hung up."""
    until = time.monotonic() + SWEEP_SECONDS
    while (alive := _reap()) and time.monotonic() < until:
        time.sleep(SHORTEST_WAIT_NS / 1e9)
    return bool(alive or (home and os.listdir(home)) or any(map(_shared, ("shm", "sem", "msg"))))  # noqa: PTH208


def _shared(kind: str) -> bool:
    """Whether there is anything of that kind of System V's: below the line of titles."""
    try:
        with open(f"/proc/sysvipc/{kind}", "rb") as file:  # noqa: PTH123
            return file.read().count(b"\n") > 1
    except FileNotFoundError:  # this kernel has none
        return False


def _confined(given: list[int], seed: int, kind: type[Server]) -> Server:
    """Confine this process, and say so."""
    channel, memory, order = given
    os.setsid()
    line = wire.Channel(_socket.socket(fileno=channel))
    region = wire.Region(memory)
    os.close(memory)
    try:
        with open(order, "rb") as file:  # noqa: PTH123
            config, source = marshal.loads(file.read())
        config["parent"] = seed
        config["source"] = sealed(source)
        os.environ.update(config["environment"])
        confinement = Confinement(config)
        for folder in config.get("folders", ()):
            os.makedirs(folder, exist_ok=True)  # noqa: PTH103 - pathlib takes longer to import
        _look_around(region, line, config["unseen"])
    except (OSError, ValueError, LookupError, MemoryError) as error:
        region.write_fault(error)
        line.send(wire.FAILED)
        os._exit(1)
    line.send(wire.READY + os.getpid().to_bytes(4, "little"))
    return kind(line, region, confinement, config, source)


def _look_around(region: wire.Region, line: wire.Channel, length: int) -> None:
    """End here, with the reason, if something can be read that no submission may see.

    A child looks, and is gone: what is hidden has its names in the memory of no submission.
    """
    pid = again.again(os.fork)
    if pid == 0:
        try:
            if visible := unseen.first_visible(*marshal.loads(region.payload(length))):
                region.write_note(wire.EXPOSED, visible)
            os._exit(bool(visible))
        except BaseException as error:
            region.write_fault(error)
            os._exit(1)
    if os.waitpid(pid, 0)[1]:
        line.send(wire.FAILED)
        os._exit(1)


def _fill_finders() -> None:
    """Let imports list their folders while they may: landlock denies the list where an entry is hidden."""
    try:
        __import__("a_module_that_nobody_has")
    except ImportError:
        for finder in sys.path_importer_cache.values():
            entries = getattr(finder, "_path_cache", None)
            if isinstance(entries, set):
                entries.discard("judge")  # where it lies among the modules that may be imported
