"""Who does the work: here one after another, or several threads at once.

An executor is given what to do and the items to do it to, and gives the results in the order of the items.
Anything with this method is one: for `judge.judging.run` and jobs, both of which can be sent elsewhere, other
processes and machines can be.

A worker that dies in the middle of an item loses nothing: the item is done again. One that kills every worker
costs that item alone, whose result is JE.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Protocol, TypeVar

from msgspec import Struct

from judge.errors import JudgeError, told
from judge.run.parallel import in_order
from judge.run.result import Result

T = TypeVar("T")
Lost = Callable[[T, str], Result]  # the result of an item that no worker survives, and why

ATTEMPTS = 2  # at an item, whose workers die


class WorkerDied(Exception):  # noqa: N818 - what has happened, not an error of who asked
    """A worker has ended in the middle of an item, through no fault that the item's work tells of."""


class Executor(Protocol):
    """Does work on items, in any order and any place."""

    def results(self, work: Callable[[T], Result], items: Sequence[T], lost: Lost[T]) -> Iterator[Result]:
        """The result of each item, in order, each as soon as those before it are there.

        What `work` raises as a JudgeError is raised in place of the result.
        """
        ...


class Here(Struct, frozen=True):
    """One item after another, by whoever asks for the results."""

    def results(self, work: Callable[[T], Result], items: Sequence[T], lost: Lost[T]) -> Iterator[Result]:
        """See `Executor.results`."""
        for item in items:
            yield attempted(work, item, lost)


class Threads(Struct, frozen=True):
    """So many items at once, each in a thread; their work is waiting for other processes."""

    count: int

    def results(self, work: Callable[[T], Result], items: Sequence[T], lost: Lost[T]) -> Iterator[Result]:
        """See `Executor.results`."""
        return in_order(items, self.count, lambda item: attempted(work, item, lost))


def executor(jobs: int) -> Executor:
    """What does so many things at once on this machine."""
    return Threads(jobs) if jobs > 1 else Here()


def attempted(work: Callable[[T], Result], item: T, lost: Lost[T]) -> Result:
    """The item's result, by as many workers as it takes, within reason."""
    why = ""
    for _ in range(ATTEMPTS):
        try:
            return work(item)
        except (KeyboardInterrupt, JudgeError):
            raise
        except BaseException as fault:  # SystemExit too: it would end a thread, and its item with it
            why = told(fault) if isinstance(fault, Exception) else repr(fault)
    return lost(item, f"it was lost {ATTEMPTS} times: {why}")
