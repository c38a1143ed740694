"""`judge interview`: some cards, a kata whose file is judged on every save, more cards, and a page."""

from __future__ import annotations

import select
import sys
from collections.abc import Iterator, Sequence
from contextlib import closing, suppress
from pathlib import Path
from time import monotonic

import click
from msgspec import Struct

from judge.cli.commands.quiz import Round, StoppedError, shown_cards
from judge.cli.files import OutFile, read_submissions
from judge.cli.judging import Wish
from judge.cli.options import Common, command, opt
from judge.cli.resolve import Kata, history_at
from judge.cli.watching import WatchedFile
from judge.judging.api import RunOptions
from judge.languages import file_name
from judge.practice.events import Answer, Help, now
from judge.practice.history import History
from judge.practice.interview import Held, plan, usual_kata
from judge.practice.quiz.cards import Card
from judge.practice.quiz.choose import to_practise
from judge.practice.review import card_reviews
from judge.practice.sets import USUAL
from judge.practice.stub import write_stub
from judge.problem.find import find_problem
from judge.report import quiz
from judge.report.judged import Judged, judged
from judge.report.published_quiz import Interviewed, interviewed
from judge.report.screen import Screen, drawn, is_terminal, note

_LAST = 0.1  # of the time, kept for the cards after the kata
_LOOK = 0.5  # seconds between two looks at the file
_ENTER = "An empty line has the file judged, q goes on"
_MOST = 15  # questions of the page
_TITLE, _PAGE_WIDTH = "\nThe interview", 80


class InterviewAsk(Struct, frozen=True):
    """How to hold it."""

    minutes: int = opt("--minutes N", "How long it takes; 30.", type=click.IntRange(1, 600), default=30)
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

    Answers may also come from a pipe, one a line. With --json the questions go to standard error.
    """
    cards, folders = shown_cards(name, common.problems), common.problems
    page = OutFile(ask.out, "--out", "page of an interview", lambda start: start.startswith(_TITLE.encode()))
    with history_at(common.db) as history:
        today = now().astimezone()
        if ask.kata:
            problem = find_problem(ask.kata, folders)
        else:
            problem = usual_kata(name, history.runs(), history.events(Help), today, folders)
        if ask.file is not None:
            read_submissions([ask.file])  # whether it is there is said before the first card
        path = ask.file or file_name(f"{problem.id.replace('-', '_')}_interview")
        held = _Interview(ask, history, common, Kata(problem, Path(path).absolute()))
        planned = plan(cards, ask.minutes, card_reviews(history.events(Answer)), today)
        held.show(quiz.opening(ask.minutes, planned, held.held))
        try:
            with suppress(StoppedError):
                held.ask_all(planned.before, planned.count)
                held.solve()
                held.ask_all(planned.after, planned.count)
        finally:  # after Ctrl-C too
            found = held.page()
            if page.path:
                plain = Screen(sys.stdout, False, _PAGE_WIDTH)
                page.write(drawn(quiz.interviewed(found, plain), plain).encode())
            yield found


class _Interview(Round):
    """An interview that is being held."""

    def __init__(self, ask: InterviewAsk, history: History, common: Common, kata: Kata) -> None:
        super().__init__(ask.seed, history, common)
        self.held = Held(kata.problem, kata.name)
        self._wanted, self._common, self._kata = ask, common, kata
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
        if self._left() <= 0:
            raise StoppedError
        self.show(quiz.kata(self.held, max(0, int(self._left(_LAST) // 60))))
        if not self._kata.path.exists():
            write_stub(self._kata.problem, self._kata.path)
        person = is_terminal(sys.stdin)
        with closing(WatchedFile(self._kata, Wish(RunOptions(), db=self._common.db))) as watched:
            watched.saved()  # what is there now is not judged until it is saved
            if self._wanted.file is not None:
                self._judge(watched)
                if not person:
                    return
            with suppress(StoppedError):
                while not self.held.solved and (left := self._left(_LAST)) > 0:
                    if self._is_asked(watched, left) if person else self._is_told(watched):
                        self._judge(watched)
                if not self.held.solved:
                    self.show(quiz.time_over())

    def _judge(self, watched: WatchedFile) -> None:
        found = watched.judge()
        if isinstance(found, str):
            note(found)
            return
        if self._common.json:
            note(f"{found.result.submission}: {found.result.verdict.value}")
        else:
            shown = Judged(found.result, found.source, found.problem, found, commands=False)
            self.show(judged(shown, self.screen))
            self.screen.write("\n")
        self.held = self.held.after(found.result)

    def _is_told(self, watched: WatchedFile) -> bool:
        """Wait for an empty line of a pipe; True. Raises StoppedError at its end."""
        while self.typed():
            note(_ENTER)
        watched.saved()
        return True

    def _is_asked(self, watched: WatchedFile, seconds: float) -> bool:
        """Wait for a save or an empty line; False where the time is over first. Raises StoppedError."""
        end, prompt = monotonic() + seconds, quiz.prompt(quiz.SAVE, self.screen)
        self.screen.write(prompt)
        while monotonic() < end:
            if select.select([sys.stdin], [], [], _LOOK)[0]:
                if not self.typed():
                    watched.saved()
                    return True
                self.show(quiz.mistyped(_ENTER))
                self.screen.write(prompt)
            if watched.saved():
                self.screen.write("\n")
                return True
        self.screen.write("\n")
        return False

    def page(self) -> Interviewed:
        """How it went, and what to practise: what the cards and the kata's last run left open."""
        folders, whole = self._common.problems, self._wanted.minutes
        practise = to_practise(self.missed, folders, self.held.questions(folders))[:_MOST]
        taken = min(whole - int(self._left() // 60), whole)
        return interviewed(self.held, self.asked, practise, (max(taken, 1), whole), self.sources.seed)
