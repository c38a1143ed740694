"""`judge solution`: the approaches there are and why they work, for who has solved the problem or gave up."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from judge.cli.kata import problem_in_hand
from judge.cli.options import db_option, json_option, problems_option, write_json
from judge.errors import ExitCode, JudgeError, UsageError
from judge.kata.model import Model, approaches, chosen_approach
from judge.languages import language_of
from judge.problem import Problem, Verdict
from judge.report.progress import progress
from judge.report.screen import note, out
from judge.report.solution import YOURS, approach_lines, solution_text

if TYPE_CHECKING:
    from judge.kata.events import Run

SCHEMA = 1


@click.command("solution")
@click.argument("name", metavar="[PROBLEM", required=False)
@click.argument("approach", metavar="[APPROACH]]", required=False)
@click.option(
    "--give-up",
    "giving_up",
    is_flag=True,
    help="Show it before you have solved the kata; this is remembered.",
)
@click.option("--no-time", "untimed", is_flag=True, help="Do not measure times.")
@click.option(
    "--language", metavar="NAME", help="Show the one in this language: go, cpp, java …; Python by default."
)
@json_option
@db_option
@problems_option
def command(
    name: str | None,
    approach: str | None,
    giving_up: bool,
    untimed: bool,
    language: str | None,
    as_json: bool,
    db: Path | None,
    folders: tuple[Path, ...],
) -> ExitCode:
    """Explain a model solution.

    Without PROBLEM: of your current kata. It is shown once yours is accepted, or with --give-up; the kata
    then comes back sooner. Below it are the other approaches by name, each with its time beside your latest
    accepted run, measured now.

    Approaches in other languages have the names of their files: judge solution distance reference.go, or
    judge solution distance --language go. Their time is a multiple of the reference in that language.
    """
    problem = problem_in_hand(name, folders, db)
    models = approaches(problem)
    model = chosen_approach(problem, models, approach, language)
    yours = _admit(problem, db, giving_up=giving_up)
    ratios = {} if untimed or problem.time is None else _ratios(problem, models, model, yours)
    run = yours[0] if yours else None
    if as_json:
        write_json(
            {
                "schema": SCHEMA,
                "problem": problem.id,
                "file": model.path.name,
                "language": model.tongue,
                "idea": model.idea,
                "explanation": model.explanation,
                "program": model.program,
                "solved": run is not None,
                "approaches": [_approach(each, ratios) for each in models],
                "yours": {"run": run.id, "file": run.submission, "ratio": ratios.get(YOURS)} if run else None,
            }
        )
        return ExitCode.ACCEPTED
    screen = out()
    screen.write(solution_text(problem, model, screen))
    screen.show(approach_lines(problem, models, model, run, ratios, screen.width))
    return ExitCode.ACCEPTED


def _approach(model: Model, ratios: Mapping[str, float | None]) -> dict[str, Any]:
    return {
        "name": model.name,
        "file": model.path.name,
        "language": model.tongue,
        "about": model.about,
        "ratio": ratios.get(model.path.name),
    }


def _ratios(
    problem: Problem, models: Sequence[Model], shown: Model, yours: tuple[Run, bytes] | None
) -> dict[str, float | None]:
    """The times of approaches by file, and of one's own; none where they cannot be measured.

    Of other languages only those of the one shown, and of one's own, are compiled for it.
    """
    from judge import RunOptions, Session  # only who has them measured waits for it

    wanted = [None, shown.language, *([language_of(yours[0].submission)] if yours else [])]
    timed = [model for model in models if model.language in wanted]
    programs = [(model.path.name, model.source) for model in timed]
    names = [model.path.name for model in timed]
    if yours is not None:
        programs.append((yours[0].submission, yours[1]))
        names.append(YOURS)
    try:
        with Session(problem, RunOptions(diagnosed=False, named=False), bars=progress) as session:
            session.boot(programs[0][1], programs[0][0])
            results = [session.judge(source, file) for file, source in programs]
    except JudgeError as fault:  # the solution is what was asked for
        note(f"the times are not measured: {fault}")
        return {}
    ratios = [result.time.ratio if result.verdict is Verdict.AC else None for result in results]
    believed = [ratio.median if ratio and not ratio.unreliable else None for ratio in ratios]
    return dict(zip(names, believed, strict=True))


def _admit(problem: Problem, db: Path | None, *, giving_up: bool) -> tuple[Run, bytes] | None:
    """The person's latest run that solved it, and its source; None where it was given up, which is noted.

    Raises UsageError where it is neither.
    """
    from judge.cli.kept import history_at
    from judge.kata.events import Help

    with history_at(db, reading=not giving_up) as history:
        solved = [run for run in history.runs(problem.id) if run.solved]
        if solved:
            return solved[-1], history.source(solved[-1].id)
        if any(each.gave_up for each in history.events(Help, problem.id)):
            return None
        if giving_up:
            history.keep(Help(problem.id, hints=0))
            return None
    remedy = f"'judge hint {problem.id}' helps, 'judge solution {problem.id} --give-up' shows it all the same"
    raise UsageError(f"{problem.id} is not solved yet", remedy=remedy)
