"""`judge due`: what to do again today."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from judge.cli.drilling import known_cards
from judge.cli.kept import history_at
from judge.cli.options import db_option, json_option, problems_option, write_json
from judge.errors import ExitCode
from judge.kata import events
from judge.kata.review import Review, card_reviews, reviews
from judge.problem.find import problem_folders
from judge.report.due import card_lines, due_lines, nothing_lines
from judge.report.screen import out

SCHEMA = 1


@click.command("due")
@json_option
@db_option
@problems_option
def command(as_json: bool, db: Path | None, folders: tuple[Path, ...]) -> ExitCode:
    """Say what to do again today.

    A kata that you solve at once comes again after 1, 3, 8, 21, 60, then 180 days. If you needed failed runs
    or hints, it goes down a step; if you did not solve it, it comes again the next day. Running an already
    accepted file again changes nothing. Cards (judge quiz) come again in the same way.
    """
    now = events.now().astimezone()
    with history_at(db, reading=True) as history:
        runs = history.runs()
        found = reviews(runs, history.events(events.Help))
        cards = card_reviews(history.events(events.Answer))
    if cards:  # whoever has answered none waits for no deck
        cards = known_cards(cards, folders)
    here = {folder.name for folder in problem_folders(folders)}
    known = [review for review in found if review.name in here]
    elsewhere = [review.name for review in found if review.name not in here]
    if as_json:
        katas = [(review, {"problem": review.name, "solved": review.solved}) for review in known]
        asked = [(review, {"card": review.name}) for review in cards]
        write_json(
            {
                "schema": SCHEMA,
                "time": now.isoformat(),
                "due": [_as_object(*each) for each in katas if each[0].is_due(now)],
                "later": [_as_object(*each) for each in katas if not each[0].is_due(now)],
                "elsewhere": sorted(elsewhere),
                "cards": {
                    "due": [_as_object(*each) for each in asked if each[0].is_due(now)],
                    "later": [_as_object(*each) for each in asked if not each[0].is_due(now)],
                },
            }
        )
        return ExitCode.ACCEPTED
    screen, tried = out(), any(run.counts for run in runs)
    screen.show(
        due_lines(known, elsewhere, now, screen.width) if found else nothing_lines(screen.width, tried=tried)
    )
    screen.show(card_lines(cards, now, screen.width))
    return ExitCode.ACCEPTED


def _as_object(review: Review, named: dict[str, Any]) -> dict[str, Any]:
    return named | {
        "due": review.due.isoformat(),
        "last": review.last.isoformat(),
        "rating": review.rating.name.lower(),
        "sittings": review.sittings,
        "in_a_row": review.in_a_row,
        "interval_days": review.days,
    }
