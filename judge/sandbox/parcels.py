"""What a container is handed: the code of its seed, memory shared with the judge, nameless files, folders.

The code is one file, so that no path of the package is needed inside it: marshal data, (modules, config). The
interpreter inside, the same as the judge's, reads it, makes the modules under their own names and is the
seed, which forgets those names again. Files are memory on Linux, unlinked temporary files elsewhere.

<temporary folder>/judge-box-<random>     locked as long as its judge lives; of a killed one it goes when the
                                          next one makes its own
"""

from __future__ import annotations

import contextlib
import fcntl
import marshal
import os
import sys
import time
from collections.abc import Iterator
from functools import cache
from importlib.machinery import PathFinder
from pathlib import Path
from types import CodeType
from typing import Any

from judge.sandbox.inside import wire
from judge.sandbox.inside.again import again

_PREFIX = "judge-box-"
_OLD = 60.0  # seconds; one that was made just now may not be locked yet
_AS_A_FOLDER = os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW | os.O_CLOEXEC
_ALWAYS = (  # in the order in which they import one another
    "judge.sandbox.encode",
    "judge.sandbox.inside.again",
    "judge.sandbox.inside.wire",
    "judge.sandbox.inside.source",
    "judge.sandbox.inside.child",
    "judge.sandbox.inside.confine",
    "judge.sandbox.inside.unseen",
    "judge.sandbox.inside.server",
    "judge.sandbox.inside.seed",
)
_ON_LINUX = "judge.sandbox.inside.linux"

# argv: the bundle's descriptor, the channel's
BOOTSTRAP = """\
import marshal, sys
from types import ModuleType
bundle, channel = map(int, sys.argv[1:])
with open(bundle, "rb") as file:
    modules, config = marshal.loads(file.read())
for name in ("judge", "judge.sandbox", "judge.sandbox.inside"):
    sys.modules[name] = ModuleType(name)
    sys.modules[name].__path__ = []
for name, code in modules:
    module = sys.modules[name] = ModuleType(name)
    package, _, own = name.rpartition(".")
    setattr(sys.modules[package], own, module)
    exec(code, module.__dict__)
module.start(channel, config)
"""


def code(config: dict[str, Any]) -> bytes:
    """The code of a seed, whose last module starts it. `config` holds plain values only."""
    first = [_ON_LINUX] if sys.platform == "linux" else []
    return marshal.dumps((tuple(map(_module, (*first, *_ALWAYS))), config))


@cache
def _module(name: str) -> tuple[str, CodeType]:
    return name, _code_of(name)


def _code_of(name: str) -> CodeType:
    """A module's code as its file has it: pytest imports judge through a hook that rewrites its asserts."""
    spec: Any = PathFinder.find_spec(name, sys.modules[name.rpartition(".")[0]].__path__)
    return _as(f"{name.replace('.', '/')}.py", spec.loader.get_code(name))


def _as(path: str, code: CodeType) -> CodeType:
    """The code as of a file of that name: where the judge lies is in the memory of no submission."""
    inner = tuple(_as(path, each) if isinstance(each, CodeType) else each for each in code.co_consts)
    return code.replace(co_filename=path, co_consts=inner)


def nameless(data: bytes = b"") -> int:
    """A descriptor of a new nameless file holding `data`, positioned at its start."""
    descriptor = _create(0)
    try:
        rest = memoryview(data)
        while rest:
            rest = rest[os.write(descriptor, rest) :]
        os.lseek(descriptor, 0, os.SEEK_SET)
    except BaseException:
        os.close(descriptor)
        raise
    return descriptor


def region() -> tuple[int, wire.Region]:
    """A new region and its descriptor; on Linux its size is sealed, so that no user can pull it away."""
    descriptor = _create(os.MFD_ALLOW_SEALING if sys.platform == "linux" else 0)
    try:
        os.ftruncate(descriptor, wire.REGION_BYTES)
        if sys.platform == "linux":
            seals = fcntl.F_SEAL_SHRINK | fcntl.F_SEAL_GROW | fcntl.F_SEAL_SEAL
            fcntl.fcntl(descriptor, fcntl.F_ADD_SEALS, seals)
        return descriptor, wire.Region(descriptor)
    except BaseException:
        os.close(descriptor)
        raise


@contextlib.contextmanager
def files(*contents: bytes) -> Iterator[list[int]]:
    """Descriptors of new files that hold these, closed at the end."""
    opened: list[int] = []
    try:
        for data in contents:
            opened.append(nameless(data))
        contents, data = (), b""  # they may be large
        yield opened
    finally:
        for descriptor in opened:
            os.close(descriptor)


def part(descriptor: int, start: int, length: int) -> bytes:
    """So many bytes of a file from `start` on, fewer where it ends."""
    return os.pread(descriptor, max(0, min(length, size(descriptor) - start)), start)


def size(descriptor: int) -> int:
    """A file's length in bytes."""
    return os.fstat(descriptor).st_size


def tail(descriptor: int, most: int) -> bytes:
    """The last `most` bytes of a file, fewer if it is shorter."""
    return os.pread(descriptor, most, max(0, size(descriptor) - most))


def _create(flags: int) -> int:
    if sys.platform != "linux":
        return _unlinked()
    return again(lambda: os.memfd_create("judge", os.MFD_CLOEXEC | flags))


def _unlinked() -> int:
    import tempfile  # slow to import, and Linux does without

    descriptor, path = again(lambda: tempfile.mkstemp(prefix="judge-"))
    os.unlink(path)  # noqa: PTH108 - nothing to see before it is gone
    return descriptor


@contextlib.contextmanager
def temporary_folder() -> Iterator[Path]:
    """A new folder that others may pass through, for a user that a container becomes. Raises OSError."""
    place = Path(os.environ.get("TMPDIR", ""))  # tempfile takes as long to import as all else of a start
    place = place if place.is_absolute() and place.is_dir() else Path("/tmp")
    sweep(place)
    path = place / f"{_PREFIX}{os.urandom(8).hex()}"
    path.mkdir(mode=0o700)  # before others may pass through
    path.chmod(0o711)
    lock = os.open(path, _AS_A_FOLDER)
    try:
        with contextlib.suppress(OSError):  # a file system without locks: its age protects it
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        yield path
    finally:
        _remove(str(path))
        os.close(lock)


def sweep(folder: Path) -> None:
    """Take away what judges of this user left there that are dead; silently, and following no link."""
    with contextlib.suppress(OSError), os.scandir(folder) as entries:
        for entry in entries:
            if entry.name.startswith(_PREFIX):
                _take_away(entry.path)


def _remove(path: str) -> None:
    """Take it away with all that is in it, as far as that goes."""
    with contextlib.suppress(OSError):
        _empty(path)
        Path(path).rmdir()


def _take_away(path: str) -> None:
    with contextlib.suppress(OSError):  # it is gone, in use, or no business of ours
        descriptor = os.open(path, _AS_A_FOLDER)
        try:
            found = os.fstat(descriptor)
            if found.st_uid == os.geteuid() and time.time() - found.st_mtime > _OLD:
                fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)  # refused while its judge lives
                _remove(path)
        finally:
            os.close(descriptor)


def _empty(folder: str) -> None:
    """Take away all that is below it, no link followed, where nobody changes it meanwhile. Raises OSError.

    What lies in a folder below is taken up beside that, so that however deep they are no path grows long.
    """
    top = os.open(folder, _AS_A_FOLDER)
    try:
        waiting = _without_files(top, top)
        while waiting:
            here = os.open(waiting[-1], _AS_A_FOLDER, dir_fd=top)
            try:
                inner = _without_files(here, top)
            finally:
                os.close(here)
            os.rmdir(waiting.pop(), dir_fd=top)
            waiting += inner
    finally:
        os.close(top)


def _without_files(folder: int, into: int) -> list[str]:
    """Take the files of an open folder away, and its folders into another one; their names there."""
    folders = []
    for entry in list(os.scandir(folder)):
        if entry.is_dir(follow_symlinks=False):
            os.chmod(entry.name, 0o700, dir_fd=folder)
            folders.append(os.urandom(8).hex())
            os.rename(entry.name, folders[-1], src_dir_fd=folder, dst_dir_fd=into)
        else:
            os.unlink(entry.name, dir_fd=folder)
    return folders
