"""What known mistakes answer on a problem's data: found once and kept.

<cache folder>/mistakes/<id>-<place>-<seed>-<key>.json
    [[{group: [cases, {case: [form, numbers], …}], …}, …], {hash of a program: which of these it does, …}]

A mistake that is a choice (`judge.mistakes.family`) is called here and now: it is the setter's own code,
trusted as problem.py is. A file of `wrong/` may keep state, loop or read standard input; it is judged in
containment. Many mistakes are computed on the same cases, and most of them answer most cases alike. So each
different answer to a case is decided once.
"""

from __future__ import annotations

import hashlib
import pickle
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from decimal import Context, localcontext
from functools import partial
from itertools import chain
from typing import Any

from msgspec import Struct
from msgspec.structs import replace

from judge.cache import DISK, Store, code_key
from judge.data import GroupData, ProblemData
from judge.data.load import kept_place
from judge.errors import ProblemError
from judge.problem import Case, Problem
from judge.run.result import Answers, Behaviour
from judge.run.settings import Settings
from judge.sandbox.encode import encode, found
from judge.values.answers import Target
from judge.values.check import ExactOf
from judge.values.outline import Outline, wrong_outline

CASES = 24  # of a group that are compared
FORMAT = 5  # raise it when the form of the file changes

Progress = Callable[[int, int], None]  # programs done, programs in all
_CODE = ("run", "sandbox")  # beside the packages that the data depend on
_WHAT = "the known mistakes' answers"
_OUTLINE: Any = tuple[str, tuple[float, ...]]
_FORM: Any = tuple[list[dict[str, tuple[int, dict[int, _OUTLINE]]]], dict[str, int]]
_PROTOCOL = 5


class ComputedProgram(Struct, frozen=True):
    """A program whose answers are wanted; a trusted one is run here and now."""

    source: bytes
    file: str
    trusted: bool = False

    @property
    def key(self) -> str:
        """What its answers are kept under."""
        return hashlib.sha256(self.source).hexdigest()[:24]


class Computer:
    """Finds what trusted programs answer wrongly on one problem's data; it keeps what it has decided.

    Groups of big cases are left out: they ask for time.
    """

    def __init__(self, data: ProblemData) -> None:
        self._problem = data.problem
        self._groups = [_Group(data, each) for each in data.groups if each.group.size is None]

    def behaviour(self, program: ComputedProgram) -> Behaviour:
        """What the program answers wrongly. Raises ProblemError."""
        with localcontext(Context()):  # as in a container, whatever the caller's precision
            function = entry_of(self._problem, program)
            return {each.name: each.answers(function) for each in self._groups}


class _Group:
    """The cases of one group, as they are handed over, and what was decided of each answer to them."""

    def __init__(self, data: ProblemData, group: GroupData) -> None:
        self.name = group.group.name
        self._data = data
        self._group = group
        self._decided: list[dict[bytes, Outline | None]] = [{} for _ in group.cases]

    def answers(self, function: Callable[..., Any]) -> Answers:
        """What a function answers wrongly, the cases being called in order. It may change its lists."""
        wrong: dict[int, Outline] = {}
        for index, given in enumerate(self._data.problem.calls(self._group.cases)):
            try:
                answer = function(*given)
            except Exception as fault:  # as a submission's would be, a wrong answer
                wrong[index] = raised(type(fault).__name__)
                continue
            found = self._known(index, answer)
            if found is not None:
                wrong[index] = found
        return Answers(len(self._group.cases), wrong)

    def _known(self, index: int, answer: Any) -> Outline | None:
        """The outline of a wrong answer to that case, None of a right one."""
        try:
            key = pickle.dumps(answer, _PROTOCOL)  # the same only where all types are the same too
        except Exception:  # what has no such form, such as a generator
            return self._outline(index, answer)
        decided = self._decided[index]
        if key not in decided:
            decided[key] = self._outline(index, answer)
        return decided[key]

    def _outline(self, index: int, answer: Any) -> Outline | None:
        group = self._group
        exact = partial(self._data.exact, group.cases[index], group.group)
        return _outline_of(self._data.problem, lambda: answer, group.targets[index], exact)


def answered(
    problem: Problem, function: Callable[..., Any], case: Case, target: Target, exact: ExactOf
) -> Outline | None:
    """The outline of what a trusted program answers to a case of one's own, None of a right answer."""
    with localcontext(Context()):
        return _outline_of(problem, lambda: function(*problem.calls([case])[0]), target, exact)


def _outline_of(
    problem: Problem, answer: Callable[[], Any], target: Target, exact: ExactOf
) -> Outline | None:
    try:
        raw = encode(answer())
    except Exception as fault:
        return raised(type(fault).__name__)
    return wrong_outline(problem.answer, raw, target, exact)


def entry_of(problem: Problem, program: ComputedProgram) -> Callable[..., Any]:
    """The entry function of a trusted program. Raises ProblemError where it has none."""
    space: dict[str, Any] = {"__name__": "mistakes"}
    try:
        exec(compile(program.source, program.file, "exec", dont_inherit=True), space)
        function: Callable[..., Any] = found(space, problem.called, problem.answer.items)
        if function is None:
            raise KeyError(problem.entry)
    except Exception as fault:
        what = f"the program with this mistake cannot be run: {type(fault).__name__}: {fault}"
        raise ProblemError(what, where=program.file, remedy="correct the change") from None
    return function


def raised(exception: str) -> Outline:
    """The outline of a call that raised an exception with that name."""
    return f"raised {exception}", ()


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
        for done, learnt in enumerate(chain(trusted, contained), 1):
            yield learnt
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
