"""What the sandbox is told of a language: plain command lines, and which files of this machine they need.

Command lines hold places in braces, which are filled in once it is known where a thing lies inside.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple, Protocol

from judge.sandbox.boundary import SourceFault, Usage

Files = Sequence[tuple[str, bytes]]  # by name, which may have folders in it


class Recipe(NamedTuple):
    """How a language is compiled and run; `key` changes with its description and its tools.

    `empty` is a program that does nothing, by its file's name; `stack`, `allowance` are bytes, `stack` 0 for
    as much as the memory limit. `complaint` and `warning` are patterns of what a compiler says; with
    one of `checks` at their ends its command lines make a program that says what it does wrong, in the
    forms of `finds`.
    """

    name: str
    key: str
    steps: tuple[tuple[str, ...], ...]
    compile_reads: tuple[str, ...]
    compile_runs: tuple[str, ...]
    compile_environment: Mapping[str, str]
    keeps: bool  # whether the sources themselves are run
    command: tuple[str, ...]
    reads: tuple[str, ...]
    runs: tuple[str, ...]
    environment: Mapping[str, str]
    stack: int
    allowance: int
    out_of_memory: str
    empty: tuple[str, bytes]
    complaint: str = ""
    warning: str = ""
    checks: tuple[tuple[str, ...], ...] = ()
    finds: tuple[str, ...] = ()
    help: Files = ()  # files for the compiler, that no program is made of


class Sources(NamedTuple):
    """The files that one submission is compiled from, the one with the program's start first.

    `own` is the submission's own file. Where it has a function to be called, `entry` is that function's name
    in the problem, `line` its line; the start is then a driver, and `mismatch` is what is to be said where
    the compiler finds the fault in that. A `fault` is one that is seen without any compiler; a function is
    `empty` as long as nothing is written in it.
    """

    files: Files
    own: str
    entry: str = ""
    line: int = 0
    mismatch: str = ""
    fault: SourceFault | None = None
    empty: bool = False

    @property
    def main(self) -> str:
        """The file with the program's start."""
        return self.files[0][0]


class ArtifactStore(Protocol):
    """Where artifacts and what was measured are kept; whatever cannot be kept is made again."""

    def artifact(self, key: str) -> Files | None:
        """What was compiled under that key."""

    def keep_artifact(self, key: str, files: Files) -> None:
        """Keep it."""

    def idle(self, key: str) -> Usage | None:
        """What the empty program was found to cost."""

    def keep_idle(self, key: str, usage: Usage) -> None:
        """Keep that."""


def filled(words: Sequence[str], places: Mapping[str, str], sources: Sequence[str] = ()) -> list[str]:
    """The words with the places in them filled in; `{sources}` alone becomes several."""
    found: list[str] = []
    for word in words:
        if word == "{sources}":
            found += sources
            continue
        for name, place in places.items():
            word = word.replace(f"{{{name}}}", place)
        found.append(word)
    return found


def written(folder: Path, files: Files) -> None:
    """Put the files into a new folder that others may read and start programs from."""
    folder.mkdir(mode=0o755)
    folder.chmod(0o755)
    for name, content in files:
        path = folder / name
        for parent in reversed(path.relative_to(folder).parents[:-1]):
            (folder / parent).mkdir(mode=0o755, exist_ok=True)
        path.write_bytes(content)
        path.chmod(0o755)
