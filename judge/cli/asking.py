"""Asking cards: at a terminal, or with answers from a pipe, one a line."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from contextlib import suppress
from typing import TYPE_CHECKING

from judge.errors import ProblemError
from judge.practice.cards import MistypedError
from judge.practice.events import Answer, Rating
from judge.practice.questions import Question, Reply, ask
from judge.report import quiz
from judge.report.screen import Screen, is_terminal, note, show

if TYPE_CHECKING:
    from rich.console import RenderableType

    from judge.practice.cards import Card
    from judge.practice.history import History
    from judge.practice.questions import Sources

_STOP = ("q", "quit")
_UNKNOWN = "?"
_LONGEST = 10_000  # characters of a line
_KEPT = 400  # of them in the history
_RATINGS = {str(int(rating)): rating for rating in Rating} | {each.name.lower(): each for each in Rating}


class StoppedError(Exception):
    """The person has had enough: `q`, Ctrl-D, the end of a pipe."""


class Round:
    """Cards that are asked in turn on one screen; `asked` has each that was answered, with its rating."""

    def __init__(self, sources: Sources, history: History, screen: Screen) -> None:
        self.sources = sources
        self.screen = screen
        self.asked: list[tuple[Question, Rating]] = []
        self._history = history

    def ask(self, card: Card, count: int) -> None:
        """Ask the next of `count` cards, keep the answer, and say what it came to. Raises StoppedError.

        A card whose figure cannot be made costs a note.
        """
        try:
            asked = ask(card, self.sources, str(len(self.asked)))
        except ProblemError as fault:
            note(f"a card is left out: {fault}")
            return
        self.show(quiz.question(asked, f"Question {len(self.asked) + 1} of {count}", self.screen))
        given, found, rating = self._rated(asked) if asked.check is None else self._checked(asked)
        self._history.keep(Answer(card.key, card.form, rating, asked.check is not None, given[:_KEPT]))
        self.asked.append((asked, rating))
        self.show(quiz.reply(asked, found, rating))

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
            self.screen.write(quiz.prompt(asks, self.screen))
        text = ""
        try:
            buffer = getattr(sys.stdin, "buffer", None)
            line = buffer.readline(_LONGEST) if buffer else sys.stdin.readline(_LONGEST)
            text = line.decode("utf-8", "replace") if isinstance(line, bytes) else line
        except UnicodeDecodeError:  # of a stream that has no bytes to decode anew
            text = "\ufffd"
        except (OSError, ValueError):  # it cannot be read, or was closed: nobody types there
            text = ""
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
                self.show(quiz.mistyped(str(fault)))
                continue
            return found.given, found, Rating.GOOD if found.right else Rating.AGAIN

    def _rated(self, asked: Question) -> tuple[str, Reply | None, Rating]:
        """What was typed, and how the person rates it beside the model answer."""
        typed = self.typed(f"{asked.expects}: ")
        self.show(quiz.model(asked))
        if typed == _UNKNOWN:
            return "", None, Rating.AGAIN
        while True:
            with suppress(KeyError):
                return typed, None, _RATINGS[self.typed(quiz.RATE).lower()]
            self.show(quiz.mistyped("Type 1, 2, 3 or 4"))
