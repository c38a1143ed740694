"""The cache of built data: one file a problem, read whole on a warm start.

    <cache folder>/data/<id>-<place>-<seed>-<key>.json
        {"<group>": [[case, …], [target, …]], …}

`place` stands for the problem's folder, `key` for the content of everything the data are made from. The cache
folder is the user's, or $JUDGE_CACHE.
"""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path

from judge.digest import Digest, digest_of
from judge.errors import ProblemError
from judge.folders import cache_folder
from judge.kept import KeptFile
from judge.problem import Problem
from judge.reading import read_ordinary

FORMAT = 3  # raise it when the form of the file changes

_PACKAGE = Path(__file__).resolve().parent.parent
_CODE = ("exact", "values", "data", "problem", "topics")  # the packages that the data depend on
_OWN_FILES = ("*.toml", "*.md", "*.py")  # of the problem's folder


class DataCache(KeptFile):
    """The cached data of one problem and one seed."""

    def __init__(self, problem: Problem, seed: int | None) -> None:
        super().__init__(cache_folder, "data", kept_stem(problem, seed), data_key(problem, seed))


def kept_stem(problem: Problem, seed: int | None) -> str:
    """With what the name of a file begins that is kept for this problem, in this place and for a seed."""
    place = digest_of(os.fsencode(problem.folder))[:8]
    return f"{problem.id}-{place}-{'own' if seed is None else 'seeded'}-"


def data_key(problem: Problem, seed: int | None) -> str:
    """The hash of all that the data are made from."""
    return content_key(f"{FORMAT}/{seed}", [*own_files(problem), *code_files(_CODE)])


def own_files(problem: Problem) -> list[Path]:
    """The files of the problem's folder that its data are made from, and the pack's own types."""
    own = [path for pattern in _OWN_FILES for path in sorted(problem.folder.glob(pattern))]
    return own + sorted((problem.folder.parent / "types").glob("*.py"))


def code_files(packages: Iterable[str]) -> list[Path]:
    """The source files of the judge's packages of those names."""
    return [path for package in packages for path in _sources(_PACKAGE / package)]


def all_code_files() -> list[Path]:
    """The source files of the judge."""
    return _sources(_PACKAGE)


def _sources(folder: Path) -> list[Path]:
    """The Python files below a folder, in an order of their own: comparing paths takes as long as reading."""
    found: list[str] = []
    for place, _, files in os.walk(folder):
        found += [f"{place}/{name}" for name in files if name.endswith(".py")]
    return [Path(name) for name in sorted(found)]


def content_key(start: str, files: Iterable[Path]) -> str:
    """The hash of `start` and of the files' names and contents. Raises ProblemError."""
    total = Digest(start.encode())
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
