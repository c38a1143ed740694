"""The executor whose workers are other processes, on this machine or others, that a scheduler knows.

Not more items are sent than the workers can soon begin: what waits, waits here. An item whose worker dies is
sent again under another key, by itself for the last time, so that it does not suffer for a neighbour that
kills.
"""

from __future__ import annotations

import time
import uuid
from collections import Counter, deque
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from queue import Empty, SimpleQueue
from typing import Any, Generic, TypeVar

from judge.cluster.greeting import Offer, common_level
from judge.cluster.keys import Keys
from judge.cluster.need import distributed
from judge.cluster.parcel import Answer, answer_of, call, name_of, packed, result_of
from judge.cluster.reach import check_reached
from judge.cluster.where import Address
from judge.errors import JudgeError, UsageError
from judge.judging.executors import ATTEMPTS, Finished, Lost, lost_for

T = TypeVar("T")
R = TypeVar("R")

DIED = f"the machine died {ATTEMPTS} times"
_KEPT = "what is judged is kept, and the same command goes on"
_CONNECT = 5.0  # seconds
_PAUSE = 0.5  # seconds between looks for the first worker
_LOOK = 2.0  # seconds between looks at who is there


class Ring:
    """A context manager; on entering, the scheduler is reached and every worker compared with `wanted`.

    `patience` is for how many seconds there may be no worker: one that died may just be starting again. The
    first may take `wait` seconds instead, where that is not 0; `say` is told that it is waited for. Raises
    UsageError where a worker is not as it must be, JudgeError where the scheduler cannot be reached or there
    is no worker.
    """

    def __init__(
        self,
        address: Address,
        keys: Keys | None = None,
        wanted: Offer = Offer({}, {}, ()),  # noqa: B008 - frozen
        patience: float = 60.0,
        wait: float = 0.0,
        say: Callable[[str], None] = lambda _: None,
    ) -> None:
        self.address = address
        self.wanted = wanted
        self.patience = patience
        self._keys = keys
        self._wait = wait or patience
        self._say = say
        self._client: Any = None
        self._looked = float("-inf")
        self._fit: dict[str, Mapping[str, Any]] = {}
        self._unfit: dict[str, str] = {}

    def __enter__(self) -> Ring:
        self._client = _connected(self.address, self._keys)
        try:
            self._greet()
        except BaseException:
            self.close()
            raise
        return self

    def __exit__(self, *exc: object) -> None:
        self.close()

    def close(self) -> None:
        """Leave; what the workers still do is for nobody, and no further item is begun."""
        client, self._client = self._client, None
        if client is not None:
            client.close(timeout=_CONNECT)

    @property
    def level(self) -> str:
        """The level of isolation that every worker can hold submissions at."""
        return self.wanted.levels[0]

    def machines(self) -> dict[str, list[str]]:
        """The addresses of the workers, by the machine they are on."""
        found: dict[str, list[str]] = {}
        for address, told in self._fit.items():
            found.setdefault(str(told["host"]), []).append(address)
        return found

    def left_out(self) -> tuple[str, ...]:
        """The workers that are there but are given nothing, each with the reason."""
        return tuple(self._unfit.values())

    def alive(self) -> int:
        """How many workers there are just now that are as they must be."""
        self._look()
        return len(self._fit)

    def finished(self, work: Callable[[T], R], items: Sequence[T], lost: Lost[T, R]) -> Finished[R]:
        """See `Executor.finished`. Raises JudgeError too where the scheduler or every worker is lost."""
        return self._finished(_Sent(self._client, work, items, lost, self.wanted))

    def everywhere(self, work: Callable[[T], R], items: Sequence[T], lost: Lost[T, R]) -> Finished[R]:
        """As `finished`, but each item once on each machine: a place comes as often as there are machines.

        A machine that is lost meanwhile is left out.
        """
        machines = list(self.machines().values())
        given = [item for _ in machines for item in items]
        only = [addresses for addresses in machines for _ in items]
        for place, result in self._finished(_Sent(self._client, work, given, lost, self.wanted, only)):
            yield place % len(items), result

    def _finished(self, sent: _Sent[T, R]) -> Finished[R]:
        seen = time.monotonic()
        try:
            while sent.fill(self._window()):
                future = sent.next(_LOOK)
                if future is not None:
                    yield from sent.outcome(future)
                elif self._client.status != "running":
                    raise _scheduler_lost(self.address)
                count = self.alive()
                sent.leave_out(self._fit)
                if count:
                    seen = time.monotonic()
                elif time.monotonic() - seen > self.patience:
                    what = f"no worker is left at {self.address}"
                    raise JudgeError(what, remedy=f"start some with 'judge worker {self.address}'; {_KEPT}")
        except OSError as fault:  # while something was sent or looked at
            raise _scheduler_lost(self.address) from fault
        finally:
            sent.close()

    def _window(self) -> int:
        """How many items may be on their way: one for each worker, and some that follow at once."""
        count = self.alive()
        return count + (count + 1) // 2

    def _greet(self) -> None:
        """Compare every worker with what is wanted, and settle on a level of isolation."""
        workers, until = self._workers(), time.monotonic() + self._wait
        if not workers:
            self._say(f"there is no worker at {self.address} yet; waiting {self._wait:.0f} s for one")
        while not workers and time.monotonic() < until:
            time.sleep(_PAUSE)
            workers = self._workers()
        if not workers:
            what = f"the scheduler at {self.address} has no workers"
            raise JudgeError(what, remedy=f"start some with 'judge worker {self.address}'")
        offers = {name: Offer.of_resources(told["resources"]) for name, told in workers.items()}
        for name, offer in offers.items():
            what, remedy = self.wanted.differs(offer)
            if what:
                raise UsageError(_of_worker(name, workers[name], what), remedy=remedy)
        if not self.wanted.levels:
            level = common_level(offer for offer in offers.values() if offer is not None)
            self.wanted = Offer(self.wanted.facts, self.wanted.problems, (level,))
        self._look()

    def _look(self) -> None:
        """See who is there, unless that was seen just now."""
        now = time.monotonic()
        if now - self._looked < _LOOK or self._client is None:
            return
        self._looked = now
        workers = self._workers()
        wrong = {
            name: self.wanted.differs(Offer.of_resources(told["resources"]))[0]
            for name, told in workers.items()
        }
        self._fit = {name: told for name, told in workers.items() if not wrong[name]}
        self._unfit = {name: _of_worker(name, workers[name], what) for name, what in wrong.items() if what}

    def _workers(self) -> dict[str, Mapping[str, Any]]:
        """All workers that the scheduler knows, by their addresses."""
        try:
            return dict(self._client.scheduler_info()["workers"])
        except Exception as fault:  # of several kinds, as the connection breaks here or there
            raise _scheduler_lost(self.address) from fault


class _Sent(Generic[T, R]):
    """The items that wait, and those that are on their way."""

    def __init__(
        self,
        client: Any,
        work: Callable[[T], R],
        items: Sequence[T],
        lost: Lost[T, R],
        wanted: Offer,
        only: Sequence[list[str]] = (),
    ) -> None:
        """`only` holds for each item the addresses of the workers that may do it, where not all may."""
        self._client = client
        self._work = work
        self._name = name_of(work)
        self._items = items
        self._lost = lost
        self._wanted = wanted
        self._only = only
        self._waiting = deque(range(len(items)))
        self._last: deque[int] = deque()  # items that are to be sent alone, for the last time
        self._tries = Counter[int]()
        self._flying: dict[Any, int] = {}
        self._done: SimpleQueue[Any] = SimpleQueue()
        self._batch = uuid.uuid4().hex

    def fill(self, window: int) -> bool:
        """Send what may be sent; whether anything is still to come."""
        while not self._last and self._waiting and len(self._flying) < max(window, 1):
            self._send(self._waiting.popleft())
        if self._last and not self._flying:
            self._send(self._last.popleft())
        return bool(self._flying)

    def next(self, seconds: float) -> Any:
        """A future that is done, or None where there is none within so many seconds."""
        try:
            return self._done.get(timeout=seconds)
        except Empty:
            return None

    def outcome(self, future: Any) -> Iterator[tuple[int, R]]:
        """The item's place and result, where it has one now; else it waits again."""
        from distributed.scheduler import KilledWorker

        place = self._flying.pop(future, None)
        if place is None:  # it was given up
            return
        try:
            answer = answer_of(future.result())
        except KilledWorker:
            why = DIED
        except OSError:
            raise
        except Exception as fault:  # such as a function that the worker does not have
            if future.status in ("cancelled", "lost"):
                raise ConnectionError from fault
            why = lost_for(f"{type(fault).__name__}: {fault}")
        else:
            why = lost_for(answer.ended) if answer.ended else ""
            if not why:
                yield place, self._received(answer)
        finally:
            future.release()
        if why:
            yield from self._again(place, why)

    def leave_out(self, there: Collection[str]) -> None:
        """Give up the items whose only workers are not there."""
        if not self._only:
            return
        gone = {place for place, names in enumerate(self._only) if not set(names) & set(there)}
        for future in [future for future, place in self._flying.items() if place in gone]:
            del self._flying[future]
            future.release()
        self._waiting = deque(place for place in self._waiting if place not in gone)
        self._last = deque(place for place in self._last if place not in gone)

    def close(self) -> None:
        """Give up what is on its way."""
        for future in self._flying:
            future.release()
        self._flying.clear()

    def _received(self, answer: Answer) -> R:
        result: R = result_of(self._work, answer)
        return result

    def _again(self, place: int, why: str) -> Iterator[tuple[int, R]]:
        self._tries[place] += 1
        if self._tries[place] >= ATTEMPTS:
            yield place, self._lost(self._items[place], why)
        elif self._tries[place] == ATTEMPTS - 1:
            self._last.append(place)
        else:
            self._waiting.append(place)

    def _send(self, place: int) -> None:
        item = self._items[place]
        future = self._client.submit(
            call,
            self._name,
            packed(item),
            key=f"judge-{self._batch}-{place}-{self._tries[place]}",
            resources=self._wanted.wants(getattr(item, "problem", "")),
            workers=self._only[place] if self._only else None,
            pure=False,
        )
        self._flying[future] = place
        future.add_done_callback(self._done.put)


def _connected(address: Address, keys: Keys | None) -> Any:
    """A client of the scheduler there. Raises JudgeError where none answers."""
    check_reached(address)
    module = distributed()
    security = keys.security() if keys and address.safe else None
    try:
        return module.Client(str(address), security=security, timeout=_CONNECT, set_as_default=False)
    except Exception as fault:  # OSError, and kinds of its own where certificates are refused
        if address.safe:
            what, remedy = (
                "does not take this certificate",
                "copy the folder of keys from the scheduler's machine",
            )
        else:
            what, remedy = "does not answer as a scheduler without keys does", "give tls:// if it has keys"
        raise JudgeError(f"what listens at {address} {what}", remedy=remedy) from fault


def _scheduler_lost(address: Address) -> JudgeError:
    return JudgeError(f"the scheduler at {address} is lost", remedy=_KEPT)


def _of_worker(name: str, told: Mapping[str, Any], what: str) -> str:
    host = str(told.get("host") or "")
    return f"the worker {name}{f' on {host}' if host and host not in name else ''} {what}"
