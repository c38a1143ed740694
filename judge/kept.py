"""A file of the cache, keyed by the content of all that it was made from.

    line 1     the digest of the file's key and of everything after this line
    the rest   the content, JSON in most

A file that is not as it should be counts as missing; a folder that cannot be written costs speed and a note,
never a run. Two runs may write at once: either file is whole. Of users who share a cache each believes what
it has written itself, or the superuser, or the folder's owner.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import msgspec

from judge.digest import digest_of
from judge.files import CACHE_VARIABLE, read_ordinary, replace_file


def read_kept(path: Path, key: str, folder: Path) -> bytes | None:
    """What is kept under that key in a file of the cache `folder`; None where it is not as it was written.

    Raises OSError where it cannot be read, or is of a user who is not believed.
    """
    content = read_ordinary(path, owners={os.geteuid(), 0, folder.stat().st_uid})
    checksum, _, body = content.partition(b"\n")
    return body if checksum == _checksum(key, body) else None


def write_kept(path: Path, key: str, body: bytes) -> None:
    """Keep that. Raises OSError."""
    path.parent.mkdir(parents=True, exist_ok=True)
    replace_file(path, _checksum(key, body) + b"\n" + body, follow_links=False)


def _checksum(key: str, body: bytes) -> bytes:
    """With the key in it, so that a sound file under another one's name is not taken for its content."""
    return digest_of(key.encode() + body).encode()


class KeptFile:
    """The file `<cache folder>/<folder>/<stem><key>.json`; of one stem only the last written key is kept.

    `what` names the content in the note for the person. `cache_folder` is asked when it is needed: it may
    raise OSError or RuntimeError where there is no home folder.
    """

    def __init__(
        self, cache_folder: Callable[[], Path], folder: str, stem: str, key: str, what: str = "test data"
    ) -> None:
        self._cache_folder = cache_folder
        self._folder = folder
        self._stem = stem
        self._key = key
        self._what = what

    def read(self, form: Any = Any) -> Any:
        """What was written, or None if there is no sound file.

        `form` is the type it is read as, such as tuples for JSON's lists; where it does not fit, it is none.
        """
        try:
            body = read_kept(self._path(), self._key, self._cache_folder())
        except (OSError, RuntimeError):  # RuntimeError: there is no home folder
            return None
        if body is None:
            return None
        try:
            return _parsed(body, form)
        except (ValueError, RecursionError):
            return None

    def exists(self) -> bool:
        """Whether there is such a file, sound or not; True where nobody can say."""
        try:
            return self._path().exists()
        except (OSError, RuntimeError):
            return True

    def write(self, value: Any) -> str | None:
        """Keep `value` and drop what was kept for older contents; a note for the person if that fails."""
        import json  # only for who writes

        body = json.dumps(value, separators=(",", ":")).encode()
        try:
            path = self._path()
            write_kept(path, self._key, body)
            for old in path.parent.glob(f"{self._stem}*.json"):
                if old != path:
                    old.unlink(missing_ok=True)
        except (OSError, RuntimeError) as error:
            reason = getattr(error, "strerror", None) or str(error)
            remedy = f"set ${CACHE_VARIABLE} to a writable folder"
            return f"{self._what} are not kept for the next run ({reason}); {remedy}"
        return None

    def _path(self) -> Path:
        return self._cache_folder() / self._folder / f"{self._stem}{self._key}.json"


def _parsed(body: bytes, form: Any) -> Any:
    """The JSON, by the quicker parser of two that agree; it knows no infinity. Raises ValueError."""
    try:
        return msgspec.json.decode(body, type=form)
    except msgspec.DecodeError:
        import json  # seldom

        return json.loads(body)
