"""Which problem a file is meant to solve, told from its text: neither it nor any problem.py is run.

Asked in this order, until exactly one problem is left:

    the functions that the file defines at its top level: a problem's entry
    the line that a stub begins with (`count: …`), or the file's name (count.py)
    a function inside a class or another function, which the verdict then says to move out

In another language than Python only the first two are looked at, by that language's own patterns. The text is
searched and not parsed: a file that does not compile has its problem too, and no text, however
it was made, takes longer than reading it.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path, PurePath
from typing import TYPE_CHECKING

from msgspec import Struct

from judge.errors import nearest
from judge.languages import language_of
from judge.languages.scan import reading, stripped, usual_tokens
from judge.problem.find import near_problem_folders, problem_folders
from judge.problem.load import load_problem
from judge.problem.model import Problem

if TYPE_CHECKING:
    from judge.languages.model import Language

_READ = 2**20  # characters of a file that are looked at
_MOST_NAMES = 200  # of functions, one of which may be meant
_DEFINED = re.compile(
    r"^(?:async[ \t]+def|def|class)[ \t]+(\w+)|^(\w+)[ \t]*(?::[^=\n]*)?=(?!=)", re.MULTILINE
)
_NESTED = re.compile(r"^[ \t]+(?:async[ \t]+)?def[ \t]+(\w+)", re.MULTILINE)
_STUB = re.compile(r"\s*(?:#[^\n]*\n\s*)*[rR]?(?:\"\"\"|''')\s*([a-z][a-z0-9-]*): ")
_ABROAD = r"\s*{comment}\s*([a-z][a-z0-9-]*): "  # such a line in another language
_ENTRY = re.compile(r"""^[ \t]*["']?entry["']?[ \t]*=[ \t]*["'](\w+)["']""", re.MULTILINE)


class Signs(Struct, frozen=True):
    """What of a file tells its problem."""

    defined: frozenset[str]  # at its top level
    nested: frozenset[str]  # functions below it
    stub: str  # the problem's id in the first line, or nothing
    stem: str  # the id that the file's name stands for
    file: str  # the file's own name
    defines: Callable[[str], bool] | None = None  # in another language: whether it defines such an entry

    def has(self, entry: str) -> bool:
        """Whether the file defines the entry where it is called."""
        return self.defines(entry) if self.defines else entry in self.defined


def signs(source: bytes, name: str) -> Signs:
    """The signs of a file with this text and name. Raises JudgeError as `judge.languages.scan.reading`."""
    with reading(name):
        return _signs(source, name)


def _signs(source: bytes, name: str) -> Signs:
    text = source[:_READ].decode("utf-8", "replace").replace("\r\n", "\n").removeprefix("\ufeff")
    language = language_of(name)
    if language is not None:
        return _signs_abroad(text, name, language)
    stub = _STUB.match(text)
    bare = stripped(text.encode(), usual_tokens("#"))
    return Signs(
        frozenset(one or other for one, other in _DEFINED.findall(bare)),
        frozenset(_NESTED.findall(bare)),
        stub[1] if stub else "",
        id_of(PurePath(name).stem),
        name,
    )


def _signs_abroad(text: str, name: str, language: Language) -> Signs:
    from judge.languages.sources import defined

    stub = re.match(_ABROAD.replace("{comment}", re.escape(language.comment)), text)
    quiet = stripped(text.encode(), language.tokens)

    def defines(entry: str) -> bool:
        return defined(language, quiet, entry) is not None

    suffix = next(each for each in language.suffixes if name.endswith(each))
    stem = id_of(PurePath(name).name.removesuffix(suffix))
    return Signs(frozenset(), frozenset(), stub[1] if stub else "", stem, name, defines)


def id_of(stem: str) -> str:
    """The problem that a file or folder of this name, without its ending, is called like."""
    return stem.lower().replace("_", "-")


def fitting_problems(found: Signs, extra: Sequence[Path] = ()) -> list[Problem]:
    """The problems that the signs fit equally well: none, one or several; `extra` folders come first.

    Installed packs are searched only where no nearer problem fits, or the stub's line names none of them.
    Raises as `find_problem` does, and JudgeError where the text takes too long to read.
    """
    with reading(found.file):
        fitting = _all_fitting(found, extra)
    return [load_problem(folder) for folder in fitting]


def _all_fitting(found: Signs, extra: Sequence[Path]) -> list[Path]:
    near = _entries(near_problem_folders(extra))
    fitting = _fitting(found, near)
    if not fitting or (found.stub and found.stub not in [folder.name for folder in near]):
        every = _fitting(found, _entries(problem_folders(extra)))
        if not fitting or [folder.name for folder in every] == [found.stub]:
            fitting = every
    return fitting


def meant_problem(found: Signs, extra: Sequence[Path] = ()) -> tuple[str, str, str] | None:
    """The function of the file that may be meant as an entry, the entry, and its problem; or None."""
    entries = _entries(near_problem_folders(extra))
    names = {entry: folder.name for folder, entry in entries.items()}
    for name in sorted(found.defined | found.nested)[:_MOST_NAMES]:
        entry = nearest(name, names)
        if entry:
            return name, entry, names[entry]
    return None


def _fitting(found: Signs, entries: dict[Path, str]) -> list[Path]:
    hinted = [[folder for folder in entries if folder.name == name] for name in (found.stub, found.stem)]
    for at_top in (True, False):
        has = found.has if at_top else found.nested.__contains__
        fitting = [folder for folder, entry in entries.items() if has(entry)]
        if len(fitting) > 1:  # the stub's line or the file's name says which
            fitting = next((hint for hint in hinted if hint and hint[0] in fitting), fitting)
        if fitting:
            return fitting
        if at_top and any(hinted):
            return next(hint for hint in hinted if hint)
    return []


def _entries(folders: Iterable[Path]) -> dict[Path, str]:
    """The entry function of each problem, one problem of each name, as its problem.toml seems to have it."""
    entries: dict[Path, str] = {}
    seen = set()
    for folder in folders:
        if folder.name in seen:
            continue
        seen.add(folder.name)
        try:
            found = _ENTRY.search((folder / "problem.toml").read_text(encoding="utf-8", errors="replace"))
        except OSError:  # whoever asks for this one is told
            continue
        if found:
            entries[folder] = found[1]
    return entries
