"""Results as compilers write them, which editors read: VS Code's matchers, Vim's quickfix, Emacs' compile.

    FILE:LINE:COLUMN: error: MESSAGE      what is wrong
    FILE:LINE:COLUMN: note: MESSAGE       the smallest case, and the mistake's name

An accepted submission is a line without a place: there is nothing to go to.
"""

from __future__ import annotations

from collections.abc import Iterator

from judge.problem.model import Verdict
from judge.report.layout import printable
from judge.report.names import shown_name
from judge.report.places import annotated_place
from judge.report.results import failure_place, verdict_lines
from judge.report.values import arguments
from judge.run.result import Result


def editor_lines(result: Result, source: bytes, entry: str) -> Iterator[str]:
    """The lines for one submission; each is one line, whatever a submission said."""
    if result.verdict is Verdict.AC:
        said = "".join(span.text for row in verdict_lines(result, None) for span in row)
        yield printable(f"{shown_name(result.submission)}: {said}")
        return
    place = annotated_place(result, source, entry)
    where = f"{shown_name(result.submission)}:{place.line}:{place.column or 1}"
    yield printable(f"{where}: error: {_what(result)}")
    found = result.counterexample
    if found is not None and found.replay is not None:
        case = f"{arguments(found.input or {})}: {found.expected} wanted, {found.got} given"
        yield printable(f"{where}: note: smallest case found: {case}; judge try {found.replay}")
    if result.pitfall:
        for name, advice in zip(result.pitfall.names, result.pitfall.advice, strict=True):
            yield printable(f"{where}: note: likely {name}: {advice}")


def _what(result: Result) -> str:
    """The verdict, where it came, and why."""
    place = failure_place(result.failure) if result.groups else ""
    why = result.failure.message if result.failure else ""
    return f"{result.verdict.value}{f' in {place}' if place else ''}{f': {why}' if why else ''}"
