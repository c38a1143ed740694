"""A box's container: started ahead, tried again, at the next level where the first is refused for good."""

from __future__ import annotations

import contextlib
import threading
from collections.abc import Callable
from typing import Protocol

from judge.sandbox.container import Container, Lost
from judge.sandbox.inside.again import PAUSES
from judge.sandbox.refusal import NotStarted


class Ladder(Protocol):
    """Which level comes after which, for all boxes of a command."""

    def had(self, level: str) -> None:
        """A container is ready at this level."""
        ...

    def below(self, level: str, reason: str) -> str:
        """The level to try now that this one is refused for good. Raises JudgeError where none may be."""
        ...


class Holder:
    """The container of one box, at the level where it can be had.

    A refusal that may pass is tried again and then costs the submission; it never leads to another level.
    Neither does any refusal once a container was ready.
    """

    def __init__(self, level: str, ladder: Ladder, start: Callable[[str], Container]) -> None:
        """Start a container ahead; what goes wrong with that shows when it is asked for."""
        self.level = level
        self.prepared = False  # whether the container has compiled the source
        self._ladder = ladder
        self._start = start
        self._closed = threading.Event()
        self._container: Container | None = None
        with contextlib.suppress(NotStarted):
            self._container = start(level)

    def here(self) -> Container:
        """The running container, ready for a request.

        Raises:
            ShortageError: there is no room for one, also after a while.
            JudgeError: the level is refused for good and no other may be taken.
            Lost: the box is closed.
        """
        tries = 0
        while True:
            if self._closed.is_set():
                raise Lost
            try:
                return self._ready()
            except NotStarted as refusal:
                self._container = None
                tries += 1
                if tries >= refusal.tries:
                    if not refusal.lasting:
                        raise refusal.shortage from refusal
                    self.level = self._ladder.below(self.level, refusal.what)
                    tries = 0
                else:
                    self._closed.wait(PAUSES[tries - 1])

    def _ready(self) -> Container:
        if self._container is None:
            self.prepared = False
            self._container = self._start(self.level)
        self._container.await_ready()
        self._ladder.had(self.level)
        return self._container

    def drop(self) -> None:
        """End the container; the next request starts another."""
        container, self._container = self._container, None
        self.prepared = False
        if container is not None:
            container.close()

    def close(self, *, at_once: bool) -> None:
        """Start no other container; with `at_once` what runs in this one ends, whoever waits for it."""
        self._closed.set()
        if at_once and self._container is not None:
            self._container.kill()
