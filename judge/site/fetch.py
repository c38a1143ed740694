"""What a site has of others: Python for a tab, its libraries, an editor; parts.toml says which.

They are fetched once, from the npm registry and from PyPI, and kept in the cache. Their licences come along.
"""

from __future__ import annotations

import gzip
import hashlib
import io
import shutil
import tarfile
from collections.abc import Callable
from http.client import HTTPException
from pathlib import Path
from urllib.error import URLError
from urllib.request import urlopen

import msgspec
from msgspec import Struct

from judge.errors import JudgeError, UsageError, printable
from judge.files import cache_folder, replace_file

Progress = Callable[[str, int, int], None]  # what is fetched, bytes so far, bytes in all
_PIECE = 1 << 18
_SECONDS = 60  # without a byte


class Part(Struct, frozen=True):
    """A file of others, and what a site takes of it: these `files`, or all of it where there are none."""

    folder: str
    address: str
    sha256: str
    files: tuple[str, ...] = ()

    @property
    def name(self) -> str:
        """The file's own name."""
        return self.address.rpartition("/")[2]

    def is_sound(self, content: bytes) -> bool:
        """Whether these are its bytes."""
        return hashlib.sha256(content).hexdigest() == self.sha256

    def taken(self, content: bytes) -> dict[str, bytes]:
        """Of its bytes what a site takes, by name; a wheel is called by its package alone."""
        if not self.files:
            return {f"{self.name.partition('-')[0]}.whl": content}
        with tarfile.open(fileobj=io.BytesIO(gzip.decompress(content))) as tar:
            members = [(name, tar.extractfile(f"package/{name}")) for name in self.files]
            return {name.partition("/")[2] or name: file.read() for name, file in members if file}


def parts(pyodide: str | None, progress: Progress | None = None) -> Path:
    """A folder with `pyodide/`, `wheels/` and `ace/`, as a site has them.

    `pyodide` is a folder or an address that has Pyodide's files; by default its archive is fetched. Raises
    JudgeError where something cannot be had.
    """
    kept = cache_folder() / "site"
    out = kept / "parts"
    shutil.rmtree(out, ignore_errors=True)
    wanted = (Path(__file__).parent / "parts.toml").read_bytes()
    for part in msgspec.toml.decode(wanted, type=dict[str, tuple[Part, ...]])["parts"]:
        if part.folder == "pyodide" and pyodide is not None:
            files = {name: _given(pyodide, name) for name in part.files if not name.endswith(".md")}
        else:
            files = part.taken(_fetched(part, kept, progress))
        for name, content in files.items():
            path = out / part.folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
    return out


def _given(place: str, name: str) -> bytes:
    """A file of a folder or of an address. Raises UsageError."""
    try:
        if place.startswith(("https://", "http://")):
            with urlopen(f"{place.rstrip('/')}/{name}", timeout=_SECONDS) as answer:
                return bytes(answer.read())
        return (Path(place) / name).read_bytes()
    except (OSError, ValueError, HTTPException) as fault:  # the address is none, or what answers is
        remedy = "name a folder or an address that holds the files of the npm package pyodide"
        what = f"there is no {name}: {_why(fault)}"
        raise UsageError(what, where=f"--pyodide {printable(place)}", remedy=remedy) from None


def _fetched(part: Part, kept: Path, progress: Progress | None) -> bytes:
    """The bytes of a part, from the cache or from its address. Raises JudgeError."""
    path = kept / part.name
    if path.is_file() and part.is_sound(content := path.read_bytes()):
        return content
    found = b""
    try:
        with urlopen(part.address, timeout=_SECONDS) as answer:
            size = int(answer.headers.get("Content-Length") or 0)
            while piece := answer.read(_PIECE):
                found += piece
                if progress:
                    progress(part.name, min(size, len(found)), size)
    except (OSError, HTTPException) as fault:
        remedy = f"fetch {part.address} yourself and put it into {kept}"
        raise JudgeError(f"{part.name} cannot be fetched: {_why(fault)}", remedy=remedy) from None
    if not part.is_sound(found):
        what = f"{part.name} is not what it was when it was pinned"
        raise JudgeError(what, where=part.address, remedy="try again later")
    path.parent.mkdir(parents=True, exist_ok=True)
    replace_file(path, found)
    return found


def _why(fault: Exception) -> str:
    reason = fault.reason if isinstance(fault, URLError) else getattr(fault, "strerror", None) or fault
    return str(getattr(reason, "strerror", None) or reason).lower()
