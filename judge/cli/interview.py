"""The mock interview: some cards, a kata whose file is judged on every save, some cards more, and a page."""

from __future__ import annotations

import select
import sys
import time
from collections.abc import Callable, Sequence
from contextlib import closing, suppress
from pathlib import Path

from msgspec import Struct

from judge.cli.asking import AsEvents, Round, StoppedError, drilled, stopped, typed_line
from judge.cli.drilling import to_drill
from judge.cli.kata import Kata, write_stub
from judge.cli.outputs import show_result
from judge.cli.picture import Drawing
from judge.cli.submissions import read_submissions
from judge.cli.watching import WatchedFile
from judge.cli.wish import Wish, named_problem
from judge.errors import ExitCode, UsageError
from judge.judging.job import RunOptions
from judge.kata.checklist import read_checklist
from judge.kata.events import Answer, Help, now
from judge.kata.history import History
from judge.kata.progress import Standing, standings
from judge.kata.quiz.cards import Card
from judge.kata.quiz.choose import next_cards, rising
from judge.kata.review import card_reviews, reviews
from judge.kata.sets import FIRST, USUAL, find_set
from judge.languages import file_name
from judge.problem import Problem, Tier
from judge.report.interview import Outcome, interview_lines, kata_lines, kata_prompt, over_lines, page_lines
from judge.report.kata import writing_lines
from judge.report.quiz import mistyped_lines
from judge.report.screen import is_terminal, note, out

_OPENING, _CLOSING = 6, 15  # minutes of the whole for each card before the kata, and after it
_LAST = 0.1  # of the time, kept for the cards after the kata
_LOOK = 0.5  # seconds between two looks at the file
_ENTER = "an empty line has the file judged, q goes on"
_MOST_ROWS = 15  # of the page

Clock = Callable[[], float]  # in seconds


class Interview(Struct, frozen=True):
    """What was asked for: the set, the minutes, a kata and its file, how many cards, the history's file."""

    name: str
    minutes: int
    kata: str | None = None
    file: str | None = None
    cards: int | None = None
    db: Path | None = None


class _Time:
    """How much of it is left."""

    def __init__(self, minutes: int, clock: Clock) -> None:
        self._clock = clock
        self._begun = clock()
        self._seconds = minutes * 60.0

    def left(self, *, kept: float = 0.0) -> float:
        """The seconds that are left, when a part of the whole is kept for later."""
        return self._begun + self._seconds * (1 - kept) - self._clock()

    @property
    def taken(self) -> int:
        """The minutes that are gone, begun ones too."""
        return int((self._clock() - self._begun) // 60) + 1


def hold(wanted: Interview, cards: Sequence[Card], asking: Round, clock: Clock = time.monotonic) -> ExitCode:
    """Hold it to its end, or until the person leaves; the page comes in any case.

    Raises:
        UsageError: the kata or its file is not there.
    """
    kata = _kata(wanted, asking.sources.folders, asking.history)
    opening, closing = _chosen(wanted, cards, asking.history)
    found = _Held(wanted, asking, _Time(wanted.minutes, clock), Outcome(kata.problem, kata.name))
    if not isinstance(asking.voice, AsEvents):
        screen = out()
        screen.show(interview_lines(wanted.minutes, len(opening), len(closing), kata.problem, screen.width))
    total = len(opening) + len(closing)
    try:
        with suppress(StoppedError):
            if found.ask(opening, total):
                found.solve(kata)
                found.ask(closing, total)
    finally:  # after Ctrl-C too
        found.page()
    return ExitCode.ACCEPTED


def _chosen(wanted: Interview, cards: Sequence[Card], history: History) -> tuple[list[Card], list[Card]]:
    """The cards before the kata and after it, rising from the junior ones on."""
    before, after = max(2, wanted.minutes // _OPENING), max(1, wanted.minutes // _CLOSING)
    if wanted.cards is not None:
        after = wanted.cards // 3
        before = wanted.cards - after
    if not before + after:
        return [], []
    known = card_reviews(history.events(Answer))
    pool = next_cards(cards, known, now(), len(cards), ahead=True)
    found = rising(pool, before + after, [tier.value for tier in Tier])
    return found[:before], found[before:]


def _kata(wanted: Interview, folders: Sequence[Path], history: History) -> Kata:
    problem = named_problem(wanted.kata, folders) if wanted.kata else _usual_kata(wanted, folders, history)
    if wanted.file is not None:
        read_submissions([wanted.file])  # whether it is there is told before the first card
        return Kata(problem, Path(wanted.file).absolute())
    return Kata(problem, Path(file_name(f"{problem.id.replace('-', '_')}_interview")).absolute())


def _usual_kata(wanted: Interview, folders: Sequence[Path], history: History) -> Problem:
    """The kata that is due, or else the first that is not passed, past the first steps; or any."""
    try:
        problems = find_set(wanted.name, folders).problems
    except UsageError:  # the name of a deck
        problems = find_set(USUAL, folders).problems
    named = {problem.id: problem for problem in problems}
    runs = history.runs()
    for review in reviews(runs, history.events(Help)):
        if review.name in named and review.is_due(now().astimezone()):
            return named[review.name]
    found = standings(runs)
    new = [each for each in problems if found.get(each.id, Standing()).passed is None]
    later = [each for each in new if FIRST not in each.sets]
    return (later or new or list(problems))[0]


class _Held:
    """An interview that is being held."""

    def __init__(self, wanted: Interview, asking: Round, timer: _Time, outcome: Outcome) -> None:
        self._wanted = wanted
        self._asking = asking
        self._timer = timer
        self._outcome = outcome
        self._events = asking.voice if isinstance(asking.voice, AsEvents) else None

    def ask(self, cards: Sequence[Card], total: int) -> bool:
        """Ask the cards while there is time; whether there was enough. Raises StoppedError."""
        for card in cards:
            if self._timer.left() <= 0:
                return False
            self._asking.ask(card, len(self._asking.asked) + 1, total)
        return True

    def solve(self, kata: Kata) -> None:
        """Have the kata solved: its file judged on every save and whenever that is asked for.

        From a pipe each empty line has it judged, and `q` or the end goes on; a file that was named is judged
        once without being asked for.
        """
        self._begin(kata)
        with closing(WatchedFile(kata, Wish(RunOptions(), db=self._wanted.db))) as watched:
            self._solve(watched)

    def _solve(self, watched: WatchedFile) -> None:
        watched.saved()  # what is there now is not judged until it is saved
        person = is_terminal(sys.stdin) and self._events is None
        if self._wanted.file is not None:
            self._judge(watched)
            if not person:
                return
        with suppress(StoppedError):
            while not self._outcome.solved and (left := self._timer.left(kept=_LAST)) > 0:
                if not _is_asked(watched, person=person, seconds=left):
                    break
                self._judge(watched)
            if person and not self._outcome.solved:
                out().show(over_lines())

    def _begin(self, kata: Kata) -> None:
        """Say what the kata is, and see to it that there is a file."""
        screen = out()
        left = max(0, int(self._timer.left(kept=_LAST) // 60))
        new = not kata.path.exists()
        if self._events:
            self._events.tell("kata", problem=kata.problem.id, file=kata.name, minutes=left)
        else:
            screen.show(kata_lines(kata.problem, kata.name, left, screen.width))
            if new:
                screen.show(writing_lines(kata.problem, kata.name, screen.width))
        if new:
            write_stub(kata.problem, kata.path)

    def _judge(self, watched: WatchedFile) -> None:
        found: Drawing | str = watched.judge()
        if isinstance(found, str):
            note(found)
            return
        if self._events:
            self._events.tell("run", result=found.result.as_json())
        else:
            show_result(found)
        self._outcome = self._outcome.after(found.result)

    def page(self) -> None:
        """What to drill: the rows of the cards that were not known, and of what the kata's run failed."""
        asking, outcome, folders = self._asking, self._outcome, self._asking.sources.folders
        drill = to_drill(asking.missed, folders, _rows_of(outcome, folders))[:_MOST_ROWS]
        minutes = min(self._timer.taken, self._wanted.minutes)
        if self._events is None:
            screen = out()
            screen.show(
                page_lines(asking.asked, outcome, drill, (minutes, self._wanted.minutes), screen.width)
            )
            return
        kata = {
            "problem": outcome.problem.id,
            "file": outcome.file,
            "runs": outcome.runs,
            "solved": outcome.solved,
            "skills": list(outcome.lacking),
        }
        rows = drilled(drill)
        self._events.tell(
            "page", minutes=minutes, asked=len(asking.asked), known=asking.known, kata=kata, drill=rows
        )


def _is_asked(watched: WatchedFile, *, person: bool, seconds: float) -> bool:
    """Wait until the file is to be judged; False where the time is over first. Raises StoppedError."""
    if not person:
        while stopped(typed_line()):  # nobody was prompted
            note(_ENTER)
        watched.saved()
        return True
    screen = out()
    screen.write(kata_prompt(screen))
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if select.select([sys.stdin], [], [], _LOOK)[0]:
            if not stopped(typed_line()):
                watched.saved()
                return True
            screen.show(mistyped_lines(_ENTER, screen.width))
            screen.write(kata_prompt(screen))
        if watched.saved():
            screen.write("\n")
            return True
    screen.write("\n")
    return False


def _rows_of(outcome: Outcome, folders: Sequence[Path]) -> dict[str, str]:
    """The rows of the checklist that ask for what the kata's last run did not show, and how to go on."""
    if outcome.solved or not outcome.runs:
        return {}
    lacking = set(outcome.lacking)
    command = f"judge {'hint' if outcome.problem.has_hints else 'show'} {outcome.problem.id}"
    return {
        row.id: command
        for row in read_checklist(folders).rows
        if lacking.intersection(row.skills) or (not lacking and outcome.problem.id in row.katas)
    }
