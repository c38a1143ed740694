"""Opening boxes one after the other at one isolation level: which one, and when another may be taken."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from judge.errors import JudgeError, UsageError, nearest
from judge.sandbox.boundary import LEVELS

if TYPE_CHECKING:
    from judge.sandbox.boundary import Box
    from judge.sandbox.room import Share
    from judge.sandbox.roots import Roots

_DOCTOR = "let 'judge doctor' look again"


def check_level(level: str) -> None:
    """Raise UsageError where no level of isolation has that name."""
    if level not in LEVELS:
        near = nearest(level, LEVELS)
        remedy = f"did you mean {near}?" if near else f"levels are {', '.join(LEVELS)}"
        raise UsageError(f"there is no isolation level {level}", remedy=remedy)


class Boxes:
    """A `BoxFactory` at the best isolation level there is, or at the one demanded.

    A level that is refused for good leads to the next one, and is not tried again; `refused` says why. A
    level that was had is demanded from then on, and so is `least`, which was found here before. `limits` is
    taken only where it is demanded, or where the machine has no sandbox at all.
    """

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
        if level is not None:
            check_level(level)
        self.refused: dict[str, str] = {}
        self._demanded = level
        self._least = least
        self.hide = tuple(hide)
        self._own_share = share
        self._had = set[str]() if had is None else {had}
        self._roots: Roots | None = None  # looking for them takes longer than starting a process

    def __call__(self, source: bytes, name: str) -> Box:
        """A box for this source; `name` is its file's. Raises UsageError and JudgeError as `below`."""
        from judge.sandbox.box import ForkServerBox  # only a run needs sockets, processes and ctypes
        from judge.sandbox.container import Container
        from judge.sandbox.holder import Holder
        from judge.sandbox.roots import find_roots

        level = self.first()
        if self._roots is None:
            self._roots = find_roots(self.hide)
        roots, share = self._roots, self.share
        holder = Holder(level, self, lambda level: Container(level, name, source, roots, share))
        return ForkServerBox(holder, share)

    @property
    def share(self) -> Share:
        """The threads that each submission may have."""
        if self._own_share is None:
            from judge.sandbox import room

            self._own_share = room.measure().share(1)
        return self._own_share

    def had(self, level: str) -> None:
        """A container is ready at this level."""
        self._had.add(level)

    def below(self, level: str, reason: str) -> str:
        """The level to try now that this one is refused for good.

        Raises:
            UsageError: it was demanded, or was found here before.
            JudgeError: it was had in this command, or there is none below it.
        """
        from judge.sandbox import launch, probe

        if level == "full" and launch.bind_proc(reason):
            return level
        if level in self._had:
            raise JudgeError(
                f"isolation {level} was had and is now refused: {reason}", remedy=probe.remedy(level, reason)
            )
        if level == self._demanded:
            what = f"isolation {level} cannot be had here: {reason}"
            raise UsageError(what, remedy=probe.remedy(level, reason))
        if level == self._least:
            what = f"isolation {level}, which 'judge doctor' found here, cannot be had: {reason}"
            raise UsageError(what, remedy=", or ".join(filter(None, (probe.remedy(level, reason), _DOCTOR))))
        following = LEVELS[LEVELS.index(level) + 1 :]
        if not following or (following[0] == "limits" and not probe.missing(level)):
            raise JudgeError(f"no container can be started: {reason}", remedy="see 'judge doctor'")
        self.refused[level] = reason
        return self._from(following[0])

    def first(self) -> str:
        """The level to begin with: what was had, what is demanded, or the best there may be."""
        had = next((level for level in LEVELS if level in self._had), None)
        return had or self._from(self._demanded or LEVELS[0])

    def _from(self, level: str) -> str:
        """This level, or where it is known that it cannot be had the next one."""
        from judge.sandbox import probe

        reason = self.refused.get(level) or probe.missing(level)
        return self.below(level, reason) if reason else level
