"""A class's folder: whose file is for which problem.

    STUDENT/PROBLEM.py          a folder for each student; folders within it are theirs too
    PROBLEM/STUDENT.py          where a folder at the top is called like a problem; PROBLEM/STUDENT/any.py too

A file is for the problem that it is called like (`exact_count.py` is for exact-count), or else for the one
whose function it defines. What a learning platform hands out is taken as it is (judge.batch.platforms); a
list of the students tells who is meant by a name. Zips and notebooks are opened, and a name that an editor
spoilt is put right.
Whatever lies in the folder costs at most its own row.

A student may have set links, so that they are followed to the student's own files alone. A file that has
names in the folders of several students (a hard link) belongs to the one whose folder has the file's owner,
and to nobody where that does not tell.
"""

from __future__ import annotations

import errno
import io
import json
import os
import stat
import unicodedata
import zipfile
from collections import defaultdict
from collections.abc import Collection, Iterator, Sequence
from contextlib import suppress
from itertools import chain
from pathlib import Path, PurePath

from msgspec import Struct
from msgspec.structs import replace

from judge.batch.model import Submission
from judge.batch.platforms import METADATA, Owner, Roster, owners, submitters
from judge.errors import JudgeError, UsageError
from judge.files import NOT_FOLLOWED, RefusedError, files_below, read_below, unreadable, why_unreadable
from judge.languages import SUFFIX, is_program, language_of
from judge.problem.find import fitting_problems, id_of, problem_folders, signs

_MOST_BYTES = 2**29  # of all programs together, which are in memory while they are judged
_ZIP, _NOTEBOOK, _TEXT = ".zip", ".ipynb", ".txt"
_MOST_FILES, _LARGEST = 100, 2 << 20  # of a zip: files, and bytes of all of them
_MAGIC = ("%", "!")  # lines of a notebook that are no Python
_NOBODY = "it lies in no student's folder"
_BACKSLASH = "its name holds a backslash where folders should be: unpack the archive again, with 'unzip'"
_NO_PROBLEM = "no kata has that name, and it defines no kata's function"


class ClassFolder(Struct, frozen=True):
    """What was found: submissions in the order of students, problems and files.

    `unplaced` are other files, and programs without a student or a problem, each with why it is not judged;
    `late` are students whose files the platform calls late.
    """

    submissions: tuple[Submission, ...]
    unplaced: tuple[Submission, ...]
    late: frozenset[str] = frozenset()


def read_class(
    folder: Path, *, only: Collection[str] = (), folders: Sequence[Path] = (), roster: Roster | None = None
) -> ClassFolder:
    """Everything that is submitted, in a class's folder.

    `only` are ids of problems: without them, all; `folders` are folders of problems to look in first.
    A folder that is called after somebody of the `roster` is theirs in any case.

    Raises:
        UsageError: it is no folder, cannot be read, or holds more than any class.
    """
    root = root_of(folder)
    every = list(files_below(root))
    reader = _Reader(root, folders, roster or Roster(), [PurePath(path) for path, _ in every])
    placed, unplaced, size = list[Submission](), list[Submission](), 0
    for path, why in every:
        if PurePath(path).name == METADATA or reader.is_receipt(PurePath(path)):
            continue
        group = [who for who, _ in reader.group(PurePath(path)) if who]
        for found in reader.submissions(path, why):
            size += len(found.source)
            if size > _MOST_BYTES:
                what = f"the programs come to more than {_MOST_BYTES // 2**20} MB"
                raise UsageError(what, where=str(folder), remedy="judge a part of the class at a time")
            whole = found.problem and found.student
            if not whole or not only or found.problem in only:
                # The same file for each student of the group that has submitted it.
                shared = [replace(found, student=who) for who in dict.fromkeys(group)]
                (placed if whole else unplaced).extend(shared or [found])
    placed = sorted(reader.without_shared(placed), key=lambda each: (each.student, each.problem, each.file))
    late = frozenset(who for group in reader.owners.values() for who, owner in group if owner.late)
    return ClassFolder(tuple(placed), tuple(unplaced), late)


def root_of(folder: Path) -> Path:
    """The folder itself, wherever links lead. Raises UsageError where it is none, or cannot be read."""
    try:
        root = os.path.realpath(folder, strict=True)
        os.scandir(root).close()
    except (OSError, ValueError) as fault:
        raise unreadable(folder, fault, "name the folder that holds the students' folders") from fault
    return Path(root)


def display_name(name: str) -> str:
    """A file's name as text, whatever its bytes are; letters that are composed in two ways are the same."""
    return unicodedata.normalize("NFC", os.fsencode(name).decode("utf-8", "backslashreplace"))


class _Reader:
    """Reads files of one class, which lie at these paths in its folder `root`."""

    def __init__(
        self, root: Path, folders: Sequence[Path], roster: Roster, paths: Sequence[PurePath]
    ) -> None:
        self.root, self.folders, self.roster = root, folders, roster
        self.known = {each.name for each in problem_folders(folders)}
        # Of files that have several names, by device and inode: the student and the name, and whether the
        # folder that it is in has the file's owner.
        self.names = defaultdict[tuple[int, int], list[tuple[str, str, bool]]](list)
        self.outer = 0  # folders around all of them
        metadata = next((path for path in paths if path.name == METADATA), None)
        if metadata:
            self.outer = len(metadata.parts) - 1
            found = submitters(read_below(root, str(metadata))[0].decode("utf-8", "replace"))
        else:
            tops = {path.parts[0] for path in paths}
            found = owners(tops)
            if not found and len(tops) == 1 and all(len(path.parts) > 1 for path in paths):
                found = owners({path.parts[1] for path in paths})
                self.outer = 1 if found else 0
        keys = defaultdict[str, set[str]](set)
        for each in chain(*found.values()):
            keys[each.name].add(each.key)
        # Of names in the outermost folder: the students, and what it tells of each.
        self.owners = {
            name: [
                (roster.owner(each) or display_name(each.called(len(keys[each.name]))), each)
                for each in group
            ]
            for name, group in found.items()
        }

    def group(self, path: PurePath) -> list[tuple[str, Owner]]:
        """The students whom a platform's name tells, and what else it tells."""
        return self.owners.get((path.parts[self.outer :] or path.parts)[0], [])

    def is_receipt(self, path: PurePath) -> bool:
        """Whether it is Blackboard's text about files beside it; alone it may hold what was submitted."""
        own = any(owner.at and not owner.file for _, owner in self.group(path)) and path.suffix == _TEXT
        return own and any(name.startswith(f"{path.stem}_") for name in self.owners)

    def submissions(self, path: str, why: str) -> Iterator[Submission]:
        """What a file holds, by its path in the class's folder; without a student or a problem where it has
        none. With a `why` it is a folder that is not entered.
        """
        inside = list[tuple[str, bytes | OSError | JudgeError]]()
        try:
            if why:
                raise JudgeError(why)
            if not is_program(path) and not _is_packed(path):
                raise JudgeError("not a program, by its name")
            source = self._read(path, self._placed(PurePath(path))[0])
            inside += [(path, source)] if is_program(path) else _unpacked(path, source)
        except (OSError, JudgeError) as fault:
            inside.append((path, fault))
        for name, found in inside:
            yield self._submission(path, name, found)

    def _submission(self, path: str, name: str, source: bytes | OSError | JudgeError) -> Submission:
        """A program of that name in the file: its bytes, or why it is not read."""
        student, problem = self._placed(PurePath(path), PurePath(name).name if name != path else "")
        problem, why = problem if is_program(name) else "", ""
        try:
            if not isinstance(source, bytes):
                raise source
            if not student:
                raise JudgeError(_BACKSLASH if "\\" in path else _NOBODY)
            problem = problem or self._fitting(source, name)
        except (OSError, JudgeError) as fault:  # of a problem that is broken, or of this text, too
            why, source = _told(fault).removeprefix(f"{name}: "), b""
        at = next((owner.at for _, owner in self.group(PurePath(path))), 0.0)
        with suppress(OSError, ValueError):
            at = at or (self.root / path).stat().st_mtime
        return Submission(student, problem, display_name(name), source, why, at)

    def _placed(self, path: PurePath, inner: str = "") -> tuple[str, str]:
        """The student and the problem that a path tells, either empty where it does not.

        `inner` is the name of what lies in the file itself.
        """
        top, *rest = path.parts[self.outer :] or path.parts
        who, owner = next(iter(self.group(path)), ("", None))
        named = id_of(_stem(inner or (owner.file if owner and owner.file and not rest else path.name)))
        problem = named if named in self.known else ""
        if owner or not rest:
            return who, problem
        name, listed = display_name(top), self.roster.named(display_name(top))
        if listed or id_of(top) not in self.known:
            return listed or name, problem
        own = display_name(rest[0] if len(rest) > 1 else _stem(rest[0]))
        return self.roster.named(own) or own, id_of(top)

    def _fitting(self, source: bytes, name: str) -> str:
        """The problem that the text of a file of that name tells. Raises JudgeError where it tells none."""
        fitting = [each.id for each in fitting_problems(signs(source, name), self.folders)]
        if len(fitting) != 1:
            raise JudgeError(f"it fits {' and '.join(fitting)}" if fitting else _NO_PROBLEM)
        return fitting[0]

    def _read(self, path: str, student: str) -> bytes:
        """The bytes of a file of that student's, wherever links within their folder lead. Raises OSError."""
        source, real, found = read_below(self.root, path)
        whose = self._placed(PurePath(real))[0]
        if real != path and whose != student:
            where = "another student's folder" if whose else "a file of nobody"
            raise RefusedError(errno.EXDEV, f"it is a link to {where}, {NOT_FOLLOWED}")
        if found.st_nlink > 1:
            owned = (self.root / real).parent.stat().st_uid == found.st_uid
            self.names[found.st_dev, found.st_ino].append((student, display_name(path), owned))
        return source

    def without_shared(self, submissions: Sequence[Submission]) -> list[Submission]:
        """The submissions without the source of a file that has names in the folders of several students.

        It stays with the only one of them whose folder has the file's owner.
        """
        refused: dict[str, str] = {}
        for names in self.names.values():
            owners = {student for student, _, owned in names if owned}
            for student, file, _ in names:
                if owners != {student} and any(other != student for other, *_ in names):
                    refused[file] = "it is the same file as another student's (a hard link); copy it"
        return [
            replace(each, source=b"", why=refused[each.file]) if each.file in refused else each
            for each in submissions
        ]


def _stem(name: str) -> str:
    """A program's name without what tells its language."""
    language = language_of(name)
    ends = language.suffixes if language else (SUFFIX,)
    return name.removesuffix(next((end for end in ends if name.endswith(end)), ""))


def _told(fault: OSError | JudgeError) -> str:
    return why_unreadable(fault) if isinstance(fault, OSError) else str(fault)


# -- programs inside of something else ---------------------------------------------------------------------


def _is_packed(name: str) -> bool:
    """Whether a file of that name holds programs under other names."""
    path = PurePath(name)
    ends = path.suffix.lower()
    return ends in (_ZIP, _NOTEBOOK, SUFFIX) or (ends == _TEXT and is_program(path.stem))


def _unpacked(name: str, content: bytes) -> Iterator[tuple[str, bytes]]:
    """The programs in it, each by its name. Raises JudgeError, which says why there is none."""
    path = PurePath(name)
    ends = path.suffix.lower()
    if ends == _ZIP:
        yield from _zipped(name, content)
    else:  # of a text the second ending stays
        whole = _cells(content) if ends == _NOTEBOOK else content
        yield str(path.with_suffix("" if ends == _TEXT else SUFFIX)), whole


def _zipped(name: str, content: bytes) -> Iterator[tuple[str, bytes]]:
    try:
        archive = zipfile.ZipFile(io.BytesIO(content))
        files = [each for each in archive.infolist() if not each.is_dir()]
        if len(files) > _MOST_FILES:
            raise JudgeError(f"{len(files)} files are more than {_MOST_FILES}")
        if (size := sum(each.file_size for each in files)) > _LARGEST:
            raise JudgeError(f"{size >> 20} MB is more than {_LARGEST >> 20} MB")
        programs = [each for each in files if is_program(each.filename) and not _is_link(each)]
        if not programs:
            raise JudgeError("no program is in this zip")
        for each in programs:
            with archive.open(each) as file:
                yield f"{name}/{each.filename}", file.read(_LARGEST)
    except (zipfile.BadZipFile, NotImplementedError, RuntimeError, EOFError, ValueError, OSError) as fault:
        raise JudgeError(f"this zip cannot be opened ({fault})") from fault


def _is_link(each: zipfile.ZipInfo) -> bool:
    return stat.S_ISLNK(each.external_attr >> 16)


def _cells(content: bytes) -> bytes:
    """The code cells of a notebook, one after the other."""
    try:
        cells = [each for each in json.loads(content)["cells"] if each["cell_type"] == "code"]
        texts = ["".join(each["source"]) for each in cells]
    except (ValueError, TypeError, KeyError, RecursionError) as fault:
        raise JudgeError("this notebook cannot be read") from fault
    rows = (row for text in texts for row in (*text.splitlines(), ""))
    return "\n".join(row for row in rows if not row.startswith(_MAGIC)).encode("utf-8", "backslashreplace")
