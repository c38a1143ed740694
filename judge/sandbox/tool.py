"""The box of a program that reads files and leaves some, such as one that checks another program's output.

It is held as any submission is, but for the folder that it fills, with so many files and bytes and no more.
"""

from __future__ import annotations

import marshal
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

from judge.errors import ShortageError
from judge.sandbox import shared
from judge.sandbox.boundary import Limits, ProgramResult
from judge.sandbox.container import Lost
from judge.sandbox.factory import Boxes
from judge.sandbox.inside import wire
from judge.sandbox.launch import RESULT, SCRATCH, Workplace
from judge.sandbox.native import NativeBox, Order
from judge.sandbox.recipe import Files, Store

_GIVEN = "/given"
_FILES = 64  # that a run may leave
_LEFT_BYTES = 8 << 20
_WORK = Limits(cpu_seconds=10.0, wall_seconds=30.0, memory_bytes=1 << 30, output_bytes=_LEFT_BYTES)
_BUSY = "judge it again"


class Left(NamedTuple):
    """One run: how it ended, and the files it left; `why` says why these could not be had, or is empty."""

    run: ProgramResult
    files: Files = ()
    why: str = ""


class ToolBox(NativeBox):
    """One such program, compiled once and run as often as wanted; one thread at a time may use it."""

    def __init__(self, order: Callable[[], Order], boxes: Boxes, store: Store) -> None:
        """As of `NativeBox`."""
        super().__init__(order, boxes, store, idle=False)
        self._given: Path | None = None

    def _placed(self, folder: Path, box: Path) -> Workplace:
        self._given = folder / "given"
        self._given.mkdir(mode=0o755)
        (folder / "scratch").mkdir(mode=0o755)
        place = super()._placed(folder, box)
        return place._replace(
            profile="check",
            shown=(*place.shown, (_GIVEN, str(self._given))),
            scratch=str(folder / "scratch"),
            feedback=(_FILES + 1, _LEFT_BYTES),  # the folder itself counts
        )

    def check(self, stdin: bytes, given: Files, more: Sequence[str], limits: Limits) -> Left:
        """Run it with the paths of the `given` files, of the folder that it fills, and `more` as arguments.

        That folder is empty at first, and its path ends with a slash.

        Raises:
            ShortageError: its container ended.
            JudgeError: no container can be had.
        """
        fault = self.inspect().fault
        assert fault is None, "whoever runs it has looked"
        try:
            folder = self._emptied()
            place, level, shown = self._place, self._run_holder().level, self._given
            assert place is not None
            assert shown is not None
            for name, content in given:
                (shown / name).write_bytes(content)
                (shown / name).chmod(0o644)
            inside = place.where(_GIVEN, level)
            self._arguments = (*(f"{inside}/{name}" for name, _ in given), f"{folder}/", *more)
            run = self.run_whole(stdin, limits)
            return self._left(folder, run)
        except Lost:
            raise ShortageError("the container of a checking program has ended", remedy=_BUSY) from None

    def _emptied(self) -> str:
        """The path inside of the folder that it fills; where that cannot be emptied, a new container's."""
        holder = self._run_holder()
        for _ in range(2):
            container = holder.here()
            assert self._place is not None
            folder = f"{self._place.where(SCRATCH, holder.level)}/{RESULT}"
            with shared.stdio(b"") as stdio:
                container.ask(wire.EMPTY, stdio, marshal.dumps(folder), _WORK, _WORK.memory_bytes)
            if container.region.note()[0] != wire.BROKEN_BOX:
                return folder
            holder.drop()
        raise ShortageError("what a checking program has left cannot be taken away", remedy=_BUSY)

    def _left(self, folder: str, run: ProgramResult) -> Left:
        container = self._run_holder().here()
        payload = marshal.dumps((folder, _LEFT_BYTES, _FILES))
        with shared.stdio(b"") as stdio:
            container.ask(wire.COLLECT, stdio, payload, _WORK, _WORK.memory_bytes)
            found = marshal.loads(container.replies(payload, _WORK.output_bytes, 1))
            content = shared.head(stdio[1], _LEFT_BYTES)
        if isinstance(found, str):
            return Left(run, why="it left more files than it may, or they cannot be read")
        files, start = [], 0
        for name, size in found:
            files.append((name, content[start : start + size]))
            start += size
        return Left(run, tuple(files))
