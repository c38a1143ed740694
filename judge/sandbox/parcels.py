"""What a container is handed: the code of its seed, memory shared with the judge, files without a name.

The code is one file, so that no path of the package is needed inside it: marshal data, (modules, config). The
interpreter inside, the same as the judge's, reads it, makes the modules under their own names and is the
seed, which forgets those names again. Files are memory on Linux, unlinked temporary files elsewhere.
"""

from __future__ import annotations

import contextlib
import fcntl
import marshal
import os
import sys
from collections.abc import Iterator
from functools import cache
from importlib.machinery import PathFinder
from types import CodeType
from typing import Any

from judge.sandbox.inside import wire
from judge.sandbox.inside.again import again

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
