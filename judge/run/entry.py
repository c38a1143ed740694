"""Why a submission could answer nothing: not a wrong answer to be looked for, but a file that cannot be run.

The verdict is what it is; nothing here changes it. Such a submission needs no smallest case and no name of a
mistake, but one sentence.
"""

from __future__ import annotations

import re

from judge.errors import nearest
from judge.problem import Problem, Verdict
from judge.run.result import EntryError, EntryKind, Result
from judge.run.runner import Runner
from judge.sandbox.boundary import IMPORTING, Defined, Inspection

_NO_MODULE = re.compile(r"ModuleNotFoundError: No module named '([\w.]+)'")  # as Python says it
_LINE = re.compile(r"\(line (\d{1,9})\)")
_READS = (b"stdin", b"input", b"open(0", b"os.read")  # what a program that is meant as one has somewhere


def entry_error(result: Result, runner: Runner, inspection: Inspection, source: bytes) -> EntryError | None:
    """What keeps a submission that compiles from running at all; None where it runs."""
    if result.verdict is Verdict.AC or not result.groups or result.failure is None:
        return None
    problem, called = runner.problem, runner.calls
    entry = next((each for each in inspection.functions if each.name == problem.entry), None)
    message = result.failure.message
    place = _LINE.search(message)
    line = int(place[1]) if place else 0
    in_python = problem.methods and not runner.language  # where a function of that name is no class
    if called and entry is not None and entry.empty and not in_python:
        return EntryError(EntryKind.STUB, entry.line)
    if message.startswith(f"NotImplementedError: {problem.entry or problem.id} is still to be written"):
        return EntryError(EntryKind.STUB, line)
    if called and problem.methods:
        if entry is not None and in_python:
            return EntryError(EntryKind.NO_CLASS, entry.line, _methods(problem))
        if not inspection.defines(problem.entry):
            return missing_entry(problem, inspection, source)
    # What such a one printed is right by chance; in another language its compiler would not have taken it.
    meant = called or runner.language or not problem.entry or getattr(runner, "asked", False)
    missing = None if meant else missing_entry(problem, inspection, source)
    ran = any(group.passed for group in result.groups)
    if ran or runner.language or result.verdict is not Verdict.RTE:
        return missing
    if called and entry is not None and not problem.methods and not entry.takes(len(problem.parameters)):
        return EntryError(EntryKind.ARITY, entry.line, takes=_takes(entry))
    if called and not message.endswith(IMPORTING):
        return None
    if absent := _NO_MODULE.match(message):
        return EntryError(EntryKind.MODULE, line, absent[1])
    return EntryError(EntryKind.IMPORT, line) if called else missing


def missing_entry(problem: Problem, inspection: Inspection, source: bytes) -> EntryError | None:
    """Why a source has no entry that can be called; None where it reads its input, as a program does."""
    entry = problem.entry
    inner = {each.name: each for each in reversed(inspection.inner)}
    reads = not problem.methods and (not problem.parameters or any(word in source for word in _READS))
    functions = {each.name for each in inspection.functions}
    names = dict(inspection.names)
    # In what reads its input a variable of a name like the entry's means nothing.
    close = nearest(entry, functions if reads else names)
    if close:
        return EntryError(EntryKind.MISNAMED, names[close], close)
    if reads:
        return None
    if found := inner.get(entry) or inner.get(nearest(entry, inner) or ""):
        name = "" if found.name == entry else found.name
        return EntryError(EntryKind.NESTED, found.line, name, within=found.within)
    lines = source.splitlines()
    called = re.compile(rb"\bdef[ \t]+%s[ \t]*\(" % re.escape(entry.encode()))
    for number, line in enumerate(lines, 1):
        if written := called.search(line):  # the tree knows of none
            noted = b"#" in line[: written.start()]
            return EntryError(EntryKind.COMMENT if noted else EntryKind.TEXT, number)
    if not any(line.strip() and not line.lstrip().startswith(b"#") for line in lines):
        return EntryError(EntryKind.EMPTY)
    return EntryError(EntryKind.NO_ENTRY, name="print" if b"print" in source else "")


def _methods(problem: Problem) -> str:
    """The methods of the class, `get and put`."""
    return " and ".join(getattr(problem.answer, "place", ()))


def _takes(entry: Defined) -> str:
    if entry.most < 0:
        return f"at least {entry.least}"
    return str(entry.most) if entry.least == entry.most else f"{entry.least} to {entry.most}"
