"""What the judge keeps from run to run: files of the cache folder, each keyed by what it comes from.

    line 1     the digest of the value's key and of everything after this line
    the rest   the value: JSON, or bytes as they are

A file that is not as it was written counts as missing; a folder that cannot be written costs speed and a
note, never a run. Two runs may write at once: either file is whole. Of users who share a cache each believes
what it has written itself, or the superuser, or the folder's owner.
"""

from __future__ import annotations

import os
import time
from _blake2 import blake2b  # hashlib's own; the rest of that loads OpenSSL
from collections.abc import Callable, Iterable
from functools import cache
from pathlib import Path
from typing import Any, Protocol, TypeVar

import msgspec

from judge.errors import ProblemError
from judge.files import CACHE_VARIABLE, cache_folder, read_ordinary

T = TypeVar("T")

_PACKAGE = Path(__file__).resolve().parent
_YOUNG = 2.0  # seconds; within them a file may change again and keep its time


class Store(Protocol):
    """Where values are kept: of a name what was written last, which is read under its own key alone."""

    def read(self, name: str, key: str, kind: type[T]) -> T | None:
        """What was written, as that type (`bytes` as they are); None where there is nothing sound."""

    def write(self, name: str, key: str, value: Any, what: str = "test data") -> str | None:
        """Keep a value; a note for the person, who knows it as `what`, where that fails."""


class CacheFolder:
    """The store on disk: the file `<folder>/<name>` for each name.

    The folder is asked when it is needed: it may raise RuntimeError where there is no home folder.
    """

    def __init__(self, folder: Callable[[], Path] = cache_folder) -> None:
        self._folder = folder

    def path(self, name: str) -> Path:
        """The file of that name, which need not be there. Raises RuntimeError."""
        return self._folder() / name

    def read(self, name: str, key: str, kind: type[T]) -> T | None:
        """As `Store.read`."""
        try:
            owners = {os.geteuid(), 0, self._folder().stat().st_uid}
            checksum, _, body = read_ordinary(self.path(name), owners=owners).partition(b"\n")
            return decoded(body, kind) if checksum == _checksum(key, body) else None
        except (OSError, RuntimeError, ValueError):  # RecursionError is a RuntimeError
            return None

    def write(self, name: str, key: str, value: Any, what: str = "test data") -> str | None:
        """As `Store.write`."""
        import json  # only for who writes; it keeps integers of any size, and infinity

        from judge.files import replace_file

        body = value if isinstance(value, bytes) else json.dumps(value, separators=(",", ":")).encode()
        try:
            path = self.path(name)
            path.parent.mkdir(parents=True, exist_ok=True)
            replace_file(path, _checksum(key, body) + b"\n" + body, follow_links=False)
        except (OSError, RuntimeError) as error:
            reason = getattr(error, "strerror", None) or str(error)
            remedy = f"set ${CACHE_VARIABLE} to a writable folder"
            return f"{what} are not kept for the next run ({reason}); {remedy}"
        return None


DISK = CacheFolder()


def _checksum(key: str, body: bytes) -> bytes:
    return digest(key.encode(), b"\n", body).encode()


def decoded(body: bytes, kind: type[T]) -> T:
    """Raises ValueError where it is nothing of that type."""
    if kind is bytes:
        return body  # type: ignore[return-value]
    try:
        return msgspec.json.decode(body, type=kind)
    except msgspec.DecodeError:  # it knows no infinity
        import json

        return msgspec.convert(json.loads(body), kind, str_keys=True)


def digest(*parts: bytes) -> str:
    """The digest of the parts one after another, 64 hex digits."""
    total = blake2b(digest_size=32)
    for part in parts:
        total.update(part)
    return total.hexdigest()


def content_key(paths: Iterable[str | Path]) -> str:
    """The hash of the files' names and contents, 32 hex digits. Raises ProblemError."""
    parts = []
    for path in map(Path, paths):
        try:
            content = read_ordinary(path)
        except OSError as error:
            what = f"cannot be read: {error.strerror}"
            raise ProblemError(what, where=str(path), remedy="make it readable") from None
        parts += [f"/{path.name}/{len(content)}/".encode(), content]
    return digest(*parts)[:32]


def stamp(paths: Iterable[str]) -> str:
    """What changes with every change of these files, none of which is read.

    "" where one changed just now, or is not there.
    """
    try:
        found = [(path, os.stat(path)) for path in paths]  # noqa: PTH116 - of hundreds
    except OSError:
        return ""
    if max((each.st_ctime for _, each in found), default=0.0) > time.time() - _YOUNG:
        return ""
    told = [(path, each.st_size, each.st_mtime_ns, each.st_ctime_ns, each.st_ino) for path, each in found]
    return digest(repr(told).encode())[:32]


@cache
def code_key(*rooms: str) -> str:
    """The hash of the judge's code in these rooms, of all of it without any; made once a process."""
    return content_key(code_files(*rooms))


def code_files(*rooms: str) -> list[str]:
    """The Python files of these rooms of the judge, of all of them without any, in an order of their own."""
    places = [place for room in rooms or ("",) for place in os.walk(_PACKAGE / room)]
    return sorted(f"{place}/{name}" for place, _, names in places for name in names if name.endswith(".py"))
