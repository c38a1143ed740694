"""Opening boxes one after the other at one isolation level."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

from judge.sandbox.levels import Levels

if TYPE_CHECKING:
    from judge.sandbox.boundary import Box
    from judge.sandbox.container import Seeds
    from judge.sandbox.room import Share
    from judge.sandbox.visible import Visible


class Containment:
    """A `BoxFactory` at the best isolation level there is, or at the one demanded; see `Levels`."""

    def __init__(
        self,
        level: str | None = None,
        hide: Iterable[Path] = (),
        *,
        least: str | None = None,
        had: str | None = None,
        share: Share | None = None,
    ) -> None:
        """Arguments as of `open_box`.

        Args:
            level: the level demanded.
            hide: more folders that must not be seen inside.
            least: the level below which nothing may be run, though none is demanded.
            had: a level that this command has had before.
            share: the threads each submission may have; counted for one at a time where it is None.
        """
        self.levels = Levels(level, least, had)
        self.hide = tuple(hide)
        self._own_share = share
        self._visible: dict[tuple[tuple[str, ...], bool], Visible] = {}

    def __call__(self, source: bytes, name: str) -> Box:
        """A box for this source; `name` is its file's. Raises UsageError and JudgeError as `Levels.open`."""
        from judge.sandbox.box import PythonBox  # only a run needs sockets, processes and ctypes

        return PythonBox(self, source, name)

    @cached_property
    def seeds(self) -> Seeds:
        """What forks the boxes' servers."""
        from judge.sandbox.container import Seeds

        return Seeds()

    def kept(self) -> Containment:
        """These, where what a box was started from is there for the next one, until `close`."""
        self.seeds.keep = True
        return self

    def close(self) -> None:
        """End what is there for the next box."""
        self.seeds.close()

    def visible(self, more: tuple[str, ...] = (), *, modules: bool = True) -> Visible:
        """What a submission sees; see `visible.visible`. It is looked for once."""
        from judge.sandbox.visible import visible

        if (more, modules) not in self._visible:
            self._visible[more, modules] = visible(self.hide, more, modules=modules)
        return self._visible[more, modules]

    @cached_property
    def share(self) -> Share:
        """The threads that each submission may have."""
        from judge.sandbox import room

        return self._own_share or room.measure().share(1)
