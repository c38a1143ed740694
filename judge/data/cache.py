"""The cache of built data: one file a problem, read whole on a warm start.

    <cache folder>/data/<id>-<place>-<seed>-<key>.json
        line 1     the sha256 of the file's key and of everything after this line
        the rest   {"<group>": [[case, …], [target, …]], …}

`place` stands for the problem's folder, `key` for the content of everything the data are made from. The cache
folder is the user's, or $JUDGE_CACHE. A file that is not as it should be is built anew; a folder that cannot
be written costs speed and a note, never a run.
"""

from __future__ import annotations

import hashlib
import json
import os
from pathlib import Path
from typing import Any

from judge.data.atomic import replace_file
from judge.errors import ProblemError
from judge.spec import Problem

FORMAT = 2  # raise it when the form of the file changes

_VARIABLE = "JUDGE_CACHE"
_PACKAGE = Path(__file__).resolve().parent.parent
_CODE = ("exact", "compare", "data", "spec")  # the packages that the data depend on
_OWN_FILES = ("*.toml", "*.md", "*.py")  # of the problem's folder


class DataCache:
    """The cached data of one problem and one seed."""

    def __init__(self, problem: Problem, seed: int | None) -> None:
        place = hashlib.sha256(os.fsencode(problem.folder)).hexdigest()[:8]
        self._stem = f"{problem.id}-{place}-{'own' if seed is None else 'seeded'}-"
        self._key = _content_key(problem, seed)

    def read(self) -> Any:
        """The groups as they were written, or None if there is no sound file."""
        try:
            content = self._path().read_bytes()
        except (OSError, RuntimeError):  # RuntimeError: there is no home folder
            return None
        checksum, _, body = content.partition(b"\n")
        if checksum != self._checksum(body):
            return None
        try:
            return json.loads(body)
        except (ValueError, RecursionError):
            return None

    def write(self, groups: dict[str, Any]) -> str | None:
        """Keep the groups and drop what was kept for older contents; a note for the person if that fails."""
        body = json.dumps(groups, separators=(",", ":")).encode()
        try:
            path = self._path()
            path.parent.mkdir(parents=True, exist_ok=True)
            replace_file(path, self._checksum(body) + b"\n" + body)
            for old in path.parent.glob(f"{self._stem}*.json"):
                if old != path:
                    old.unlink(missing_ok=True)
        except (OSError, RuntimeError) as error:
            reason = getattr(error, "strerror", None) or str(error)
            return (
                f"test data are not kept for the next run ({reason}); set ${_VARIABLE} to a writable folder"
            )
        return None

    def _checksum(self, body: bytes) -> bytes:
        """With the key in it, so that a sound file under another one's name is not taken for its data."""
        return hashlib.sha256(self._key.encode() + body).hexdigest().encode()

    def _path(self) -> Path:
        return cache_folder() / "data" / f"{self._stem}{self._key}.json"


def cache_folder() -> Path:
    """Where built data are kept: $JUDGE_CACHE, or the user's own cache folder."""
    own = os.environ.get(_VARIABLE)
    if own:
        return Path(own)
    from platformdirs import user_cache_path  # only where it is needed: it costs a few ms

    return user_cache_path("circle-line-judge", appauthor=False)


def _content_key(problem: Problem, seed: int | None) -> str:
    """The hash of all that the data are made from."""
    files = [path for pattern in _OWN_FILES for path in sorted(problem.folder.glob(pattern))]
    files += [path for package in _CODE for path in sorted((_PACKAGE / package).rglob("*.py"))]
    total = hashlib.sha256(f"{FORMAT}/{seed}".encode())
    for path in files:
        content = _content(path)
        total.update(f"/{path.name}/{len(content)}/".encode())
        total.update(content)
    return total.hexdigest()[:32]


def _content(path: Path) -> bytes:
    try:
        return path.read_bytes()
    except OSError as error:
        raise ProblemError(
            f"cannot be read: {error.strerror}", where=str(path), remedy="make it readable"
        ) from None
