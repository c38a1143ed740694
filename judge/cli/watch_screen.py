"""The loop of `judge start` on a terminal: the last verdict, what a key asks for, and the keys."""

from __future__ import annotations

import signal
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Collection, Iterator, Sequence
from contextlib import closing, contextmanager, redirect_stderr, suppress
from io import StringIO
from queue import Empty, SimpleQueue
from types import FrameType
from typing import TYPE_CHECKING, NoReturn

from judge.cli.commands.practise import HintAsk, hints, note_seen
from judge.cli.drawings import Drawing
from judge.cli.home import standing
from judge.cli.judging import Wish
from judge.cli.options import Common
from judge.cli.resolve import Kata, history_at, take_up
from judge.cli.watching import WatchedFile
from judge.errors import JudgeError
from judge.judging.api import RunOptions
from judge.languages import file_name, language_of
from judge.practice.progress import solved
from judge.practice.saves import Saves
from judge.practice.stub import make_stub, write_stub
from judge.practice.syllabus import PracticeSet, next_kata, set_of, sound_sets
from judge.problem import Problem
from judge.problem.find import sound_problems
from judge.report.parts import FAINT, GOOD, WARNING, prose
from judge.report.picture import has_room
from judge.report.result import Shown, accepted, magnified, result, verdict_line
from judge.report.screen import Screen, drawn, out
from judge.report.tell import Told, tell
from judge.report.views import view
from judge.report.watch import (
    GONE,
    begun_text,
    keys,
    keys_text,
    note_text,
    place_text,
    redraw,
    reprompt,
    waiting_text,
)

if TYPE_CHECKING:
    from rich.console import Group

    from judge.report.published_look import Standing

_SAVED, _RESIZED = "saved", "resized"
_END = ("q", "\x04", GONE)
_LOOK = 1.0  # seconds after which the file is looked at even if nothing was told of it
_AGAIN = 2.0  # seconds that breaking off may take
_TICK = 0.1  # seconds between two states of the line that says what is being judged
_BELOW = 2  # rows that the keys take, and one to spare

View = Callable[[Screen], str]


def loop(kata: Kata, level: str | None, common: Common) -> None:
    """Judge a kata on every save, and those that are gone on to, until the person has enough."""
    screen = out()
    screen.write("\n" * (screen.height - 1))  # what stood there can be scrolled back to
    following: Kata | None = kata
    with _handled(_leave, signal.SIGTERM, signal.SIGHUP):
        while following is not None:
            following = _Loop(following, level, common).watch()


def _leave(number: int, _frame: FrameType | None) -> NoReturn:
    """End like any program that was asked to, but after clearing up."""
    raise SystemExit(128 + number)


@contextmanager
def _handled(handler: Callable[[int, FrameType | None], None], *signals: signal.Signals) -> Iterator[None]:
    """Have these signals handled while the block runs."""
    before = [(each, signal.signal(each, handler)) for each in signals]
    try:
        yield
    finally:
        for each in before:
            signal.signal(*each)


@contextmanager
def _waiting(screen: Screen, file: str) -> Iterator[None]:
    """Say below what is seen what is being judged, and for how long, while the block runs."""
    over = threading.Event()

    def tell() -> None:
        begun = time.monotonic()
        while True:
            reprompt(screen, waiting_text(file, time.monotonic() - begun, screen))
            if over.wait(_TICK):
                return

    thread = threading.Thread(target=tell, name="waiting", daemon=True)
    thread.start()
    try:
        yield
    finally:
        over.set()
        thread.join()


class _Loop:
    """One kata on the screen."""

    def __init__(self, kata: Kata, level: str | None, common: Common) -> None:
        self._kata, self._common = kata, common
        options = RunOptions(isolation=common.isolation, level=level)
        self._file = WatchedFile(kata, Wish(options, db=common.db))
        self._stub = make_stub(kata.problem, language_of(kata.path)).encode()
        self._events: SimpleQueue[str] = SimpleQueue()
        self._found: Drawing | None = None
        self._text = ""  # why there is no result
        self._notes = ""
        self._standing: Standing | None = None
        self._view: View = self._report
        self._asked = ""  # the key before, where it asks for confirmation
        self._leaving = False

    def watch(self) -> Kata | None:
        """Judge on every save and obey the keys; the kata to go on to, or None to end."""
        try:
            with closing(self._file), keys(sys.stdin.fileno(), self._pressed) as take:

                def resized(number: int, _frame: object) -> None:
                    if number == signal.SIGCONT:
                        take()
                    self._events.put(_RESIZED)

                with (
                    _handled(resized, signal.SIGWINCH, signal.SIGCONT),
                    Saves(self._kata.path, self._saved),
                ):
                    return self._obey()
        except KeyboardInterrupt:
            if not self._leaving:
                raise
            return None
        finally:
            reprompt(out(), "")

    def _saved(self) -> None:
        """Perhaps, as the thread tells that watches the file."""
        self._events.put(_SAVED)
        self._file.look()

    def _pressed(self, key: str) -> None:
        """A key, in the thread that reads them: the one that ends it does so in the middle of judging too."""
        if key in _END:
            self._leaving = True
            while self._file.judging.break_off():  # again, if an import has swallowed it
                self._file.judging.over(_AGAIN)
        self._events.put(key)

    def _obey(self) -> Kata | None:
        while not self._leaving:
            if self._file.saved():
                self._judge()
            event = ""
            with suppress(Empty):
                event = self._events.get(timeout=_LOOK)
            if event == _RESIZED:
                self._draw()
            elif event and event != _SAVED and not self._leaving and (following := self._key(event)):
                return following
        return None

    def _judge(self) -> None:
        """Judge what stands in the file, unless that is still the stub."""
        untouched = False
        with suppress(OSError):  # judging says so
            untouched = self._kata.path.read_bytes() == self._stub
        if untouched:
            self._found, self._text, self._notes = None, "", ""
            self._show(self._begun)
            return
        screen = out()
        if not (self._found or self._text):
            redraw(screen, drawn(self._place(screen), screen), "")
        notes = StringIO()
        found: Drawing | str | None = None
        with self._file.judging:
            if not self._leaving:
                with _waiting(screen, self._kata.name), redirect_stderr(notes):  # a bar would be drawn over
                    found = self._file.judge()
        if found is None:  # what was judged is out of date: what is there now comes next
            return
        self._found, self._text = (None, found) if isinstance(found, str) else (found, "")
        self._notes, self._asked, self._standing = notes.getvalue(), "", None
        self._show(self._report)
        if self._solved:  # the verdict stands there already, and is worth more
            with suppress(JudgeError):
                self._standing = standing(self._kata.problem.id, self._common)
                self._draw()

    def _begun(self, screen: Screen) -> str:
        """The kata, whose file is still to be written."""
        rows = screen.height - _BELOW
        return begun_text(self._place(screen), self._kata.problem, self._kata.name, screen, rows)

    def _place(self, screen: Screen) -> Group:
        problem, (problems, sets, done) = self._kata.problem, self._katas()
        mine = sum(each.id in done for each in problems)
        found = set_of(problem.id, sets)
        return place_text(problem, found, mine, len(problems), screen)

    def _katas(self) -> tuple[Sequence[Problem], Sequence[PracticeSet[Problem]], Collection[str]]:
        """All katas, their sets, and those that are solved."""
        with history_at(self._common.db, reading=True) as history:
            done = solved(history.runs())
        problems, _ = sound_problems(self._common.problems)
        return problems, sound_sets(problems, self._common.problems)[0], done

    def _key(self, key: str) -> Kata | None:
        """Do what a key says; the kata to go on to, if it says so."""
        sure, self._asked = key == self._asked, ""
        try:
            if key == "n":
                if sure or self._solved:
                    return self._next()
                self._ask_again(key, "Not solved yet. Press n again to skip it.")
            elif key == "x":
                if sure:
                    write_stub(self._kata.problem, self._kata.path, over=True)
                else:
                    text = "Start over? Your text will be kept as a .bak file. Press x again."
                    self._ask_again(key, text)
            elif key in _VIEWS:
                self._show(_VIEWS[key](self))
        except JudgeError as fault:
            self._say(str(fault))
        return None

    def _next(self) -> Kata | None:
        """The kata to go on to, taken up; None where all others are solved."""
        common, following = self._common, next_kata(self._kata.problem.id, *self._katas())
        if following is None:
            self._say("All other katas are solved.", GOOD)
            return None
        kata = Kata(following, self._kata.path.with_name(file_name(following.id.replace("-", "_"))))
        if not kata.path.exists():
            write_stub(following, kata.path)
        take_up(kata, common.db)
        return kata

    def hint(self) -> View:
        """The next hint."""
        (hint,) = hints(self._kata.problem, HintAsk(), self._common.db)
        note_seen(hint, self._common.db)
        return lambda screen: drawn(view(hint, screen), screen)

    def statement(self) -> View:
        """The statement."""
        return lambda screen: drawn(prose(self._kata.problem.statement, screen), screen)

    def katas(self) -> View:
        """The katas by set."""
        from judge.cli.commands.look import ListAsk, listed
        from judge.report.look import kata_list

        found = listed(None, ListAsk(), self._common)
        return lambda screen: drawn(kata_list(found, screen), screen)

    def picture(self) -> View:
        """The failing case, drawn below its arguments."""
        found = self._found

        def shown(screen: Screen) -> str:
            if found and not has_room(screen):
                return note_text("A picture needs a terminal of 60 columns that knows braille.", screen)
            drawing = found.rows(screen) if found else None
            if found is None or drawing is None:
                return note_text("There is no failing case to draw.", screen)
            rows = screen.height - _BELOW - 2
            return drawn(magnified(_told(found), drawing, rows, screen.width), screen)

        return shown

    def browser(self) -> View:
        """The failing case on a page where it can be dragged, opened in the browser."""
        problem, page = self._kata.problem, None
        if self._found and (explore := self._found.data.module.hooks.explore):
            failures = (self._found.result.counterexample, self._found.result.failure)
            page = explore(problem, next((each.input for each in failures if each and each.input), None))
        if page is None:
            return lambda screen: note_text(f"There is no page for {problem.id} yet.", screen)
        import click

        with tempfile.NamedTemporaryFile("w", suffix=".html", delete=False, encoding="utf-8") as file:
            file.write(page)
        click.launch(file.name)
        return lambda screen: note_text(f"Opened {file.name}", screen, FAINT)

    def report(self) -> View:
        """What judging came to."""
        return self._report

    def _report(self, screen: Screen) -> str:
        if self._found is None:
            return note_text(self._text, screen)
        after = None
        if self._solved:
            after = accepted(self._kata.problem.id, self._standing, screen.width, key="n")
        told, name, rows = _told(self._found), self._found.result.submission, self._found.rows(screen)
        shown = Shown(told, name, drawing=rows, after=after, commands=False)
        return drawn(result(shown, screen, screen.height - _BELOW - self._notes.count("\n")), screen)

    def _end(self, screen: Screen) -> str:
        """The last lines, whatever else is shown: the verdict."""
        if self._found is None:
            return note_text(self._text, screen) if self._text else ""
        return drawn(verdict_line(_told(self._found), self._kata.name), screen)

    @property
    def _solved(self) -> bool:
        return self._found is not None and self._found.result.solved

    def _ask_again(self, key: str, text: str) -> None:
        self._asked = key
        self._say(text)

    def _say(self, text: str, style: str = WARNING) -> None:
        self._show(lambda screen: note_text(text, screen, style))

    def _show(self, view: View) -> None:
        self._view = view
        self._draw()

    def _draw(self) -> None:
        """All of it at once; the verdict is last, above the keys."""
        screen = out()
        parts = [self._notes, self._view(screen)]
        if self._view != self._report and (end := self._end(screen)):
            parts += ["" if parts[-1].endswith("\n\n") else "\n", end]
        failed = self._found is not None and self._found.result.failure is not None
        redraw(screen, "".join([*parts, "\n"]), keys_text(screen, failed=failed))


def _told(found: Drawing) -> Told:
    """The result in words."""
    return tell(found.problem, found.result, found.source)


_VIEWS: dict[str, Callable[[_Loop], View]] = {
    "h": _Loop.hint,
    "s": _Loop.statement,
    "l": _Loop.katas,
    "p": _Loop.picture,
    "e": _Loop.browser,
    " ": _Loop.report,
    "\n": _Loop.report,
}
