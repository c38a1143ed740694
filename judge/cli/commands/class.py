"""`judge class`: judge what a class has handed in."""

from __future__ import annotations

from contextlib import AbstractContextManager, nullcontext
from pathlib import Path
from typing import TYPE_CHECKING

import click

from judge.cli.judging_options import (
    follow_links_option,
    isolation_option,
    jobs_option,
    junit_option,
    no_name_option,
)
from judge.cli.options import json_option, level_option, problems_option
from judge.errors import ExitCode, UsageError
from judge.judging.job import RunOptions

if TYPE_CHECKING:
    from collections.abc import Callable

    from judge.judging.executors import Executor


@click.command("class")
@click.argument("folder", metavar="FOLDER", type=click.Path(path_type=Path))
@click.argument("more", metavar="[STORE...]", nargs=-1, type=click.Path(path_type=Path))
@click.option(
    "--students",
    metavar="LIST",
    type=click.Path(path_type=Path),
    help="A CSV file of the class, with the columns id, name and group.",
)
@jobs_option
@click.option(
    "--on",
    "where",
    metavar="WHERE",
    help="Judge with the workers of a dask scheduler: tls://HOST:PORT or FILE. See 'judge help class'.",
)
@click.option(
    "--out",
    "place",
    metavar="STORE",
    type=click.Path(path_type=Path),
    help="Keep the results in this file, instead of FOLDER.judge.sqlite3.",
)
@click.option("--problem", "only", metavar="PROBLEM", multiple=True, help="Only this problem; repeatable.")
@click.option(
    "--again",
    metavar="WHOSE",
    multiple=True,
    help="Judge a student, a problem or one file again; repeatable.",
)
@follow_links_option
@no_name_option
@level_option
@isolation_option
@click.option("--shard", metavar="K/N", help="Judge only part K of N; the parts need no contact.")
@click.option(
    "--merge",
    "part",
    metavar="STORE",
    type=click.Path(path_type=Path),
    help="Put the results of shards together instead of judging: --merge *-of-20.sqlite3.",
)
@json_option
@click.option("-q", "--quiet", is_flag=True, help="Only the table.")
@click.option("--all", "whole", is_flag=True, help="Show the whole cohort; with --json, as a last object.")
@click.option(
    "--csv",
    "csv",
    metavar="FILE",
    type=click.Path(path_type=Path),
    help="Write the gradebook, a line a student.",
)
@click.option(
    "--html",
    "html",
    metavar="FILE",
    type=click.Path(path_type=Path),
    help="Write one page of it all, with a picture of each mistake.",
)
@click.option(
    "--feedback",
    "feedback",
    metavar="DIR",
    type=click.Path(path_type=Path),
    help="Write a page for each student into this folder.",
)
@junit_option
@click.option(
    "--similar",
    metavar="DETECTOR",
    type=click.Choice(["dolos"]),
    help="Write what the detector dolos reads, and run it if it is installed.",
)
@problems_option
def command(
    folder: Path,
    more: tuple[Path, ...],
    students: Path | None,
    jobs: int,
    where: str | None,
    place: Path | None,
    only: tuple[str, ...],
    again: tuple[str, ...],
    follow_links: bool,
    no_name: bool,
    kata_level: str | None,
    level: str | None,
    shard: str | None,
    part: Path | None,
    as_json: bool,
    quiet: bool,
    whole: bool,
    csv: Path | None,
    html: Path | None,
    feedback: Path | None,
    junit: Path | None,
    similar: str | None,
    folders: tuple[Path, ...],
) -> ExitCode:
    """Judge what a class has handed in.

    FOLDER holds STUDENT/PROBLEM.py or PROBLEM/STUDENT.py, in any language. A file of another name is for the
    problem whose function it defines. Each row is kept at once in FOLDER.judge.sqlite3: after Ctrl-C or a
    crash the same command goes on, and judges only what is new. If a student has several files for one
    problem, the best counts. Equal files are judged once.

    Exit status: 0 all accepted, 1 not, 2 usage, 3 something could not be judged.
    """
    from judge.batch.folder import root_of
    from judge.batch.shards import Shard
    from judge.batch.store import Store
    from judge.cli.class_views import Views
    from judge.cli.classroom import Classroom, Wanted
    from judge.problem.find import find_problem

    if more and part is None:
        raise UsageError("a class is one folder", where=str(more[0]), remedy="judge one after another")
    parts = (part, *more) if part is not None else ()
    if shard is not None and parts:
        raise UsageError("--shard and --merge contradict each other", remedy="leave one out")
    if where is not None and (parts or jobs > 1):
        remedy = "leave one out"
        raise UsageError(f"--on and {'--merge' if parts else '-j'} contradict each other", remedy=remedy)
    root_of(folder)  # before a file is made beside it
    views = Views(csv, html, feedback, junit, similar, whole)
    if shard is not None and views.any_file:
        remedy = "give these options with --merge, when all parts are there"
        raise UsageError("a shard is no whole class", where="--shard", remedy=remedy)
    views.check()
    for each in only:
        find_problem(each, folders)
    options = RunOptions((), None, level, diagnosed=False, named=not no_name, level=kata_level)
    wanted = Wanted(
        folder,
        options,
        students=students,
        out=place,
        only=only,
        again=again,
        folders=folders,
        shard=Shard.read(shard) if shard is not None else None,
        parts=parts,
        as_json=as_json,
        quiet=quiet,
        follow=follow_links,
    )
    with Store.open(wanted.place) as store:
        classroom = Classroom(wanted, store)
        try:
            if parts:
                classroom.merge()
            else:
                with _executor(where, jobs, level, classroom.say) as executor:
                    classroom.judge(executor)
        except KeyboardInterrupt:
            classroom.close(interrupted=True)
            raise
        found = classroom.close()
        classroom.show_views(views, found)
        return found.exit_code


def _executor(
    where: str | None, jobs: int, level: str | None, say: Callable[[str], None]
) -> AbstractContextManager[Executor]:
    """Who judges: this machine, or others."""
    if where is not None:
        from judge.batch.elsewhere import Elsewhere

        return Elsewhere(where, level, say)
    from judge.judging.executors import Here
    from judge.judging.processes import Processes

    return nullcontext(Processes(jobs) if jobs > 1 else Here())
