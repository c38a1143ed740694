"""A class's folder: whose file is for which problem.

    STUDENT/PROBLEM.py          a folder for each student; folders within it are theirs too
    PROBLEM/STUDENT.py          where a folder at the top is called like a problem; PROBLEM/STUDENT/any.py too

A file is for the problem that it is called like (`exact_count.py` is for exact-count), or else for the one
whose function it defines. Whatever lies in the folder costs at most its own row.

A student may have set links, so that they are followed to the student's own files alone. A file that has
names in the folders of several students (a hard link) belongs to the one whose folder has the file's owner,
and to nobody where that does not tell.
"""

from __future__ import annotations

import errno
import os
import unicodedata
from collections.abc import Collection, Sequence
from pathlib import Path, PurePath

from msgspec import Struct
from msgspec.structs import replace

from judge.batch.model import Handin
from judge.errors import JudgeError, UsageError
from judge.files import (
    NOT_FOLLOWED,
    RefusedError,
    files_below,
    read_below,
    unreadable,
    why_unreadable,
)
from judge.languages import SUFFIX, is_program, language_of
from judge.problem.find import fitting_problems, id_of, problem_folders, signs

_MOST_BYTES = 2**29  # of all programs together, which are in memory while they are judged
_NOBODY = "it lies in no student's folder"
_BACKSLASH = "its name holds a backslash where folders should be: unpack the archive again, with 'unzip'"
_NO_PROBLEM = "no kata has that name, and it defines no kata's function"


class ClassFolder(Struct, frozen=True):
    """What was found: hand-ins in the order of students, problems and files.

    `unplaced` are other files, and programs without a student or a problem, each with why it is not judged.
    """

    handins: tuple[Handin, ...]
    unplaced: tuple[Handin, ...]


def read_class(
    folder: Path,
    *,
    only: Collection[str] = (),
    folders: Sequence[Path] = (),
    students: Collection[str] = (),
) -> ClassFolder:
    """Everything that is handed in, in a class's folder.

    `only` are ids of problems: without them, all; `folders` are folders of problems to look in first.
    `students` are the known ids: a folder that is called like one of them is a student's in any case.

    Raises:
        UsageError: it is no folder, cannot be read, or holds more than any class.
    """
    root = root_of(folder)
    known = {each.name for each in problem_folders(folders)}
    reader = _Reader(root, known, folders, students)
    handins, unplaced, size = [], [], 0
    for path, why in files_below(root):
        if why or not is_program(path):
            unplaced.append(Handin("", "", legible(path), why=why or "not a program, by its name"))
            continue
        found = reader.handin(path)
        size += len(found.source)
        if size > _MOST_BYTES:
            what = f"the programs come to more than {_MOST_BYTES // 2**20} MB"
            raise UsageError(what, where=str(folder), remedy="judge a part of the class at a time")
        if found.problem and found.student:
            handins += [found] if not only or found.problem in only else []
        else:
            unplaced.append(found)
    handins = reader.without_shared(handins)
    handins.sort(key=lambda each: (each.student, each.problem, each.file))
    return ClassFolder(tuple(handins), tuple(unplaced))


def root_of(folder: Path) -> Path:
    """The folder itself, wherever links lead. Raises UsageError where it is none, or cannot be read."""
    try:
        root = os.path.realpath(folder, strict=True)
        os.scandir(root).close()
    except (OSError, ValueError) as fault:
        raise unreadable(folder, fault, "name the folder that holds the students' folders") from fault
    return Path(root)


def legible(name: str) -> str:
    """A file's name as text, whatever its bytes are; letters that are composed in two ways are the same."""
    return unicodedata.normalize("NFC", os.fsencode(name).decode("utf-8", "backslashreplace"))


class _Name(Struct, frozen=True):
    """A name of a file that has several; `owned` is whether its folder has the file's owner."""

    student: str
    file: str
    owned: bool


class _Reader(Struct):
    """Reads files of one class; `names` are those of files that have several, by device and inode."""

    root: Path
    known: Collection[str]
    folders: Sequence[Path]
    students: Collection[str]
    names: dict[tuple[int, int], list[_Name]] = {}

    def handin(self, path: str) -> Handin:
        """The file, by its path in the class's folder; without a problem or a student where it has none."""
        student, problem = self._placed(PurePath(path))
        source, why = b"", ""
        try:
            source = self._read(path, student)
            if student and not problem:
                problem = self._told(source, path)
        except OSError as fault:
            why = why_unreadable(fault)
        except JudgeError as fault:  # of a problem that is broken, or of this text
            why = str(fault).removeprefix(f"{path}: ")
        if not student:
            why = why or (_BACKSLASH if "\\" in path else _NOBODY)
        return Handin(student, problem, legible(path), b"" if why else source, why)

    def _placed(self, path: PurePath) -> tuple[str, str]:
        """The student and the problem that a path tells, either empty where it does not."""
        top, *rest = path.parts
        named = id_of(_stem(path.name))
        problem = named if named in self.known else ""
        if not rest:
            return "", problem
        if legible(top) in self.students or id_of(top) not in self.known:
            return legible(top), problem
        return legible(rest[0] if len(rest) > 1 else _stem(rest[0])), id_of(top)

    def _told(self, source: bytes, path: str) -> str:
        """The problem that the text tells. Raises JudgeError where it tells none."""
        fitting = [each.id for each in fitting_problems(signs(source, path), self.folders)]
        if len(fitting) != 1:
            raise JudgeError(f"it fits {' and '.join(fitting)}" if fitting else _NO_PROBLEM)
        return fitting[0]

    def _read(self, path: str, student: str) -> bytes:
        """The bytes of a file of that student's, wherever links within their folder lead. Raises OSError."""
        source, real, found = read_below(self.root, path)
        whose = self._placed(PurePath(real))[0]
        if real != path and whose != student:
            where = f"{whose}'s folder" if whose else "a file of nobody"
            raise RefusedError(errno.EXDEV, f"it is a link to {where}, {NOT_FOLLOWED}")
        if found.st_nlink > 1:
            owned = (self.root / real).parent.stat().st_uid == found.st_uid
            name = _Name(student, legible(path), owned=owned)
            self.names.setdefault((found.st_dev, found.st_ino), []).append(name)
        return source

    def without_shared(self, handins: Sequence[Handin]) -> list[Handin]:
        """The hand-ins without the source of a file that has names in the folders of several students.

        It stays with the only one of them whose folder has the file's owner.
        """
        refused: dict[str, str] = {}
        for names in self.names.values():
            owners = {name.student for name in names if name.owned}
            for name in names:
                other = next((each.file for each in names if each.student != name.student), None)
                if other is not None and owners != {name.student}:
                    refused[name.file] = f"it is the same file as {other} (a hard link); copy it"
        return [
            replace(each, source=b"", why=refused[each.file]) if each.file in refused else each
            for each in handins
        ]


def _stem(name: str) -> str:
    """A program's name without what tells its language."""
    language = language_of(name)
    ends = language.suffixes if language else (SUFFIX,)
    return name.removesuffix(next((end for end in ends if name.endswith(end)), ""))
