"""The programs beside a problem, each in the folder of the verdict that it must get.

    solutions/<id>/accepted/by-halves.py    right, each in a way of its own
    solutions/<id>/slow/one-by-one.py       right, and too slow
    solutions/<id>/wrong/off-by-one.py      a mistake that people make; off-by-one-….py are variants of it
    solutions/<id>/libraries/ezdxf.py       a call of a real library, of which no verdict is wanted

Beside the folders may stand mistakes.py, from which many more wrong programs are made (judge.mistakes).

A program begins with what the judge says about it: its name (an idea, or a mistake), and below that why it
works, or what is wrong and what to do instead. In Python that is its docstring, in another language the line
comments that it begins with. A pack may come without any.
"""

from __future__ import annotations

import ast
import re
import warnings
from collections.abc import Iterable
from contextlib import suppress
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from msgspec import Struct

from judge.errors import ProblemError
from judge.files import read_ordinary
from judge.languages import SUFFIX, is_program, language_of
from judge.problem.model import Problem, Verdict

if TYPE_CHECKING:
    from judge.languages.model import Language

MISTAKES = "mistakes.py"  # beside the folders: right ways with their mistakes (judge.mistakes.routes)

LONGEST = 65_536  # bytes of a stranger's program; a tree takes six hundred times as many
_ENDLESS = r"[^\x00-\x7f]{1000}"  # accents upon accents, which Python sorts in a name one by one
_LIBRARY = re.compile(r"(@?[\w./-]+) (\d\S*): ")
_SENTENCE_END = r"(?<=[.!?])\s+(?=[A-Z`\d])"


class SolutionKind(Enum):
    """The folders, and so the verdict that is wanted of what is in them; of a library none is."""

    ACCEPTED = "accepted"
    WRONG = "wrong"
    SLOW = "slow"
    LIBRARY = "libraries"

    def allows(self, verdict: Verdict) -> bool:
        """Whether a program of this folder may get that verdict."""
        if self is SolutionKind.WRONG:
            return verdict not in (Verdict.AC, Verdict.CE, Verdict.JE)
        return verdict is (Verdict.AC if self is SolutionKind.ACCEPTED else Verdict.TLE)

    @property
    def wanted(self) -> str:
        """The verdict in words."""
        return {"accepted": "AC", "wrong": "a rejection", "slow": "TLE"}[self.value]


class Solution(Struct, frozen=True):
    """One program: its bytes, its name and what is told below it; both texts may be empty.

    `language` is None for Python's.
    """

    kind: SolutionKind
    path: Path
    source: bytes
    name: str
    text: str
    language: Language | None = None

    @property
    def file(self) -> str:
        """As `wrong/absolute-epsilon.py`."""
        return f"{self.kind.value}/{self.path.name}"

    @property
    def advice(self) -> str:
        """The text in one paragraph: of a mistake, what is wrong and what to do instead."""
        return " ".join(self.text.split())

    @property
    def sentence(self) -> str:
        """The first sentence of it: of a mistake, what is wrong."""
        return re.split(_SENTENCE_END, self.advice, maxsplit=1)[0]

    @property
    def usual(self) -> bool:
        """Whether its file is called after it: of a mistake, that it is none of the variants."""
        return self.path.stem == self.name


class Solutions(NamedTuple):
    """What was read: the programs by kind and name of the file, and what is wrong with the folders."""

    programs: tuple[Solution, ...]
    faults: tuple[ProblemError, ...]


def read_solutions(problem: Problem, *kinds: SolutionKind) -> Solutions:
    """The programs of these kinds; of all that get a verdict where none is given.

    What is hidden is passed over. A file that cannot be read, or is in no language known here, is a fault and
    no program; one that says no name is both.
    """
    programs: list[Solution] = []
    faults: list[ProblemError] = []
    for kind in kinds or (SolutionKind.ACCEPTED, SolutionKind.WRONG, SolutionKind.SLOW):
        for path in _visible(problem.solutions / kind.value, faults):
            try:
                programs.append(found := _read(kind, path))
            except ProblemError as fault:
                faults.append(fault)
                continue
            if not found.name:
                remedy = (
                    f"begin it with the name of its {'mistake' if kind is SolutionKind.WRONG else 'idea'}"
                )
                what = "it has no docstring" if found.language is None else "no comment begins it"
                faults.append(_fault(path, what, remedy))
    # What lies beside their folders and looks as if somebody thought that it was judged.
    for path in () if kinds else _visible(problem.solutions, faults):
        judged = path.name in (*(kind.value for kind in SolutionKind), MISTAKES)
        if not judged and (path.is_dir() or is_program(path)):
            faults.append(_fault(path, "nobody judges this", "move it to accepted, wrong or slow", 2))
    return Solutions(tuple(programs), tuple(faults))


def usual_first(programs: Iterable[Solution]) -> list[Solution]:
    """Those that say their name, by name, what is called after it before its variants."""
    named = [each for each in programs if each.name]
    return sorted(named, key=lambda each: (each.name, not each.usual, each.path.name))


def accepted_source(problem: Problem, file: str) -> bytes | None:
    """The bytes of one accepted program; None where it is not there, as in a pack without solutions."""
    try:
        return read_ordinary(problem.solutions / SolutionKind.ACCEPTED.value / file)
    except OSError:  # `judge verify` tells of it
        return None


def requirement(path: Path) -> str:
    """What pip installs for the adapter of a library, as `ezdxf==1.4.5`; "" for any other file.

    For one in another language it is as npm knows it, `three@0.187.0`.

    Its docstring begins with the package, its version, a colon and what is called.
    """
    found = None
    if path.parent.name == SolutionKind.LIBRARY.value:
        with suppress(ProblemError):
            found = _LIBRARY.match(_read(SolutionKind.LIBRARY, path).name)
    return ("==" if path.suffix == SUFFIX else "@").join(found.groups()) if found else ""


def install_command(package: str) -> str:
    """The command for what `requirement` gives."""
    return f"{'pip' if '==' in package else 'npm'} install {package}"


def _visible(folder: Path, faults: list[ProblemError]) -> list[Path]:
    """What a folder holds, in order, without what is hidden; `faults` gets one where it cannot be read."""
    try:
        return sorted(path for path in folder.iterdir() if not path.name.startswith((".", "__")))
    except OSError as fault:
        if not isinstance(fault, FileNotFoundError):
            faults.append(_fault(folder, f"cannot be read: {fault.strerror}", "make it a readable folder", 2))
        return []


def _read(kind: SolutionKind, path: Path) -> Solution:
    language = language_of(path)
    if language is None and path.suffix != SUFFIX:
        remedy = f"end its name as a language does ({SUFFIX}) if it is one, or move it elsewhere"
        raise _fault(path, "this is not a program", remedy)
    try:
        source = read_ordinary(path)
        head = (ast.get_docstring(tree_of(source)) or "") if language is None else parted(source, language)[0]
    except OSError as fault:
        raise _fault(path, f"cannot be read: {fault.strerror}", "make it readable") from None
    except SyntaxError as fault:
        raise _fault(path, f"not Python: {fault.msg}", "repair it", line=fault.lineno) from None
    name, _, text = head.partition("\n")
    return Solution(kind, path, source, name.strip().rstrip("."), text.strip("\n"), language)


def _fault(path: Path, what: str, remedy: str, parts: int = 3, line: int | None = None) -> ProblemError:
    """A fault of what lies there; a person is told the end of its path: `middle/wrong/off-by-one.py`."""
    where = "/".join(path.parts[-parts:])
    return ProblemError(what, where=f"{where}:{line}" if line else where, remedy=remedy)


def parted(source: bytes, language: Language) -> tuple[str, str]:
    """The text of the line comments that a source of another language begins with, and the lines below."""
    text, mark = "\n".join(source.decode("utf-8-sig", "replace").splitlines()), re.escape(language.comment)
    head = re.match(rf"(?:#!.*\n|[^\S\n]*+\n)*+((?:{mark}.*(?:\n|\Z))*)", text)
    assert head is not None  # it may be empty
    said = re.sub(rf"(?m)^{mark} ?|[^\S\n]+$", "", head[1])
    return said.removesuffix("\n"), text[head.end() :].strip("\n")


def tree_of_stranger(source: bytes) -> ast.Module:
    """The tree of what anybody may have written, which is no longer than LONGEST. Raises SyntaxError.

    What encoding the program says that it has is not believed: some make accents of plain letters.
    """
    try:
        text = source.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = source.decode("latin-1")
    if re.search(_ENDLESS, text):
        raise SyntaxError("a word in it is too long")
    return tree_of(text)


def tree_of(source: str | bytes) -> ast.Module:
    """The program's tree; what the compiler would warn of is not for whoever runs the judge.

    Raises:
        SyntaxError: it is no Python, or nested too deeply for the compiler.
    """
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return ast.parse(source)
    except ValueError as fault:  # a NUL
        raise SyntaxError(str(fault)) from fault
    except (RecursionError, MemoryError) as fault:
        raise SyntaxError("it is nested too deeply") from fault
