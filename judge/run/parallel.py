"""Doing several things at once, and the one thing that must be done alone: measuring.

Threads suffice: they wait for processes of the submissions. They are daemons, so that Ctrl-C need not wait
for them; what they started ends with the judge's own process.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Generator, Iterable, Iterator, Sequence
from contextlib import closing, contextmanager
from queue import SimpleQueue
from typing import Generic, TypeVar

from judge.run.alone import Admitted, Machine

T = TypeVar("T")
R = TypeVar("R")


class Turnstile:
    """Many may judge at once, or one may measure alone; who waits to measure is let in first.

    So it is among the threads that share the turnstile, and among the user's processes on this machine. What
    is yielded says how long the other processes kept us waiting, and whether they left us alone.
    """

    def __init__(self, machine: Machine | None = None) -> None:
        self._machine = machine or Machine()
        self._changed = threading.Condition()
        self._judging = 0
        self._measuring = False
        self._waiting = 0

    @contextmanager
    def judging(self) -> Iterator[Admitted]:
        """Hold a place among those who judge; not to be asked for by who holds a place."""
        with self._changed:
            self._changed.wait_for(lambda: not self._measuring and not self._waiting)
            self._judging += 1
        try:
            with self._machine.judging() as place:
                yield place
        finally:
            with self._changed:
                self._judging -= 1
                self._changed.notify_all()

    @contextmanager
    def measuring(self) -> Iterator[Admitted]:
        """Be the only one; not to be asked for by who holds a place."""
        with self._changed:
            self._waiting += 1
            try:
                self._changed.wait_for(lambda: not self._measuring and not self._judging)
                self._measuring = True
            finally:  # after Ctrl-C too
                self._waiting -= 1
                self._changed.notify_all()
        try:
            with self._machine.measuring() as place:
                yield place
        finally:
            with self._changed:
                self._measuring = False
                self._changed.notify_all()


class _Queue(Generic[T]):
    """Hands out the items of a sequence, each once, with its place."""

    def __init__(self, items: Sequence[T]) -> None:
        self._items: Iterator[tuple[int, T]] = iter(enumerate(items))
        self._lock = threading.Lock()

    def __iter__(self) -> Iterator[tuple[int, T]]:
        while True:
            with self._lock:
                item = next(self._items, None)
            if item is None:
                return
            yield item

    def end(self) -> None:
        """Hand out nothing more."""
        with self._lock:
            self._items = iter(())


def share(items: Sequence[T], workers: int, work: Callable[[Iterable[tuple[int, T]]], None]) -> None:
    """Call `work` in as many threads as `workers`, this one included; together they see each item once.

    Where the machine has fewer threads left, fewer do it.
    The first exception of any of them is raised here once all have ended.
    """
    queue: _Queue[T] = _Queue(items)
    faults: list[BaseException] = []

    def guarded() -> None:
        try:
            work(queue)
        except BaseException as fault:
            faults.append(fault)

    threads = _started(guarded, min(workers, len(items)) - 1)
    work(queue)
    for thread in threads:
        thread.join()
    if faults:
        raise faults[0]


class _Outcome(Generic[R]):
    """What an item's work has come to."""

    def __init__(self, work: Callable[[T], R], item: T) -> None:
        self._fault: BaseException | None = None
        try:
            self._result = work(item)
        except BaseException as fault:
            self._fault = fault

    def get(self) -> R:
        """The result, or the exception that is in its place."""
        if self._fault is not None:
            raise self._fault
        return self._result


def in_order(items: Sequence[T], workers: int, work: Callable[[T], R]) -> Iterator[R]:
    """`work` of each item, several at once; the results come in the order of the items.

    Where the machine has fewer threads left, fewer do it, at the worst this one alone.

    An exception is raised in place of its item's result.
    """
    done: dict[int, _Outcome[R]] = {}
    outcomes = _outcomes(items, workers, work)
    with closing(outcomes):
        for place in range(len(items)):
            while place not in done:
                at, outcome = next(outcomes)
                done[at] = outcome
            yield done.pop(place).get()


def finished(
    items: Sequence[T], workers: int, work: Callable[[T], R]
) -> Generator[tuple[int, R], None, None]:
    """As `in_order`, but each result, with its item's place, as soon as it is there. An exception is raised
    as soon as it comes.
    """
    outcomes = _outcomes(items, workers, work)
    with closing(outcomes):
        for place, outcome in outcomes:
            yield place, outcome.get()


def _outcomes(
    items: Sequence[T], workers: int, work: Callable[[T], R]
) -> Generator[tuple[int, _Outcome[R]], None, None]:
    """Each item's place and outcome; once this is closed, nothing more is begun."""
    queue: _Queue[T] = _Queue(items)
    done: SimpleQueue[tuple[int, _Outcome[R]]] = SimpleQueue()

    def serve() -> None:
        for place, item in queue:
            done.put((place, _Outcome(work, item)))

    try:
        several = workers > 1 and len(items) > 1
        if several and _started(serve, min(workers, len(items))):
            for _ in items:
                yield done.get()
        else:
            for place, item in queue:
                yield place, _Outcome(work, item)
    finally:
        queue.end()


def _started(serve: Callable[[], None], count: int) -> list[threading.Thread]:
    """So many threads that do this, or as many of them as the machine lets start."""
    threads: list[threading.Thread] = []
    for _ in range(count):
        thread = threading.Thread(target=serve, daemon=True)
        try:
            thread.start()
        except (RuntimeError, MemoryError):  # RuntimeError is all that Python says of it
            break
        threads.append(thread)
    return threads
