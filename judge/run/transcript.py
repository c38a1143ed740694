"""A failing case of calls in a row: each call with what it returned, up to the one that fails."""

from __future__ import annotations

import re

from judge.problem import Problem
from judge.problem.model import case_of
from judge.problem.module import load_module
from judge.problem.transcripts import typed_lines
from judge.run.result import Failure
from judge.values import check, show
from judge.values.answers import Tolerance
from judge.values.calls import ReturnType

_ROWS = 20
_WHAT = re.compile(r": | \(line |, in call ")  # what comes after the exception's type
_IN_CALL = re.compile(r", in call ([0-9]{1,9}): ")


def transcript(problem: Problem, failure: Failure) -> str:
    """The calls in rows, the last one is marked. Raises ProblemError where the exact side fails."""
    case, type_ = case_of(failure.input or {}), problem.answer
    assert isinstance(type_, ReturnType)
    group = problem.group(failure.group or "")
    tolerance = group.tolerance if group else Tolerance()
    exact = load_module(problem).solve(*case)
    target = type_.aim(exact, tolerance)
    first, *typed = typed_lines(problem, case)
    given = failure.given if isinstance(failure.given, list) and len(failure.given) == len(target) else []
    found = _IN_CALL.search(failure.message)
    stopped = int(found[1]) if found else 0
    wide = max(map(len, typed), default=0)
    rows = []
    for at, line in enumerate(typed):
        place, wanted = target[at]
        answer = type_.methods[place].answer
        told = show.wanted(answer, wanted) if answer else ""
        wrong = at + 1 == stopped
        if wrong:
            told = f"raised {_WHAT.split(failure.message)[0]}"
        elif given:
            off = type_.decided(at, given[at], target[at], lambda: (exact, tolerance))
            if isinstance(off, check.Rejection):
                wrong, told = True, f"{off.wanted} expected, {off.got} given"
        rows.append(f"{line:{wide}}   {told}".rstrip())
        if wrong:
            break
    if len(rows) > _ROWS:
        rows = [rows[0], "…", *rows[2 - _ROWS :]]
    return "\n".join([first, *rows])
