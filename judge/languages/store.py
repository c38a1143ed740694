"""Where compiled programs and what a language costs are kept from run to run (`judge.cache`).

languages/compiled/<key>     names and contents
languages/idle/<key>         CPU and wall seconds and peak bytes of the empty program
"""

from __future__ import annotations

import contextlib
import os
from collections.abc import Sequence

import msgspec

from judge.cache import DISK, CacheFolder, digest
from judge.sandbox.boundary import Usage

Files = Sequence[tuple[str, bytes]]

MOST_KEPT = 400  # compiled programs, the newest


class CacheStore:
    """A `judge.sandbox.recipe.Store` in a folder of the cache."""

    def __init__(self, folder: CacheFolder = DISK) -> None:
        self._folder = folder

    def artifact(self, key: str) -> Files | None:
        """What was compiled under that key."""
        name = f"languages/compiled/{key}"
        body = self._folder.read(name, key, bytes)
        if body is None:
            return None
        try:
            found = msgspec.msgpack.decode(body, type=list[tuple[str, bytes]])
            os.utime(self._folder.path(name))
        except (OSError, ValueError):
            return None
        return found

    def keep_artifact(self, key: str, files: Files) -> None:
        """Keep it, and drop those that were not used for longest."""
        name = f"languages/compiled/{key}"
        if self._folder.write(name, key, msgspec.msgpack.encode(list(files))) is None:
            with contextlib.suppress(OSError):
                every = self._folder.path(name).parent.glob("[!.]*")
                for old in sorted(every, key=lambda each: each.stat().st_mtime)[:-MOST_KEPT]:
                    old.unlink(missing_ok=True)

    def idle(self, key: str) -> Usage | None:
        """What the empty program was found to cost."""
        return self._folder.read(f"languages/idle/{digest(key.encode())[:32]}", key, Usage)

    def keep_idle(self, key: str, usage: Usage) -> None:
        """Keep that."""
        self._folder.write(f"languages/idle/{digest(key.encode())[:32]}", key, usage)
