"""What the known mistakes answer on a problem's data: found once and kept.

<cache folder>/mistakes/<id>-<place>-<seed>-<key>.json
    {hash of a program: {group: [cases, {case: [form, numbers], …}], …}, …}; in place of what a program before
    answers as well, that one's hash

A mistake that is a choice (`judge.mistakes.family`) is computed here: it is the setter's own code, trusted as
problem.py is. A file of `wrong/` may keep state, loop or read standard input; it is judged in containment.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import chain
from typing import Any

from msgspec.structs import replace

from judge.cache import DISK, Store, code_key
from judge.data.load import kept_place
from judge.data.model import GroupData, ProblemData
from judge.mistakes.computed import ComputedProgram, Computer
from judge.mistakes.likeness import CASES
from judge.problem import Problem
from judge.run.result import Answers, Behaviour
from judge.run.settings import Settings

FORMAT = 4  # raise it when the form of the file changes

Progress = Callable[[int, int], None]  # programs done, programs in all
_CODE = ("run", "sandbox")  # beside the packages that the data depend on
_WHAT = "the known mistakes' answers"
_FORM: Any = dict[str, str | dict[str, tuple[int, dict[int, tuple[str, tuple[float, ...]]]]]]


class KnownAnswers:
    """The answers of known programs on one problem's data, read from the cache and added to it."""

    def __init__(self, data: ProblemData, seed: int | None, settings: Settings, store: Store = DISK) -> None:
        self._data = ProblemData(data.problem, tuple(map(_first, data.groups)), loaded=data.loaded)
        self._settings = settings
        self._store = store
        self._place = _place(data.problem, seed)

    @property
    def kept(self) -> bool:
        """Whether anything is kept of these data."""
        return self._store.read(*self._place, _FORM) is not None

    def of(
        self, programs: Sequence[ComputedProgram], progress: Progress | None = None
    ) -> tuple[list[Behaviour], str | None]:
        """The behaviour of each program, and a note for the person where they cannot be kept.

        Raises ProblemError for a choice that cannot be run, JudgeError where nothing can be.
        """
        kept = _unshared(self._store.read(*self._place, _FORM) or {})
        missing = {each.key: each for each in programs if each.key not in kept}
        note = None
        if missing:
            try:
                kept |= self._learnt(missing, progress)
            finally:
                note = self._store.write(*self._place, _shared(kept), _WHAT)
        first: dict[str, Behaviour] = {}
        return [first.setdefault(repr(kept[each.key]), kept[each.key]) for each in programs], note

    def _learnt(
        self, missing: Mapping[str, ComputedProgram], progress: Progress | None
    ) -> Iterator[tuple[str, Behaviour]]:
        """Each program that was asked for, by its key, as soon as its behaviour is known."""
        data, settings = self._data, self._settings

        def judge(program: ComputedProgram) -> Behaviour:
            from judge.run.execute import judge_submission

            return judge_submission(data, program.source, program.file, settings).behaviour

        computer = Computer(data)
        trusted = ((key, computer.behaviour(each)) for key, each in missing.items() if each.trusted)
        contained = ((key, judge(each)) for key, each in missing.items() if not each.trusted)
        for done, found in enumerate(chain(trusted, contained), 1):
            yield found
            if progress:
                progress(done, len(missing))


def _first(each: GroupData) -> GroupData:
    """Its first cases; all of them where these are big."""
    if each.group.size is not None:
        return each
    group = replace(each.group, count=min(CASES, each.group.count))
    return GroupData(group, each.cases[:CASES], each.targets[:CASES])


def is_kept(problem: Problem, seed: int | None) -> bool:
    """Whether anything is kept of what the known mistakes answer."""
    return DISK.read(*_place(problem, seed), _FORM) is not None


def _place(problem: Problem, seed: int | None) -> tuple[str, str]:
    """Its name in the store, and the key of all that the behaviours depend on beside the programs."""
    name, key = kept_place("mistakes", problem, seed)
    return name, f"{FORMAT}/{sys.version}/{key}/{code_key(*_CODE)}"


def _shared(kept: Mapping[str, Behaviour]) -> dict[str, Any]:
    """What is written of the behaviours."""
    firsts: dict[str, str] = {}
    found = {key: firsts.setdefault(repr(each), key) for key, each in kept.items()}
    return {key: each if found[key] == key else found[key] for key, each in kept.items()}


def _unshared(plain: Mapping[str, Any]) -> dict[str, Behaviour]:
    """The behaviours that were written."""
    whole = {
        key: {group: Answers(*each) for group, each in groups.items()}
        for key, groups in plain.items()
        if isinstance(groups, dict)
    }
    return whole | {
        key: whole[first] for key, first in plain.items() if isinstance(first, str) and first in whole
    }
