"""Where a kata lies that is being watched: its file, its saves, its judging."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from queue import Empty, SimpleQueue
from types import FrameType
from typing import TYPE_CHECKING, Any

from msgspec import Struct

from judge.cli.judging import Sitting
from judge.cli.resolve import folder_to_keep, shown
from judge.cli.submissions import read_submissions
from judge.cli.wish import Wish
from judge.errors import JudgeError, StoreError, UsageError
from judge.practice.saves import SavedMark, mark, settled
from judge.problem import Problem
from judge.report.screen import note

if TYPE_CHECKING:
    from judge.cli.picture import Drawing

_LOOK = 1.0  # seconds after which the file is looked at even if nothing was told of it


class Kata(Struct, frozen=True):
    """A kata and the file that is to solve it, from the root."""

    problem: Problem
    path: Path

    @property
    def name(self) -> str:
        """The file as a person would name it from here."""
        return shown(self.path)


def take_up(kata: Kata, db: Path | None) -> None:
    """Note that the kata was started; a history that fails does not stand in the way."""
    from judge.cli.kept import history_at
    from judge.practice.events import Started

    try:
        with history_at(db) as history:
            history.keep(Started(kata.problem.id, str(kata.path), folder_to_keep(kata.problem)))
    except StoreError as fault:
        note(f"not kept in the history: {fault}")


class Judging:
    """A context in which the main thread judges, and another may break that off as Ctrl-C does."""

    def __init__(self) -> None:
        self._idle = threading.Event()
        self._idle.set()
        self._turn = threading.Lock()  # so that no interrupt comes when judging is over
        self._outdated = False

    def __enter__(self) -> None:
        self._outdated = False
        self._idle.clear()

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> bool:
        """Judging is over; no error comes of breaking off what is out of date."""
        try:
            self._over()
        except KeyboardInterrupt:  # it came at the last moment
            self._over()
            if not self._outdated:
                raise
        return kind is KeyboardInterrupt and self._outdated

    def _over(self) -> None:
        with self._turn:
            self._idle.set()

    def break_off(self, *, outdated: bool = False) -> bool:
        """Interrupt the main thread if it is judging; whether there was something to break off."""
        with self._turn:
            if self._idle.is_set():
                return False
            self._outdated = outdated
            signal.pthread_kill(threading.main_thread().ident or 0, signal.SIGINT)
            return True

    def over(self, seconds: float) -> None:
        """Wait so long until nothing is being judged."""
        self._idle.wait(seconds)


class WatchedFile:
    """A kata under watch: whether its file was saved since it was judged, and judging it."""

    def __init__(self, kata: Kata, wish: Wish) -> None:
        self.kata = kata
        self._sitting = Sitting(kata.problem, wish)
        self._seen: SavedMark | None = None
        self._looked = False
        self.judging = Judging()

    def look(self) -> None:
        """Something has happened to the file: give up judging what stood in it before, from any thread."""
        if mark(self.kata.path) != self._seen:
            self.judging.break_off(outdated=True)

    def saved(self) -> bool:
        """Whether there is something new to judge or to tell; waits while the file is being written."""
        if self._looked and mark(self.kata.path) == self._seen:
            return False
        now = settled(self.kata.path)
        new = not self._looked or now != self._seen
        self._seen, self._looked = now, True
        return new

    def judge(self) -> Drawing | str:
        """Judge the file as it is now, as `judge run` does; a sentence where that cannot be done.

        Raises:
            UsageError: the isolation that was demanded cannot be had.
        """
        name = self.kata.name
        if self._seen is None:
            return f"{name} is gone; it is judged again when it is back"
        try:
            submissions = read_submissions([name])
        except UsageError as fault:
            return str(fault)
        if not submissions[0].source.strip():
            return f"{name} is empty; it is judged when there is something in it"
        try:
            return self._sitting.judged(submissions[0])
        except UsageError:
            raise
        except JudgeError as fault:
            return str(fault)

    def close(self) -> None:
        """End what is kept from one save to the next."""
        self._sitting.close()


def await_event(events: SimpleQueue[str]) -> str | None:
    """The next event, or None after a second without one."""
    try:
        return events.get(timeout=_LOOK)
    except Empty:
        return None


@contextmanager
def handled(handlers: Mapping[str, Callable[[int, FrameType | None], Any]]) -> Iterator[None]:
    """Have these signals handled while the block runs."""
    before = {name: signal.signal(getattr(signal, name), handler) for name, handler in handlers.items()}
    try:
        yield
    finally:
        for name, handler in before.items():
            signal.signal(getattr(signal, name), handler)
