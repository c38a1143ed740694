"""Problems in the cache: what problem.toml, problem.py and the statement came to, so that none is run again.

    <cache folder>/problems/<id>-<place>-<key>.json

`place` stands for the problem's folder, `key` for the content of all that the problem is made from. What is
kept holds no path. A problem whose groups stand in problem.toml is not kept.
"""

from __future__ import annotations

import os
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import msgspec
from msgspec.structs import replace

from judge.digest import digest_of
from judge.errors import ProblemError
from judge.files import cache_folder
from judge.kept import KeptFile
from judge.problem.keys import code_key, content_key, own_files
from judge.problem.model import Problem, tupled
from judge.values.answers import Words
from judge.values.atoms import Type
from judge.values.grammar import TypeFault, parse

_CODE = ("exact", "values", "data", "problem", "geometry")  # the packages that groups depend on
_NO_FOLDER = Path()


class KeptProblem:
    """The file of one problem."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def read(self, solutions: Path) -> Problem | None:
        """The problem that was kept, with these folders; None where there is none that still holds."""
        file = self._file()
        kept = file.read() if file else None
        if kept is None:
            return None
        try:
            problem = msgspec.convert(kept, Problem, dec_hook=self._decoded)
        except (ValueError, TypeFault, TypeError, KeyError):  # msgspec.ValidationError is a ValueError
            return None
        examples = tuple(replace(each, case=tupled(each.case)) for each in problem.examples)
        return replace(problem, folder=self._folder, solutions=solutions, examples=examples)

    def write(self, problem: Problem) -> None:
        """Keep a problem."""
        file = self._file()
        if file is not None:
            bare = replace(problem, folder=_NO_FOLDER, solutions=_NO_FOLDER)
            file.write(msgspec.to_builtins(bare, enc_hook=_encoded))

    def _file(self) -> KeptFile | None:
        try:
            if not (self._folder / "problem.toml").is_file():
                return None
            pins = [path for path in [self._folder / "pins.json"] if path.is_file()]
            key = content_key("1", [*own_files(self._folder), *pins], code_key(_CODE))
        except (OSError, ProblemError):  # whoever reads it says what is wrong
            return None
        place = digest_of(os.fsencode(self._folder))[:8]
        return KeptFile(cache_folder, "problems", f"{self._folder.name}-{place}-", key, "problems")

    def _decoded(self, wanted: Any, value: Any) -> Any:
        if wanted is Fraction:
            return _fraction(value)
        if wanted is Path:
            return Path(value)
        return _type(value["type"], self._folder.parent / "types", Words(**value["words"]))


_fraction = cache(Fraction)  # a problem has hundreds of them, most of them alike


@cache
def _type(text: str, folder: Path, words: Words) -> Type:
    return parse(text, folder if folder.is_dir() else None, words)


def _encoded(value: Any) -> Any:
    if isinstance(value, Type):
        return {"type": value.text, "words": msgspec.to_builtins(value.words)}
    return str(value)  # a Fraction or a path
