"""`judge due`: what to do again today."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from judge.cli.options import db_option, json_option, problems_option, write_json
from judge.errors import ExitCode
from judge.kata import history as kept
from judge.kata.review import Review, reviews
from judge.problem.find import problem_folders
from judge.report.due import due_lines, nothing_lines
from judge.report.screen import out

SCHEMA = 1


@click.command("due")
@json_option
@db_option
@problems_option
def command(as_json: bool, db: Path | None, folders: tuple[Path, ...]) -> ExitCode:
    """Say what to do again today.

    A kata comes again shortly before it would be forgotten. How long that takes is worked out from your runs:
    how many failed before one was accepted, whether you took hints or gave up, and how long ago that was.
    Judging a file that was accepted before counts for nothing.
    """
    now = kept.now().astimezone()
    with kept.History.open(db, reading=True) as history:
        found = reviews(history.runs(), history.helps(), now)
    here = {folder.name for folder in problem_folders(folders)}
    known = [review for review in found if review.problem in here]
    elsewhere = [review.problem for review in found if review.problem not in here]
    if as_json:
        write_json(
            {
                "schema": SCHEMA,
                "time": now.isoformat(),
                "due": [_as_object(review) for review in known if review.is_due(now)],
                "later": [_as_object(review) for review in known if not review.is_due(now)],
                "elsewhere": sorted(elsewhere),
            }
        )
        return ExitCode.ACCEPTED
    screen = out()
    screen.show(due_lines(known, elsewhere, now, screen.width) if found else nothing_lines(screen.width))
    return ExitCode.ACCEPTED


def _as_object(review: Review) -> dict[str, Any]:
    return {
        "problem": review.problem,
        "due": review.due.isoformat(),
        "last": review.last.isoformat(),
        "rating": review.rating.name.lower(),
        "sittings": review.sittings,
        "solved": review.solved,
        "interval_days": review.interval,
        "recall": round(review.recall, 4),
    }
