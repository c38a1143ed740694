"""`judge report`: the history as one HTML page."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from judge.cli.kept import history_at
from judge.cli.options import db_option, json_option, problems_option, write_json
from judge.cli.target import OutFile, moment
from judge.errors import ExitCode, JudgeError, ProblemError, UsageError
from judge.kata.events import Answer, Hack, Run
from judge.problem import Problem
from judge.problem.find import sound_problems
from judge.report.layout import Link, Span, line
from judge.report.names import shown_name
from judge.report.progress import progress
from judge.report.screen import note, out

if TYPE_CHECKING:
    from judge.kata.progress import Progress
    from judge.report.page.known import KnownProblem
    from judge.run.matrix import Matrix

SCHEMA = 1
_USUAL = Path("judge-report.html")


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
    with history_at(db, reading=True) as history:
        runs = history.runs()
        answers, hacks = history.events(Answer), history.events(Hack)
        if not (runs or answers or hacks):
            remedy = "judge something first: judge run PROBLEM FILE"
            raise UsageError("there is nothing to report", where=str(history.path), remedy=remedy)
        last = {run.problem: run.id for run in runs}
        sources = {name: history.source(number) for name, number in last.items()}
    from judge.report.page.compose import compose_page
    from judge.report.page.render import render

    # What only accepted its own solutions, as README's first command does, has nothing to learn from.
    told = {run.problem for run in runs if run.counts or not run.whole}
    known = _known(folders, told, matrix=matrix)
    learned = _progress([each.problem for each in known], folders, db)
    page = render(
        compose_page(
            runs,
            known,
            sources,
            learned.skills,
            ready=learned.sections,
            answers=answers,
            hacks=hacks,
            generated=moment(),
            person=person,
        )
    )
    target.write(page)
    _tell(path, page, runs, last, as_json=as_json)
    return ExitCode.ACCEPTED


def _known(folders: Sequence[Path], told: Collection[str], *, matrix: bool) -> list[KnownProblem]:
    """Every sound problem, with the mistakes of those that are told of."""
    from judge.mistakes.told import told_mistakes
    from judge.report.page.known import KnownProblem

    found = []
    problems, faults = sound_problems(folders)
    for fault in faults:  # its runs are told of all the same
        note(f"a problem is left out: {fault}")
    for problem in problems:
        if problem.id not in told:
            found.append(KnownProblem(problem))
            continue
        advice = {name: told.advice for name, told in told_mistakes(problem).items()}
        found.append(KnownProblem(problem, advice, _matrix(problem) if matrix else None))
    return found


def _progress(problems: Sequence[Problem], folders: Sequence[Path], db: Path | None) -> Progress:
    """What was learned; nothing where a file of skills or questions is broken."""
    from judge.kata.checklist import unknown_skills
    from judge.kata.progress import Progress, read_progress

    try:
        with history_at(db, reading=True) as history:
            found, faults = read_progress(history, problems, folders)
        for fault in (*unknown_skills(problems, folders), *faults):
            note(str(fault))
    except ProblemError as fault:
        note(f"skills and questions are left out: {fault}")
        return Progress({}, (), ())
    return found


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
