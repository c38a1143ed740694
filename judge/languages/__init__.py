"""Which files are programs to judge, and in which language each is written, by the end of its name.

Python's own end is known here. The others are data, a TOML file each, and none is read before a name asks.
"""

from __future__ import annotations

import os
from pathlib import Path, PurePath
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from judge.languages.model import Language

NAME = "Python"
SUFFIX = ".py"
VARIABLE = "JUDGE_LANGUAGES"  # more folders with folders of languages, parted by the system's own sign
FILE = "language.toml"
PATTERN = f"*{SUFFIX}"  # of such files, for a shell and for a person


def is_program(name: str | os.PathLike[str]) -> bool:
    """Whether a file of that name is a program, and not hidden."""
    path = PurePath(name)
    if path.name.startswith("."):
        return False
    return path.suffix == SUFFIX or language_of(path) is not None


def language_of(name: str | os.PathLike[str]) -> Language | None:
    """The language of a file of that name; None for Python's, and for what is in none.

    Raises JudgeError where the description of a language is broken.
    """
    path = PurePath(name)
    if path.suffixes == [SUFFIX] or not path.suffix[1:2].isalpha():
        return None
    from judge.languages.model import language_of_file

    return language_of_file(path.name)


def spelt(name: str, file: str | os.PathLike[str]) -> str:
    """A name of several words, such as `signed_area`, as the language of that file writes it."""
    language = language_of(file)
    return language.spelt(name) if language else name


def file_name(stem: str, language: Language | None = None) -> str:
    """The name of a program's file, in Python where no language is named."""
    return f"{stem}{language.suffixes[0] if language else SUFFIX}"


def folders() -> list[Path]:
    """Where the folders of languages are: here, and where `$JUDGE_LANGUAGES` says."""
    more = os.environ.get(VARIABLE, "").split(os.pathsep)
    return [Path(__file__).parent, *(Path(each).absolute() for each in more if each)]


def is_described(language: str) -> bool:
    """Whether there is a language of that id; none is read for that."""
    return language.isidentifier() and any((each / language / FILE).is_file() for each in folders())


def described() -> list[str]:
    """The ids of all languages that are described, by name."""
    return sorted({path.parent.name for each in folders() for path in each.glob(f"*/{FILE}")})
