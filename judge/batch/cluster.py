"""Workers of a dask cluster, to which `judge class --on` sends submissions.

Each worker has one task at a time, which names that worker: a worker that dies costs an attempt of its own
task, and nothing waits behind it. A worker that would judge otherwise than this machine raises a UsageError
before it judges, and gets nothing more.
"""

from __future__ import annotations

import ipaddress
import logging
import socket
import time
import uuid
from collections import Counter, deque
from collections.abc import Callable, Sequence
from concurrent.futures import CancelledError
from importlib import import_module
from pathlib import Path
from threading import Event
from typing import Any, TypeVar
from urllib.parse import urlsplit

import msgspec

from judge.errors import JudgeError, UsageError
from judge.files import read_ordinary, unreadable
from judge.judging.pool import ATTEMPTS, Finished, Lost, Outcome, attempt
from judge.sandbox.boundary import LEVELS

T = TypeVar("T")
R = TypeVar("R")

_DIED = f"the machine died {ATTEMPTS} times"
_KILLED = "the machine died of it"  # as dask has seen it, by its own count
_FORMS = "give tls://HOST:PORT, or the file that 'dask scheduler --scheduler-file FILE' writes"
_HELP = "see 'judge help class'"
_KEPT = "what is judged is kept, and the same command goes on"
_PORT = 8786
_CONNECT = 5.0  # seconds
_ANSWER = 30.0  # seconds for a worker to say which isolation it has
_FETCH = 5.0  # seconds to fetch a result, which is gone if its worker has died meanwhile
_PATIENCE = 60.0  # seconds to wait for a worker
_RESTART = 15.0  # seconds more for one that died to be there again
_LOOK = 1.0  # seconds between looks at who is there


class ClusterExecutor:
    """An executor, and a context manager that reaches the scheduler at the address or in the file `where`.

    `level` is the isolation that every worker can have: the best, or the one that is demanded. `say` is told
    which workers are left out and why.

    Raises:
        UsageError: `where` is no scheduler, or no worker can judge as this machine does.
        JudgeError: the scheduler cannot be reached or is lost, or no worker is there.
    """

    def __init__(
        self, where: str, demanded: str | None = None, say: Callable[[str], None] = lambda _: None
    ) -> None:
        self.address = scheduler_at(where)
        self.level = demanded or ""
        self._allowed = (demanded,) if demanded else LEVELS[: LEVELS.index("limits")]
        self._say = say
        self._client: Any = None
        # Those that are there, by address: the levels that each gives, none of one that is left out.
        self._workers: dict[str, tuple[str, ...]] = {}
        self._why = ""  # the last one is left out
        self._looked = 0.0
        self._seen = time.monotonic() - _RESTART  # when a worker was fit; none has died yet

    def __enter__(self) -> ClusterExecutor:
        """Wait for the first workers, and find the isolation that they have in common."""
        self._client = _connected(self.address)
        try:
            self._look()
            if not self._workers:
                self._say(f"there is no worker at {self.address} yet; waiting {_PATIENCE:.0f} s for one")
            while not self._fit():
                time.sleep(_LOOK)
                self._look()
            has = [self._workers[address] for address in self._fit()]
            common = [level for level in self._allowed if all(level in each for each in has)]
            if not common:
                remedy = "demand one with --isolation"
                raise UsageError("the workers have no isolation in common", remedy=remedy)
        except BaseException:
            self.__exit__()
            raise
        self.level = common[0]
        self._allowed = (self.level,)
        return self

    def __exit__(self, *exc: object) -> None:
        """Leave; a worker finishes what it does, and begins nothing more."""
        self._client.close(timeout=_CONNECT)

    def run(self, work: Callable[[T], R], items: Sequence[T], lost: Lost[T, R]) -> Finished[R]:
        """See `Executor.run`; but a UsageError costs its worker, and ends the work when none is left."""
        waiting, tries = deque(range(len(items))), Counter[int]()
        sent: dict[Any, tuple[int, str]] = {}  # the place of each item, and its worker
        ended = Event()  # one of them
        try:
            while waiting or sent:
                self._look()
                idle = self._fit() - {worker for _, worker in sent.values()}
                for worker, place in zip(idle, [*waiting], strict=False):
                    waiting.popleft()
                    key = f"judge-{uuid.uuid4().hex}"  # none comes twice
                    future = self._client.submit(
                        attempt, work, items[place], key=key, workers=[worker], pure=False
                    )
                    sent[future] = place, worker
                    future.add_done_callback(lambda _: ended.set())
                ended.wait(_LOOK)
                ended.clear()
                for future, (place, worker) in [*sent.items()]:
                    if not future.done() and worker in self._workers:
                        continue
                    del sent[future]
                    result, fault = self._fetched(worker, future)
                    future.release()
                    tries[place] += 1
                    if fault is None:
                        yield place, result
                    elif isinstance(fault, UsageError):
                        self._leave_out(worker, str(fault))
                        waiting.append(place)
                    elif isinstance(fault, JudgeError):
                        raise fault
                    elif tries[place] < ATTEMPTS and fault != _KILLED:
                        waiting.append(place)
                    else:
                        yield place, lost(items[place], fault)
        finally:
            for future in sent:
                future.release()

    def _fetched(self, worker: str, future: Any) -> Outcome:
        """The result of a task, or its fault: a UsageError where its worker cannot judge."""
        from distributed.scheduler import KilledWorker

        if worker not in self._workers:
            return None, _DIED
        try:
            outcome: Outcome = future.result(timeout=_FETCH)
        except KilledWorker:
            return None, _KILLED
        except TimeoutError:
            return None, _DIED
        except (CancelledError, OSError) as lost:
            raise self._lost() from lost
        except Exception as other:  # there or at the scheduler is no judge, or one that cannot read the task
            return None, UsageError(_cannot(other))
        return outcome

    def _fit(self) -> set[str]:
        """The workers that are there and can judge."""
        return {address for address, levels in self._workers.items() if levels}

    def _leave_out(self, address: str, why: str) -> None:
        self._workers[address], self._why = (), why
        self._say(f"the worker {address} is left out: {why}")

    def _lost(self) -> JudgeError:
        return JudgeError(f"the scheduler at {self.address} is lost", remedy=_KEPT)

    def _look(self) -> None:
        """See who is there, unless that was seen just now, and ask newcomers which isolation they have."""
        now = time.monotonic()
        if now - self._looked < _LOOK:
            return
        self._looked = now
        if self._client.status != "running":
            raise self._lost()
        try:
            there = self._client.scheduler_info(n_workers=-1)["workers"]
            answers = self._asked([address for address in there if address not in self._workers])
        except Exception as fault:  # of several kinds
            raise self._lost() from fault
        self._workers = {address: levels for address, levels in self._workers.items() if address in there}
        for address, levels in answers.items():
            if isinstance(levels, OSError) and not isinstance(levels, TimeoutError):
                continue  # it has gone; if not, it is asked again
            if why := self._unfit(levels, there[address]["nthreads"]):
                self._leave_out(address, why)
            else:
                self._workers[address] = levels
        if self._fit():
            self._seen = now
        elif there and there.keys() == self._workers.keys() and now - self._seen > _RESTART:
            raise UsageError(f"no worker at {self.address} can judge this: {self._why}", remedy=_HELP)
        elif now - self._seen > _PATIENCE + _RESTART:
            remedy = f"start some with 'dask worker {self.address} --nthreads 1'; {_KEPT}"
            raise JudgeError(f"no worker is ready at {self.address}", remedy=remedy)

    def _asked(self, workers: Sequence[str]) -> dict[str, Any]:
        """What each worker answers: its levels, or a fault. A task would end a worker that has no judge."""
        if not workers:
            return {}
        try:
            found: dict[str, Any] = self._client.run(
                levels_here, workers=workers, on_error="return", callback_timeout=_ANSWER
            )
        except TimeoutError as fault:
            if len(workers) == 1:
                return {workers[0]: fault}
            return {worker: answer for each in workers for worker, answer in self._asked([each]).items()}
        return found

    def _unfit(self, levels: Any, threads: int) -> str:
        """Why a worker of so many threads that answers this is left out, or nothing."""
        if isinstance(levels, Exception):
            return _cannot(levels)
        if threads > 1:
            return f"it has {threads} threads; start it with --nthreads 1"
        if not set(levels) & set(self._allowed):
            has, wanted = " or ".join(levels) or "none", " or ".join(self._allowed)
            return f"its isolation is {has}, not {wanted}; see 'judge doctor' there"
        return ""


def _cannot(fault: Exception) -> str:
    what = str(fault).partition("\n")[0].partition(". ")[0]
    return f"it cannot begin ({what}); install the same judge there and where the scheduler runs"


def levels_here() -> tuple[str, ...]:
    """What a worker answers: the levels of isolation that its machine gives."""
    from judge.judging.containment import every_hidden_folder
    from judge.sandbox.available import levels_here

    return tuple(each.name for each in levels_here(every_hidden_folder()) if each.available)


def scheduler_at(where: str) -> str:
    """The address that `where` is, or that stands in the file it names.

    Raises:
        UsageError: it is no address and no such file, or plain tcp to another machine.
    """
    address = where if "://" in where or not where else _read(where)
    try:
        parts = urlsplit(address)
        host, port = parts.hostname, parts.port or _PORT
    except ValueError:
        host = None
    if not host or parts.scheme not in ("tcp", "tls") or parts.path not in ("", "/"):
        raise UsageError(f"'{address}' is not the address of a scheduler", remedy=_FORMS)
    if parts.scheme == "tcp" and not _is_here(host):
        what = f"{address} is refused: whoever reaches a scheduler can run programs on every machine of it"
        raise UsageError(f"{what}, and plain tcp asks nobody who they are", remedy=f"use TLS; {_HELP}")
    return f"{parts.scheme}://{f'[{host}]' if ':' in host else host}:{port}"


def _read(where: str) -> str:
    try:
        return str(msgspec.json.decode(read_ordinary(Path(where)))["address"])
    except OSError as fault:
        raise unreadable(Path(where), fault, _FORMS) from fault
    except (msgspec.DecodeError, UnicodeDecodeError, KeyError, TypeError) as fault:
        raise UsageError("is not the file of a dask scheduler", where=where, remedy=_FORMS) from fault


def _is_here(host: str) -> bool:
    """Whether only this machine reaches it."""
    try:
        return host == "localhost" or ipaddress.ip_address(host).is_loopback
    except ValueError:
        return False


def _connected(address: str) -> Any:
    """A client of the scheduler there. Raises UsageError without dask, JudgeError where none answers."""
    try:
        import dask

        distributed: Any = import_module("distributed")
    except ImportError as fault:
        what = "judging on other machines needs the package distributed, which is not installed"
        raise UsageError(what, remedy="pip install 'circle-line-judge[cluster]'") from fault
    for name in ("distributed", "distributed.client", "distributed.core", "tornado", "asyncio"):
        logging.getLogger(name).setLevel(logging.CRITICAL)  # what matters is said here, in a line
    parts = urlsplit(address)
    try:
        socket.create_connection((str(parts.hostname), parts.port or _PORT), timeout=_CONNECT).close()
    except (OSError, UnicodeError) as fault:  # a name of a host that is none
        reason = (getattr(fault, "strerror", None) or str(fault)).lower()
        remedy = "start it with 'dask scheduler', or see whether a firewall is between"
        raise JudgeError(f"no scheduler can be reached at {address} ({reason})", remedy=remedy) from fault
    dask.config.set({"distributed.comm.timeouts.connect": _CONNECT})
    try:
        return distributed.Client(address, timeout=_CONNECT, set_as_default=False)
    except Exception as fault:  # OSError, and others where certificates are missing or refused
        what = f"what listens at {address} is no scheduler, or has a certificate other than yours"
        raise JudgeError(what, remedy=f"if it has TLS, give tls://; {_HELP}") from fault
