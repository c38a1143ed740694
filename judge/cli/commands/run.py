"""`judge run`: judge submissions on a problem."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from judge.cli.fitting import assigned, split
from judge.cli.judging_options import (
    PROGRAM,
    TEXT,
    all_option,
    chosen_format,
    follow_links_option,
    format_option,
    isolation_option,
    jobs_option,
    junit_option,
    mode_option,
    no_history_option,
    no_name_option,
    no_shrink_option,
    picture_option,
    svg_option,
)
from judge.cli.kata import file_in_hand, problem_of
from judge.cli.options import (
    db_option,
    group_option,
    json_option,
    level_option,
    problems_option,
    seed_option,
)
from judge.cli.outputs import OnScreen, Outputs
from judge.cli.submissions import gathered
from judge.cli.target import check_svg
from judge.cli.wish import Wish, named_problem
from judge.errors import ExitCode
from judge.judging.job import RunOptions
from judge.problem.model import chosen_groups


@click.command("run")
@click.argument("first", metavar="[[PROBLEM]", required=False)
@click.argument("rest", metavar="FILE...]", nargs=-1)
@json_option
@format_option
@junit_option
@click.option("-q", "--quiet", is_flag=True, help="Only the verdicts, one line a submission.")
@all_option
@picture_option
@group_option
@level_option
@seed_option
@no_name_option
@jobs_option
@isolation_option
@follow_links_option
@mode_option
@no_shrink_option
@svg_option
@no_history_option
@db_option
@problems_option
def command(
    first: str | None,
    rest: tuple[str, ...],
    as_json: bool,
    form: str | None,
    junit: Path | None,
    quiet: bool,
    whole: bool,
    pictured: bool,
    groups: tuple[str, ...],
    kata_level: str | None,
    seed: int | None,
    no_name: bool,
    jobs: int,
    level: str | None,
    follow_links: bool,
    mode: str | None,
    unshrunk: bool,
    svg: Path | None,
    unrecorded: bool,
    db: Path | None,
    folders: tuple[Path, ...],
) -> ExitCode:
    """Judge submissions on a problem.

    Without arguments: the file of your current kata. A PROBLEM alone means its file in this folder, such as
    count.py. A FILE alone says its problem by the function that it defines, by the first line of its stub,
    or by its name. A first word that is a problem's name is the problem: write ./count for a file of that
    name. A folder stands for every *.py in it and below. Files of several problems are judged one by one.

    If a FILE defines the problem's function, that is called. Any other file is run as a program that reads
    standard input.

    Of several files, one that cannot be read or fits no problem is a row of the table (JE). Ctrl-C shows the
    table so far.

    Exit status: 0 all accepted, 1 not accepted, 2 usage, 3 a fault of the judge or of a problem.
    """
    from judge.cli.judging import all_judged

    current = None
    if first is not None:
        name, files = split((first, *rest), "run", folders, db)
    else:
        current, file = file_in_hand(db)
        name, files = current.problem, (file,)
    form = chosen_format(form, as_json=as_json)
    show = Outputs(form, OnScreen(quiet, not unrecorded, whole, pictured), junit)
    try:
        problem = None
        if name is not None:
            problem = problem_of(current, folders) if current else named_problem(name, folders)
        submissions, unread = gathered(files, problem.id if problem else "", follow=follow_links)
        tasks, unfit = assigned(submissions, problem, folders, db)
        total = show.expect(tasks, [*unread, *unfit])
        if svg is not None:
            check_svg(svg, total)
        for task in tasks:
            chosen_groups(
                task.problem, groups, kata_level
            )  # a name that is none is told before anything is built
        options = RunOptions(
            groups,
            seed,
            level,
            diagnosed=not (unshrunk or (quiet and svg is None)),
            named=not (no_name or (quiet and show.on_screen)),
            level=kata_level,
            program=mode == PROGRAM,
        )
        wish = Wish(options, jobs, kept=not unrecorded, db=db, total=total)
        for drawing in all_judged(tasks, wish, show, silent=quiet and show.on_screen):
            show.result(drawing.result, several=total > 1, drawing=drawing)
            drawing.save(svg)
            if drawing.result.isolation == "strong" and not (level or quiet) and form == TEXT:
                _say_that_full_is_missing()
    except KeyboardInterrupt:
        show.close(interrupted=True)
        raise
    except Exception as fault:
        show.fail(name or "", files, fault)
        raise
    return show.close()


def _say_that_full_is_missing() -> None:
    """Once a day, to a person who has not been told so by `judge doctor`."""
    from judge.judging.isolation import first_today, kept_level
    from judge.report.screen import is_terminal, note

    if is_terminal(sys.stderr) and kept_level() is None and first_today():
        note("isolation is 'strong', not 'full'; 'judge doctor' says why and what to do")
