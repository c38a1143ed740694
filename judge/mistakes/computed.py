"""What a trusted program answers wrongly, found by calling it here and now: the setter's own code.

Many mistakes are computed on the same cases, and most of them answer most cases alike. So each different
answer to a case is decided once.
"""

from __future__ import annotations

import hashlib
import pickle
from collections.abc import Callable
from decimal import Context, localcontext
from functools import partial
from typing import Any

from msgspec import Struct

from judge.data import GroupData, ProblemData
from judge.errors import ProblemError
from judge.problem import Case, Problem
from judge.run.result import Answers, Behaviour
from judge.sandbox.encode import encode, found
from judge.values.answers import Target
from judge.values.check import ExactOf
from judge.values.outline import Outline, wrong_outline

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
