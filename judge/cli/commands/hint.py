"""`judge hint`: the hints to a problem, one step at a time."""

from __future__ import annotations

from pathlib import Path

import click

from judge.cli.fitting import problem_meant
from judge.cli.hints import hints_of, hints_seen, next_hint, note_seen
from judge.cli.kata import problem_in_hand
from judge.cli.options import db_option, json_option, problems_option, write_json
from judge.errors import ExitCode, UsageError
from judge.problem import Problem
from judge.problem.hints import Hint
from judge.report.hint import hint_text
from judge.report.screen import out

SCHEMA = 1


@click.command("hint")
@click.argument("name", metavar="[PROBLEM|FILE]", required=False)
@click.option("--again", is_flag=True, help="Repeat the last one.")
@click.option("--step", type=int, metavar="N", help="Show hint N; the first is 1.")
@click.option("--all", "every", is_flag=True, help="Show all hints.")
@json_option
@db_option
@problems_option
def command(
    name: str | None,
    again: bool,
    step: int | None,
    every: bool,
    as_json: bool,
    db: Path | None,
    folders: tuple[Path, ...],
) -> ExitCode:
    """Give the next hint.

    The hint is for that problem, for the problem of a file, or for your current kata. The first hint is a
    nudge, the last is nearly the whole solution. The judge remembers which ones you have seen.
    """
    if again + every + (step is not None) > 1:
        raise UsageError("--again, --step and --all exclude each other", remedy="name one of them")
    problem = problem_in_hand(name, folders, db) if name is None else problem_meant(name, folders, db)
    hints = hints_of(problem)
    if again:
        chosen = [hints[_last_seen(problem, hints, db) - 1]]
    elif step is not None:
        chosen = [_numbered(problem, hints, step)]
    else:
        chosen = list(hints) if every else [next_hint(problem, hints, db)]
    try:
        note_seen(problem, chosen[-1], db)  # first: what was shown counts as seen, whatever happens then
    finally:
        for hint in chosen:
            if as_json:
                write_json(as_object(problem, hint, len(hints)))
            else:
                screen = out()
                screen.write(hint_text(problem, hint, len(hints), screen))
    return ExitCode.ACCEPTED


def as_object(problem: Problem, hint: Hint, steps: int) -> dict[str, object]:
    """The published object of one hint."""
    return {
        "schema": SCHEMA,
        "problem": problem.id,
        "step": hint.number,
        "steps": steps,
        "title": hint.title,
        "text": hint.text,
    }


def _last_seen(problem: Problem, hints: tuple[Hint, ...], db: Path | None) -> int:
    seen = hints_seen(problem, db)
    if not seen:
        remedy = f"'judge hint {problem.id}' gives the first"
        raise UsageError(f"no hint to {problem.id} was given yet", remedy=remedy)
    return min(seen, len(hints))


def _numbered(problem: Problem, hints: tuple[Hint, ...], step: int) -> Hint:
    if not 1 <= step <= len(hints):
        raise UsageError(f"{problem.id} has no hint {step}", remedy=f"they go from 1 to {len(hints)}")
    return hints[step - 1]
