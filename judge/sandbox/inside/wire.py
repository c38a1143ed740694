"""What the judge and its fork server say to each other, and the memory they share.

    judge → seed     one 64-byte frame: OPEN, with the descriptors of a server's channel, of the memory
                     that it shares with the judge, and of a file with (config, source)
    judge → server   one 64-byte frame: REQUEST, with the descriptors of stdin, stdout, stderr
                     and, of calls, that of a file with their arguments
                     and, while one is outstanding, perhaps STOP: its child is killed
    server → judge   one 64-byte frame DONE, after the child is dead and reaped;
                     or LACK, where the machine had no process or descriptor left for a child

A child that makes calls stops itself twice: once its module is imported, and after the last call. At the
first stop the server reads its CPU clock, lays the arguments where the child finds them, and lets it go on;
at the second it reads the clock and kills it. So import, calls and nothing else are measured, and no argument
is there before the calls' own time begins. A stop anywhere else is its end.

One request is outstanding at a time, and a STOP that comes after its end is for nobody. Frames have one
size, so that a stream socket (macOS) does as well as a packet socket. A child never sees this socket.

Everything longer goes through the region, memory shared by the judge, the server and its children:

    0      64       4096                       start                                  stop
    ├ words ┼ note ──┼ payload (judge → child) ──┼ replies, one JSON text per line ─────┤
      USED NOTE_KIND NOTE_SIZE STOOD_AT CODE

A child that has used up its time is asked by SIGUSR1 to write the line where it stands to STOOD_AT,
and killed a moment later, whatever it does: the line is for a person, and decides nothing.

The child appends a reply and then moves USED; nothing needs flushing, so what was answered survives the
death of the process that answered, whatever kills it, and the call it died in is the one after the last
reply. The child holds no descriptor of the region. All of it is foreign data to the judge: bounded, parsed
as JSON, never believed.
"""

from __future__ import annotations

import _socket
import errno
import mmap
import struct
import sys

TYPE_CHECKING = False  # not typing's: that import would cost every container a millisecond
if TYPE_CHECKING:
    from collections.abc import Sequence

FRAME = 64
REQUEST = struct.Struct("=cqqqqqii")  # kind, cpu ns and wall ns, and as the fields of Request
DONE = struct.Struct("=4siiqqqiqqq")  # ENDED and the first fields of container.ChildEnd
LACK = struct.Struct("=4si")  # LACKING and the errno of what there was no room for, in place of a DONE
ENDED, LACKING = b"done", b"lack"
READY = b"ready"  # and the server's pid, in 4 bytes
FAILED = b"failed"  # the reason is in the region's note

OPEN = b"O"
INSPECT, CALLS, PROGRAM = b"I", b"F", b"P"
EXECUTE, COLLECT = b"X", b"C"  # of what is not Python: see server.py
STOP = b"S"
PAUSES = sys.platform == "linux"  # elsewhere no clock of another process says when an import is over

MOST_DESCRIPTORS = 64

NOT_KILLED, FOR_CPU, FOR_WALL = 0, 1, 2
FOR_WAITING = 3  # it waited too long, import and calls together

NOT_STARTED, IMPORTING, CALLING = range(3)  # how far a child came


REGION_BYTES = 96 << 20  # sparse: only what is written costs memory
WORDS = 64
PAYLOAD_AT = 4096
USED, NOTE_KIND, NOTE_SIZE, STOOD_AT, CODE = range(5)  # places of the region's words
NOTE_BYTES = PAYLOAD_AT - WORDS

REPLY_BYTES = 8 << 20  # of all replies, whatever the output limit: the judge has to parse them

NO_NOTE, RAISED, NO_MEMORY, TOO_MUCH, BROKEN_BOX = range(5)  # what a note says of a child's end
COMPILED = 6  # of a look at the source: these modules are to be imported
EXPOSED = 5  # of the server's own: this path can be read, and no submission may see it


class Request:
    """One request, unpacked."""

    def __init__(self, frame: bytes, descriptors: list[int]) -> None:
        fields = REQUEST.unpack_from(frame)
        self.kind, self.cpu_ns, self.wall_ns, self.waiting_ns, self.memory, self.output = fields[:6]
        self.payload, self.stop = fields[6:]
        self.descriptors = descriptors  # stdin, stdout, stderr, and the file of the arguments


class Channel:
    """Frames and descriptors over one end of a socket pair."""

    def __init__(self, end: _socket.socket) -> None:
        self._end = end

    def fileno(self) -> int:
        """The socket's descriptor."""
        return self._end.fileno()

    def close(self) -> None:
        """Hang up."""
        self._end.close()

    def ended(self, seconds: float) -> bool:
        """Ask the other side to end; whether it does in that time."""
        try:
            self._end.shutdown(_socket.SHUT_WR)
            self._end.settimeout(seconds)
            while self._end.recv(FRAME):
                continue
        except TimeoutError:
            return False
        except OSError:  # it has
            return True
        return True

    def patience(self, seconds: float | None) -> None:
        """How long a receive may wait; it raises TimeoutError after that."""
        self._end.settimeout(seconds)

    def send(self, message: bytes, descriptors: Sequence[int] = ()) -> None:
        """Send one frame with copies of the descriptors. Raises OSError when the other side is gone."""
        carried = struct.pack(f"={len(descriptors)}i", *descriptors)
        ancillary = [(_socket.SOL_SOCKET, _socket.SCM_RIGHTS, carried)] if descriptors else []
        self._end.sendmsg([message.ljust(FRAME, b"\0")], ancillary)

    def receive(self, descriptors: int = 0) -> tuple[bytes, list[int]]:
        """One frame and the descriptors that came with it; an empty frame at the end. Raises OSError."""
        room = _socket.CMSG_SPACE(descriptors * 4) if descriptors else 0
        message, ancillary, _, _ = self._end.recvmsg(FRAME, room)
        found: list[int] = []
        for level, kind, data in ancillary:
            if level == _socket.SOL_SOCKET and kind == _socket.SCM_RIGHTS:
                found += struct.unpack(f"={len(data) // 4}i", data[: len(data) - len(data) % 4])
        while message and len(message) < FRAME:
            more = self._end.recv(FRAME - len(message))
            if not more:
                return b"", found
            message += more
        return message, found


class Region:
    """The shared memory of one container."""

    def __init__(self, descriptor: int) -> None:
        self.memory = mmap.mmap(descriptor, REGION_BYTES, mmap.MAP_SHARED)
        self.words = memoryview(self.memory)[:WORDS].cast("Q")

    def prepare(self, payload: bytes) -> None:
        """Lay down a request's payload in memory that holds nothing of the last child.

        It could otherwise leave its answers to the next one: those of the judging to those of the race.
        """
        if hasattr(mmap, "MADV_REMOVE"):  # Linux: punches a hole
            self.memory.madvise(mmap.MADV_REMOVE)
        else:  # as far as it says that it wrote
            used = min(max(self.words[USED], PAYLOAD_AT), REGION_BYTES)
            self.memory[:used] = bytes(used)
        self.lay(payload)
        self.words[USED] = replies_at(len(payload))

    def lay(self, arguments: bytes) -> None:
        """Lay the arguments in the place of the request's payload, which is as long as they are."""
        self.memory[PAYLOAD_AT : PAYLOAD_AT + len(arguments)] = arguments

    def payload(self, length: int) -> bytes:
        """The request's payload, or the arguments."""
        return self.memory[PAYLOAD_AT : PAYLOAD_AT + length]

    def append(self, data: bytes, stop: int = REGION_BYTES) -> bool:
        """Append to the replies, if it ends before `stop`; whether it does."""
        start = self.words[USED]
        end = start + len(data)
        if end > stop:
            return False
        self.memory[start:end] = data
        self.words[USED] = end
        return True

    def replies(self, start: int, stop: int) -> bytes:
        """What was appended between `start` and `stop`, as far as USED says and no further."""
        return self.memory[start : min(max(self.words[USED], start), stop)]

    def note(self) -> tuple[int, str]:
        """The note on the child's end: its kind and its text, one printable line."""
        size = min(self.words[NOTE_SIZE], NOTE_BYTES)
        text = self.memory[WORDS : WORDS + size].decode(errors="replace")
        return self.words[NOTE_KIND], printable(text)

    def write_note(self, kind: int, text: str) -> None:
        """Say how the child ends."""
        data = text.encode(errors="replace")[:NOTE_BYTES]
        self.memory[WORDS : WORDS + len(data)] = data
        self.words[NOTE_SIZE] = len(data)
        self.words[NOTE_KIND] = kind

    def write_fault(self, fault: BaseException) -> None:
        """Say that trusted code has failed, why, and with which errno."""
        code = getattr(fault, "errno", None)
        self.words[CODE] = errno.ENOMEM if isinstance(fault, MemoryError) else code or 0
        self.write_note(BROKEN_BOX, f"{type(fault).__name__}: {fault}")

    def close(self) -> None:
        """Unmap it."""
        self.words.release()
        self.memory.close()


def replies_at(payload: int) -> int:
    """Where the replies start after a payload of that many bytes."""
    return (PAYLOAD_AT + payload + 7) & ~7


def reply_bytes(output: int) -> int:
    """How long the replies may be together, under an output limit."""
    return min(output, REPLY_BYTES)


def printable(text: str) -> str:
    """Foreign text as one line that cannot move a terminal's cursor."""
    return "".join(c if c.isprintable() else " " for c in text).strip()
