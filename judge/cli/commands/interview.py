"""`judge quiz` and `judge interview` ask cards, before they are forgotten; `judge drill` plans an evening.

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

from judge.cli.options import Common, command, opt
from judge.cli.resolve import Kata, history_at
from judge.errors import ProblemError
from judge.languages import file_name
from judge.practice import events
from judge.practice import quiz as rules
from judge.practice.cards import Card, MistypedError, cards_of, option
from judge.practice.drill import evening
from judge.practice.events import Answer, Hack, Rating
from judge.practice.history import History
from judge.practice.questions import ask as asked_of
from judge.practice.stub import write_stub
from judge.practice.syllabus import USUAL
from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.report import exercises as texts
from judge.report.published_exercises import Drill, Interviewed, Quizzed
from judge.report.screen import err, is_terminal, note, out, show
from judge.report.views import copied
from judge.report.words import shown_name
from judge.run.result import Result

if TYPE_CHECKING:
    from judge.cli.judging import WatchedFile

_T = TypeVar("_T")
_STOP = ("q", "quit")
_UNKNOWN = "?"
_LONGEST = 10_000  # characters of a line
_KEPT = 400  # of them in the history
_RATINGS = "".join(str(int(each)) for each in Rating)
_LAST = 0.1  # of the time, kept for the cards after the kata
_LOOK = 0.5  # seconds between two looks at the file
_MOST = 15  # questions of the page


class QuizAsk(Struct, frozen=True):
    """How many cards to ask."""

    cards: int = opt("--cards N", "How many cards; 10 without it.", type=click.IntRange(1, 1000), default=10)


@command("quiz", Quizzed, ask=QuizAsk)
@click.argument("name", metavar="[SET|TOPIC]", required=False)
def quiz(name: str | None, ask: QuizAsk, common: Common) -> Iterator[Struct]:
    """Ask short questions that need no code.

    First come the cards that are due. Half of the rest are of the topics that you do not know yet, clamp and
    near-tangent, and half are of the highest set in which you have solved a kata.
    You type one line; ? means "I do not know". What you say in your own words you compare with a model
    answer, and rate. q, Ctrl-D and Ctrl-C stop. Your answers are kept, and decide when a card comes again.

    Answers may also come from a pipe, one on each line. With --json the questions go to standard error.
    """
    cards = cards_of(name or USUAL, common.problems)
    with history_at(common.db) as history:
        wanted = rules.read_wanted(name or "", history, common.problems)
        asking = Round(history, common)
        chosen = wanted.of(cards, events.now().astimezone(), ask.cards)[: ask.cards]
        try:
            with suppress(StoppedError):
                for card in chosen:
                    asking.ask(card, len(chosen))
        finally:  # after Ctrl-C too
            yield asking.summary(next_due=None if chosen else rules.next_due(cards, wanted.answered))


@command("drill", Drill)
def drill(common: Common) -> Drill:
    """Plan an evening of practice, mostly of what you do not know yet.

    It shows how you stand in each topic, such as clamp and near-tangent, and some commands to type, one after
    the other. A skill is known if your last run that tests it passes, and its last card was right. Nothing is
    written.
    """
    with history_at(common.db, reading=True) as history:
        wanted, hacks = rules.read_wanted("", history, common.problems), history.events(Hack)
    now = events.now().astimezone()
    steps = tuple(evening(wanted, cards_of(USUAL, common.problems), hacks, now))
    return Drill(now, sum(each.minutes for each in steps), tuple(wanted.topics), steps)


class StoppedError(Exception):
    """The person has had enough of these questions, or of this kata: `q`."""


class EndedError(StoppedError):
    """All is over: Ctrl-D, the end of a pipe, the end of the time."""


class Round:
    """Cards that are asked in turn on one screen; `missed` are the questions that were not known well."""

    def __init__(self, history: History, common: Common) -> None:
        self.folders, self._seed = common.problems, secrets.randbits(32)
        self.screen = err() if common.json else out()
        self.answers: list[Answer] = []
        self.missed: list[str] = []
        self._history = history

    def ask(self, card: Card, count: int) -> None:
        """Ask the next of `count` cards, keep the answer, and say what it came to. Raises StoppedError.

        A card whose figure cannot be made costs a note.
        """
        try:
            asked = asked_of(card, self.folders, self._seed, str(len(self.answers)))
        except ProblemError as fault:
            note(f"a card is left out: {fault}")
            return
        self.show(texts.question(asked, f"Question {len(self.answers) + 1} of {count}", self.screen))
        found = None
        if asked.check:
            found = self._read(texts.expected(asked), asked.check)
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
            self.missed += card.content.rows[:1]
        self.show(texts.reply(asked, found, rating, self.screen))

    def summary(self, more: Mapping[str, str] = {}, next_due: datetime | None = None) -> Quizzed:
        """How the cards went, and what to practise: what was not known well, and `more` with its commands."""
        commands = {**more, **dict.fromkeys(self.missed, "")}
        practise = rules.to_practise(commands, self.folders)
        known = sum(each.known for each in self.answers)
        return Quizzed(len(self.answers), known, tuple(self.answers), practise, next_due)

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
        if not text:
            raise EndedError
        if text.strip().lower() in _STOP:
            raise StoppedError
        return text.strip()


class InterviewAsk(Struct, frozen=True):
    """How to hold it."""

    minutes: int = opt("--minutes N", "How long; 30 without it.", type=click.IntRange(1, 600), default=30)
    kata: str | None = opt("--kata KATA", "The kata to solve.")


@command("interview", Interviewed, ask=InterviewAsk)
@click.argument("name", metavar="[SET]", default=USUAL)
def interview(name: str, ask: InterviewAsk, common: Common) -> Iterator[Interviewed]:
    """Hold a mock interview.

    It has questions from easy to hard, a kata, more questions, and a page of what to practise. At least one
    question is of each topic that you do not know yet. The kata is the first that you have not solved in your
    set, or in the next one. Its file is created here and judged on every save, or when you press Enter. q
    goes on to the next part, and a second q ends the interview. What you did is kept.

    Answers may also come from a pipe, one on each line. With --json the questions go to standard error.
    """
    cards, folders = cards_of(name, common.problems), common.problems
    with history_at(common.db) as history:
        wanted = rules.read_wanted(name, history, folders)
        problem = find_problem(ask.kata, folders) if ask.kata else rules.usual_kata(name, wanted.mine)
        name = file_name(f"{problem.id.replace('-', '_')}_interview")
        held = _Interview(ask.minutes, history, common, Kata(problem, Path(name).absolute()))
        first, last = rules.interview_cards(ask.minutes)
        count = first + last
        now = events.now().astimezone()
        chosen = rules.plan(wanted.of(cards, now, count, ahead=True), count, wanted.topics)
        before, after = chosen[:first], chosen[first:]
        held.show(texts.opening(ask.minutes, len(before), problem.id, len(after)))
        try:
            held.go(before, after)
        finally:  # after Ctrl-C too
            yield held.page()


class _Interview(Round):
    """An interview that is being held; `results` are those of the kata's file."""

    def __init__(self, minutes: int, history: History, common: Common, kata: Kata) -> None:
        super().__init__(history, common)
        self._minutes, self._common, self._kata = minutes, common, kata
        self._results: list[Result] = []
        self._begun = monotonic()

    def _left(self, kept: float = 0.0) -> float:
        """The seconds that are left, when a part of the whole is kept for later."""
        return self._begun + self._minutes * 60 * (1 - kept) - monotonic()

    def go(self, before: Sequence[Card], after: Sequence[Card]) -> None:
        """Hold its three parts; q ends one, and all of them if nothing was done since the last q."""
        count, stopped_at = len(before) + len(after), -1
        parts = partial(self._ask_all, before, count), self._solve, partial(self._ask_all, after, count)
        for part in parts:
            try:
                part()
            except EndedError:
                return
            except StoppedError:
                done = len(self.answers) + len(self._results)
                if done == stopped_at:
                    return
                stopped_at = done

    def _ask_all(self, cards: Sequence[Card], count: int) -> None:
        """Ask the cards. Raises StoppedError, also once the time is over."""
        for card in cards:
            if self._left() <= 0:
                raise EndedError
            self.ask(card, count)

    def _solve(self) -> None:
        """Have the kata solved: its file is judged on every save and line. Raises StoppedError."""
        from judge.cli.judging import WatchedFile

        if self._left() <= 0:
            raise EndedError
        problem, name, minutes = self._kata.problem, self._kata.name, max(0, int(self._left(_LAST) // 60))
        where = f"Write it in {shown_name(name)}: the statement is in there. I judge it on every save."
        self.show(texts.stage(problem.title, minutes, problem.summary, where))
        if not self._kata.path.exists():
            write_stub(problem, self._kata.path)
        with closing(WatchedFile(self._kata, self._common)) as watched:
            watched.saved()  # what is there now is not judged until it is saved
            while not self._solved and self._is_asked(watched):
                self._judge(watched)
            if not self._solved:
                self.show(texts.remark("The time for the kata is over."))

    def _is_asked(self, watched: WatchedFile) -> bool:
        """Wait for a line, or a person's save; False once the time is over. Raises StoppedError."""
        self.screen.write(texts.prompt(texts.SAVE, self.screen))
        while self._left(_LAST) > 0:
            if not is_terminal(sys.stdin) or select.select([sys.stdin], [], [], _LOOK)[0]:
                self.line()
                watched.saved()
                return True
            if watched.saved():
                break
        self.screen.write("\n")
        return self._left(_LAST) > 0

    def _judge(self, watched: WatchedFile) -> None:
        from judge.report.result import run_report

        found = watched.judge()
        if isinstance(found, str):
            note(found)
            return
        self.show(run_report(replace(found, commands=False), self.screen))
        self.screen.write("\n")
        self._results.append(found.result)

    @property
    def _solved(self) -> bool:
        return bool(self._results) and self._results[-1].verdict is Verdict.AC

    def page(self) -> Interviewed:
        """How it went, and what to practise: what the cards and the kata's last run left open."""
        problem, whole = self._kata.problem, self._minutes
        last = self._results[-1] if self._results else None
        skills = rules.lacking(problem, last) if last else ()
        more = rules.left_open(problem, skills, self.folders) if last and not self._solved else {}
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
