"""Results as JUnit XML, the form that CI servers read: a suite for each submission, a case for each group.

    testsuites
    └── testsuite                 a submission; errors counts what is the judge's own fault (JE)
        ├── properties            verdict, score, levels, mode, isolation, memory, ratio, mistake
        └── testcase              a test group; `compile` or `judge` where nothing could be run
            └── failure | error   its verdict as the type; the case, what was wanted and what was given

Only elements and attributes that both Jenkins and Surefire declare are used. Times are CPU seconds.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from xml.etree import ElementTree as Xml

from judge.problem.model import Verdict
from judge.report.layout import printable
from judge.report.levels import level_share
from judge.report.results import counterexample_lines, failure_lines, failure_place, pitfall_lines
from judge.report.values import counted
from judge.run.result import GroupResult, Result


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
    suite = Xml.Element("testsuite", {"name": printable(f"{result.problem} {result.submission}")})
    properties = Xml.SubElement(suite, "properties")
    for name, value in _properties(result):
        Xml.SubElement(properties, "property", {"name": name, "value": printable(value)})
    # Jenkins takes what is before the last dot for the package: the problem.
    classname = printable(f"{result.problem}.{result.submission.replace('.', '_')}")
    cases = [_case(result, group, classname) for group in result.groups]
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


def _case(result: Result, group: GroupResult, classname: str) -> Xml.Element:
    case = Xml.Element(
        "testcase", {"name": group.name, "classname": classname, "time": _time(group.cpu_seconds)}
    )
    if group.verdict is not Verdict.AC:
        passed = f"{group.passed:,} of {counted(group.cases, 'case')} passed"
        failure = result.failure
        if failure is not None and failure.group == group.name:
            _rejected(case, result, f"{failure_place(failure)}: {failure.message}", [passed, *_shown(result)])
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


def _shown(result: Result) -> Iterator[str]:
    """The failing case, the smallest one and the mistake, as the screen has them."""
    rows = list(failure_lines(result.failure, None)) if result.failure else []
    if result.counterexample:
        rows += counterexample_lines(result, result.counterexample, None)
    if result.pitfall:
        rows += pitfall_lines(result.pitfall, None)
    return ("".join(span.text for span in row) for row in rows)


def _time(seconds: float) -> str:
    return f"{seconds:.3f}"  # Surefire takes three decimals and no exponent
