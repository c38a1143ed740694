"""A failing case of calls in a row: each call with what it returned, up to the one that fails.

Where it is not known at which call the program ended, nothing is said of what they returned.
"""

from __future__ import annotations

import re

from judge.problem import Problem
from judge.problem.model import case_of
from judge.problem.module import load_module
from judge.problem.transcripts import typed_lines
from judge.run.result import NO_ANSWER, Failure
from judge.values import check, show
from judge.values.answers import Tolerance
from judge.values.calls import ReturnType

_ROWS = 20
_WHAT = re.compile(r": | \(|, in call ")  # what comes after the exception's type, or what ended it
_RAISED = re.compile(r"[\w.:]+")  # a type
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
    stopped, ended = int(found[1]) if found else 0, failure.got == NO_ANSWER
    wide = max(map(len, typed), default=0)
    rows = []
    for at, line in enumerate(typed):
        place, wanted = target[at]
        answer = type_.methods[place].answer
        told = show.wanted(answer, wanted) if answer and (stopped or not ended) else ""
        wrong = at + 1 == stopped
        if wrong:
            what = _WHAT.split(failure.message)[0]
            told = f"raised {what}" if _RAISED.fullmatch(what) else what
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
