"""`judge quiz`: cards, at a terminal or with answers from a pipe, asked again before they are forgotten."""

from __future__ import annotations

import secrets
import sys
from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

import click
from msgspec import Struct

from judge.cli.options import Common, command, opt
from judge.cli.resolve import history_at
from judge.errors import ProblemError, UsageError, nearest
from judge.practice import events
from judge.practice.checklist import find_row, read_checklist
from judge.practice.events import Answer, Rating, Run
from judge.practice.quiz.cards import Card, all_cards, cards_of
from judge.practice.quiz.choose import next_cards, next_due, to_practise
from judge.practice.quiz.questions import Question, Reply, Sources
from judge.practice.quiz.questions import ask as asked_of
from judge.practice.quiz.typed import MistypedError
from judge.practice.review import card_reviews
from judge.practice.sets import FIRST, USUAL
from judge.problem.find import find_problem, problem_folders
from judge.report import quiz as texts
from judge.report.published_quiz import CardList, CardRow, Quizzed, quizzed
from judge.report.screen import err, is_terminal, note, out, show
from judge.report.wait import progress

if TYPE_CHECKING:
    from rich.console import RenderableType

    from judge.practice.history import History

_STOP = ("q", "quit")
_UNKNOWN = "?"
_LONGEST = 10_000  # characters of a line
_KEPT = 400  # of them in the history
_RATINGS = {str(int(rating)): rating for rating in Rating} | {each.name.lower(): each for each in Rating}


class QuizAsk(Struct, frozen=True):
    """Which cards to ask."""

    cards: int = opt("--cards N", "How many cards; 10.", type=click.IntRange(1, 1000), default=10)
    question: str | None = opt(
        "--question ID", "Only this question of the checklist, or this card; due or not."
    )
    listed: bool = opt("--list", "List the cards instead of asking them.")
    seed: int | None = opt("--seed N", "Repeat the figures of this seed.", type=click.IntRange(0))


@command("quiz", CardRow, Quizzed, ask=QuizAsk)
@click.argument("name", metavar="[SET]", required=False)
def quiz(name: str | None, ask: QuizAsk, common: Common) -> Iterator[Struct]:
    """Ask short questions that need no code.

    First the cards of SET that are due, then new ones. Without a SET the new ones are of the set you are in.
    You type one line; ? means "I do not know". What you say in your own words you compare with a model
    answer, and rate. q, Ctrl-D and Ctrl-C stop. Your answers are kept, and decide when a card comes again.

    Answers may also come from a pipe, one a line. With --json the questions go to standard error.
    """
    cards = _narrowed(shown_cards(name or USUAL, common.problems), ask.question, common.problems)
    with history_at(common.db, reading=ask.listed) as history:
        answered, today = card_reviews(history.events(Answer)), events.now().astimezone()
        if ask.listed:
            yield CardList(tuple(cards), {review.name: review for review in answered}, today)
            return
        own = name or _own_set(history.runs(), common.problems)
        chosen = next_cards(cards, answered, today, own=own, ahead=ask.question is not None)[: ask.cards]
        asking = Round(ask.seed, history, common)
        if not chosen:
            yield quizzed((), (), asking.sources.seed, next_due(cards, answered))
            return
        try:
            with suppress(StoppedError):
                for card in chosen:
                    asking.ask(card, len(chosen))
        finally:  # after Ctrl-C too
            yield quizzed(asking.asked, to_practise(asking.missed, common.problems), asking.sources.seed)


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


class StoppedError(Exception):
    """The person has had enough: `q`, Ctrl-D, the end of a pipe."""


class Round:
    """Cards that are asked in turn on one screen; `asked` has each that was answered, with its rating."""

    def __init__(self, seed: int | None, history: History, common: Common) -> None:
        seed = secrets.randbits(32) if seed is None else seed
        self.sources = Sources(common.problems, seed, progress)
        self.screen = err() if common.json else out()
        self.asked: list[tuple[Question, Rating]] = []
        self._history = history

    def ask(self, card: Card, count: int) -> None:
        """Ask the next of `count` cards, keep the answer, and say what it came to. Raises StoppedError.

        A card whose figure cannot be made costs a note.
        """
        try:
            asked = asked_of(card, self.sources, str(len(self.asked)))
        except ProblemError as fault:
            note(f"a card is left out: {fault}")
            return
        self.show(texts.question(asked, f"Question {len(self.asked) + 1} of {count}", self.screen))
        given, found, rating = self._rated(asked) if asked.check is None else self._checked(asked)
        self._history.keep(Answer(card.key, card.form, rating, asked.check is not None, given[:_KEPT]))
        self.asked.append((asked, rating))
        self.show(texts.reply(asked, found, rating))

    @property
    def missed(self) -> Sequence[Card]:
        """The cards that were not remembered well."""
        return [asked.card for asked, rating in self.asked if rating in (Rating.AGAIN, Rating.HARD)]

    def show(self, what: RenderableType) -> None:
        """Draw something between the questions."""
        show(what, self.screen)

    def typed(self, asks: str = "") -> str:
        """The next line of standard input, after a prompt. Raises StoppedError."""
        if asks:
            self.screen.write(texts.prompt(asks, self.screen))
        text = ""  # if it cannot be read, or was closed: nobody types there
        try:
            buffer = getattr(sys.stdin, "buffer", None)
            line = buffer.readline(_LONGEST) if buffer else sys.stdin.readline(_LONGEST)
            text = line.decode("utf-8", "replace") if isinstance(line, bytes) else line
        except UnicodeDecodeError:  # of a stream that has no bytes to decode anew
            text = "\ufffd"
        except (OSError, ValueError):
            pass
        finally:  # Ctrl-C and Ctrl-D leave the line of the prompt open, and a pipe is not seen at all
            if asks and not (text and is_terminal(sys.stdin)):
                self.screen.write("\n")
        if not text or text.strip().lower() in _STOP:
            raise StoppedError
        return text.strip()

    def _checked(self, asked: Question) -> tuple[str, Reply | None, Rating]:
        """What was typed, what it comes to, and the rating of that."""
        assert asked.check is not None
        while True:
            typed = self.typed(f"Answer ({asked.expects}): ")
            if typed == _UNKNOWN:
                return "", None, Rating.AGAIN
            try:
                if not typed:
                    raise MistypedError(f"Type {asked.expects}; ? if you do not know, q to stop")
                found = asked.check(typed)
            except MistypedError as fault:
                self.show(texts.mistyped(str(fault)))
                continue
            return found.given, found, Rating.GOOD if found.right else Rating.AGAIN

    def _rated(self, asked: Question) -> tuple[str, Reply | None, Rating]:
        """What was typed, and how the person rates it beside the model answer."""
        typed = self.typed(f"{asked.expects}: ")
        self.show(texts.model(asked))
        if typed == _UNKNOWN:
            return "", None, Rating.AGAIN
        while True:
            with suppress(KeyError):
                return typed, None, _RATINGS[self.typed(texts.RATE).lower()]
            self.show(texts.mistyped("Type 1, 2, 3 or 4"))
