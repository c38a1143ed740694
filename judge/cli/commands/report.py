"""`judge report`: the history as one HTML page."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from judge.cli.kept import history_at
from judge.cli.options import db_option, json_option, problems_option, write_json
from judge.cli.target import OutFile, moment
from judge.errors import ExitCode, ProblemError, UsageError
from judge.problem import Problem
from judge.problem.find import sound_problems
from judge.report.layout import Link, Span, line
from judge.report.names import shown_name
from judge.report.screen import note, out

if TYPE_CHECKING:
    from judge.kata.progress import SkillProgress

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
@click.option("--force", is_flag=True, help="Overwrite a file that is not a report.")
@click.option("--name", "person", metavar="NAME", default="", help="Whose report it is, for its heading.")
@json_option
@db_option
@problems_option
def command(
    path: Path,
    force: bool,
    person: str,
    as_json: bool,
    db: Path | None,
    folders: tuple[Path, ...],
) -> ExitCode:
    """Write the history as one HTML page.

    It shows what you have solved, the skills that your runs have shown, every run, and for each mistake the
    latest case that failed, drawn. The page holds all it shows: you can send it, print it and keep it. An
    existing file is overwritten only if it is such a report.

    Exit status: 0 written, 2 usage, 3 a fault of the history or of a problem.
    """
    target = OutFile(path, "--out", "report", _is_report)
    target.check(force=force, remedy="name another file with --out, or overwrite it with --force")
    with history_at(db, reading=True) as history:
        runs = [run for run in history.runs() if run.counts]
        if not runs:
            remedy = "judge a file of yours first: judge run FILE"
            raise UsageError("it holds no run of your own", where=str(history.path), remedy=remedy)
        solved = {run.problem: run.id for run in runs if run.solved}
        sources = {name: history.source(number) for name, number in solved.items()}
    from judge.report.html.learner import learner_page

    problems, faults = sound_problems(folders)
    for fault in faults:  # its runs are shown all the same
        note(f"a problem is left out: {fault}")
    skills = _skills(problems, folders, db)
    generated = moment().astimezone()
    page = learner_page(runs, problems, skills, sources, person=person, generated=generated)
    target.write(page)
    if as_json:
        tried = sorted({run.problem for run in runs})
        told = {"schema": SCHEMA, "out": str(path), "bytes": len(page), "runs": len(runs), "problems": tried}
        write_json(told)
    else:
        out().show([line(Span(shown_name(str(path)), link=Link(str(path))))])
    return ExitCode.ACCEPTED


def _skills(problems: Sequence[Problem], folders: Sequence[Path], db: Path | None) -> Sequence[SkillProgress]:
    """How every skill stands; none where a file of skills or questions is broken."""
    from judge.kata.checklist import unknown_skills
    from judge.kata.progress import read_progress

    try:
        for fault in unknown_skills(problems, folders):
            note(str(fault))
        with history_at(db, reading=True) as history:
            return read_progress(history, problems, folders)[0].skills
    except ProblemError as fault:
        note(f"the skills are left out: {fault}")
        return ()


def _is_report(start: bytes) -> bool:
    from judge.report.html import is_page
    from judge.report.html.learner import MARK

    return is_page(start, MARK)
