"""`judge solution`: a model solution and why it works, for who has solved the problem or has given up."""

from __future__ import annotations

from pathlib import Path

import click

from judge.cli.kata import problem_in_hand
from judge.cli.options import db_option, json_option, problems_option, write_json
from judge.errors import ExitCode, UsageError
from judge.kata.model import model_solution
from judge.problem import Problem
from judge.report.screen import out
from judge.report.solution import solution_text

SCHEMA = 1


@click.command("solution")
@click.argument("name", metavar="[PROBLEM]", required=False)
@click.option(
    "--give-up", "giving_up", is_flag=True, help="Show it before you have solved it; that is remembered."
)
@json_option
@db_option
@problems_option
def command(
    name: str | None, giving_up: bool, as_json: bool, db: Path | None, folders: tuple[Path, ...]
) -> ExitCode:
    """Explain a model solution.

    Of that problem or the kata in hand, once you have solved it; before that only with --give-up, and the
    problem then comes back for review sooner.
    """
    problem = problem_in_hand(name, folders, db)
    model = model_solution(problem)
    solved = _admit(problem, db, giving_up=giving_up)
    if as_json:
        write_json(
            {
                "schema": SCHEMA,
                "problem": problem.id,
                "file": model.path.name,
                "idea": model.idea,
                "explanation": model.explanation,
                "program": model.program,
                "solved": solved,
            }
        )
        return ExitCode.ACCEPTED
    screen = out()
    screen.write(solution_text(problem, model, screen))
    return ExitCode.ACCEPTED


def _admit(problem: Problem, db: Path | None, *, giving_up: bool) -> bool:
    """Whether the problem is solved; if it is not, note that it was given up. Raises UsageError."""
    from judge.kata.history import History

    with History.open(db, reading=not giving_up) as history:
        if any(run.solved for run in history.runs(problem.id)):
            return True
        if history.gave_up(problem.id):
            return False
        if giving_up:
            history.give_up(problem.id)
            return False
    remedy = f"'judge hint {problem.id}' helps, 'judge solution {problem.id} --give-up' shows it all the same"
    raise UsageError(f"{problem.id} is not solved yet", remedy=remedy)
