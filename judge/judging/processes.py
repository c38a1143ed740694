"""Several processes of this machine that do the work: a fault of one costs an item's attempt, never the run.

Each worker has a pool of its own with one process, so that a death tells whose item it was. A worker lives no
longer than who gives it work: it holds the end of a pipe, and ends when nobody holds the other one.
"""

from __future__ import annotations

import fcntl
import multiprocessing
import os
import signal
from collections import Counter, deque
from collections.abc import Callable, Container, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from multiprocessing.connection import Connection
from typing import Any, Generic, TypeVar

from judge.errors import JudgeError, shortage
from judge.judging.executors import ATTEMPTS, Finished, Lost, lost_for, told_of

T = TypeVar("T")
R = TypeVar("R")

_SPAWN = multiprocessing.get_context("spawn")  # a fork would copy threads' locks and open boxes
_DIED = "its worker died"
_LINES: list[Connection] = []  # of a worker: who gives it work holds the other end


class Processes:
    """So many items at once, each in a process of its own.

    The work is a module's function, known by its name; items and results are pickled. A worker stays with the
    items of one `problem`, where they have one, for what that needs is warm there. `short` says why workers
    are fewer than asked for, where they are.
    """

    def __init__(self, count: int) -> None:
        from judge.judging.containment import room_for  # which a worker has no need of

        self.count, self.short = room_for(count)
        self._alive = 0

    def finished(self, work: Callable[[T], R], items: Sequence[T], lost: Lost[T, R]) -> Finished[R]:
        """See `Executor.finished`."""
        round_ = _Round(items, lost)
        idle = [_Worker() for _ in range(min(self.count, len(items)))]
        busy: dict[Future[R], tuple[_Worker, int]] = {}
        ended = False
        try:
            while round_.waiting or busy:
                while round_.waiting and idle:
                    worker = idle.pop()
                    place = round_.taken(worker.at, {other.at for other, _ in busy.values()})
                    future = self._given(worker, work, items[place], others=len(busy))
                    if future is None:
                        round_.put_back(place)
                    else:
                        busy[future] = worker, place
                        worker.at = round_.kind(place)
                    self._alive = len(busy) + len(idle)
                for future in wait(busy, return_when=FIRST_COMPLETED).done:
                    worker, place = busy.pop(future)
                    idle.append(worker)  # before the result is taken: whoever takes it may want no more
                    yield from round_.outcome(future, place)
            ended = True
        finally:
            for worker in (*idle, *(worker for worker, _ in busy.values())):
                worker.end(at_once=not ended)
            self._alive = 0

    def alive(self) -> int:
        """The processes that have or await an item."""
        return self._alive

    def _given(self, worker: _Worker, work: Callable[[T], R], item: T, *, others: int) -> Future[R] | None:
        """The item, given to a worker; None where no process can be started for it but others are at work."""
        try:
            return worker.give(work, item)
        except (OSError, RuntimeError, MemoryError) as fault:
            short = shortage(fault)
            if short is None:
                raise
            worker.end(at_once=True)
            if others:
                return None
            raise short from fault


class _Round(Generic[T, R]):
    """What is still to be done, and how often each item was tried in vain."""

    def __init__(self, items: Sequence[T], lost: Lost[T, R]) -> None:
        self._items = items
        self._lost = lost
        self._tries = Counter[int]()
        self.waiting: dict[object, deque[int]] = {}  # the places of each kind; none is empty
        for place in range(len(items)):
            self.put_back(place)

    def kind(self, place: int) -> object:
        """What the item needs to be warm."""
        return getattr(self._items[place], "problem", None)

    def put_back(self, place: int) -> None:
        """The item waits."""
        self.waiting.setdefault(self.kind(place), deque()).append(place)

    def taken(self, at: object, others: Container[object]) -> int:
        """The next place for a worker that was at this kind: of the same kind, or of one that no other is at,
        or of that of which most wait.
        """
        kind = at
        if at not in self.waiting:
            alone = [kind for kind in self.waiting if kind not in others]
            kind = alone[0] if alone else max(self.waiting, key=lambda each: len(self.waiting[each]))
        place = self.waiting[kind].popleft()
        if not self.waiting[kind]:
            del self.waiting[kind]
        return place

    def outcome(self, future: Future[R], place: int) -> Iterator[tuple[int, R]]:
        """The item's result where it has one now; else it waits again."""
        try:
            result = future.result()
        except BrokenProcessPool:
            why = _DIED
        except JudgeError:
            raise
        except BaseException as fault:
            why = told_of(fault)
        else:
            yield place, result
            return
        self._tries[place] += 1
        if self._tries[place] < ATTEMPTS:
            self.put_back(place)
        else:
            yield place, self._lost(self._items[place], lost_for(why))


class _Worker:
    """A process that does one item after another, and another one in its place when it has died."""

    def __init__(self) -> None:
        self.at: object = None  # the kind of its last item
        self._pool: ProcessPoolExecutor | None = None
        self._line: Connection | None = None

    def give(self, work: Callable[[T], R], item: T) -> Future[R]:
        """Do this; nothing else is being done. Raises OSError where no process can be started."""
        if self._pool is not None:
            try:
                return self._pool.submit(work, item)
            except BrokenProcessPool:  # it has died, perhaps while it waited
                self.end(at_once=True)
        end, self._line = _SPAWN.Pipe(duplex=False)
        self._pool = ProcessPoolExecutor(1, _SPAWN, _begin, (end,))
        with _uninterrupted(), end:  # the process is started here
            return self._pool.submit(work, item)

    def end(self, *, at_once: bool) -> None:
        """End the process, after its item or in the middle of it."""
        line, pool, self._line, self._pool = self._line, self._pool, None, None
        if line is not None and at_once:
            line.close()
        if pool is not None:
            try:
                pool.shutdown(wait=True, cancel_futures=True)
            except RuntimeError:  # its own thread could not be started, and is not there to wait for
                for process in pool._processes.values():
                    process.kill()
        if line is not None:
            line.close()


def _begin(line: Connection) -> None:
    """What a worker does first. Ctrl-C, which every process of a terminal gets, ends it without a word."""
    if signal.getsignal(signal.SIGINT) is not signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT, signal.SIGIO})
    _LINES.append(line)
    signal.signal(signal.SIGIO, signal.SIG_DFL)  # which ends this process: nobody is left for its results
    fcntl.fcntl(line, fcntl.F_SETOWN, os.getpid())
    fcntl.fcntl(line, fcntl.F_SETFL, fcntl.fcntl(line, fcntl.F_GETFL) | os.O_ASYNC)
    if line.poll():  # it was closed before
        os._exit(1)


@contextmanager
def _uninterrupted() -> Iterator[None]:
    """Ctrl-C waits: a process that is started meanwhile does not get it before it is ready."""
    before: Any = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
