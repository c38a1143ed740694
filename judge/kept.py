"""A JSON file of the cache, keyed by the content of all that it was made from.

    line 1     the digest of the file's key and of everything after this line
    the rest   the JSON

A file that is not as it should be counts as missing; a folder that cannot be written costs speed and a note,
never a run. Two runs may write at once: either file is whole.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import msgspec

from judge.atomic import replace_file, sweep
from judge.digest import digest_of
from judge.folders import CACHE_VARIABLE
from judge.reading import read_ordinary


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
            sweep(self._path().parent)
            content = read_ordinary(self._path())
        except (OSError, RuntimeError):  # RuntimeError: there is no home folder
            return None
        checksum, _, body = content.partition(b"\n")
        if checksum != self._checksum(body):
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
            path.parent.mkdir(parents=True, exist_ok=True)
            replace_file(path, self._checksum(body) + b"\n" + body)
            for old in path.parent.glob(f"{self._stem}*.json"):
                if old != path:
                    old.unlink(missing_ok=True)
        except (OSError, RuntimeError) as error:
            reason = getattr(error, "strerror", None) or str(error)
            remedy = f"set ${CACHE_VARIABLE} to a writable folder"
            return f"{self._what} are not kept for the next run ({reason}); {remedy}"
        return None

    def _checksum(self, body: bytes) -> bytes:
        """With the key in it, so that a sound file under another one's name is not taken for its data."""
        return digest_of(self._key.encode() + body).encode()

    def _path(self) -> Path:
        return self._cache_folder() / self._folder / f"{self._stem}{self._key}.json"


def _parsed(body: bytes, form: Any) -> Any:
    """The JSON, by the quicker parser of two that agree; it knows no infinity. Raises ValueError."""
    try:
        return msgspec.json.decode(body, type=form)
    except msgspec.DecodeError:
        import json  # seldom

        return json.loads(body)
