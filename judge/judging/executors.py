"""Who does the work: here one after another, or several processes at once (processes.py).

An executor is given what to do and the items to do it to, and gives each result as soon as it is there, with
the place of its item; `results` puts them in the order of the items. judge/batch/elsewhere.py is one whose
workers are on other machines.

A worker that dies in the middle of an item loses nothing: the item is done again. One that kills every worker
costs that item alone, for which `lost` gives the result.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator, Sequence
from typing import Generic, Protocol, TypeAlias, TypeVar

from msgspec import Struct

from judge.errors import JudgeError, told

T = TypeVar("T")
R = TypeVar("R")
Lost: TypeAlias = Callable[[T, str], R]  # the result of an item that no worker survives, and why
Finished: TypeAlias = Generator[tuple[int, R], None, None]  # an item's place and its result; to be closed

ATTEMPTS = 3  # at an item, whose workers die


class Executor(Protocol):
    """Does work on items, in any order and any place."""

    def finished(self, work: Callable[[T], R], items: Sequence[T], lost: Lost[T, R]) -> Finished[R]:
        """The place and the result of each item, each once, as soon as it is there; close it to end the work.

        What `work` raises as a JudgeError is raised, and ends the work. Any other fault of it is that item's:
        it is tried again, and then lost.
        """
        ...

    def alive(self) -> int:
        """How many workers there are just now."""
        ...


class Here(Struct, frozen=True):
    """One item after another, by whoever asks for the results."""

    def finished(self, work: Callable[[T], R], items: Sequence[T], lost: Lost[T, R]) -> Finished[R]:
        """See `Executor.finished`."""
        for place, item in enumerate(items):
            yield place, attempted(work, item, lost)

    def alive(self) -> int:
        """This one."""
        return 1


def results(executor: Executor, work: Callable[[T], R], items: Sequence[T], lost: Lost[T, R]) -> Iterator[R]:
    """The result of each item, in order, each as soon as those before it are there.

    What `work` raises as a JudgeError is raised in place of the result.
    """
    done: dict[int, R | Raised] = {}
    outcomes = executor.finished(Held(work), items, lost)
    try:
        for place in range(len(items)):
            while place not in done:
                at, outcome = next(outcomes)
                done[at] = outcome
            result = done.pop(place)
            if isinstance(result, Raised):
                raise result.fault
            yield result
    finally:
        outcomes.close()


def attempted(work: Callable[[T], R], item: T, lost: Lost[T, R]) -> R:
    """The item's result, by as many workers as it takes, within reason."""
    why = ""
    for _ in range(ATTEMPTS):
        try:
            return work(item)
        except (KeyboardInterrupt, JudgeError):
            raise
        except BaseException as fault:  # SystemExit too: it would end a thread, and its item with it
            why = told_of(fault)
    return lost(item, lost_for(why))


def told_of(fault: BaseException) -> str:
    """What ended an attempt, in words."""
    return told(fault) if isinstance(fault, Exception) else repr(fault)


def lost_for(why: str) -> str:
    """Why an item is given up, after so many attempts of which the last one ended so."""
    return f"it was lost {ATTEMPTS} times: {why}"


class Raised(Struct, frozen=True):
    """A fault in place of a result."""

    fault: JudgeError


class Held(Struct, Generic[T, R], frozen=True):
    """Work whose JudgeError is handed over like a result: it is to be raised in its place."""

    work: Callable[[T], R]

    def __call__(self, item: T) -> R | Raised:
        """The result, or the fault in its place."""
        try:
            return self.work(item)
        except JudgeError as fault:
            return Raised(fault)
