"""Compiling in a container of its own: what a compiler may use, what it leaves, its complaints in one line.

A source can make a compiler read files, fill memory and disk, or never end: it is held as a submission is,
but for the folder that it fills and the processes that it starts.
"""

from __future__ import annotations

import errno
import marshal
import os
import re
import signal
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from judge.errors import ShortageError, shortage_of
from judge.sandbox import outcome, parcels, room
from judge.sandbox.boundary import Limits, SourceFault
from judge.sandbox.box import BUSY
from judge.sandbox.container import ChildEnd, Container
from judge.sandbox.inside import wire
from judge.sandbox.launch import PLAIN, RESULT, SCRATCH, Workplace
from judge.sandbox.recipe import Files, Recipe, Sources, filled

SOURCE = "/source"
LIMITS = Limits(cpu_seconds=10.0, wall_seconds=60.0, memory_bytes=1 << 30, output_bytes=64 << 20)
ARTIFACT_BYTES = 64 << 20
ARTIFACT_FILES = 2000
PROCESSES = 256  # of all that the compiler starts, where they have a user of their own
DESCRIPTORS = 512
_SAID = 1 << 16  # bytes of what a compiler says that are looked at
_SHOWN = 300
_WARNINGS = 3  # of a compiler that are told
_LONGEST = 500  # characters of a line of it
_NAME = re.compile(r"[\w$+-][\w$.+-]*(/[\w$+-][\w$.+-]*)*")
_PATH = re.compile(r"(?<![\w.])/[\w.+-]+(?:/[\w.+-]+)+/")
_PLACED = re.compile(
    r"^(?P<file>[\w.$-]+):(?P<line>\d+)(?::(?P<column>\d+))?:? *"
    r"(?![\d: ]*(?:warning|note|Note|In |At |(?:recursively )?required ))"  # nor by going back before it
    r"(?:(?:fatal )?error(?:\[\w+\])?:? *)?(?P<message>.*)$",
    re.MULTILINE,
)
_REQUIRED = re.compile(  # what a line of the source asks of a library of templates
    r"^(?P<file>[\w.$-]+):(?P<line>\d+)(?::(?P<column>\d+))?: +required from here\n"
    r".*?\berror: (?P<message>.*)$",
    re.MULTILINE,
)
_PYTHON = re.compile(r'File "(?P<file>[\w.$-]+)", line (?P<line>\d+)')
_ERROR = re.compile(r"^.*?(?:(?:\w*Error|error|panic):.*)$", re.MULTILINE)
_CARET = re.compile(r"^([ \t]*)\^+[ \t]*$", re.MULTILINE)
_NO_TEXT = "stream did not contain valid UTF-8"  # of what a driver includes
_SYMBOL = re.compile(r"^ *symbol: +(.+)$", re.MULTILINE)  # the name that javac does not find
_ASSEMBLED = re.compile(r"^cc\w{6}\.s:\d+: ", re.MULTILINE)  # a file of the compiler's own
_UNLINKED = (  # what a linker says, and what that means where it is not plain
    (re.compile(r"undefined (?:reference|symbol)s?\b.*"), ""),
    (re.compile(r"multiple definition of [^;\n]*"), ""),
    (re.compile("relocation truncated to fit"), "its arrays take more than the 2 GB that can be linked"),
    (
        re.compile("ld returned|linking with"),
        "it cannot be linked: is something declared and nowhere defined?",
    ),
)
_TOO_LARGE = f"it compiles to more than {LIMITS.output_bytes >> 20} MB"


class Compiled(NamedTuple):
    """What came of it: files, or the fault of the source; `warnings` are about the submission's own file."""

    files: Files
    fault: SourceFault | None
    warnings: tuple[str, ...] = ()


def place_of(recipe: Recipe, folder: Path) -> Workplace:
    """What the compiler's container has; `folder` holds `source` and an empty `scratch`."""
    return Workplace(
        profile="compile",
        shown=((SOURCE, str(folder / "source")),),
        scratch=str(folder / "scratch"),
        runnable=tuple(map(os.path.realpath, recipe.compile_runs)),
        descriptors=DESCRIPTORS,
        random=False,  # an endless file
    )


def compiled(recipe: Recipe, sources: Sources, container: Container, place: Workplace) -> Compiled:
    """Compile the sources that are shown in the container. Raises Lost.

    Raises ShortageError where it is too busy, or the compiler ends for want of something.
    """
    room.check_memory(LIMITS.memory_bytes)
    level = container.level
    scratch, source = place.where(SCRATCH, level), place.where(SOURCE, level)
    places = {
        "out": f"{scratch}/{RESULT}",
        "scratch": scratch,
        "folder": source,
        "source": f"{source}/{sources.main}",
    }
    own_first = sorted((name for name, _ in sources.files), key=lambda name: name != sources.own)
    names = [f"{source}/{name}" for name in own_first]  # what begins first is the submission's
    environment = {
        **PLAIN,
        "HOME": scratch,
        "TMPDIR": scratch,
        **{name: filled([value], places)[0] for name, value in recipe.compile_environment.items()},
    }
    alone = level == "full" or os.geteuid() == 0  # else the kernel counts all processes of a user together
    limits = {
        "RLIMIT_CPU": int(LIMITS.cpu_seconds) + 1,  # each of its processes
        "RLIMIT_FSIZE": LIMITS.output_bytes,
        "RLIMIT_DATA": LIMITS.memory_bytes,
        "RLIMIT_NPROC": PROCESSES if alone else room.tasks_of_mine() + PROCESSES,
        "RLIMIT_STACK": 64 << 20,
    }
    kills = room.oom_kills()
    warnings: tuple[str, ...] = ()
    for step in recipe.steps:
        payload = marshal.dumps((filled(step, places, names), environment, scratch, limits))
        with parcels.files(b"", b"", b"") as stdio:
            done = container.ask(wire.EXECUTE, stdio, payload, LIMITS, LIMITS.memory_bytes)
            said = parcels.part(stdio[2], 0, _SAID) + b"\n" + parcels.part(stdio[1], 0, _SAID)
        kind, note = done.note
        if kind == wire.BROKEN_BOX:
            raise ShortageError(f"{step[0]} cannot be started: {note}", remedy=BUSY)
        text = _plain(said.decode(errors="replace"), (f"{source}/", f"{scratch}/"))
        warnings += _warned(text, sources, recipe.warning)
        fault = _fault(done, text, sources, recipe.complaint)
        if fault:
            if not fault.line and room.oom_kills() != kills:
                raise shortage_of(errno.ENOMEM, "the kernel has killed the compiler")
            return Compiled((), fault)
    if recipe.keeps:
        return Compiled(sources.files, None, warnings)
    return _collected(container, places["out"])._replace(warnings=warnings)


def _collected(container: Container, folder: str) -> Compiled:
    """What the compiler left."""
    payload = marshal.dumps((folder, ARTIFACT_BYTES, ARTIFACT_FILES))
    with parcels.files(b"", b"", b"") as stdio:
        container.ask(wire.COLLECT, stdio, payload, LIMITS, LIMITS.memory_bytes)
        found = marshal.loads(parcels.part(stdio[1], 0, parcels.size(stdio[1])))
    if isinstance(found, str):
        return Compiled((), SourceFault(found))
    for name, _ in found:
        if not _NAME.fullmatch(name) or ".." in name:
            return Compiled((), SourceFault(f"it compiles to a file of a strange name, {ascii(name)[:80]}"))
    return Compiled(found, None)


def _plain(said: str, places: Sequence[str]) -> str:
    """What a compiler says, without the folders in it."""
    for place in places:
        said = said.replace(place, "")
    return wire_lines(_PATH.sub("", said))


def _warned(said: str, sources: Sources, warning: str) -> tuple[str, ...]:
    """What it says of the submission's own file, each line once."""
    found = re.finditer(warning, said, re.MULTILINE) if warning else ()
    lines = {each["line"]: each["message"].strip() for each in found if each["file"] == sources.own}
    return tuple(f"the compiler warns: {lines[line]} (line {line})" for line in lines)[:_WARNINGS]


def _fault(done: ChildEnd, said: str, sources: Sources, complaint: str) -> SourceFault | None:
    """Why a step failed, for a person; None where it did not. Raises ShortageError."""
    if not done.status:
        return None
    if done.reason == wire.FOR_CPU or done.cpu_ns / 1e9 > LIMITS.cpu_seconds:  # of all that it has started
        return SourceFault(f"the compiler took more than {LIMITS.cpu_seconds:g} s of CPU time")
    if done.reason:
        took = f"{done.wall_ns / 1e9:.3g} s for {done.cpu_ns / 1e9:.2g} s of CPU time"
        raise ShortageError(f"the machine is too busy to compile it: that took {took}", remedy=BUSY)
    if outcome.is_from_outside(done):
        raise ShortageError("the compiler was killed", remedy=BUSY)
    if os.WIFSIGNALED(done.status):
        number = os.WTERMSIG(done.status)
        return SourceFault(f"the compiler did not survive it: {signal.strsignal(number) or number}")
    if "File size limit exceeded" in said:  # an assembler's, or a linker's, of which the compiler tells
        return SourceFault(_TOO_LARGE)
    status = os.waitstatus_to_exitcode(done.status)
    return _told(_ASSEMBLED.sub("", said), sources, complaint, status)


def wire_lines(text: str) -> str:
    """Foreign text as lines that cannot move a terminal's cursor, indented as they were, none too long."""
    lines = (line[:_LONGEST] for line in text.splitlines())
    return "\n".join(" " * (len(line) - len(line.lstrip())) + wire.printable(line) for line in lines)


def _told(said: str, sources: Sources, complaint: str, status: int) -> SourceFault:
    names = [name for name, _ in sources.files]
    forms = [re.compile(complaint, re.MULTILINE)] if complaint else [_PLACED, _REQUIRED, _PYTHON]
    places = (each for form in forms for each in form.finditer(said) if each["file"] in names)
    found = min(places, key=lambda each: (each.re is _PYTHON, each.start()), default=None)
    error = next((each[0].strip() for each in _ERROR.finditer(said)), "")
    if found is None:
        lines = [line for line in said.splitlines() if line.strip()]
        unlinked = (meant or met[0] for pattern, meant in _UNLINKED if (met := pattern.search(said)))
        text = next(unlinked, "") or error
        text = text or (lines[-1].strip() if lines else f"the compiler ended with status {status}")
        return SourceFault(text[:_SHOWN])
    groups = found.groupdict()
    message = (groups.get("message") or "").strip()
    if sources.mismatch and found["file"] != sources.own:
        return SourceFault(_NO_TEXT if _NO_TEXT in message else sources.mismatch)
    if not message or error.split(":")[0].endswith("SyntaxError"):
        message = error or "it does not compile"
    following = _PLACED.search(said, found.end())
    shown = said[found.end() : following.start() if following else None]
    symbol, caret = _SYMBOL.search(shown), _CARET.search(shown)
    if symbol:
        message += f": {symbol[1].strip()}"
    marked = len(caret[1]) + 1 if caret and found.re is _PLACED else 0
    return SourceFault(message[:_SHOWN], int(found["line"]), int(groups.get("column") or marked))
