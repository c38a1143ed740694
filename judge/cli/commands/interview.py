"""`judge interview`: some cards, a kata whose file is judged on every save, more cards, and a page."""

from __future__ import annotations

import select
import sys
from collections.abc import Iterator, Sequence
from contextlib import closing, suppress
from pathlib import Path
from time import monotonic
from typing import Annotated

import click
from msgspec import Struct

from judge.cli.asking import Round, StoppedError
from judge.cli.commands.quiz import new_seed, shown_cards
from judge.cli.kept import history_at
from judge.cli.options import Common, command, opt, takes
from judge.cli.submissions import read_submissions
from judge.cli.target import OutFile
from judge.cli.watching import Kata, WatchedFile
from judge.cli.wish import Wish
from judge.judging.api import RunOptions
from judge.languages import file_name
from judge.practice.cards import Card
from judge.practice.events import Answer, Help, now
from judge.practice.questions import Sources
from judge.practice.quiz import Held, plan, to_practise, usual_kata
from judge.practice.review import card_reviews
from judge.practice.stub import write_stub
from judge.practice.syllabus import USUAL
from judge.problem.find import find_problem
from judge.report import quiz
from judge.report.judged import Judged, judged
from judge.report.published_quiz import Interviewed, interviewed
from judge.report.screen import Screen, drawn, err, is_terminal, note, out, show
from judge.report.wait import progress

_LAST = 0.1  # of the time, kept for the cards after the kata
_LOOK = 0.5  # seconds between two looks at the file
_ENTER = "An empty line has the file judged, q goes on"
_MOST = 15  # questions of the page
_TITLE, _PAGE_WIDTH = "\nThe interview", 80


class InterviewAsk(Struct, frozen=True):
    """How to hold it."""

    minutes: Annotated[
        int, opt("--minutes", type=click.IntRange(1, 600), metavar="N", help="How long it takes; 30.")
    ] = 30
    kata: Annotated[str | None, opt("--kata", metavar="KATA", help="The kata to solve.")] = None
    file: Annotated[
        str | None,
        opt(
            "--file",
            metavar="FILE",
            type=click.Path(dir_okay=False),
            help="Your file for it, instead of a new one.",
        ),
    ] = None
    out: Annotated[Path | None, opt("--out", metavar="FILE", help="Write the last page there too.")] = None
    seed: Annotated[
        int | None, opt("--seed", type=click.IntRange(0), hidden=True, help="Repeat these figures.")
    ] = None


@command("interview", Interviewed)
@click.argument("name", metavar="[SET]", default=USUAL)
@takes(InterviewAsk, "ask")
def interview(name: str, ask: InterviewAsk, common: Common) -> Iterator[Interviewed]:
    """Hold a mock interview.

    It has questions from easy to hard, a kata, more questions, and a page of what to practise. The kata is
    the one that is due, or the first that is not solved. Its file is created here and judged on every save,
    or when you press Enter. q goes on to the last questions, and a second q ends the interview. What you did
    is kept.

    Answers may also come from a pipe, one a line. With --json the questions go to standard error.
    """
    cards = shown_cards(name, common.problems)
    page = OutFile(ask.out, "--out", "page of an interview", _is_page) if ask.out else None
    if page:
        page.check()
    with history_at(common.db) as history:
        today = now().astimezone()
        problem = (
            find_problem(ask.kata, common.problems)
            if ask.kata
            else usual_kata(name, history.runs(), history.events(Help), today, common.problems)
        )
        if ask.file is not None:
            read_submissions([ask.file])  # whether it is there is said before the first card
        seed = new_seed() if ask.seed is None else ask.seed
        path = ask.file or file_name(f"{problem.id.replace('-', '_')}_interview")
        asking = Round(Sources(common.problems, seed, progress), history, err() if common.json else out())
        sitting = _Sitting(ask, common, asking, Kata(problem, Path(path).absolute()))
        planned = plan(cards, ask.minutes, card_reviews(history.events(Answer)), today)
        asking.show(quiz.opening(ask.minutes, planned, sitting.held))
        try:
            with suppress(StoppedError):
                sitting.ask(planned.before, planned.count)
                sitting.solve()
                sitting.ask(planned.after, planned.count)
        finally:  # after Ctrl-C too
            found = sitting.page()
            if page:
                plain = Screen(sys.stdout, False, _PAGE_WIDTH)
                page.write(drawn(quiz.interviewed(found, plain), plain).encode())
            yield found


def _is_page(start: bytes) -> bool:
    return start.startswith(_TITLE.encode())


class _Sitting:
    """An interview that is being held."""

    def __init__(self, ask: InterviewAsk, common: Common, asking: Round, kata: Kata) -> None:
        self.held = Held(kata.problem, kata.name)
        self._wanted, self._common, self._asking, self._kata = ask, common, asking, kata
        self._begun = monotonic()

    def _left(self, kept: float = 0.0) -> float:
        """The seconds that are left, when a part of the whole is kept for later."""
        return self._begun + self._wanted.minutes * 60 * (1 - kept) - monotonic()

    def ask(self, cards: Sequence[Card], count: int) -> None:
        """Ask the cards. Raises StoppedError, also once the time is over."""
        for card in cards:
            if self._left() <= 0:
                raise StoppedError
            self._asking.ask(card, count)

    def solve(self) -> None:
        """Have the kata solved: its file judged on every save, and on each empty line.

        A file that was named is judged once without being asked for; from a pipe that is all.
        """
        if self._left() <= 0:
            raise StoppedError
        self._asking.show(quiz.kata(self.held, max(0, int(self._left(_LAST) // 60))))
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
                    self._asking.show(quiz.time_over())

    def _judge(self, watched: WatchedFile) -> None:
        found = watched.judge()
        if isinstance(found, str):
            note(found)
            return
        if self._common.json:
            note(f"{found.result.submission}: {found.result.verdict.value}")
        else:
            screen = self._asking.screen
            shown = Judged(found.result, found.source, found.problem, found, commands=False)
            show(judged(shown, screen), screen)
            self._asking.screen.write("\n")
        self.held = self.held.after(found.result)

    def _is_told(self, watched: WatchedFile) -> bool:
        """Wait for an empty line of a pipe; True. Raises StoppedError at its end."""
        while self._asking.typed():
            note(_ENTER)
        watched.saved()
        return True

    def _is_asked(self, watched: WatchedFile, seconds: float) -> bool:
        """Wait for a save or an empty line; False where the time is over first. Raises StoppedError."""
        screen, end = self._asking.screen, monotonic() + seconds
        screen.write(quiz.prompt(quiz.SAVE, screen))
        while monotonic() < end:
            if select.select([sys.stdin], [], [], _LOOK)[0]:
                if not self._asking.typed():
                    watched.saved()
                    return True
                self._asking.show(quiz.mistyped(_ENTER))
                screen.write(quiz.prompt(quiz.SAVE, screen))
            if watched.saved():
                screen.write("\n")
                return True
        screen.write("\n")
        return False

    def page(self) -> Interviewed:
        """How it went, and what to practise: what the cards and the kata's last run left open."""
        folders, whole = self._common.problems, self._wanted.minutes
        practise = to_practise(self._asking.missed, folders, self.held.questions(folders))[:_MOST]
        taken = min(whole - int(self._left() // 60), whole)
        seed = self._asking.sources.seed
        return interviewed(self.held, self._asking.asked, practise, (max(taken, 1), whole), seed)
