"""A class's folder: whose file is for which problem.

    STUDENT/PROBLEM.py          a folder for each student; folders within it are theirs too
    PROBLEM/STUDENT.py          where a folder at the top is called like a problem; PROBLEM/STUDENT/any.py too

A file is for the problem that it is called like (`exact_count.py` is for exact-count), or else for the one
whose function it defines. Whatever lies in the folder costs at most its own row. Links are followed to files
within the folder only: a student may have set them.
"""

from __future__ import annotations

import os
import unicodedata
from collections.abc import Collection, Iterator, Sequence
from pathlib import Path, PurePath

from msgspec import Struct

from judge.batch.model import Handin
from judge.errors import JudgeError, UsageError
from judge.judging.sources import DANGLING, ENVIRONMENT, LARGEST, is_dangling, why_unreadable, within_limit
from judge.languages import SUFFIX, is_program, language_of
from judge.problem.find import problem_folders
from judge.problem.fit import fitting_problems, id_of, signs
from judge.reading import read_ordinary

_DEEPEST = 20  # levels of folders
_MOST = 100_000  # files
_MOST_BYTES = 2**29  # of all programs together, which are in memory while they are judged
_OTHERS = ("node_modules",)  # folders of programs that nobody has handed in
_NOBODY = "it lies in no student's folder"
_NO_PROBLEM = "no problem is called so, and it defines no problem's function"


class ClassFolder(Struct, frozen=True):
    """What was found: hand-ins in the order of students, problems and files.

    `unplaced` are programs without a student or a problem, each with the reason; `others` are files that are
    no programs, by their paths. Neither is judged.
    """

    handins: tuple[Handin, ...]
    unplaced: tuple[Handin, ...]
    others: tuple[str, ...]


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
    reader = _Reader(root, {each.name for each in problem_folders(folders)}, folders, students)
    handins, unplaced, others, size = [], [], [], 0
    for count, path in enumerate(_files(root, ""), 1):
        if count > _MOST:
            raise UsageError(f"this folder holds more than {_MOST:,} files", where=str(folder))
        if not is_program(path):
            why = _why_not_entered(root / path)
            if why:
                unplaced.append(Handin("", "", legible(path), b"", why))
            else:
                others.append(legible(path))
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
    handins.sort(key=lambda each: (each.student, each.problem, each.file))
    return ClassFolder(tuple(handins), tuple(unplaced), tuple(others))


def root_of(folder: Path) -> Path:
    """The folder itself, wherever links lead. Raises UsageError where it is none, or cannot be read."""
    try:
        root = folder.resolve(strict=True)
        os.scandir(root).close()
    except (OSError, ValueError, RuntimeError) as fault:  # RuntimeError: a loop of links
        reason = (getattr(fault, "strerror", None) or "no name for a folder").lower()
        remedy = "name the folder that holds the students' folders"
        what = f"this folder cannot be read ({reason})"
        raise UsageError(what, where=str(folder), remedy=remedy) from fault
    return root


def legible(name: str) -> str:
    """A file's name as text, whatever its bytes are; letters that are composed in two ways are the same."""
    return unicodedata.normalize("NFC", os.fsencode(name).decode("utf-8", "backslashreplace"))


class _Reader:
    """Reads files of one class."""

    def __init__(
        self, root: Path, known: Collection[str], folders: Sequence[Path], students: Collection[str]
    ) -> None:
        self._root = root
        self._known = known
        self._folders = folders
        self._students = students

    def handin(self, path: str) -> Handin:
        """The file, by its path in the class's folder; without a problem or a student where it has none."""
        student, problem = self._placed(PurePath(path))
        source, why = self._read(path)
        if student and not problem and not why:
            problem, why = self._told(source, path)
        if not student:
            why = why or _NOBODY
        elif not problem:
            why = why or _NO_PROBLEM
        return Handin(student, problem, legible(path), b"" if why else source, why)

    def _placed(self, path: PurePath) -> tuple[str, str]:
        """The student and the problem that a path tells, either empty where it does not."""
        top, *rest = path.parts
        named = self._named(path.name)
        if not rest:
            return "", named
        if legible(top) in self._students or id_of(top) not in self._known:
            return legible(top), named
        return legible(rest[0] if len(rest) > 1 else _stem(rest[0])), id_of(top)

    def _named(self, name: str) -> str:
        found = id_of(_stem(name))
        return found if found in self._known else ""

    def _told(self, source: bytes, path: str) -> tuple[str, str]:
        """The problem that the text tells, or why there is none."""
        try:
            fitting = fitting_problems(signs(source, path), self._folders)
        except JudgeError as fault:  # of a problem that is broken, or of this text
            return "", str(fault).removeprefix(f"{path}: ")
        if len(fitting) > 1:
            return "", f"it fits {' and '.join(each.id for each in fitting)}"
        return (fitting[0].id, "") if fitting else ("", "")

    def _read(self, path: str) -> tuple[bytes, str]:
        """The bytes, or why they are not read."""
        place = self._root / path
        try:
            if is_dangling(place):
                return b"", DANGLING
            if place.is_symlink() and not place.resolve().is_relative_to(self._root):
                return b"", "it is a link out of the class's folder, which is not followed"
            if place.is_dir():
                return b"", "it is a folder"
            if not place.is_file():
                place.stat()
                return b"", "it is no ordinary file"
            return within_limit(read_ordinary(place, LARGEST + 1), path), ""
        except UsageError as fault:
            return b"", fault.what
        except (OSError, RuntimeError) as fault:  # RuntimeError: a loop of links
            return b"", why_unreadable(fault) if isinstance(fault, OSError) else DANGLING


def _stem(name: str) -> str:
    """A program's name without what tells its language."""
    language = language_of(name)
    ends = language.suffixes if language else (SUFFIX,)
    return name.removesuffix(next((end for end in ends if name.endswith(end)), ""))


def _why_not_entered(path: Path) -> str:
    """Why what lies in a folder is not looked at; empty for what is none, and for a link to one."""
    try:
        if path.is_symlink() or not path.is_dir():
            return ""
        os.scandir(path).close()
    except OSError as fault:
        return f"this folder {why_unreadable(fault)}"
    return f"this folder lies more than {_DEEPEST} levels down"


def _files(root: Path, within: str, depth: int = _DEEPEST) -> Iterator[str]:
    """The files below a folder, by their paths from the root; and folders that are called like programs, that
    cannot be read, or that lie too deep.
    """
    try:
        with os.scandir(root / within) as scanned:
            entries = sorted(scanned, key=lambda entry: entry.name)
    except OSError:
        yield within
        return
    for entry in entries:
        path = f"{within}/{entry.name}" if within else entry.name
        if entry.name.startswith((".", "__")) or entry.name in _OTHERS:
            continue
        if not entry.is_dir(follow_symlinks=False) or depth == 1 or is_program(entry.name):
            yield path
        elif not os.path.lexists(root / path / ENVIRONMENT):
            yield from _files(root, path, depth - 1)
