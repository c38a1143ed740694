"""Results for other programs: JUnit XML, GitHub's annotations, and lines that editors read.

    ::error file=FILE,line=LINE,col=COLUMN,title=TITLE::MESSAGE     GitHub; `::notice` where it is accepted
    FILE:LINE:COLUMN: error: MESSAGE                                 editors, as compilers write them
    FILE:LINE:COLUMN: note: MESSAGE                                  the smallest case, and the mistake

A line that begins with `::` is a command to GitHub, so nothing of a submission may begin one. In JUnit a
submission is a suite and a test group a case; only elements and attributes that both Jenkins and Surefire
declare are used. Times are CPU seconds.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from judge.problem.model import Problem, Verdict
from judge.report.tell import annotated_place, place_of, tell
from judge.report.words import counted, printable, shown_name
from judge.run.result import Result

# -- editors -------------------------------------------------------------------------------------------------


def editor_lines(result: Result, source: bytes, problem: Problem | None) -> Iterator[str]:
    """The lines for one submission; each is one line, whatever a submission said."""
    told, name = tell(problem, result, source), shown_name(result.submission)
    if result.verdict is Verdict.AC:
        yield printable(f"{name}: AC  {told.last}")
        return
    place = annotated_place(result, source, problem.entry if problem else "")
    where = f"{name}:{place.line}:{place.column or 1}"
    why = told.happened if result.hurdle else result.failure.message if result.failure else told.last
    group = f" in {place_of(result.failure)}" if place_of(result.failure) else ""
    yield printable(f"{where}: error: {result.verdict.value}{group}: {why}")
    if result.counterexample is not None and told.input:
        got = ", ".join(f"{label} {text}" for label, text in told.facts if label in ("expected", "got"))
        yield printable(f"{where}: note: {told.case}: {', '.join(told.input)}: {got}")
    if told.mistake:
        yield printable(f"{where}: note: {' '.join((f'{told.mistake}.', *told.advice))}")


# -- GitHub --------------------------------------------------------------------------------------------------


def annotation(result: Result, source: bytes, problem: Problem | None, environment: Mapping[str, str]) -> str:
    """The command for one submission: an error, or a notice where it is accepted."""
    told, accepted = tell(problem, result, source), result.verdict is Verdict.AC
    properties = {"file": _file(result.submission, environment)}
    if result.verdict is not Verdict.JE:
        place = annotated_place(result, source, problem.entry if problem else "")
        properties |= {"line": str(place.line), **({"col": str(place.column)} if place.column else {})}
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
    from judge.report.html import rendered

    suites = []
    for result in results:
        cases = [*_cases(result)]
        suites.append((result, cases, sum(bool(lines) for *_, lines in cases)))
    time = sum(result.time.cpu_seconds for result in results)
    rejected = sum(count for *_, count in suites)
    errors = sum(count for result, _, count in suites if result.verdict is Verdict.JE)
    tests = sum(len(cases) for _, cases, _ in suites)
    counts = {"tests": tests, "failures": rejected - errors, "errors": errors}
    return rendered("junit.xml.j2", suites=suites, time=time, **counts)


def _cases(result: Result) -> Iterator[tuple[str, float, Verdict, str, list[str]]]:
    """A test group's name and CPU seconds; why it is rejected: in a line, and at length."""
    told, failure, verdict = tell(None, result), result.failure, result.verdict
    for group in result.groups:
        passed = f"{group.passed:,} of {counted(group.cases, 'case')} pass"
        if group.verdict is Verdict.AC:
            yield group.name, group.cpu_seconds, group.verdict, "", []
        elif failure is not None and failure.group == group.name:
            why = [passed, failure.message, *told.lines]
            yield group.name, group.cpu_seconds, verdict, f"{place_of(failure)}: {failure.message}", why
        else:
            yield group.name, group.cpu_seconds, group.verdict, f"{group.verdict.meaning}: {passed}", [passed]
    if not result.groups:
        message = failure.message if failure else verdict.meaning
        yield "judge" if verdict is Verdict.JE else "compile", 0, verdict, message, [verdict.meaning, message]
