"""A package as a folder of files, whether it is one or a zip file; nothing in it leads out of it.

A zip file is written into a folder of its own, file by file, within bounds that hold for what is really
written and not for what the archive says. Links are refused in an archive, in a folder those that leave it.
"""

from __future__ import annotations

import errno
import os
import stat
import struct
import zipfile
import zlib
from collections.abc import Iterator
from pathlib import Path, PurePosixPath
from typing import IO

from judge.errors import ProblemError, UsageError, unwritable
from judge.packs.foreign.look import DESCRIPTION, ENDINGS
from judge.reading import LedOutError, read_inside, real_within
from judge.sandbox.temporary import TemporaryFolder

MOST_FILES = 20_000
_DEEPEST = 16  # folders below the package's own
_LARGEST = 256 << 20  # bytes of one file
_MOST_BYTES = 1 << 30  # of all files of an archive
_ARCHIVE = 512 << 20
_DIRECTORY = 8 << 20  # of the archive's list of files
_AT_ONCE = 1 << 20
_METHODS = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)
_DAMAGES = (zipfile.BadZipFile, zlib.error, struct.error, EOFError)
_ENCRYPTED = 1  # of an entry's flags
_END, _END_AT, _ZIP64 = b"PK\x05\x06", 22, b"PK\x06\x07"


class Opened:
    """A context manager; `root` is the package's folder, `name` what the package is called.

    Raises:
        UsageError: it cannot be read, or is no package.
        ProblemError: there is something in the archive that has no place in a package.
    """

    def __init__(self, word: str) -> None:
        self.word = word
        self.described = 0  # bytes of YAML that were read
        self._folder: TemporaryFolder | None = None
        place = Path(word)
        if not word.endswith(ENDINGS) or place.is_dir():
            self.root = place.resolve()
            self.name = self.root.name
            return
        self._folder = _temporary(word)
        try:
            self.root = _unpacked(word, self._folder.path / "package")
        except BaseException:
            self._folder.close()
            raise
        self.name = self.root.name if self.root.name != "package" else place.stem

    def __enter__(self) -> Opened:
        return self

    def __exit__(self, *exc: object) -> None:
        if self._folder is not None:
            self._folder.close()

    def name_of(self, path: Path) -> str:
        """A file of the package as a person is told of it: from the package's folder on."""
        return path.relative_to(self.root).as_posix() if path.is_relative_to(self.root) else str(path)

    def entries(self, *parts: str) -> list[Path]:
        """What lies in a folder of the package, in order of name, hidden files left out; none without it."""
        folder = self.root.joinpath(*parts)
        self.check(folder)
        try:
            if not folder.is_dir():
                return []
            if not os.access(folder, os.X_OK):  # its names can be read, and nothing of what lies there
                raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
            return sorted(path for path in folder.iterdir() if not path.name.startswith("."))
        except OSError as fault:
            what = f"this folder cannot be read ({(fault.strerror or str(fault)).lower()})"
            raise ProblemError(what, where=self.name_of(folder)) from None

    def walk(self, folder: Path) -> Iterator[Path]:
        """Every file below a folder of the package, folder by folder, in order of name.

        Raises ProblemError for a link that leaves the package, and for more files than anybody has.
        """
        for count, path in enumerate(self._walk(folder, 0)):
            if count == MOST_FILES:
                raise ProblemError(f"there are more than {MOST_FILES:,} files", where=self.name_of(folder))
            yield path

    def _walk(self, folder: Path, depth: int) -> Iterator[Path]:
        if depth > _DEEPEST:
            raise ProblemError(f"its folders lie more than {_DEEPEST} deep", where=self.name_of(folder))
        for path in self.entries(*folder.relative_to(self.root).parts):
            self.check(path)
            if path.is_dir():
                yield from self._walk(path, depth + 1)
            else:
                yield path

    def check(self, path: Path) -> None:
        """Raise ProblemError where that path leads out of the package."""
        try:
            inside = path.resolve().is_relative_to(self.root)
        except (OSError, RuntimeError):  # a link to itself
            inside = False
        if not inside:
            raise self._led_out(path)

    def size(self, path: Path) -> int:
        """A file's length in bytes. Raises ProblemError where it cannot be looked at."""
        try:
            return path.stat().st_size
        except OSError as fault:
            raise self._unreadable(path, fault) from None

    def read(self, path: Path, most: int = _LARGEST) -> bytes:
        """A file's content. Raises ProblemError where it is larger, leads out, or cannot be read."""
        root = str(self.root)
        try:
            content, _ = read_inside(root, real_within(root, os.path.relpath(path, root)), most + 1)
        except LedOutError:
            raise self._led_out(path) from None
        except (OSError, ValueError) as fault:
            raise self._unreadable(path, fault) from None
        if len(content) > most:
            size = f"{most >> 20} MB" if most >> 20 else f"{most >> 10} KB"
            raise ProblemError(f"it is larger than {size}", where=self.name_of(path))
        return content

    def _led_out(self, path: Path) -> ProblemError:
        return ProblemError("this link leads out of the package", where=self.name_of(path))

    def _unreadable(self, path: Path, fault: OSError | ValueError) -> ProblemError:
        reason = (getattr(fault, "strerror", None) or str(fault)).lower()
        return ProblemError(f"it cannot be read ({reason})", where=self.name_of(path))


def _temporary(word: str) -> TemporaryFolder:
    try:
        return TemporaryFolder()
    except OSError as fault:
        raise unwritable(Path(word), fault) from fault


def _unpacked(word: str, folder: Path) -> Path:
    """The package's own folder, in that new one."""
    folder.mkdir()
    try:
        with open(word, "rb", opener=_unwaiting) as file:
            found = os.fstat(file.fileno())
            if not stat.S_ISREG(found.st_mode):
                remedy = f"name a zip file, or a folder with a {DESCRIPTION}"
                raise UsageError("this is no ordinary file", where=word, remedy=remedy)
            if found.st_size > _ARCHIVE:
                raise ProblemError(f"it is larger than {_ARCHIVE >> 20} MB", where=word)
            _check_directory(file, found.st_size, word)
            with zipfile.ZipFile(file) as archive:
                _write_all(archive, folder, word)
    except _DAMAGES:
        raise _unreadable("it is damaged", word) from None
    except RuntimeError:
        raise _unreadable("it is packed in an unusual way", word) from None
    except ValueError:
        raise _unreadable("a name in it is no text", word) from None
    except OSError as fault:
        if fault.errno == errno.EINVAL:  # it says that something lies before its beginning
            raise _unreadable("it is damaged", word) from None
        what = f"it cannot be unpacked ({(fault.strerror or str(fault)).lower()})"
        raise UsageError(what, where=word) from None
    homes = [path.parent for path in (folder / DESCRIPTION, *sorted(folder.glob(f"*/{DESCRIPTION}")))]
    homes = [home for home in homes if (home / DESCRIPTION).is_file()]
    if len(homes) != 1:
        what = f"there is no {DESCRIPTION} in it" if not homes else "there are several packages in it"
        raise ProblemError(what, where=word)
    return homes[0].resolve()


def _unwaiting(path: str, flags: int) -> int:
    """Opened without waiting for who may never write into it."""
    return os.open(path, flags | os.O_NONBLOCK | os.O_NOCTTY)


def _unreadable(why: str, word: str) -> ProblemError:
    remedy = "pack it anew, as zip does without options"
    return ProblemError(f"this is no zip file that can be read: {why}", where=word, remedy=remedy)


def _check_directory(file: IO[bytes], size: int, word: str) -> None:
    """Raise ProblemError where the list of files alone would fill the memory."""
    file.seek(max(0, size - (1 << 16) - _END_AT))
    tail = file.read()
    place = tail.rfind(_END)
    if place < 0 or len(tail) < place + _END_AT:
        raise ProblemError("this is no zip file", where=word)
    count, length = struct.unpack_from("<HI", tail, place + 10)
    if length > _DIRECTORY or count > MOST_FILES or _ZIP64 in tail:
        raise ProblemError(f"there are more than {MOST_FILES:,} files in it", where=word)
    file.seek(0)


def _write_all(archive: zipfile.ZipFile, folder: Path, word: str) -> None:
    left = _MOST_BYTES
    if len(archive.infolist()) > MOST_FILES:
        raise ProblemError(f"there are more than {MOST_FILES:,} files in it", where=word)
    for member in archive.infolist():
        path = _place(member, folder, word)
        if member.compress_type not in _METHODS:  # which few tools write, and whose readers are less proven
            remedy = "pack it anew, as zip does without options"
            raise ProblemError(f"{_shown(member)} is packed in an unusual way", where=word, remedy=remedy)
        if member.flag_bits & _ENCRYPTED:
            raise ProblemError(
                f"{_shown(member)} is encrypted", where=word, remedy="pack it without a password"
            )
        if member.is_dir():
            path.mkdir(parents=True, exist_ok=True)
            continue
        path.parent.mkdir(parents=True, exist_ok=True)
        if path.exists():
            raise ProblemError(f"{_shown(member)} is in it twice", where=word)
        with archive.open(member) as source, path.open("xb") as target:
            most = min(left, _LARGEST)
            left -= _copied(source, target, most)
        if left < 0 or path.stat().st_size > _LARGEST:
            what = (
                f"unpacked it is larger than {_MOST_BYTES >> 20} MB, or a file of it than {_LARGEST >> 20} MB"
            )
            raise ProblemError(what, where=word)
        path.chmod(0o755 if member.external_attr >> 16 & 0o111 else 0o644)


def _copied(source: IO[bytes], target: IO[bytes], most: int) -> int:
    """Copy what there is, at most a block over `most`; how much it was."""
    written = 0
    while written <= most and (part := source.read(_AT_ONCE)):
        target.write(part)
        written += len(part)
    return written


def _place(member: zipfile.ZipInfo, folder: Path, word: str) -> Path:
    """Where a member goes. Raises ProblemError for a name that leads elsewhere, and for a link."""
    name = member.filename
    parts = PurePosixPath(name).parts
    odd = (
        not parts or name.startswith("/") or ".." in parts or "\\" in name or "\0" in name or ":" in parts[0]
    )
    if odd or len(parts) > _DEEPEST + 2 or max(len(os.fsencode(part)) for part in parts) > 255:
        raise ProblemError(f"{_shown(member)} is no name of a file in a package", where=word)
    kind = stat.S_IFMT(member.external_attr >> 16)
    if kind and not stat.S_ISREG(kind) and not stat.S_ISDIR(kind):
        raise ProblemError(f"{_shown(member)} is a link or no ordinary file", where=word)
    return folder.joinpath(*parts)


def _shown(member: zipfile.ZipInfo) -> str:
    return ascii(member.filename)[:80]
