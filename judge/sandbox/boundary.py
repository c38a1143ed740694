"""The boundary between the judge and whatever runs a submission.

In front of it the judge holds the cases and the expected answers; behind it only the submission's source, the
arguments of the calls and standard input ever arrive. What comes back is plain JSON data of bounded size and
figures that were measured from outside. Nothing here knows what a problem is.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from enum import Enum
from typing import Any, NamedTuple, Protocol

from judge.sandbox.encode import IMPORTING as IMPORTING
from judge.sandbox.encode import MOST_ITEMS

BoxFactory = Callable[[bytes, str], "Box"]  # from a source and its file's name

_BUSY = 5  # times its CPU time
LEVELS = ("full", "strong", "limits")  # of isolation, the best first


class Stop(Enum):
    """Why a call or a program ended."""

    ANSWERED = "answered"
    EXCEPTION = "exception"  # an uncaught exception of the submission
    EXITED = "exited"  # it left with a non-zero status or was killed by a signal, or left in mid-call
    CPU = "cpu"  # CPU limit
    WALL = "wall"  # wall limit: it slept or waited
    WAITING = "waiting"  # its runs together have waited longer than they may
    MEMORY = "memory"
    OUTPUT = "output"  # it printed or answered more than the limit
    TAMPERED = "tampered"  # it wrote on the judge's own channel


class Limits(NamedTuple):
    """The bounds of one process: a program, or calls; the times hold for an import and again for its calls.

    `items` is how many items one answer may hold, in lists of all levels.
    """

    cpu_seconds: float
    wall_seconds: float
    memory_bytes: int
    output_bytes: int
    waiting_seconds: float = 1e9  # wall time beyond CPU time
    items: int = MOST_ITEMS


class Usage(NamedTuple):
    """What the submission's processes have used, measured from outside, without start-up."""

    cpu_seconds: float = 0.0
    wall_seconds: float = 0.0
    memory_bytes: int = 0  # peak resident size

    def __add__(self, other: Usage) -> Usage:  # type: ignore[override]
        return Usage(
            self.cpu_seconds + other.cpu_seconds,
            self.wall_seconds + other.wall_seconds,
            max(self.memory_bytes, other.memory_bytes),
        )

    @property
    def waiting_seconds(self) -> float:
        """Wall time beyond CPU time."""
        return max(0.0, self.wall_seconds - self.cpu_seconds)

    @property
    def slept_seconds(self) -> float:
        """What it waited, where that is more than a machine with much else to do lets a process wait."""
        return self.waiting_seconds if self.waiting_seconds > _BUSY * self.cpu_seconds else 0.0


class SourceFault(NamedTuple):
    """Why a source cannot be run at all; `line` and `column` count from 1, 0 where there is none."""

    message: str
    line: int = 0
    column: int = 0
    text: str = ""


class Defined(NamedTuple):
    """A function that a source defines at its top level, and binds to nothing else."""

    name: str
    line: int
    least: int  # arguments that a call must have
    most: int  # and may have; -1: any number
    empty: bool  # nothing is written in it yet

    def takes(self, count: int) -> bool:
        """Whether it can be called with so many arguments."""
        return self.least <= count and (self.most < 0 or count <= self.most)


class Inner(NamedTuple):
    """A function that stands `within` a "class Solution" or a "function main"."""

    name: str
    line: int
    within: str


class Inspection(NamedTuple):
    """What a source is, found inside the containment without running it."""

    fault: SourceFault | None
    names: tuple[tuple[str, int], ...] = ()  # what it binds at module level, each with its line
    functions: tuple[Defined, ...] = ()  # of these, those that are plain functions
    inner: tuple[Inner, ...] = ()
    language: str = ""  # its name; "" for Python
    warnings: tuple[str, ...] = ()  # of its compiler, in sentences

    @classmethod
    def read(cls, found: Mapping[str, Any]) -> Inspection:
        """What `inside.source.inspect` found in a Python source."""
        return cls(
            SourceFault(*found["fault"]) if found["fault"] else None,
            tuple((name, line) for name, line in found["names"]),
            tuple(Defined(*each) for each in found["functions"]),
            tuple(Inner(*each) for each in found["inner"]),
        )

    def defines(self, name: str) -> bool:
        """Whether the module binds `name` at its top level."""
        return any(bound == name for bound, _ in self.names)


class Reply(NamedTuple):
    """One call's end; `answer` is the answer's JSON form (see encode.py) when `stop` is ANSWERED."""

    stop: Stop
    answer: Any = None
    detail: str = ""  # for a person: the exception's last line with its line number, the signal's name


class CallsResult(NamedTuple):
    """The replies to some calls, in order.

    A call that raised (EXCEPTION) costs nothing but itself. Any other end than ANSWERED ends the process:
    it is the last reply, and the calls after it were not made. `usage` is that of the calls, `imported` what
    the module's import took, where that can be told apart; of an import that ended it, `usage` tells.
    `printed` is the beginning of what the calls wrote to stdout.
    """

    replies: tuple[Reply, ...]
    usage: Usage
    imported: Usage = Usage()
    printed: bytes = b""


class ProgramResult(NamedTuple):
    """One run of a whole program."""

    stop: Stop  # ANSWERED: it ended with status 0
    stdout: bytes
    stderr: bytes  # the last few KB
    detail: str
    usage: Usage


class Conversation(Protocol):
    """What a program is talked with, line by line, while it runs."""

    def say(self, data: bytes) -> None:
        """Hand it over, as far as the program is there to read it."""

    def hear(self) -> bytes:
        """The program's next line, with its line feed; what is left of one, and then nothing, at its end."""


Talk = Callable[[Conversation], bool]  # whether the program may go on to its own end, or else is ended there


class Box(Protocol):
    """One submission in containment; a context manager, nothing of it outlives the `with`."""

    @property
    def isolation(self) -> str:
        """The level that holds it: "full", "strong" or "limits"; "" as long as no container was made."""

    def __enter__(self) -> Box: ...

    def __exit__(self, *exc: object) -> None: ...

    def inspect(self) -> Inspection:
        """Parse and compile the source, without running it."""

    def call(self, entry: str, calls: Sequence[Sequence[Any]], limits: Limits) -> CallsResult:
        """Import the module, then call its function `entry` once for each argument list, in order.

        Arguments are None, ints, floats, str, (nested) lists and tuples of them, and `array.array`; they come
        after the import, and the submission receives fresh ones for each call.
        """

    def run_program(self, stdin: bytes | Talk, limits: Limits) -> ProgramResult:
        """Run the source as `__main__` with this standard input, in a process of its own.

        Of a program that is talked with, in a thread, `stdout` is what nobody has heard of it. What the talk
        raises is raised here. One that the program's end does not end is left alone.
        """
