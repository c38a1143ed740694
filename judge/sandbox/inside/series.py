"""The series of calls of one request, handed to a child one after the other.

A child stops itself at the end of each series but the last. A stop counts as that only where exactly the
replies of the series are there; they are sealed by their digest, so that they cannot become others later.
Only then are the next arguments laid where the child finds them: it cannot do the work of a later series on
the time of an earlier one. They come in a file that the child has no descriptor of:

    (calls, bytes) of each series ── arguments of the second ── of the third ── …
"""

from __future__ import annotations

import os
import struct

from judge.sandbox.inside import wire

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

ENTRY = struct.Struct("=II")


def pack(calls: Sequence[int], arguments: Sequence[bytes]) -> bytes:
    """The file's content, for the judge's side; `arguments` are those of every series, packed."""
    table = [ENTRY.pack(count, len(data)) for count, data in zip(calls, arguments, strict=True)]
    return b"".join([*table, *arguments[1:]])


class Series:
    """How far a child has come in its series."""

    __slots__ = ("_at", "_each", "_file", "_place", "_sealed", "_start", "_stop", "_streams", "_table")

    def __init__(self, count: int, payload: int, output: int, stop: int, descriptors: Sequence[int]) -> None:
        """The series of a request: `count` of them, `descriptors` as in the request."""
        self._streams = descriptors[1:3]
        self._file = descriptors[3] if count > 1 else -1
        table = os.pread(self._file, count * ENTRY.size, 0) if count > 1 else b""
        self._table = list(ENTRY.iter_unpack(table))
        self._at = count * ENTRY.size  # of the next arguments in the file
        self._place = 0
        self._start = self._sealed = wire.replies_at(payload)
        self._stop = stop
        self._each = output

    @property
    def more(self) -> bool:
        """Whether another series comes after this one."""
        return self._place + 1 < len(self._table)

    def seal(self, region: wire.Region) -> tuple[int, int, bytes]:
        """End the series: why the child must be killed, if at all, where its replies end, their digest."""
        part = region.replies(self._sealed, self._stop)
        calls = self._table[self._place][0]
        if part.count(b"\n") != calls or not (part.endswith(b"\n") if calls else part == b""):
            return wire.FOR_STOPPING, 0, b""
        printed = max(os.fstat(stream).st_size for stream in self._streams)
        reason = wire.NOT_KILLED
        if printed > self._each or len(part) > wire.reply_bytes(self._each):
            reason = wire.FOR_OUTPUT
        self._sealed += len(part)
        if self._stop - self._sealed < wire.reply_bytes(self._each):
            reason = reason or wire.FOR_ROOM
        return reason, self._sealed - self._start, wire.digest(part)

    def hand_out(self, region: wire.Region) -> None:
        """Begin the next series: its arguments, and an empty stdout and stderr."""
        self._place += 1
        length = self._table[self._place][1]
        data = os.pread(self._file, length, self._at)
        self._at += length
        region.memory[wire.PAYLOAD_AT : wire.PAYLOAD_AT + length] = data
        for stream in self._streams:  # the child writes through the same open file
            os.ftruncate(stream, 0)
            os.lseek(stream, 0, os.SEEK_SET)
