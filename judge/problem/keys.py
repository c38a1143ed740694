"""Keys of the cache: hashes of all that a problem, or its data, is made from."""

from __future__ import annotations

import os
from collections.abc import Iterable
from functools import cache
from pathlib import Path

from judge.digest import Digest
from judge.errors import ProblemError
from judge.files import read_ordinary

_PACKAGE = Path(__file__).resolve().parent.parent
_OWN_FILES = ("*.toml", "*.md", "*.py")  # of the problem's folder


def own_files(folder: Path) -> list[Path]:
    """The files of a problem's folder that it and its data are made from, and the pack's own types."""
    own = [path for pattern in _OWN_FILES for path in sorted(folder.glob(pattern))]
    return own + sorted((folder.parent / "types").glob("*.py"))


@cache
def code_key(packages: tuple[str, ...]) -> str:
    """The hash of the source files of the judge's packages of those names; made once a process."""
    return content_key("code", [path for package in packages for path in _sources(_PACKAGE / package)])


def all_code_files() -> list[Path]:
    """The source files of the judge."""
    return _sources(_PACKAGE)


def _sources(folder: Path) -> list[Path]:
    """The Python files below a folder, in an order of their own: comparing paths takes as long as reading."""
    found: list[str] = []
    for place, _, files in os.walk(folder):
        found += [f"{place}/{name}" for name in files if name.endswith(".py")]
    return [Path(name) for name in sorted(found)]


def content_key(start: str, files: Iterable[Path], more: str = "") -> str:
    """The hash of `start`, of the files' names and contents, and of `more`. Raises ProblemError."""
    total = Digest(f"{start}/{more}".encode())
    for path in files:
        content = _content(path)
        total.update(f"/{path.name}/{len(content)}/".encode())
        total.update(content)
    return total.hex()[:32]


def _content(path: Path) -> bytes:
    try:
        return read_ordinary(path)
    except OSError as error:
        raise ProblemError(
            f"cannot be read: {error.strerror}", where=str(path), remedy="make it readable"
        ) from None
