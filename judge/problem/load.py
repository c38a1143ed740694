"""A problem's folder - problem.toml, problem.py and statement.md - into one checked Problem, and its cache.

    problems/<place>          {"<id>": [stamp, key, its head], …}, one file for a folder of problems
    problems/<place>-<id>     the problem, whole

`stamp` is of the files' sizes and times: where it holds, none of them is read. Where it does not, the hash
`key` of what they and the judge's code hold says whether the problem is read anew: only then problem.py runs.
"""

from __future__ import annotations

import os
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any, TypeVar, cast

import msgspec
from msgspec.structs import replace

from judge.cache import DISK, code_files, code_key, content_key, digest, stamp
from judge.errors import ProblemError
from judge.problem.model import FORMS, NAME, Listed, Problem, is_name, parsed_type, tupled
from judge.values.answers import Words
from judge.values.atoms import Type

P = TypeVar("P", bound=Listed)
_FORMAT = "3"  # raise it when the form of the file changes
_ROOMS = ("exact", "values", "problem", "data", "geometry")  # what groups and data depend on
_OWN = (".toml", ".md", ".py", "pins.json")


def load_problem(folder: Path, solutions: Path | None = None) -> Problem:
    """The problem of that folder; `solutions` is its own folder of solutions.

    By default that is `solutions/<id>` beside the folder of problems. A problem that was read before comes
    from the cache, and nothing of it is run. Raises ProblemError.
    """
    shelf = Shelf(folder.parent)
    problem = shelf.problem(folder, Problem)
    shelf.keep()
    return problem if solutions is None else replace(problem, solutions=solutions)


class Shelf:
    """The problems of one folder, from the cache as far as that holds. Call `keep` when all are asked for."""

    def __init__(self, root: Path) -> None:
        self._name = f"problems/{digest(os.fsencode(root))[:16]}"
        self._heads = DISK.read(self._name, _FORMAT, dict[str, tuple[str, str, Listed]]) or {}
        self._solutions = root.parent / "solutions"
        self._shared = [_code_stamp(), stamp(_files(root / "types", (".py",)))]
        self._changed = False

    def problem(self, folder: Path, kind: type[P]) -> P:
        """The problem of a folder in it, as much of it as `kind` has. Raises ProblemError."""
        name = folder.name
        if not is_name(name):
            what, remedy = f"{name!r} is not a name for a kata", f"use {FORMS[NAME]}"
            raise ProblemError(what, where=str(folder), remedy=remedy)
        was, key, head = self._heads.get(name, ("", "", None))
        stamps = [*self._shared, stamp(_files(folder, _OWN))]
        now = "".join(stamps) if all(stamps) else ""
        found: Listed | None = None
        if (now and now == was) or problem_key(folder) == key:
            found = head if kind is Listed else self._decoded(folder, key)
        if found is None:
            from judge.problem.read import read_problem  # not for who reads the cache

            key = problem_key(folder)
            found = whole = replace(read_problem(folder, self._solutions / name), key=key)
            if not key or problem_key(folder) != key:  # its files changed meanwhile
                return cast("P", replace(whole, key=""))
            head = msgspec.convert(whole, Listed, from_attributes=True)
            kept = msgspec.json.encode(replace(whole, folder=Path(), solutions=Path()), enc_hook=_encoded)
            DISK.write(f"{self._name}-{name}", key, kept)
            was = "nothing sound"
        if head and now != was:
            self._heads[name] = now, key, head
            self._changed = True
        return cast("P", found)

    def _decoded(self, folder: Path, key: str) -> Problem | None:
        """The whole problem that was kept, in its folder; None where there is none."""

        def made(wanted: Any, value: Any) -> Any:
            if wanted is Fraction:
                return _fraction(value)
            if wanted is Path:
                return folder
            words = Words(**value["words"])
            return parsed_type(value["type"], folder.parent / "types", words, value["letters"])

        plain = DISK.read(f"{self._name}-{folder.name}", key, bytes)
        try:
            problem = msgspec.json.decode(plain or b"", type=Problem, dec_hook=made)
        except (ValueError, TypeError, KeyError):  # msgspec's and TypeFault are ValueErrors
            return None
        from judge.values.parameters import listed

        examples = []
        for each in problem.examples:
            case, wanted = tupled(each.case), tupled(each.wanted)
            if problem.methods:
                from judge.problem.transcripts import listed_answers

                wanted = listed_answers(problem, case, wanted)
            else:
                wanted = listed(problem.answer, wanted)
            examples.append(replace(each, case=case, wanted=wanted))
        return replace(problem, solutions=self._solutions / folder.name, examples=tuple(examples))

    def keep(self) -> None:
        """Write what changed to the cache."""
        if self._changed:
            DISK.write(self._name, _FORMAT, msgspec.json.encode(self._heads))


def own_files(folder: Path) -> list[str]:
    """The files of a problem's folder that it and its data are made from, and the pack's own types."""
    return [*_files(folder, _OWN), *_files(folder.parent / "types", (".py",))]


def _files(folder: Path, ends: tuple[str, ...]) -> list[str]:
    try:
        names = sorted(os.listdir(folder))  # noqa: PTH208 - of hundreds
    except OSError:
        return []
    return [f"{folder}/{name}" for name in names if name.endswith(ends)]


def problem_key(folder: Path) -> str:
    """The hash of all that the problem and its data are made from; "" where that cannot be read."""
    try:
        return digest(content_key(own_files(folder)).encode(), code_key(*_ROOMS).encode())[:32]
    except (OSError, ProblemError):  # whoever reads it says what is wrong
        return ""


@cache
def _code_stamp() -> str:
    return stamp(code_files(*_ROOMS))


_fraction = cache(Fraction)  # a problem has hundreds of them, most of them alike


def _encoded(value: Any) -> Any:
    if isinstance(value, Type):
        words = msgspec.to_builtins(value.words)
        return {"type": value.text, "words": words, "letters": value.letters}
    return str(value)  # a Fraction or a path
