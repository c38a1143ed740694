"""Results for other programs: JUnit XML, GitHub's annotations, and lines that editors read.

    ::error file=FILE,line=LINE,col=COLUMN,title=TITLE::MESSAGE     GitHub; `::notice` where it is accepted
    FILE:LINE:COLUMN: error: MESSAGE                                 editors, as compilers write them
    FILE:LINE:COLUMN: note: MESSAGE                                  the smallest case, and the mistake

A line that begins with `::` is a command to GitHub, so nothing of a submission may begin one. In JUnit a
submission is a suite and a test group a case; only elements and attributes that both Jenkins and Surefire
declare are used. Times are CPU seconds.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from xml.etree import ElementTree as Xml

from judge.problem.model import Verdict
from judge.report.tell import Told, annotated_place, level_share, place_of, tell
from judge.report.words import counted, printable, shown_name
from judge.run.result import GroupResult, Result

# -- editors -------------------------------------------------------------------------------------------------


def editor_lines(result: Result, source: bytes, entry: str) -> Iterator[str]:
    """The lines for one submission; each is one line, whatever a submission said."""
    told, name = tell(None, result, source), shown_name(result.submission)
    if result.verdict is Verdict.AC:
        yield printable(f"{name}: AC  {told.last}")
        return
    place = annotated_place(result, source, entry)
    where = f"{name}:{place.line}:{place.column or 1}"
    why = result.failure.message if result.failure else told.last
    group = f" in {place_of(result.failure)}" if place_of(result.failure) else ""
    yield printable(f"{where}: error: {result.verdict.value}{group}: {why}")
    if result.counterexample is not None and told.input:
        got = ", ".join(f"{label} {text}" for label, text in told.facts if label in ("expected", "got"))
        yield printable(f"{where}: note: {told.case}: {', '.join(told.input)}: {got}")
    if told.mistake:
        yield printable(f"{where}: note: {' '.join((f'{told.mistake}.', *told.advice))}")


# -- GitHub --------------------------------------------------------------------------------------------------


def annotation(result: Result, source: bytes, entry: str, environment: Mapping[str, str]) -> str:
    """The command for one submission: an error, or a notice where it is accepted."""
    told, accepted = tell(None, result, source), result.verdict is Verdict.AC
    properties = {"file": _file(result.submission, environment)}
    if result.verdict is not Verdict.JE:
        place = annotated_place(result, source, entry)
        properties["line"] = str(place.line)
        if place.column:
            properties["col"] = str(place.column)
    where = place_of(result.failure)
    properties["title"] = f"{result.problem}: {result.verdict.value}" + (f" in {where}" if where else "")
    message = _escaped("\n".join(printable(line) for line in [told.last, *told.lines]))
    shown = ",".join(f"{name}={_escaped(printable(text), ':,')}" for name, text in properties.items())
    return f"::{'notice' if accepted else 'error'} {shown}::{message}"


def _file(name: str, environment: Mapping[str, str]) -> str:
    """The path from the root of the repository, which is what GitHub shows annotations by."""
    root = environment.get("GITHUB_WORKSPACE")
    try:
        path = Path(name).absolute()
    except OSError:  # the current folder is gone
        return name
    return path.relative_to(root).as_posix() if root and path.is_relative_to(root) else name


def _escaped(text: str, more: str = "") -> str:
    """As GitHub's own toolkit escapes it."""
    for character in "%\r\n" + more:  # the percent sign first: the others become one
        text = text.replace(character, f"%{ord(character):02X}")
    return text


# -- JUnit ---------------------------------------------------------------------------------------------------


def junit(results: Sequence[Result]) -> bytes:
    """The document, in UTF-8."""
    root = Xml.Element("testsuites", {"name": "judge"})
    for result in results:
        root.append(_suite(result))
    for name in ("tests", "failures", "errors"):
        root.set(name, str(sum(int(suite.get(name, "0")) for suite in root)))
    root.set("time", _time(sum(result.time.cpu_seconds for result in results)))
    Xml.indent(root)
    text = Xml.tostring(root, encoding="unicode")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{text}\n'.encode()


def _suite(result: Result) -> Xml.Element:
    suite, told = (
        Xml.Element("testsuite", {"name": printable(f"{result.problem} {result.submission}")}),
        tell(None, result),
    )
    properties = Xml.SubElement(suite, "properties")
    for name, value in _properties(result):
        Xml.SubElement(properties, "property", {"name": name, "value": printable(value)})
    # Jenkins takes what is before the last dot for the package: the problem.
    classname = printable(f"{result.problem}.{result.submission.replace('.', '_')}")
    cases = [_case(result, told, group, classname) for group in result.groups]
    suite.extend(cases or [_nothing_run(result, classname)])
    suite.set("tests", str(len(cases) or 1))
    suite.set("failures", str(len(suite.findall("testcase/failure"))))
    suite.set("errors", str(len(suite.findall("testcase/error"))))
    suite.set("skipped", "0")
    suite.set("time", _time(result.time.cpu_seconds))
    return suite


def _properties(result: Result) -> Iterator[tuple[str, str]]:
    yield "problem", result.problem
    yield "submission", result.submission
    yield "verdict", result.verdict.value
    yield "score", str(result.score)
    for each in result.levels:
        yield f"{each.level.value}_level", level_share(each)
    yield "mode", result.mode.value
    if result.isolation:
        yield "isolation", result.isolation
    yield "memory_bytes", str(result.memory_bytes)
    yield "cpu_seconds", f"{result.time.cpu_seconds:.6f}"
    yield "wall_seconds", f"{result.time.wall_seconds:.6f}"
    if result.time.ratio:
        yield "ratio", f"{result.time.ratio.median:.3f}"
    if result.pitfall:
        yield "pitfall", result.pitfall.name


def _case(result: Result, told: Told, group: GroupResult, classname: str) -> Xml.Element:
    attributes = {"name": group.name, "classname": classname, "time": _time(group.cpu_seconds)}
    case = Xml.Element("testcase", attributes)
    if group.verdict is not Verdict.AC:
        passed = f"{group.passed:,} of {counted(group.cases, 'case')} pass"
        failure = result.failure
        if failure is not None and failure.group == group.name:
            message = f"{place_of(failure)}: {failure.message}"
            _rejected(case, result, message, [passed, failure.message, *told.lines])
        else:
            _rejected(case, result, f"{group.verdict.meaning}: {passed}", [passed], group.verdict)
    return case


def _nothing_run(result: Result, classname: str) -> Xml.Element:
    name = "judge" if result.verdict is Verdict.JE else "compile"
    case = Xml.Element("testcase", {"name": name, "classname": classname, "time": _time(0.0)})
    message = result.failure.message if result.failure else result.verdict.meaning
    _rejected(case, result, message, [result.verdict.meaning, message])
    return case


def _rejected(
    case: Xml.Element, result: Result, message: str, lines: Sequence[str], verdict: Verdict | None = None
) -> None:
    kind = "error" if result.verdict is Verdict.JE else "failure"
    attributes = {"type": (verdict or result.verdict).value, "message": printable(message)}
    # A backspace or half a surrogate pair has no form in XML at all, not even as an entity: written out.
    Xml.SubElement(case, kind, attributes).text = "\n".join(printable(line) for line in lines)


def _time(seconds: float) -> str:
    return f"{seconds:.3f}"  # Surefire takes three decimals and no exponent


_FORMULA = re.compile(r"""(^|[;,"'|\t])(\s*)(?=[=+\-@＝＋－＠])""")


def csv_text(rows: Iterable[Iterable[object]], end: str = "\r\n") -> str:
    """The rows, each with that end; what is no text is written as it is."""
    written = io.StringIO()
    writer = csv.writer(written, quoting=csv.QUOTE_ALL, lineterminator=end)
    writer.writerows([cell(each) if isinstance(each, str) else each for each in row] for row in rows)
    return written.getvalue()


def cell(text: str) -> str:
    """Text as a cell that no spreadsheet calculates; control characters are written out."""
    return _FORMULA.sub(r"\1\2'", printable(text))
