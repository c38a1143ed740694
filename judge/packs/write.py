"""Writing a package: whole, beside its place, and then put there at once.

Only a package of the same problem is replaced, which its uuid tells; whatever else is there stays. An export
that is killed may leave a folder `.judge-export-*`.
"""

from __future__ import annotations

import os
import zipfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from judge.errors import UsageError, unwritable
from judge.files import replace_file

_REMEDY = "name another folder with --out, or move it away"
_MOST = 65536  # bytes of a problem.yaml that are read


def check_place(place: Path, uuid: str) -> None:
    """Raises UsageError unless nothing is there, or our package of that uuid, as a folder or an archive."""
    if os.path.lexists(place) and (place.is_symlink() or not _says(place, uuid)):
        raise UsageError("it is not a package of this kata", where=str(place), remedy=_REMEDY)


def _says(place: Path, uuid: str) -> bool:
    """Whether the problem.yaml of a package, or of an archive of one, has that uuid."""
    try:
        if place.is_dir():
            with (place / "problem.yaml").open("rb") as file:
                content = file.read(_MOST)
        else:
            with zipfile.ZipFile(place) as archive:
                (name,) = [each for each in archive.namelist() if Path(each).name == "problem.yaml"]
                with archive.open(name) as file:
                    content = file.read(_MOST)
    except (OSError, zipfile.BadZipFile, RuntimeError, ValueError):  # that there is not one of that name, too
        return False
    return f"uuid: {uuid}".encode() in content.splitlines()


def write_folder(place: Path, files: Mapping[str, bytes]) -> None:
    """Put a package there; one that is there is replaced as a whole. Raises UsageError."""
    with (
        _written(place),
        TemporaryDirectory(prefix=".judge-export-", dir=place.parent, ignore_cleanup_errors=True) as scratch,
    ):
        new, old = Path(scratch, "new"), Path(scratch, "old")
        for path, content in files.items():
            target = new / path
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(content)
        if os.path.lexists(place):
            place.rename(old)
        try:
            new.rename(place)
        except BaseException:
            if old.exists():
                old.rename(place)
            raise


def write_archive(place: Path, content: bytes) -> None:
    """Put an archive there. Raises UsageError."""
    with _written(place):
        replace_file(place, content)


@contextmanager
def _written(place: Path) -> Iterator[None]:
    """Its folder is made first; what fails is a UsageError."""
    try:
        place.parent.mkdir(parents=True, exist_ok=True)
        yield
    except OSError as fault:
        raise unwritable(place, fault, _REMEDY) from fault
