"""Work on many items, here or in several processes of this machine: a fault costs an attempt, never the work.

A worker is a process that does one item after another. One that dies in the middle of an item loses nothing:
the item is done again. One that kills every worker costs that item alone, for which `lost` gives the result.
A worker lives no longer than who gives it work: its items come through a pipe, and it ends when nobody is
left who could send one. judge/batch/cluster.py has workers on other machines.
"""

from __future__ import annotations

import fcntl
import multiprocessing
import os
import signal
from collections import Counter
from collections.abc import Callable, Container, Generator, Iterator, Sequence
from contextlib import closing, suppress
from multiprocessing.connection import Connection, wait
from multiprocessing.context import SpawnProcess
from multiprocessing.resource_tracker import ensure_running
from typing import Any, Protocol, TypeAlias, TypeVar

from msgspec import Struct

from judge.errors import JudgeError, shortage, told

T = TypeVar("T")
R = TypeVar("R")
Lost: TypeAlias = Callable[[T, str], R]  # the result of an item that no worker survives, and why
Finished: TypeAlias = Generator[tuple[int, R], None, None]  # an item's place and its result; to be closed
Outcome: TypeAlias = tuple[Any, JudgeError | str | None]  # a result, or a fault; see `attempt`

_AHEAD = 20  # of the items that wait, among which a worker looks for one that suits it
ATTEMPTS = 3  # at an item, whose workers die
_LOST = f"it was lost {ATTEMPTS} times: "
_SPAWN = multiprocessing.get_context("spawn")  # a fork would copy open boxes


class Executor(Protocol):
    """Does work on items, in any order and any place."""

    def run(self, work: Callable[[T], R], items: Sequence[T], lost: Lost[T, R]) -> Finished[R]:
        """The place and the result of each item, each once, as soon as it is there; close it to end the work.

        What `work` raises as a JudgeError is raised, and ends the work. Any other fault of it is that item's:
        it is tried again, and then lost.
        """
        ...


def in_order(executor: Executor, work: Callable[[T], R], items: Sequence[T], lost: Lost[T, R]) -> Iterator[R]:
    """The result of each item, in order, each as soon as those before it are there. Raises JudgeError."""
    done: dict[int, R] = {}
    with closing(executor.run(work, items, lost)) as outcomes:
        for place in range(len(items)):
            while place not in done:
                at, result = next(outcomes)
                done[at] = result
            yield done.pop(place)


def attempt(work: Callable[[T], R], item: T) -> Outcome:
    """The item's result, or what was raised: a JudgeError as it is, of any other fault what is told if it was
    the last attempt.
    """
    try:
        return work(item), None
    except JudgeError as fault:
        return None, fault
    except Exception as fault:
        return None, _LOST + told(fault)
    except SystemExit as fault:  # it would end the worker
        return None, _LOST + repr(fault)


def _settled(outcome: Outcome, item: T, lost: Lost[T, R]) -> R:
    """The result, now that the item is not tried again. Raises the JudgeError that the work has raised."""
    result, fault = outcome
    if isinstance(fault, JudgeError):
        raise fault
    return result if fault is None else lost(item, fault)


class Here(Struct, frozen=True):
    """One item after another, by whoever asks for the results."""

    def run(self, work: Callable[[T], R], items: Sequence[T], lost: Lost[T, R]) -> Finished[R]:
        """See `Executor.run`."""
        for place, item in enumerate(items):
            tries = 1
            while isinstance((outcome := attempt(work, item))[1], str) and tries < ATTEMPTS:
                tries += 1
            yield place, _settled(outcome, item, lost)


class Processes:
    """So many items at once, each in a process of its own.

    The work is a module's function, known by its name; items and results are pickled. Of the next items a
    worker takes those of one `problem`, where they have one, for what that needs is warm there. `short` says
    why workers are fewer than asked for, where they are.
    """

    def __init__(self, count: int) -> None:
        from judge.sandbox import room  # which a worker has no need of

        room.raise_descriptors()
        self.count, limit = room.measure().at_once(count)
        short = f"{self.count} at once, not {count}: there is no room for more ({limit})"
        self.short = short if limit else ""

    def run(self, work: Callable[[T], R], items: Sequence[T], lost: Lost[T, R]) -> Finished[R]:
        """See `Executor.run`."""
        kinds = [getattr(item, "problem", None) for item in items]  # what each needs to be warm
        waiting, tries = list(range(len(items))), Counter[int]()
        workers = [_Worker() for _ in range(min(self.count, len(items)))]
        idle = list(workers)
        busy: dict[Any, tuple[_Worker, int]] = {}
        try:
            while waiting or busy:
                while waiting and idle:
                    worker = idle.pop()
                    others = {other.at for other, _ in busy.values()}
                    place = _next(waiting[:_AHEAD], kinds, worker.at, others)
                    try:
                        busy[worker.given(work, items[place])] = worker, place
                    except (OSError, MemoryError) as fault:  # no process can be started
                        short = shortage(fault)
                        if short is None or not busy:
                            raise short or fault from None
                        continue  # those that are at work will do it
                    waiting.remove(place)
                    worker.at = kinds[place]
                for line in wait(busy):
                    worker, place = busy.pop(line)
                    outcome = worker.outcome()
                    idle.append(worker)  # before the result is taken: whoever takes it may want no more
                    tries[place] += 1
                    if isinstance(outcome[1], str) and tries[place] < ATTEMPTS:
                        waiting.append(place)
                    else:
                        yield place, _settled(outcome, items[place], lost)
        finally:
            for worker in workers:
                worker.end()


def _next(waiting: Sequence[int], kinds: Sequence[object], at: object, others: Container[object]) -> int:
    """The next place for a worker that was at this kind: of the same kind, or of one that no other is at, or
    of that of which most wait.
    """
    counts = Counter(kinds[place] for place in waiting)
    best = max(counts, key=lambda kind: (kind == at, kind not in others, counts[kind]))
    return next(place for place in waiting if kinds[place] == best)


class _Worker:
    """A process that does one item after another, and another one in its place when it has died."""

    def __init__(self) -> None:
        self.at: object = None  # the kind of its last item
        self.process: SpawnProcess | None = None
        self._items: Connection
        self._outcomes: Connection

    def given(self, work: Callable[[T], R], item: T) -> Connection:
        """Give it the item; what is returned can be read once `outcome` is there.

        Raises OSError where no process can be started.
        """
        if self.process is None:
            theirs, self._items = _SPAWN.Pipe(duplex=False)
            self._outcomes, back = _SPAWN.Pipe(duplex=False)
            process = _SPAWN.Process(target=_serve, args=(theirs, back))
            ensure_running()  # which would let Ctrl-C through
            # Until the process is ready for it, it does not get Ctrl-C.
            before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
            try:
                with theirs, back:
                    process.start()
                self.process = process
            finally:
                signal.pthread_sigmask(signal.SIG_SETMASK, before)
        with suppress(BrokenPipeError):  # it has died: that is its outcome
            self._items.send((work, item))
        return self._outcomes

    def outcome(self) -> Outcome:
        """What came of the item, once that is there."""
        try:
            found: Outcome = self._outcomes.recv()
        except (EOFError, OSError):
            self.end()
            return None, f"{_LOST}its worker died"
        return found

    def end(self) -> None:
        """End the process, in the middle of an item if it has one."""
        process, self.process = self.process, None
        if process is not None:
            self._items.close()
            self._outcomes.close()
            process.join()


def _serve(items: Connection, outcomes: Connection) -> None:
    """What a worker does. Ctrl-C, which every process of a terminal gets, ends it without a word."""
    if signal.getsignal(signal.SIGINT) is not signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT, signal.SIGIO})
    signal.signal(signal.SIGIO, signal.SIG_DFL)  # which ends this process
    fcntl.fcntl(items, fcntl.F_SETOWN, os.getpid())
    flags = fcntl.fcntl(items, fcntl.F_GETFL)
    with suppress(EOFError, BrokenPipeError):  # nobody is left
        while True:
            work, item = items.recv()
            # One item comes at a time: whatever happens to the pipe meanwhile, nobody wants the result.
            fcntl.fcntl(items, fcntl.F_SETFL, flags | os.O_ASYNC)
            if items.poll():
                os._exit(1)
            outcome = attempt(work, item)
            fcntl.fcntl(items, fcntl.F_SETFL, flags)
            outcomes.send(outcome)
