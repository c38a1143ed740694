"""`judge run`: judge submissions on a problem."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from contextlib import closing, nullcontext
from functools import partial
from pathlib import Path

import click
from msgspec import Struct
from msgspec.structs import replace

from judge.cli.containment import Containment, isolation_option, jobs_option
from judge.cli.diagnosis import Diagnosis, no_shrink_option, save_regression_option
from judge.cli.kata import file_in_hand
from judge.cli.naming import Naming
from judge.cli.options import (
    chosen_groups,
    db_option,
    group_option,
    json_option,
    problems_option,
    seed_option,
)
from judge.cli.outputs import Outputs, chosen_format, format_option, junit_option
from judge.cli.picture import Drawing, check_svg, svg_option
from judge.cli.recording import Recording, no_history_option
from judge.cli.submissions import Submission, read_submissions
from judge.data import ProblemData, load_data
from judge.errors import ExitCode, JudgeError, UsageError
from judge.report.kata import pointer_lines
from judge.report.layout import line
from judge.report.progress import progress
from judge.report.results import lines_beside, result_lines, summary_lines, verdict_lines
from judge.report.screen import note, out
from judge.run import Result, Settings, exit_code, judge_fault, run_submission
from judge.run.parallel import in_order
from judge.spec import Problem
from judge.spec.find import find_problem


@click.command("run")
@click.argument("name", metavar="[PROBLEM", required=False)
@click.argument("files", metavar="FILE...]", nargs=-1)
@json_option
@format_option
@junit_option
@click.option("-q", "--quiet", is_flag=True, help="Only the verdicts: one line a submission.")
@group_option
@seed_option
@click.option("--no-name", is_flag=True, help="Do not look for the mistake behind wrong answers.")
@jobs_option
@isolation_option
@no_shrink_option
@save_regression_option
@svg_option
@no_history_option
@db_option
@problems_option
def command(
    name: str | None,
    files: tuple[str, ...],
    as_json: bool,
    form: str | None,
    junit: Path | None,
    quiet: bool,
    groups: tuple[str, ...],
    seed: int | None,
    no_name: bool,
    jobs: int,
    level: str | None,
    unshrunk: bool,
    regression: Path | None,
    svg: Path | None,
    unrecorded: bool,
    db: Path | None,
    folders: tuple[Path, ...],
) -> ExitCode:
    """Judge submissions on a problem.

    Without arguments, the file of the kata in hand. A FILE that defines the problem's entry function has it
    called; any other is run as a program that reads standard input. A folder stands for the *.py in it.

    Exit status: 0 all accepted, 1 not accepted, 2 usage, 3 the judge's or the problem's own fault.
    """
    if name is None:
        name, *files_in_hand = file_in_hand(db)
        files = tuple(files_in_hand)
    elif not files:
        named_problem(name, folders)  # whose own complaint goes first
        remedy = f"write judge run {name} FILE, or judge run alone for the kata in hand"
        raise UsageError("missing argument 'FILE...'", remedy=remedy)
    form = chosen_format(form, as_json=as_json)
    show = Outputs(form, _Screen(brief=quiet, pointing=not unrecorded), junit)
    try:
        problem = named_problem(name, folders)
        submissions = show.expected = read_submissions(files)
        if regression is not None:
            from judge.cli.regression import agree_on  # only who asks for it waits for it

            agree_on(regression)
        check_svg(svg, len(submissions))
        wish = Wish(
            groups=groups,
            seed=seed,
            jobs=jobs,
            level=level,
            diagnosed=regression is not None or not (unshrunk or (quiet and svg is None)),
            named=not (no_name or (quiet and show.on_screen)),
            regression=regression,
            kept=not unrecorded,
            db=db,
        )
        with closing(judged(problem, submissions, wish)) as drawings:
            for drawing in drawings:
                show.result(drawing.result, several=len(submissions) > 1, drawing=drawing)
                drawing.save(svg)
    except Exception as fault:
        show.fail(name, files, fault)
        raise
    return show.close()


class Wish(Struct, frozen=True):
    """How submissions are to be judged, and what is to be done about those that fail."""

    groups: tuple[str, ...] = ()  # all of them where none is named
    seed: int | None = None
    jobs: int = 1
    level: str | None = None  # of isolation
    diagnosed: bool = True  # look for the smallest failing case
    named: bool = True  # look for the mistake
    regression: Path | None = None
    kept: bool = True  # in the history
    db: Path | None = None


def judged(problem: Problem, submissions: Sequence[Submission], wish: Wish) -> Generator[Drawing, None, None]:
    """Judge them; each result is kept in the history once the caller has done with it and asks for more.

    Close it, so that it is kept as well where the caller fails. Raises JudgeError.
    """
    chosen = {group.name for group in chosen_groups(problem, wish.groups)} if wish.groups else None
    with Containment(problem, wish.level) as containment, Recording(wish.db, wanted=wish.kept) as recording:
        containment.boot(submissions[0].source, submissions[0].name)
        data = _data(problem, wish.seed)
        settings = containment.settings(jobs=wish.jobs, submissions=len(submissions))
        judge = partial(
            _judge,
            problem,
            data,
            Diagnosis(data, containment.open_box, wish.regression) if wish.diagnosed else None,
            groups=chosen,
            settings=settings,
            bar=wish.jobs == 1,
            naming=Naming(data, wish.seed, settings, wish.jobs) if wish.named else None,
        )
        for submission, result in zip(submissions, in_order(submissions, wish.jobs, judge), strict=True):
            containment.warn_of(result.isolation)
            try:
                yield Drawing(problem, data, result)
            finally:  # the verdict comes first; where nobody reads it, the run is kept all the same
                recording.add(submission, result)


def named_problem(name: str, folders: Sequence[Path]) -> Problem:
    """The problem of that name. Raises UsageError, which says so where the name is a file's."""
    try:
        return find_problem(name, folders)
    except UsageError as fault:
        if name.endswith(".py"):
            remedy = "the problem comes first: judge run PROBLEM FILE"
            raise UsageError(f"{name!r} is no problem's name", remedy=remedy) from fault
        if "/" in name:
            remedy = "give its id, and the folder it is in with --problems"
            raise UsageError(f"{name!r} is no problem's name", remedy=remedy) from fault
        raise


def _data(problem: Problem, seed: int | None) -> ProblemData:
    with progress(f"building {problem.id}") as advance:
        data = load_data(problem, seed=seed, progress=advance)
    for text in data.notes:
        note(text)
    return data


def _judge(
    problem: Problem,
    data: ProblemData,
    diagnosis: Diagnosis | None,
    submission: Submission,
    *,
    groups: set[str] | None,
    settings: Settings,
    bar: bool,
    naming: Naming | None,
) -> Result:
    source, name = submission.source, submission.name
    if diagnosis is not None:
        settings = replace(settings, diagnose=partial(diagnosis, submission))
    try:
        with progress(name) if bar else nullcontext() as advance:
            result = run_submission(
                problem, data, source, name, groups=groups, on_progress=advance, settings=settings
            )
        return naming.named(result) if naming else result
    except UsageError:  # a level of isolation that cannot be had
        raise
    except JudgeError as fault:  # such as a reference that fails on a case: the others are judged still
        return judge_fault(problem.id, name, str(fault))


def show_result(drawing: Drawing) -> None:
    """One result by itself, for a person."""
    _Screen(brief=False, pointing=True).result(drawing.result, several=False, drawing=drawing)


class _Screen(Struct):
    """Results for a person: the verdict, or the table of them, last."""

    brief: bool
    pointing: bool  # to what comes after an accepted submission
    results: list[Result] = []

    def result(self, result: Result, *, several: bool, drawing: Drawing) -> None:
        """One more result, of one or several."""
        self.results.append(result)
        screen = out()
        if not self.brief:
            drawn = drawing.lines(screen, beside=lines_beside(result, screen.width))
            if self.pointing and not several and result.exit_code is ExitCode.ACCEPTED:
                drawn = pointer_lines(result.problem, screen)
            screen.show([*result_lines(result, screen.width, drawn), *([line()] if several else [])])
        elif not several:
            screen.show(verdict_lines(result, screen.width, alone=True))

    def close(self) -> ExitCode:
        """The table of several, and what they come to."""
        if len(self.results) > 1:
            screen = out()
            screen.show(summary_lines(self.results, screen.width))
        return exit_code(self.results)
