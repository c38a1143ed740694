"""Doing several things at once, and the one thing that must be done alone: measuring.

Threads suffice: they wait for processes of the submissions. They are daemons, so that Ctrl-C need not wait
for them; what they started ends with the judge's own process.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from typing import Generic, TypeVar

T = TypeVar("T")
R = TypeVar("R")


class Turnstile:
    """Many may judge at once, or one may measure alone; who waits to measure is let in first."""

    def __init__(self) -> None:
        self._changed = threading.Condition()
        self._judging = 0
        self._measuring = False
        self._waiting = 0

    @contextmanager
    def judging(self) -> Iterator[None]:
        """Hold a place among those who judge."""
        with self._changed:
            self._changed.wait_for(lambda: not self._measuring and not self._waiting)
            self._judging += 1
        try:
            yield
        finally:
            with self._changed:
                self._judging -= 1
                self._changed.notify_all()

    @contextmanager
    def measuring(self) -> Iterator[None]:
        """Be the only one; not to be asked for by who holds a place among those who judge."""
        with self._changed:
            self._waiting += 1
            self._changed.wait_for(lambda: not self._measuring and not self._judging)
            self._waiting -= 1
            self._measuring = True
        try:
            yield
        finally:
            with self._changed:
                self._measuring = False
                self._changed.notify_all()


class _Queue(Generic[T]):
    """Hands out the items of a sequence, each once, with its place."""

    def __init__(self, items: Sequence[T]) -> None:
        self._items = enumerate(items)
        self._lock = threading.Lock()

    def __iter__(self) -> Iterator[tuple[int, T]]:
        while True:
            with self._lock:
                item = next(self._items, None)
            if item is None:
                return
            yield item


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


def in_order(items: Sequence[T], workers: int, work: Callable[[T], R]) -> Iterator[R]:
    """`work` of each item, several at once; the results come in the order of the items.

    Where the machine has fewer threads left, fewer do it, at the worst this one alone.

    An exception is raised in place of its item's result.
    """
    if workers <= 1 or len(items) <= 1:
        yield from map(work, items)
        return
    queue: _Queue[T] = _Queue(items)
    done: dict[int, R | BaseException] = {}
    changed = threading.Condition()

    def serve() -> None:
        for place, item in queue:
            outcome: R | BaseException
            try:
                outcome = work(item)
            except BaseException as fault:
                outcome = fault
            with changed:
                done[place] = outcome
                changed.notify_all()

    if not _started(serve, min(workers, len(items))):
        yield from map(work, items)
        return
    for place in range(len(items)):
        with changed:
            changed.wait_for(lambda place=place: place in done)  # type: ignore[misc]
            outcome = done.pop(place)
        if isinstance(outcome, BaseException):
            raise outcome
        yield outcome


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
