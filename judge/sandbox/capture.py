"""Nameless files that a contained process writes into and the judge reads."""

from __future__ import annotations

import os
import tempfile


class Capture:
    """An open file without a name, shared with a child by its descriptor.

    The child's descriptor is the same open file, offset included, so `clear` rewinds both sides at once.
    """

    def __init__(self, content: bytes = b"") -> None:
        self.fd = _nameless()
        if content:
            view = memoryview(content)
            while view:
                view = view[os.write(self.fd, view) :]
            os.lseek(self.fd, 0, os.SEEK_SET)

    def size(self) -> int:
        """Bytes in the file now."""
        return os.fstat(self.fd).st_size

    def head(self, limit: int) -> bytes:
        """The first bytes, at most `limit`."""
        parts: list[bytes] = []
        offset = 0
        while offset < limit:
            part = os.pread(self.fd, min(limit - offset, 1 << 20), offset)
            if not part:
                break
            parts.append(part)
            offset += len(part)
        return b"".join(parts)

    def tail(self, limit: int) -> bytes:
        """The last bytes, at most `limit`."""
        return os.pread(self.fd, limit, max(0, self.size() - limit))

    def clear(self) -> None:
        """Empty the file and rewind it, for the child too."""
        os.ftruncate(self.fd, 0)
        os.lseek(self.fd, 0, os.SEEK_SET)

    def close(self) -> None:
        """Give the descriptor back; a second call does nothing."""
        if self.fd >= 0:
            os.close(self.fd)
            self.fd = -1


def _nameless() -> int:
    if hasattr(os, "memfd_create"):
        return os.memfd_create("judge", os.MFD_CLOEXEC)
    fd, path = tempfile.mkstemp(prefix="judge-")
    os.unlink(path)  # noqa: PTH108 - pathlib is not needed otherwise, and imports slowly
    return fd
