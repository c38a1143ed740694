"""Where in a submission's file its failure is: for annotations, and for links that a terminal opens."""

from __future__ import annotations

import re

from msgspec import Struct

from judge.problem.model import Verdict
from judge.run.result import Result

# As judge.run.execute writes a compiler's complaint, whose quotation of the line follows it …
_COMPILED = re.compile(r"\(line (\d{1,9})(?:, column (\d{1,9}))?\)")
# … and judge.sandbox.inside.child an exception, which may have such words in its own text before,
# or the place where a call stood that did not end.
_RAISED = re.compile(r".*\(line (\d{1,9})\)(?:$|, after |, when |; its input|; it was run as a program)")


class FilePlace(Struct, frozen=True):
    """A line of a file, and a column where it is known; both from 1, 0 for unknown."""

    line: int
    column: int = 0


def fault_place(result: Result) -> FilePlace | None:
    """Where a submission does not compile, raised its exception or stood when its time was up.

    Its failure's message says so.
    """
    message = result.failure.message if result.failure else ""
    if result.verdict is Verdict.CE:
        found = _COMPILED.search(message)
        return FilePlace(int(found[1]), int(found[2] or 0)) if found else None
    found = _RAISED.match(message) if result.verdict in (Verdict.RTE, Verdict.TLE) else None
    return FilePlace(int(found[1])) if found else None


def annotated_place(result: Result, source: bytes, entry: str) -> FilePlace:
    """Where to show a person the result: at the fault, else at the entry function, else at the top.

    A line that the file does not have, which an exception's text may claim, is not believed.
    """
    place = fault_place(result)
    if place is not None and place.line <= source.count(b"\n") + 1:
        return place
    name = re.escape(entry.encode())
    # Not by parsing: the file is nobody's yet, and a compiler can be made to crash.
    defined = re.search(rb"^(?:async[ \t]+)?(?:def[ \t]+%s\b|%s[ \t]*(?::.*)?=)" % (name, name), source, re.M)
    return FilePlace(source.count(b"\n", 0, defined.start()) + 1 if defined and entry else 1)
