"""What new, verify, export and doctor say: frozen structs, whose field names are the JSON's keys."""

from __future__ import annotations

from msgspec import Struct

from judge.languages.find import Availability
from judge.published import Published
from judge.sandbox.available import Level


class VerifySummary(Struct, frozen=True):
    """What all of it comes to; nothing of it is in the JSON."""

    katas: int
    faults: int
    holes: int | None = None
    published: tuple[()] = ()


class FilesWritten(Published, frozen=True):
    """A kata's data as files of a folder: three for each group."""

    problem: str
    out: str
    cases: int
    files: tuple[str, ...]


class Doctor(Published, frozen=True):
    """What this machine gives; `isolation` is the best level, null where nothing can be run."""

    isolation: str | None
    levels: tuple[Level, ...]
    languages: tuple[Availability, ...]
    judge: str
    python: str
    system: str
    cores: int
    cache: str


class SiteBuilt(Published, frozen=True):
    """What came of a build: katas made now, those that were there, those for the terminal, all bytes."""

    out: str
    made: tuple[str, ...]
    kept: tuple[str, ...]
    elsewhere: tuple[str, ...]
    bytes: int
    opened: bool
