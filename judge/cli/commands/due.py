"""`judge due`: what to do again today."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from judge.cli.drilling import known_cards
from judge.cli.kept import history_at
from judge.cli.options import db_option, json_option, problems_option, write_json
from judge.errors import ExitCode
from judge.kata import history as kept
from judge.kata.review import CardReview, Memory, Review, card_reviews, reviews
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

    A kata comes again shortly before it would be forgotten. How long that takes is worked out from your runs:
    how many failed before one was accepted, whether you took hints or gave up, and how long ago that was.
    Judging a file that was accepted before counts for nothing. Cards (judge quiz) come again in the same way.
    """
    now = kept.now().astimezone()
    with history_at(db, reading=True) as history:
        runs = history.runs()
        found = reviews(runs, history.helps(), now)
        cards = card_reviews(history.answers(), now)
    if cards:  # whoever has answered none waits for no deck
        cards = known_cards(cards, folders)
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
                "cards": {
                    "due": [_card(review) for review in cards if review.is_due(now)],
                    "later": [_card(review) for review in cards if not review.is_due(now)],
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


def _as_object(review: Review) -> dict[str, Any]:
    return {"problem": review.problem, **_memory(review), "solved": review.solved}


def _card(review: CardReview) -> dict[str, Any]:
    return {"card": review.card, **_memory(review)}


def _memory(memory: Memory) -> dict[str, Any]:
    return {
        "due": memory.due.isoformat(),
        "last": memory.last.isoformat(),
        "rating": memory.rating.name.lower(),
        "sittings": memory.sittings,
        "interval_days": memory.interval,
        "recall": round(memory.recall, 4),
    }
