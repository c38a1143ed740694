"""`judge quiz` and `judge interview`: cards, asked again before they are forgotten; with a kata between them.

Answers come from a terminal or from a pipe, one on each line.
"""

from __future__ import annotations

import secrets
import select
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import closing, suppress
from datetime import datetime
from functools import partial
from pathlib import Path
from time import monotonic
from typing import TYPE_CHECKING, TypeVar

import click
from msgspec import Struct
from msgspec.structs import replace
from rich.console import RenderableType

from judge.cli.files import OutFile, read_submissions
from judge.cli.options import Common, command, opt
from judge.cli.resolve import Kata, history_at
from judge.errors import ProblemError, UsageError, nearest
from judge.languages import file_name
from judge.practice import events
from judge.practice.cards import Card, MistypedError, cards_of, option
from judge.practice.events import Answer, Help, Rating, Run
from judge.practice.history import History
from judge.practice.questions import Sources
from judge.practice.questions import ask as asked_of
from judge.practice.quiz import lacking, left_open, next_cards, next_due, plan, to_practise, usual_kata
from judge.practice.review import card_reviews
from judge.practice.stub import write_stub
from judge.practice.syllabus import USUAL, find_row, read_checklist
from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.problem.model import FIRST
from judge.report import quiz as texts
from judge.report.published_quiz import CardList, CardRow, Interviewed, Quizzed
from judge.report.screen import Screen, drawn, err, is_terminal, note, out, show
from judge.report.views import copied
from judge.report.wait import progress
from judge.report.words import shown_name
from judge.run.result import Result

if TYPE_CHECKING:
    from judge.cli.watching import WatchedFile

_T = TypeVar("_T")
_STOP = ("q", "quit")
_UNKNOWN = "?"
_LONGEST = 10_000  # characters of a line
_KEPT = 400  # of them in the history
_RATINGS = "".join(str(int(each)) for each in Rating)
_LAST = 0.1  # of the time, kept for the cards after the kata
_LOOK = 0.5  # seconds between two looks at the file
_MOST = 15  # questions of the page
_TITLE, _PAGE_WIDTH = b"\nThe interview", 80


class QuizAsk(Struct, frozen=True):
    """Which cards to ask."""

    cards: int = opt("--cards N", "How many cards; 10 without it.", type=click.IntRange(1, 1000), default=10)
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

    Answers may also come from a pipe, one on each line. With --json the questions go to standard error.
    """
    cards = _narrowed(cards_of(name or USUAL, common.problems), ask.question, common.problems)
    with history_at(common.db, reading=ask.listed) as history:
        answered, today = card_reviews(history.events(Answer)), events.now().astimezone()
        if ask.listed:
            known = {
                each.name: {"last": each.last, "rating": each.rating, "due": each.due} for each in answered
            }
            rows = [copied(CardRow, card, card=card.key, **known.get(card.key, {})) for card in cards]
            yield CardList(tuple(rows), today)
            return
        own = name or _own_set(history.runs(), common.problems)
        chosen = next_cards(cards, answered, today, own=own, ahead=ask.question is not None)[: ask.cards]
        asking = Round(ask.seed, history, common)
        try:
            with suppress(StoppedError):
                for card in chosen:
                    asking.ask(card, len(chosen))
        finally:  # after Ctrl-C too
            yield asking.summary(next_due=None if chosen else next_due(cards, answered))


def _narrowed(cards: list[Card], question: str | None, folders: Sequence[Path]) -> list[Card]:
    """The cards of that question, or the one card of that name. Raises UsageError."""
    if question is None:
        return cards
    wanted = question if "/" in question else find_row(question, read_checklist(folders).rows).id
    found = [card for card in cards if wanted in (card.key, *card.rows)]
    if not found:
        near = nearest(wanted, [card.key for card in cards])
        remedy = f"did you mean {near!r}?" if near else "judge quiz --list lists the cards"
        raise UsageError(f"There is no card for {wanted!r}", remedy=remedy)
    return found


def _own_set(runs: Sequence[Run], folders: Sequence[Path]) -> str:
    """The set of the kata that was judged last; the first steps for a newcomer."""
    with suppress(StopIteration, UsageError, ProblemError):
        last = next(run.problem for run in reversed(runs) if run.counts)
        return next(name for name in find_problem(last, folders).sets if name != USUAL)
    return FIRST


class StoppedError(Exception):
    """The person has had enough: `q`, Ctrl-D, the end of a pipe."""


class Round:
    """Cards that are asked in turn on one screen; `missed` are the questions that were not known well."""

    def __init__(self, seed: int | None, history: History, common: Common) -> None:
        seed = secrets.randbits(32) if seed is None else seed
        self.sources = Sources(common.problems, seed, progress)
        self.screen = err() if common.json else out()
        self.answers: list[Answer] = []
        self.missed: list[str] = []
        self._history = history

    def ask(self, card: Card, count: int) -> None:
        """Ask the next of `count` cards, keep the answer, and say what it came to. Raises StoppedError.

        A card whose figure cannot be made costs a note.
        """
        try:
            asked = asked_of(card, self.sources, str(len(self.answers)))
        except ProblemError as fault:
            note(f"a card is left out: {fault}")
            return
        self.show(texts.question(asked, f"Question {len(self.answers) + 1} of {count}", self.screen))
        found = None
        if asked.check:
            found = self._read(f"Answer ({asked.expects}): ", asked.check)
            given = found.given if found else ""
            rating = Rating.GOOD if found and found.right else Rating.AGAIN
        else:
            given = self._typed(f"{asked.expects}: ")
            self.show(texts.model(asked))
            rated = None if given == _UNKNOWN else self._read(texts.RATE, partial(option, letters=_RATINGS))
            rating = Rating(int(rated or Rating.AGAIN))
        answer = Answer(card.key, card.form, rating, asked.check is not None, given[:_KEPT])
        self._history.keep(answer)
        self.answers.append(answer)
        if rating in (Rating.AGAIN, Rating.HARD):
            self.missed += card.rows[:1]
        self.show(texts.reply(asked, found, rating))

    def summary(self, more: Mapping[str, str] = {}, next_due: datetime | None = None) -> Quizzed:
        """How the cards went, and what to practise: what was not known well, and `more` with its commands."""
        commands = {**more, **{row: f"judge quiz --question {row}" for row in self.missed}}
        practise = to_practise(commands, self.sources.folders)
        known = sum(each.known for each in self.answers)
        return Quizzed(len(self.answers), known, tuple(self.answers), practise, self.sources.seed, next_due)

    def show(self, what: RenderableType) -> None:
        """Draw something between the questions."""
        show(what, self.screen)

    def _typed(self, asks: str) -> str:
        """The next line of standard input, after a prompt. Raises StoppedError."""
        self.screen.write(texts.prompt(asks, self.screen))
        return self.line()

    def _read(self, asks: str, read: Callable[[str], _T]) -> _T | None:
        """What `read` makes of the next line that it takes; None for "?". Raises StoppedError."""
        while (typed := self._typed(asks)) != _UNKNOWN:
            try:
                return read(typed)
            except MistypedError as fault:
                self.show(texts.remark(str(fault)))
        return None

    def line(self) -> str:
        """The next line of standard input. Raises StoppedError."""
        text = ""  # if it cannot be read, or was closed: nobody types there
        try:
            text = sys.stdin.buffer.readline(_LONGEST).decode("utf-8", "replace")
        except (AttributeError, OSError, ValueError):
            pass
        finally:  # Ctrl-C and Ctrl-D leave the line of the prompt open, and a pipe is not seen at all
            if not (text and is_terminal(sys.stdin)):
                self.screen.write("\n")
        if not text or text.strip().lower() in _STOP:
            raise StoppedError
        return text.strip()


class InterviewAsk(Struct, frozen=True):
    """How to hold it."""

    minutes: int = opt(
        "--minutes N", "How long it takes; 30 without it.", type=click.IntRange(1, 600), default=30
    )
    kata: str | None = opt("--kata KATA", "The kata to solve.")
    file: str | None = opt(
        "--file FILE", "Your file for it, instead of a new one.", type=click.Path(dir_okay=False)
    )
    out: Path | None = opt("--out FILE", "Write the last page there too.")
    seed: int | None = opt("--seed N", "Repeat these figures.", type=click.IntRange(0), hidden=True)


@command("interview", Interviewed, ask=InterviewAsk)
@click.argument("name", metavar="[SET]", default=USUAL)
def interview(name: str, ask: InterviewAsk, common: Common) -> Iterator[Interviewed]:
    """Hold a mock interview.

    It has questions from easy to hard, a kata, more questions, and a page of what to practise. The kata is
    the one that is due, or the first that is not solved. Its file is created here and judged on every save,
    or when you press Enter. q goes on to the last questions, and a second q ends the interview. What you did
    is kept.

    Answers may also come from a pipe, one on each line. With --json the questions go to standard error.
    """
    cards, folders = cards_of(name, common.problems), common.problems
    page = OutFile(ask.out, "--out", "a page of an interview", lambda start: start.startswith(_TITLE))
    with history_at(common.db) as history:
        today = events.now().astimezone()
        if ask.kata:
            problem = find_problem(ask.kata, folders)
        else:
            problem = usual_kata(name, history.runs(), history.events(Help), today, folders)
        if ask.file is not None:
            read_submissions([ask.file])  # whether it is there is said before the first card
        path = ask.file or file_name(f"{problem.id.replace('-', '_')}_interview")
        held = _Interview(ask, history, common, Kata(problem, Path(path).absolute()))
        before, after = plan(cards, ask.minutes, card_reviews(history.events(Answer)), today)
        count = len(before) + len(after)
        held.show(texts.opening(ask.minutes, len(before), problem.id, len(after)))
        try:
            with suppress(StoppedError):
                held.ask_all(before, count)
                held.solve()
                held.ask_all(after, count)
        finally:  # after Ctrl-C too
            found = held.page()
            if page.path:
                plain = Screen(sys.stdout, False, _PAGE_WIDTH)
                page.write(drawn(texts.interviewed(found, plain), plain).encode())
            yield found


class _Interview(Round):
    """An interview that is being held; `results` are those of the kata's file."""

    def __init__(self, ask: InterviewAsk, history: History, common: Common, kata: Kata) -> None:
        super().__init__(ask.seed, history, common)
        self._wanted, self._common, self._kata = ask, common, kata
        self._results: list[Result] = []
        self._begun = monotonic()

    def _left(self, kept: float = 0.0) -> float:
        """The seconds that are left, when a part of the whole is kept for later."""
        return self._begun + self._wanted.minutes * 60 * (1 - kept) - monotonic()

    def ask_all(self, cards: Sequence[Card], count: int) -> None:
        """Ask the cards. Raises StoppedError, also once the time is over."""
        for card in cards:
            if self._left() <= 0:
                raise StoppedError
            self.ask(card, count)

    def solve(self) -> None:
        """Have the kata solved: its file judged on every save, and on each empty line.

        A file that was named is judged once without being asked for; from a pipe that is all.
        """
        from judge.cli.judging import Wish
        from judge.cli.watching import WatchedFile
        from judge.judging.options import RunOptions

        if self._left() <= 0:
            raise StoppedError
        problem, name, minutes = self._kata.problem, self._kata.name, max(0, int(self._left(_LAST) // 60))
        where = f"Write it in {shown_name(name)}: the statement is in there. I judge it on every save."
        self.show(texts.stage(problem.title, minutes, problem.summary, where))
        if not self._kata.path.exists():
            write_stub(problem, self._kata.path)
        watched = WatchedFile(self._kata, Wish(RunOptions(), db=self._common.db))
        with closing(watched), suppress(StoppedError):
            watched.saved()  # what is there now is not judged until it is saved
            if self._wanted.file is not None:
                self._judge(watched)
                if not is_terminal(sys.stdin):
                    return
            while not self._solved and self._is_asked(watched):
                self._judge(watched)
            if not self._solved:
                self.show(texts.remark("The time for the kata is over."))

    def _is_asked(self, watched: WatchedFile) -> bool:
        """Wait for an empty line, or a person's save; False once the time is over. Raises StoppedError."""
        person, prompt = is_terminal(sys.stdin), texts.prompt(texts.SAVE, self.screen)
        self.screen.write(prompt)
        while self._left(_LAST) > 0:
            if not person or select.select([sys.stdin], [], [], _LOOK)[0]:
                if not self.line():
                    watched.saved()
                    return True
                self.show(texts.remark("Press Enter to judge the file, q to go on"))
                self.screen.write(prompt)
            elif watched.saved():
                break
        self.screen.write("\n")
        return self._left(_LAST) > 0

    def _judge(self, watched: WatchedFile) -> None:
        from judge.report.result import judged

        found = watched.judge()
        if isinstance(found, str):
            note(found)
            return
        self.show(judged(replace(found, commands=False), self.screen))
        self.screen.write("\n")
        self._results.append(found.result)

    @property
    def _solved(self) -> bool:
        return bool(self._results) and self._results[-1].verdict is Verdict.AC

    def page(self) -> Interviewed:
        """How it went, and what to practise: what the cards and the kata's last run left open."""
        problem, whole = self._kata.problem, self._wanted.minutes
        last = self._results[-1] if self._results else None
        skills = lacking(problem, last) if last else ()
        more = left_open(problem, skills, self.sources.folders) if last and not self._solved else {}
        cards = self.summary(more)
        return copied(
            Interviewed,
            cards,
            minutes=min(max(whole - int(self._left() // 60), 1), whole),
            out_of=whole,
            problem=problem.id,
            file=self._kata.name,
            runs=len(self._results),
            solved=self._solved,
            verdict=last.verdict if last else None,
            score=last.score if last else None,
            mistake=last.pitfall.name if last and last.pitfall and last.pitfall.names else None,
            lacking=skills,
            practise=cards.practise[:_MOST],
        )
