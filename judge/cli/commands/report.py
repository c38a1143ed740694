"""`judge report`: the history as one HTML page."""

from __future__ import annotations

import os
from collections.abc import Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING

import click

from judge.cli.options import db_option, json_option, problems_option, write_json
from judge.cli.target import OutFile
from judge.errors import ExitCode, JudgeError, ProblemError, UsageError
from judge.kata.history import History, Run
from judge.problem import Problem
from judge.problem.find import sound_problems
from judge.report.layout import Link, Span, line
from judge.report.names import shown_name
from judge.report.progress import progress
from judge.report.screen import note, out

if TYPE_CHECKING:
    from judge.kata.skills import SkillProgress
    from judge.report.page.known import KnownProblem
    from judge.run.matrix import Matrix

SCHEMA = 1
_USUAL = Path("judge-report.html")
_EPOCH = "SOURCE_DATE_EPOCH"  # the usual way to ask for the same bytes every time


@click.command("report")
@click.option(
    "--out",
    "path",
    metavar="FILE",
    type=click.Path(path_type=Path),
    default=_USUAL,
    help=f"Where to write the page; {_USUAL} in the current folder if not given.",
)
@click.option("--force", is_flag=True, help="Overwrite a file that is no report.")
@click.option("--name", "person", metavar="NAME", default="", help="Whose report it is, for its heading.")
@click.option(
    "--matrix/--no-matrix",
    default=True,
    help="Show which test group catches which mistake; made anew where a problem has changed.",
)
@json_option
@db_option
@problems_option
def command(
    path: Path,
    force: bool,
    person: str,
    matrix: bool,
    as_json: bool,
    db: Path | None,
    folders: tuple[Path, ...],
) -> ExitCode:
    """Write the history as one HTML page.

    It shows what was solved, every run, the time over the attempts, and for each mistake the latest case that
    failed, drawn. The page holds all it shows: it can be sent, printed and kept. A file that is there already
    is overwritten only if it is such a report.

    Exit status: 0 written, 2 usage, 3 a fault of the history or of a problem.
    """
    target = OutFile(path, "--out", "report", _is_report)
    target.check(force=force, remedy="name another file with --out, or overwrite it with --force")
    with History.open(db, reading=True) as history:
        runs = history.runs()
        if not runs:
            remedy = "judge something first: judge run PROBLEM FILE"
            raise UsageError("there are no runs to report", where=str(history.path), remedy=remedy)
        last = {run.problem: run.id for run in runs}
        sources = {name: history.source(number) for name, number in last.items()}
    from judge.report.page.compose import compose_page
    from judge.report.page.render import render

    known = _known(folders, last, matrix=matrix)
    skills = _skills([each.problem for each in known], folders, runs)
    page = render(compose_page(runs, known, sources, skills, generated=_now(), person=person))
    target.write(page)
    _tell(path, page, runs, last, as_json=as_json)
    return ExitCode.ACCEPTED


def _known(folders: Sequence[Path], tried: dict[str, int], *, matrix: bool) -> list[KnownProblem]:
    """Every sound problem, with the mistakes of those that were tried."""
    from judge.mistakes.told import told_mistakes
    from judge.report.page.known import KnownProblem

    found = []
    problems, faults = sound_problems(folders)
    for fault in faults:  # its runs are told of all the same
        note(f"a problem is left out: {fault}")
    for problem in problems:
        if problem.id not in tried:
            found.append(KnownProblem(problem))
            continue
        advice = {name: told.advice for name, told in told_mistakes(problem).items()}
        found.append(KnownProblem(problem, advice, _matrix(problem) if matrix else None))
    return found


def _skills(problems: Sequence[Problem], folders: Sequence[Path], runs: Sequence[Run]) -> list[SkillProgress]:
    """How every skill stands; a checklist that is broken is left out."""
    from judge.kata.skills import assess, skills_of, unknown_skills

    try:
        for fault in unknown_skills(problems, folders):
            note(str(fault))
        skills = skills_of(problems, folders)
    except ProblemError as fault:
        note(f"the checklist is left out: {fault}")
        return []
    return assess(skills, runs, problems)


def _matrix(problem: Problem) -> Matrix | None:
    """The kill matrix, as it is kept or by judging the known-wrong programs now; a fault is but a note."""
    from judge.judging.session import Session

    try:
        with Session(problem, bars=progress) as session:
            matrix, notes = session.naming.matrix()
    except JudgeError as fault:
        note(f"the matrix of {problem.id} is left out: {fault}")
        return None
    for text in (*session.data.notes, *notes):
        note(text)
    return matrix


def _now() -> datetime:
    given = os.environ.get(_EPOCH, "")
    try:
        return datetime.fromtimestamp(int(given), UTC) if given else datetime.now(UTC)
    except (ValueError, OverflowError, OSError):
        remedy = "set it to seconds since 1970, or unset it"
        raise UsageError(f"{given!r} is no time", where=f"${_EPOCH}", remedy=remedy) from None


def _is_report(start: bytes) -> bool:
    from judge.report.page.render import is_report

    return is_report(start)


def _tell(path: Path, page: bytes, runs: Sequence[Run], tried: dict[str, int], *, as_json: bool) -> None:
    if as_json:
        write_json(
            {
                "schema": SCHEMA,
                "out": str(path),
                "bytes": len(page),
                "runs": len(runs),
                "problems": sorted(tried),
            }
        )
        return
    out().show([line(Span(shown_name(str(path)), link=Link(str(path))))])
