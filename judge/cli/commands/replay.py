"""`judge replay`: judge a submission on one case, named by its replay id."""

from __future__ import annotations

from pathlib import Path

import click
from msgspec.structs import replace

from judge.cli.fitting import usual_file
from judge.cli.judging_options import isolation_option
from judge.cli.options import db_option, json_option, problems_option, write_json
from judge.cli.submissions import read_submissions
from judge.errors import ExitCode, UsageError
from judge.judging.job import RunOptions
from judge.judging.session import Session
from judge.problem.find import find_problem
from judge.report.glance import glance_lines, screen_rows
from judge.report.layout import Span, hanging
from judge.report.obstacle import obstacle_text
from judge.report.results import verdict_lines
from judge.report.screen import Notes, out


@click.command("replay")
@click.argument("replay", metavar="ID")
@click.argument("file", metavar="[FILE]", required=False)
@json_option
@isolation_option
@db_option
@problems_option
def command(
    replay: str,
    file: str | None,
    as_json: bool,
    level: str | None,
    db: Path | None,
    folders: tuple[Path, ...],
) -> ExitCode:
    """Judge a submission on one case, by its replay id.

    `judge run` shows the id of the smallest failing case. It works on any machine with the same version of
    the problem. Without a FILE: the problem's usual file in this folder, or that of your current kata.

    Exit status: as for `judge run`.
    """
    from judge.diagnose.replay import problem_name
    from judge.judging.replaying import replayed

    name = problem_name(replay)
    file = file or usual_file(name, "replay ID", db)
    submissions = read_submissions([file])
    if len(submissions) > 1:
        raise UsageError("this folder holds several submissions", where=file, remedy="name one file")
    (submission,) = submissions
    source, called = submission.source, submission.name
    with Session(find_problem(name, folders), RunOptions(isolation=level)) as session:
        result = replayed(session, replay, source, called)
    Notes().say(result.notes)
    if as_json:
        write_json(result.as_json())
    else:
        screen = out()
        text = obstacle_text(result, result.hurdle, session.problem) if result.hurdle else ""
        hurdle = hanging(Span(""), Span(text), screen.width, indent=2, column=2) if text else []
        last = verdict_lines(result, screen.width)
        alone = replace(result, groups=())  # a table of one row
        screen.show(glance_lines(alone, screen.width, screen_rows(screen), hurdle=hurdle, verdict=last))
    return result.exit_code
