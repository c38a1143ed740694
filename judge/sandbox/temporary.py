"""Folders for what is compiled and run; a killed judge's go when the next one makes its own.

<temporary folder>/judge-box-<random>     locked as long as its judge lives
"""

from __future__ import annotations

import contextlib
import fcntl
import os
import stat
import tempfile
import time
from pathlib import Path

from judge.sandbox.inside import clear

_PREFIX = "judge-box-"
_OLD = 60.0  # seconds; one that was made just now may not be locked yet


class TemporaryFolder:
    """A context manager: a new folder that others may pass through, for a user that a container becomes."""

    def __init__(self) -> None:
        """Make it. Raises OSError."""
        sweep(Path(tempfile.gettempdir()))
        self.path = Path(tempfile.mkdtemp(prefix=_PREFIX))
        self.path.chmod(0o711)
        self._lock = os.open(self.path, clear.AS_A_FOLDER)
        with contextlib.suppress(OSError):  # a file system without locks: its age protects it
            fcntl.flock(self._lock, fcntl.LOCK_EX | fcntl.LOCK_NB)

    def __enter__(self) -> Path:
        return self.path

    def __exit__(self, *exc: object) -> None:
        self.close()

    def close(self) -> None:
        """Take it away, with all that is in it. Safe to call twice."""
        if self._lock >= 0:
            _remove(str(self.path))
            os.close(self._lock)
            self._lock = -1


def sweep(folder: Path) -> None:
    """Take away what judges of this user left there that are dead; silently, and following no link."""
    with contextlib.suppress(OSError), os.scandir(folder) as entries:
        for entry in entries:
            if entry.name.startswith(_PREFIX):
                _take_away(entry.path)


def _remove(path: str) -> None:
    """Take it away with all that is in it, as far as that goes."""
    with contextlib.suppress(OSError):
        clear.empty(path)
        Path(path).rmdir()


def _take_away(path: str) -> None:
    with contextlib.suppress(OSError):  # it is gone, in use, or no business of ours
        descriptor = os.open(path, clear.AS_A_FOLDER)
        try:
            found = os.fstat(descriptor)
            ours = stat.S_ISDIR(found.st_mode) and found.st_uid == os.geteuid()
            if ours and time.time() - found.st_mtime > _OLD:
                fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)  # refused while its judge lives
                _remove(path)
        finally:
            os.close(descriptor)
