"""Where compiled programs and what a language costs are kept from run to run, in the cache folder.

    languages/compiled/<key>.bin     names and contents
    languages/idle/<key>.json        CPU and wall seconds and peak bytes of the empty program

What is not as it was written counts as missing, as everywhere in the cache (`judge.kept`), and what cannot be
written is made again.
"""

from __future__ import annotations

import contextlib
import os
from collections.abc import Callable, Sequence
from pathlib import Path

import msgspec

from judge.digest import digest_of
from judge.files import cache_folder
from judge.kept import KeptFile, read_kept, write_kept
from judge.sandbox.boundary import Usage

Files = Sequence[tuple[str, bytes]]

MOST_KEPT = 400  # compiled programs, the newest


class CacheStore:
    """A `judge.sandbox.recipe.Store` in the cache folder."""

    def __init__(self, folder: Callable[[], Path] = cache_folder) -> None:
        """`folder` is asked when it is needed."""
        self._folder = folder

    def artifact(self, key: str) -> Files | None:
        """What was compiled under that key."""
        try:
            path = self._path(key)
            body = read_kept(path, key, self._folder())
            if body is None:
                return None
            found = msgspec.msgpack.decode(body, type=list[tuple[str, bytes]])
            os.utime(path)
        except (OSError, RuntimeError, ValueError):
            return None
        return found

    def keep_artifact(self, key: str, files: Files) -> None:
        """Keep it, and drop those that were not used for longest."""
        body = msgspec.msgpack.encode(list(files))
        with contextlib.suppress(OSError, RuntimeError):
            path = self._path(key)
            write_kept(path, key, body)
            kept = sorted(path.parent.glob("*.bin"), key=lambda each: each.stat().st_mtime)
            for old in kept[:-MOST_KEPT]:
                old.unlink(missing_ok=True)

    def idle(self, key: str) -> Usage | None:
        """What the empty program was found to cost."""
        found = self._idle(key).read(tuple[float, float, int])
        return Usage(*found) if found else None

    def keep_idle(self, key: str, usage: Usage) -> None:
        """Keep that."""
        self._idle(key).write(tuple(usage))

    def _idle(self, key: str) -> KeptFile:
        name = digest_of(key.encode())[:32]
        return KeptFile(self._folder, "languages/idle", f"{name}-", name, "costs of languages")

    def _path(self, key: str) -> Path:
        return self._folder() / "languages" / "compiled" / f"{key}.bin"
