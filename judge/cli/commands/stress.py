"""`judge stress`: judge a submission on fresh cases until the time is up or something breaks."""

from __future__ import annotations

import math
import random
from collections.abc import Sequence
from pathlib import Path

import click

from judge.cli.duration import duration
from judge.cli.fitting import problem_of_file, split
from judge.cli.judging_options import (
    isolation_option,
    no_name_option,
    no_shrink_option,
    picture_option,
    svg_option,
)
from judge.cli.options import group_option, json_option, level_option, problems_option, write_json
from judge.cli.picture import Drawing
from judge.cli.submissions import Submission, read_submissions
from judge.cli.target import check_svg
from judge.cli.wish import named_problem
from judge.data.model import ProblemData
from judge.errors import ExitCode, JudgeError, UsageError
from judge.judging.job import RunOptions
from judge.judging.session import Session
from judge.judging.stressing import Stressing
from judge.problem import Verdict
from judge.problem.model import chosen_groups
from judge.report.glance import screen_rows
from judge.report.layout import Line
from judge.report.progress import progress, stages
from judge.report.screen import Notes, out
from judge.report.stress import stress_lines
from judge.run.result import judge_fault
from judge.run.stress import Stressed

_SEEDS = 10**9  # a fresh seed is below it: short enough to be typed again


@click.command("stress")
@click.argument("first", metavar="PROBLEM|FILE")
@click.argument("second", metavar="[FILE]", required=False)
@click.option(
    "--for",
    "seconds",
    callback=duration,
    default="30s",
    metavar="TIME",
    show_default=True,
    help="How long: 30, 30s, 2m, 1h.",
)
@json_option
@picture_option
@group_option
@level_option
@click.option("--seed", type=int, metavar="N", help="Repeat the cases of this seed; new ones by default.")
@no_name_option
@isolation_option
@no_shrink_option
@svg_option
@problems_option
def command(
    first: str,
    second: str | None,
    seconds: float,
    as_json: bool,
    pictured: bool,
    groups: tuple[str, ...],
    kata_level: str | None,
    seed: int | None,
    no_name: bool,
    level: str | None,
    unshrunk: bool,
    svg: Path | None,
    folders: tuple[Path, ...],
) -> ExitCode:
    """Judge a submission on fresh cases until the time is up or something breaks.

    The file says its problem, and a problem its usual file, as for judge run.

    The test groups take turns. Each makes new cases, drawn from the seed, and each case is checked and solved
    exactly. A failing case is made smaller and shown as in `judge run`.

    Ctrl-C ends it early and keeps what was found.

    Exit status: 0 the time was up and nothing failed, 1 something failed, 2 usage, 3 a fault of the judge or
    of the problem, 130 interrupted before anything failed.
    """
    seed = random.randrange(_SEEDS) if seed is None else seed
    words = (first,) if second is None else (first, second)
    name, (file, *more) = split(words, "stress", folders, None)
    if more:
        raise UsageError("judge stress takes one file", where=more[0], remedy="name one FILE")
    submission: Submission | None = None
    try:
        problem = named_problem(name, folders) if name is not None else None
        submission = _submission(file)
        problem = problem or problem_of_file(submission, "stress", folders, None)
        if svg is not None:
            check_svg(svg, 1)
        chosen = chosen_groups(problem, groups, kata_level)
        options = RunOptions(
            groups,
            isolation=level,
            diagnosed=not unshrunk,
            named=not no_name,
            level=kata_level,
        )
        stressing = Stressing(submission.source, submission.name, chosen, seed, seconds)
        with Session(problem, options, bars=progress) as session:
            stressed = _stressed(stressing, session)
        data = ProblemData(problem, ())
        said = Notes()
        said.say(stressed.result.notes)
    except JudgeError as fault:
        if as_json and not isinstance(fault, UsageError):  # a script misses none
            judged = submission or _submission(file)
            write_json(Stressed(judge_fault(name or "", judged.name, str(fault)), seed, 0.0).as_json())
        raise
    drawing = Drawing(problem, data, stressed.result)
    if as_json:
        write_json(stressed.as_json())
    else:
        screen = out()
        rows, hurdle = screen_rows(screen), drawing.hurdle(screen.width)

        def report(drawn: Sequence[Line]) -> list[Line]:
            return stress_lines(stressed, screen.width, rows, hurdle=hurdle, drawing=drawn)

        screen.show(drawing.beside(report, screen, wanted=pictured))
    drawing.save(svg)
    if stressed.interrupted and stressed.result.verdict is Verdict.AC:
        return ExitCode.INTERRUPTED
    return stressed.result.exit_code


def _submission(file: str) -> Submission:
    submissions = read_submissions([file])
    if len(submissions) > 1:
        raise UsageError("this folder holds several submissions", where=file, remedy="name one file")
    return submissions[0]


def _stressed(stressing: Stressing, session: Session) -> Stressed:
    """What it comes to, with a bar while it goes on."""
    whole = math.ceil(stressing.seconds)
    with stages(Path(stressing.name).name) as stage:

        def tell(cases: int, seconds: float) -> None:
            if stage:
                stage(f"{cases:,} cases, {cases / seconds:,.0f} a second", min(int(seconds), whole), whole)

        return stressing.run(session, tell)
