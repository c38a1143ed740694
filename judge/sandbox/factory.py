"""Opening boxes one after the other, without trying again what this machine has refused."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from judge.sandbox.boundary import Box


class Boxes:
    """A `BoxFactory` at the best isolation level there is, or at the one demanded.

    It remembers where bubblewrap was refused, which takes a while each time. A level that it has once had is
    tried again each time: its refusal is then a passing one, and must not weaken every box that follows.
    """

    def __init__(self, level: str | None = None, hide: Iterable[Path] = ()) -> None:
        """Arguments as of `open_box`."""
        self._level = level
        self._hide = tuple(hide)
        self._refused: set[str] = set()
        self._had: set[str] = set()

    def __call__(self, source: bytes, name: str) -> Box:
        """A box for this source; `name` is its file's."""
        from judge.sandbox import probe  # only a run needs sockets, processes and ctypes

        without = self._refused - self._had
        return probe.open_box(
            source, name, level=self._level, hide=self._hide, without=without, on_level=self._tried
        )

    def _tried(self, level: str, refused: bool) -> None:
        (self._refused if refused else self._had).add(level)
