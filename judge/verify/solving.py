"""What `solve` works on, said where one case takes it long: else nobody knows whose loop does not end."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import Event, Thread
from time import monotonic

from judge.problem import Case
from judge.values.wire import cut

FIRST, AGAIN = 5.0, 30.0  # seconds of one case until it is said, and said again
_LOOK = 0.5  # seconds between two looks at it


class Solving:
    """A context manager that looks at the clock beside the work; each case is solved `within` it.

    After a Ctrl-C `text` is what was worked on: "solve works on group 'many', case 7: (3, 4)".
    """

    def __init__(self, say: Callable[[str], None], clock: Callable[[], float] = monotonic) -> None:
        self.at: tuple[str, int, Case] | None = None  # the case that is solved, or was at Ctrl-C
        self._say, self._clock = say, clock
        self._due = 0.0
        self._ended = Event()

    def __enter__(self) -> Solving:
        Thread(target=self._run, daemon=True).start()
        return self

    def __exit__(self, *_: object) -> None:
        self._ended.set()

    def _run(self) -> None:
        while not self._ended.wait(_LOOK):
            self.look()

    @property
    def text(self) -> str:
        """Which case is worked on; nothing where none is."""
        if self.at is None:
            return ""
        group, number, case = self.at
        return f"solve works on group {group!r}, case {number}: {cut(repr(case))}"

    def look(self) -> None:
        """Say it if it is time to."""
        if self._clock() >= self._due and (text := self.text):
            self._due += AGAIN
            self._say(text)

    @contextmanager
    def within(self, group: str, number: int, case: Case) -> Iterator[None]:
        """While that case of a group, counted from 1, is solved."""
        self._due = self._clock() + FIRST
        self.at = group, number, case
        try:
            yield
        except Exception:  # a Ctrl-C leaves it there
            self.at = None
            raise
        self.at = None
