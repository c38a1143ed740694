"""Asking cards: at a terminal, from a pipe, or as events of JSON for a program that shows them itself."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Protocol

from msgspec import Struct

from judge.cli.options import write_json
from judge.errors import ProblemError
from judge.kata.events import Answer, Rating
from judge.kata.quiz.questions import Question, Reply
from judge.kata.quiz.typed import MistypedError
from judge.report.layout import Span, Style, line
from judge.report.screen import is_terminal, note, out

if TYPE_CHECKING:
    from judge.kata.checklist import Row
    from judge.kata.history import History
    from judge.kata.quiz.cards import Card
    from judge.kata.quiz.questions import Sources

SCHEMA = 1
STOP = ("q", "quit")
UNKNOWN = "?"
_LONGEST = 10_000  # characters of a line
_KEPT = 400  # of them in the history
_RATINGS = {str(int(rating)): rating for rating in Rating} | {each.name.lower(): each for each in Rating}

Drill = Sequence[tuple["Row", Sequence[str]]]


class StoppedError(Exception):
    """The person has had enough: `q`, Ctrl-D, the end of a pipe."""


def typed_line(voice: Voice | None = None) -> str:
    """The next line of standard input, without its end. Raises StoppedError where there is none.

    The `voice` that has prompted for it ends its line where the person did not.
    """
    buffer = getattr(sys.stdin, "buffer", None)
    text = ""
    try:
        text = (
            buffer.readline(_LONGEST).decode("utf-8", "replace") if buffer else sys.stdin.readline(_LONGEST)
        )
    except UnicodeDecodeError:  # of a stream that has no bytes to decode anew
        text = "\ufffd"
    except (OSError, ValueError):  # it cannot be read, or was closed: nobody types there
        text = ""
    finally:  # Ctrl-C and Ctrl-D leave the line of the prompt open, and a pipe is not seen at all
        if voice and not (text and is_terminal(sys.stdin)):
            voice.broken_off()
    if not text:
        raise StoppedError
    return text.strip()


class Voice(Protocol):
    """How questions and what became of them are told."""

    def question(self, question: Question, place: int, count: int) -> None:
        """A card is asked."""
        ...

    def prompt(self, what: str) -> None:
        """Something is to be typed."""
        ...

    def broken_off(self) -> None:
        """The line of the prompt was not ended by whoever typed."""
        ...

    def mistyped(self, message: str) -> None:
        """What was typed is no answer."""
        ...

    def model(self, question: Question) -> None:
        """The model answer, to be compared with."""
        ...

    def reply(self, question: Question, reply: Reply | None, rating: Rating) -> None:
        """What an answer came to; None where the person did not know, or rated it."""
        ...

    def end(self, asked: Sequence[tuple[Question, Rating]], drill: Drill) -> None:
        """All is over."""
        ...


class OnScreen:
    """For a person."""

    def question(self, question: Question, place: int, count: int) -> None:
        """A card is asked."""
        from judge.report.quiz import question_lines

        screen = out()
        screen.show(question_lines(question, f"{place} of {count}", screen))

    def prompt(self, what: str) -> None:
        """Something is to be typed."""
        from judge.report.quiz import prompt_text

        screen = out()
        screen.write(prompt_text(what, screen))

    def broken_off(self) -> None:
        """The line of the prompt was not ended by whoever typed."""
        out().write("\n")

    def mistyped(self, message: str) -> None:
        """What was typed is no answer."""
        from judge.report.quiz import mistyped_lines

        screen = out()
        screen.show(mistyped_lines(message, screen.width))

    def model(self, question: Question) -> None:
        """The model answer, to be compared with."""
        from judge.report.quiz import model_lines

        screen = out()
        screen.show(model_lines(question, screen.width))

    def reply(self, question: Question, reply: Reply | None, rating: Rating) -> None:
        """What an answer came to."""
        from judge.report.quiz import reply_lines

        screen = out()
        if question.check is None:
            screen.show([line("  ", Span(f"noted: {rating.name.lower()}", Style.FAINT)), line()])
        else:
            screen.show(reply_lines(question, reply, screen.width))

    def end(self, asked: Sequence[tuple[Question, Rating]], drill: Drill) -> None:
        """All is over."""
        from judge.report.quiz import end_lines

        screen = out()
        screen.show(end_lines(asked, drill, screen.width))


class AsEvents:
    """For a program: an object a line; what is to be typed comes to standard input, a line each."""

    def __init__(self, seed: int) -> None:
        self._seed = seed

    def question(self, question: Question, place: int, count: int) -> None:
        """A card is asked."""
        card = question.card
        self.tell(
            "question",
            number=place,
            of=count,
            card=card.key,
            form=card.form,
            rows=list(card.rows),
            front=card.front,
            given=list(question.given),
            options=[{"letter": letter, "text": text} for letter, text in question.options],
            program=question.program or None,
            expects=question.expects,
            seed=self._seed,
        )

    def prompt(self, what: str) -> None:
        """A program knows when it is asked."""

    def broken_off(self) -> None:
        """There is no such line."""

    def mistyped(self, message: str) -> None:
        """What was typed is no answer."""
        self.tell("mistyped", message=message)

    def model(self, question: Question) -> None:
        """The model answer, to be compared with."""
        self.tell("model", card=question.card.key, answer=question.answer)

    def reply(self, question: Question, reply: Reply | None, rating: Rating) -> None:
        """What an answer came to."""
        judged = question.check is not None
        self.tell(
            "answer",
            card=question.card.key,
            right=(reply is not None and reply.right) if judged else None,
            rating=rating.name.lower(),
            given=reply.given if reply else "",
            mistake=(reply.mistake or None) if reply else None,
            answer=question.answer,
            why=question.why,
        )

    def end(self, asked: Sequence[tuple[Question, Rating]], drill: Drill) -> None:
        """All is over."""
        known = sum(rating is not Rating.AGAIN for _, rating in asked)
        self.tell("end", asked=len(asked), known=known, drill=drilled(drill), seed=self._seed)

    def tell(self, event: str, **what: Any) -> None:
        """One event."""
        write_json({"schema": SCHEMA, "event": event, **what})


def drilled(drill: Drill) -> list[dict[str, Any]]:
    """The published objects of rows to drill."""
    return [{"row": row.id, "ask": row.ask, "drill": list(commands)} for row, commands in drill]


class _Said(Struct, frozen=True):
    """What became of one question."""

    rating: Rating
    reply: Reply | None = None
    given: str = ""


class Round:
    """Cards that are asked in turn; `asked` has each question that was answered, with its rating."""

    def __init__(self, sources: Sources, voice: Voice, history: History) -> None:
        self.sources = sources
        self.voice = voice
        self.history = history
        self.asked: list[tuple[Question, Rating]] = []

    def ask(self, card: Card, place: int, count: int) -> None:
        """Ask a card, keep the answer, and tell what it came to. Raises StoppedError.

        A card whose figure cannot be made costs a note.
        """
        from judge.kata.quiz.questions import ask

        try:
            question = ask(card, self.sources, str(len(self.asked)))
        except ProblemError as fault:
            note(f"a card is left out: {fault}")
            return
        self.voice.question(question, place, count)
        answer = _rated(question, self.voice) if question.check is None else _judged(question, self.voice)
        judged = question.check is not None
        self.history.keep(Answer(card.key, card.form, answer.rating, judged, answer.given[:_KEPT]))
        self.asked.append((question, answer.rating))
        self.voice.reply(question, answer.reply, answer.rating)

    @property
    def known(self) -> int:
        """How many were remembered."""
        return sum(rating is not Rating.AGAIN for _, rating in self.asked)

    @property
    def missed(self) -> list[Card]:
        """The cards that were not remembered well."""
        return [question.card for question, rating in self.asked if rating in (Rating.AGAIN, Rating.HARD)]


def _judged(question: Question, voice: Voice) -> _Said:
    assert question.check is not None
    while True:
        voice.prompt(question.expects)
        typed = _line(voice)
        if typed == UNKNOWN:
            return _Said(Rating.AGAIN)
        try:
            if not typed:
                raise MistypedError(f"type {question.expects}; ? if you do not know, q to stop")
            reply = question.check(typed)
        except MistypedError as fault:
            voice.mistyped(str(fault))
            continue
        return _Said(Rating.GOOD if reply.right else Rating.AGAIN, reply, reply.given)


def _rated(question: Question, voice: Voice) -> _Said:
    from judge.report.quiz import RATINGS

    voice.prompt(question.expects)
    typed = _line(voice)
    voice.model(question)
    if typed == UNKNOWN:
        return _Said(Rating.AGAIN)
    while True:
        voice.prompt(RATINGS)
        rating = _RATINGS.get(_line(voice).lower())
        if rating is not None:
            return _Said(rating, given=typed)
        voice.mistyped(f"type {RATINGS}")


def stopped(typed: str) -> str:
    """The line again. Raises StoppedError where it says that the person has had enough."""
    if typed.lower() in STOP:
        raise StoppedError
    return typed


def _line(voice: Voice) -> str:
    return stopped(typed_line(voice))
