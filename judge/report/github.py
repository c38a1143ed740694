"""Results as GitHub's workflow commands: an annotation at the line of the file that it is about.

    ::error file=FILE,line=LINE,col=COLUMN,title=TITLE::MESSAGE

A line of output that begins with `::` is a command, so nothing of a submission may begin one. The escapes are
those of GitHub's own toolkit: `%`, carriage return and newline everywhere, `:` and `,` in properties too.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path

from judge.problem.model import Verdict
from judge.report.layout import printable
from judge.report.places import annotated_place
from judge.report.results import failure_place, verdict_lines
from judge.report.values import arguments
from judge.run.result import Failure, Result


def annotation(result: Result, source: bytes, entry: str, environment: Mapping[str, str]) -> str:
    """The command for one submission: an error, or a notice where it is accepted."""
    accepted = result.verdict is Verdict.AC
    properties = {"file": _file(result.submission, environment)}
    if result.verdict is not Verdict.JE:
        place = annotated_place(result, source, entry)
        properties["line"] = str(place.line)
        if place.column:
            properties["col"] = str(place.column)
    where = failure_place(result.failure) if result.groups else ""
    properties["title"] = f"{result.problem}: {result.verdict.value}" + (f" in {where}" if where else "")
    lines = [_verdict(result), *([] if accepted else _reasons(result))]
    message = _escaped("\n".join(printable(line) for line in lines))
    shown = ",".join(f"{name}={_escaped(printable(text), ':,')}" for name, text in properties.items())
    return f"::{'notice' if accepted else 'error'} {shown}::{message}"


def _verdict(result: Result) -> str:
    return "".join(span.text for row in verdict_lines(result, None) for span in row)


def _reasons(result: Result) -> Iterator[str]:
    failure = result.failure
    if failure:
        yield from _case(failure)
    found = result.counterexample
    if found and found.replay is not None:
        yield "smallest case found:"
        yield from _case(found)
        yield f"again: judge try {found.replay}"
    if result.pitfall:
        for name, advice in zip(result.pitfall.names, result.pitfall.advice, strict=True):
            yield f"likely {name}: {advice}"
    failed = [group.name for group in result.groups if group.verdict is not Verdict.AC]
    if len(failed) > 1:
        yield f"groups that fail: {', '.join(failed)}"


def _case(failure: Failure) -> Iterator[str]:
    if failure.input is not None:
        yield f"input: {arguments(failure.input)}"
    for label, text in (("wanted", failure.expected), ("got", failure.got)):
        if text is not None:
            yield f"{label}: {text}"
    yield f"why: {failure.message}"


def _file(name: str, environment: Mapping[str, str]) -> str:
    """The path from the root of the repository, which is what GitHub shows annotations by."""
    root = environment.get("GITHUB_WORKSPACE")
    try:
        path = Path(name).absolute()
    except OSError:  # the current folder is gone
        return name
    return path.relative_to(root).as_posix() if root and path.is_relative_to(root) else name


def _escaped(text: str, more: str = "") -> str:
    for character in "%\r\n" + more:  # the percent sign first: the others become one
        text = text.replace(character, f"%{ord(character):02X}")
    return text
