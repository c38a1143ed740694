"""What the known mistakes answer on a problem's data: found once and kept.

<cache folder>/mistakes/<id>-<place>-<seed>-<key>.json
    [[{group: [cases, {case: [form, numbers], …}], …}, …], {hash of a program: which of these it does, …}]

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
from judge.data import GroupData, ProblemData
from judge.data.load import kept_place
from judge.mistakes.computed import ComputedProgram, Computer
from judge.mistakes.likeness import CASES
from judge.problem import Problem
from judge.run.result import Answers, Behaviour
from judge.run.settings import Settings

FORMAT = 5  # raise it when the form of the file changes

Progress = Callable[[int, int], None]  # programs done, programs in all
_CODE = ("run", "sandbox")  # beside the packages that the data depend on
_WHAT = "the known mistakes' answers"
_OUTLINE: Any = tuple[str, tuple[float, ...]]
_FORM: Any = tuple[list[dict[str, tuple[int, dict[int, _OUTLINE]]]], dict[str, int]]


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
        """The behaviour of each program, one object for equal ones; a note where they cannot be kept.

        Raises ProblemError for a choice that cannot be run, JudgeError where nothing can be.
        """
        read: tuple[list[dict[str, Any]], dict[str, int]] | None = self._store.read(*self._place, _FORM)
        plain, kept = read or ([], {})
        all_: list[Behaviour] = [{name: Answers(*each) for name, each in one.items()} for one in plain]
        missing = {each.key: each for each in programs if each.key not in kept}
        places = {repr(each): at for at, each in enumerate(all_)} if missing else {}
        note = None
        try:
            for key, found in self._learnt(missing, progress):
                kept[key] = places.setdefault(repr(found), len(all_))
                all_ += [found] if kept[key] == len(all_) else []
        finally:
            if missing:
                note = self._store.write(*self._place, (all_, kept), _WHAT)
        return [all_[kept[each.key]] for each in programs], note

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


def _place(problem: Problem, seed: int | None) -> tuple[str, str]:
    """Its name in the store, and the key of all that the behaviours depend on beside the programs."""
    name, key = kept_place("mistakes", problem, seed)
    return name, f"{FORMAT}/{sys.version}/{key}/{code_key(*_CODE)}"
