"""Why a submission could answer nothing: not a wrong answer to be looked for, but a file that cannot be run.

The verdict is what it is; nothing here changes it. Such a submission needs no smallest case and no name of a
mistake, but one sentence.
"""

from __future__ import annotations

import re

from msgspec.structs import replace

from judge.problem import Problem, Verdict
from judge.run.program import ProgramRunner, missing_entry
from judge.run.result import Hurdle, Obstacle, Result
from judge.run.runner import Runner
from judge.sandbox.boundary import IMPORTING, Box, Defined, Inspection

_MISSING = re.compile(
    r"ModuleNotFoundError: No module named '([\w.]+)'"
)  # as Python says it, and no other way
_LINE = re.compile(r"\(line (\d{1,9})\)")


def with_hurdle(result: Result, runner: Runner, box: Box, source: bytes) -> Result:
    """The result, with what keeps the submission in `box` from running at all, if anything does."""
    hurdle = hurdle_of(result, runner, box.inspect(), source)
    return result if hurdle is None else replace(result, hurdle=hurdle)


def hurdle_of(result: Result, runner: Runner, inspection: Inspection, source: bytes) -> Hurdle | None:
    """What keeps a submission that compiles from running at all; None where it runs."""
    if result.verdict is Verdict.AC or not result.groups or result.failure is None:
        return None
    problem, called = runner.problem, runner.calls
    entry = next((each for each in inspection.functions if each.name == problem.entry), None)
    if called and entry is not None and entry.empty:
        return Hurdle(Obstacle.STUB, entry.line)
    # What such a one printed is right by chance; in another language its compiler would not have taken it.
    meant = runner.language or (isinstance(runner, ProgramRunner) and runner.asked)
    missing = None if called or meant else _no_entry(problem, inspection, source)
    if missing is not None or any(group.passed for group in result.groups):
        return missing
    if result.verdict is Verdict.RTE:
        if called and entry is not None and not entry.takes(len(problem.parameters)):
            return Hurdle(Obstacle.ARITY, entry.line, takes=_takes(entry))
        if runner.language:
            return None  # what is wrong with it stands in its message
        if not called or result.failure.message.endswith(IMPORTING):
            return _failed_import(result.failure.message, called=called)
    return None


def _failed_import(message: str, *, called: bool) -> Hurdle | None:
    """An exception before anything was answered; that of a program may have its reason in its input."""
    place = _LINE.search(message)
    line = int(place[1]) if place else 0
    missing = _MISSING.match(message)
    if missing:
        return Hurdle(Obstacle.MODULE, line, missing[1])
    return Hurdle(Obstacle.IMPORT, line) if called else None


def _no_entry(problem: Problem, inspection: Inspection, source: bytes) -> Hurdle | None:
    missing = missing_entry(problem.entry, inspection.names, source)
    if missing is None:
        return None
    if missing.nested:
        return Hurdle(Obstacle.NESTED)
    if missing.close:
        return Hurdle(Obstacle.MISNAMED, missing.line, missing.close)
    return Hurdle(Obstacle.NO_ENTRY)


def _takes(entry: Defined) -> str:
    if entry.most < 0:
        return f"at least {entry.least}"
    return str(entry.most) if entry.least == entry.most else f"{entry.least} to {entry.most}"
