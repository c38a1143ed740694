"""What the known mistakes answer on a problem's data: found once and kept.

<cache folder>/mistakes/<id>-<place>-<seed>-<key>.json
    {hash of a program: {group: its answers as judge.mistakes.packed has them, …}, …}; instead of what another
    program answers as well, that one's hash

A mistake that is a choice (`judge.mistakes.family`) is computed here: it is the setter's own code, trusted as
problem.py is. A file of `wrong/` may keep state, loop or read standard input; it is judged in containment.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property, partial
from itertools import chain
from typing import Any

from judge.cache import DISK, Store, code_key
from judge.data.load import kept_place
from judge.data.model import ProblemData
from judge.mistakes.agreement import kind_of
from judge.mistakes.computed import Computer, Program
from judge.mistakes.packed import packed, unpacked
from judge.mistakes.rights import right_outlines
from judge.problem import Problem
from judge.run.result import Behaviour
from judge.run.settings import Settings
from judge.values.outline import Outline, Usual

FORMAT = 3  # raise it when the form of the file changes

Progress = Callable[[int, int], None]  # programs done, programs in all
_CODE = ("run", "sandbox")  # beside the packages that the data depend on
_WHAT = "the known mistakes' answers"


class KnownAnswers:
    """The answers of known programs on one problem's data, read from the cache and added to it."""

    def __init__(self, data: ProblemData, seed: int | None, settings: Settings, store: Store = DISK) -> None:
        self._data = data
        self._settings = settings
        self._kinds: dict[tuple[str, int, Outline], str] = {}
        self._store = store
        self._place = _place(data.problem, seed)

    @property
    def kept(self) -> bool:
        """Whether anything is kept of these data."""
        return self._store.read(*self._place, dict[str, Any]) is not None

    def of(
        self, programs: Sequence[Program], progress: Progress | None = None
    ) -> tuple[list[Behaviour], str | None]:
        """The behaviour of each program, and a note for the person where they cannot be kept.

        Raises ProblemError for a choice that cannot be run, JudgeError where nothing can be.
        """
        plain = self._store.read(*self._place, dict[str, Any]) or {}
        kept = {each.key: plain.get(each.key) for each in programs}
        found = _from_plain(kept)
        missing = {each.key: each for each in programs if each.key not in found}
        note = None
        if missing:
            try:
                for key, each in self._learnt(missing, progress):
                    kept[key] = self._as_plain(each)
            finally:
                kept = _shared({key: each for key, each in kept.items() if each is not None})
                note = self._store.write(*self._place, kept, _WHAT)
            found = _from_plain(kept)
        return [found[each.key] for each in programs], note

    def _learnt(
        self, missing: Mapping[str, Program], progress: Progress | None
    ) -> Iterator[tuple[str, Behaviour]]:
        """Each program that was asked for, by its key, as soon as its behaviour is known."""
        data, settings = self._data, self._settings

        def judge(program: Program) -> Behaviour:
            from judge.run.execute import judge_submission

            return judge_submission(data, program.source, program.file, settings).behaviour

        computer = Computer(data)
        trusted = ((key, computer.behaviour(each)) for key, each in missing.items() if each.trusted)
        contained = ((key, judge(each)) for key, each in missing.items() if not each.trusted)
        for done, found in enumerate(chain(trusted, contained), 1):
            yield found
            if progress:
                progress(done, len(missing))

    def _as_plain(self, known: Behaviour) -> dict[str, Any]:
        return {name: packed(answers, partial(self._kind, name)) for name, answers in known.items()}

    def _kind(self, group: str, case: int, given: Outline) -> str:
        """What kind of wrong answer that is; found once of what several programs answer."""
        key = group, case, given
        if key not in self._kinds:
            right = self._rights[group][case]
            self._kinds[key] = kind_of(given, right, self._data.problem.answer, self._usual)
        return self._kinds[key]

    @cached_property
    def _rights(self) -> Mapping[str, Sequence[Outline]]:
        return right_outlines(self._data)

    @cached_property
    def _usual(self) -> Usual:
        return Usual.of(right for outlines in self._rights.values() for right in outlines)


def is_kept(problem: Problem, seed: int | None) -> bool:
    """Whether anything is kept of what the known mistakes answer."""
    return DISK.read(*_place(problem, seed), dict[str, Any]) is not None


def _place(problem: Problem, seed: int | None) -> tuple[str, str]:
    """Its name in the store, and the key of all that the behaviours depend on beside the programs."""
    name, key = kept_place("mistakes", problem, seed)
    return name, f"{FORMAT}/{sys.version}/{key}/{code_key(*_CODE)}"


def _shared(kept: dict[str, Any]) -> dict[str, Any]:
    """The same with the first one's hash in place of what was there before."""
    firsts: dict[str, str] = {}
    found: dict[str, Any] = {}
    for key, plain in kept.items():
        first = firsts.setdefault(repr(plain), key) if isinstance(plain, dict) else key
        found[key] = plain if first == key else first
    return found


def _from_plain(kept: Mapping[str, Any]) -> dict[str, Behaviour]:
    """The behaviours that were written; without those that are anything else."""
    found: dict[str, Behaviour] = {}
    for key, plain in kept.items():
        if isinstance(plain, str) and plain in found:
            found[key] = found[plain]
        elif isinstance(plain, dict):
            try:
                found[key] = {name: unpacked(each) for name, each in plain.items()}
            except (TypeError, ValueError):  # whatever a foreign file can hold
                continue
    return found
