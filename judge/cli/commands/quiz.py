"""`judge quiz`: cards, asked again before they are forgotten."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import click
from msgspec import Struct

from judge.cli.kept import history_at
from judge.cli.options import Common, command, opt, takes
from judge.errors import ProblemError, UsageError, nearest
from judge.practice import events
from judge.practice.cards import Card, all_cards, cards_of
from judge.practice.questions import Sources
from judge.practice.quiz import next_cards, next_due, to_practise
from judge.practice.review import card_reviews
from judge.practice.syllabus import FIRST, USUAL, find_row, read_checklist
from judge.problem.find import find_problem, problem_folders
from judge.report.published_quiz import CardList, CardRow, Quizzed, quizzed
from judge.report.screen import err, out
from judge.report.wait import progress

if TYPE_CHECKING:
    from judge.practice.events import Run

_SEED_BYTES = 4


class QuizAsk(Struct, frozen=True):
    """Which cards to ask."""

    cards: Annotated[
        int, opt("--cards", type=click.IntRange(1, 1000), metavar="N", help="How many cards; 10.")
    ] = 10
    question: Annotated[
        str | None,
        opt(
            "--question", metavar="ID", help="Only this question of the checklist, or this card; due or not."
        ),
    ] = None
    listed: Annotated[bool, opt("--list", help="List the cards instead of asking them.")] = False
    seed: Annotated[
        int | None,
        opt("--seed", type=click.IntRange(0), metavar="N", help="Repeat the figures of this seed."),
    ] = None


@command("quiz", CardRow, Quizzed)
@click.argument("name", metavar="[SET]", required=False)
@takes(QuizAsk, "ask")
def quiz(name: str | None, ask: QuizAsk, common: Common) -> Iterator[Struct]:
    """Ask short questions that need no code.

    First the cards of SET that are due, then new ones. Without a SET the new ones are of the set you are in.
    You type one line; ? means "I do not know". What you say in your own words you compare with a model
    answer, and rate. q, Ctrl-D and Ctrl-C stop. Your answers are kept, and decide when a card comes again.

    Answers may also come from a pipe, one a line. With --json the questions go to standard error.
    """
    cards = _narrowed(shown_cards(name or USUAL, common.problems), ask.question, common.problems)
    with history_at(common.db, reading=ask.listed) as history:
        answered, now = card_reviews(history.events(events.Answer)), events.now().astimezone()
        if ask.listed:
            yield CardList(tuple(cards), {review.name: review for review in answered}, now)
            return
        own = name or _own_set(history.runs(), common.problems)
        chosen = next_cards(cards, answered, now, own=own, ahead=ask.question is not None)[: ask.cards]
        seed = new_seed() if ask.seed is None else ask.seed
        if not chosen:
            yield quizzed((), (), seed, next_due(cards, answered))
            return
        from judge.cli.asking import Round, StoppedError  # --list does without

        asking = Round(Sources(common.problems, seed, progress), history, err() if common.json else out())
        try:
            with suppress(StoppedError):
                for card in chosen:
                    asking.ask(card, len(chosen))
        finally:  # after Ctrl-C too
            yield quizzed(asking.asked, to_practise(asking.missed, common.problems), seed)


def new_seed() -> int:
    """A seed for figures that nobody has seen."""
    return int.from_bytes(os.urandom(_SEED_BYTES), "big")


def shown_cards(name: str, folders: Sequence[Path]) -> list[Card]:
    """The cards of a set or deck whose problems are here.

    Raises UsageError where nothing is called so, ProblemError where a deck is broken.
    """
    cards = cards_of(name, all_cards(folders), folders)
    here = {folder.name for folder in problem_folders(folders)}
    return [card for card in cards if not card.problem or card.problem in here]


def _narrowed(cards: list[Card], question: str | None, folders: Sequence[Path]) -> list[Card]:
    """The cards of that question, or the one card of that name. Raises UsageError."""
    if question is None:
        return cards
    if "/" in question:
        found = [card for card in cards if card.key == question]
        near = nearest(question, [card.key for card in cards])
        what = f"There is no card {question!r}"
        remedy = f"did you mean {near!r}?" if near else "judge quiz --list lists them"
    else:
        wanted = find_row(question, read_checklist(folders).rows).id
        found = [card for card in cards if wanted in card.rows]
        what, remedy = f"No card asks {wanted!r}", f"see: judge progress --question {wanted}"
    if not found:
        raise UsageError(what, remedy=remedy)
    return found


def _own_set(runs: Sequence[Run], folders: Sequence[Path]) -> str:
    """The set of the kata that was judged last; the first steps for a newcomer."""
    last = next((run.problem for run in reversed(runs) if run.counts), None)
    if last is not None:
        with suppress(UsageError, ProblemError):
            return next((name for name in find_problem(last, folders).sets if name != USUAL), FIRST)
    return FIRST
