"""The loop of `judge start` on a terminal: the last verdict, what a key asks for, and the keys."""

from __future__ import annotations

import signal
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager, redirect_stderr, suppress
from io import StringIO
from queue import Empty, SimpleQueue
from types import FrameType
from typing import Any, NoReturn

from msgspec.structs import replace
from rich.console import Group, RenderableType
from rich.text import Text

from judge.cli.commands.practise import HintAsk, hints, note_seen
from judge.cli.home import standing
from judge.cli.judging import Wish
from judge.cli.options import Common
from judge.cli.resolve import Kata, history_at, take_up
from judge.cli.watching import WatchedFile
from judge.errors import JudgeError
from judge.judging.api import RunOptions
from judge.languages import language_of
from judge.practice.progress import solved
from judge.practice.stub import make_stub, usual_name, write_stub
from judge.practice.syllabus import Course, read_course
from judge.report.parts import faint, good, warning
from judge.report.picture import has_room, statement
from judge.report.published_result import Judged
from judge.report.result import explained, magnified, screenful, told_of, verdict_line
from judge.report.screen import Screen, drawn, out
from judge.report.tell import shown_failure
from judge.report.views import view
from judge.report.watch import GONE, begun, keys, keys_line, place, redraw, reprompt, waiting_line

_RESIZED = "resized"
_END = ("q", "\x04", GONE)
_LOOK = 0.1  # seconds between two looks at the file
_AGAIN = 2.0  # seconds after which what was broken off is broken off again, if an import has swallowed it
_BELOW = 2  # rows that the keys take, and one to spare

View = Callable[[Screen], RenderableType]


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


class _Judging:
    """A context in which the main thread judges, and another may break that off as Ctrl-C does."""

    def __init__(self) -> None:
        self._turn = threading.Lock()  # so that no interrupt comes when judging is over
        self._begun: float | None = None
        self._broken_off: float | None = None

    def __enter__(self) -> None:
        self._broken_off, self._begun = None, time.monotonic()

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> bool:
        """Judging is over; no error comes of breaking it off."""
        try:
            self._over()
        except KeyboardInterrupt:  # it came at the last moment
            self._over()
            if self._broken_off is None:
                raise
        return kind is KeyboardInterrupt and self._broken_off is not None

    def _over(self) -> None:
        with self._turn:
            self._begun = None

    def tick(self, say: Callable[[float], None], *, outdated: Callable[[], bool]) -> None:
        """If the main thread is judging, say for how many seconds, or break that off."""
        with self._turn:
            if self._begun is None:
                return
            now = time.monotonic()
            if outdated() and (self._broken_off is None or now - self._broken_off > _AGAIN):
                self._broken_off = now
                signal.pthread_kill(threading.main_thread().ident or 0, signal.SIGINT)
            with suppress(OSError):  # the terminal is gone
                say(now - self._begun)


class _Loop:
    """One kata on the screen."""

    def __init__(self, kata: Kata, level: str | None, common: Common) -> None:
        self._kata, self._common = kata, common
        options = RunOptions(isolation=common.isolation, level=level)
        self._file = WatchedFile(kata, Wish(options, db=common.db))
        self._stub = make_stub(kata.problem, language_of(kata.path)).encode()
        self._events: SimpleQueue[str] = SimpleQueue()
        self._judging = _Judging()
        self._found: Judged | None = None
        self._text = ""  # why there is no result
        self._notes = ""
        self._view: View = self._report
        self._views: dict[str, View] = {
            "s": self._statement,
            "l": self._list,
            "p": self._picture,
            " ": self._report,
            "\n": self._report,
        }
        self._asked = ""  # the key before, where it asks for confirmation
        self._leaving = False

    def watch(self) -> Kata | None:
        """Judge on every save and obey the keys; the kata to go on to, or None to end."""
        try:
            with closing(self._file), keys(sys.stdin.fileno(), self._pressed, self._tick) as take:

                def resized(number: int, _frame: object) -> None:
                    if number == signal.SIGCONT:
                        take()
                    self._events.put(_RESIZED)

                with _handled(resized, signal.SIGWINCH, signal.SIGCONT):
                    return self._obey()
        finally:
            reprompt(out(), Text())

    def _pressed(self, key: str) -> None:
        """A key, in the thread that reads them: the one that ends it does so in the middle of judging too."""
        self._leaving = self._leaving or key in _END
        self._events.put(key)

    def _tick(self) -> None:
        """In that thread too, all the time: say what is being judged, unless that is out of date."""
        screen, name = out(), self._kata.name
        self._judging.tick(
            lambda seconds: reprompt(screen, waiting_line(name, seconds, screen)),
            outdated=lambda: self._leaving or self._file.changed,
        )

    def _obey(self) -> Kata | None:
        while not self._leaving:
            if self._file.saved():
                self._judge()
            event = ""
            with suppress(Empty):
                event = self._events.get(timeout=_LOOK)
            if event == _RESIZED:
                self._draw()
            elif event and not self._leaving and (following := self._key(event)):
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
            redraw(screen, drawn(self._place(screen), screen), Text())
        notes = StringIO()
        found: Judged | str | None = None
        with self._judging, redirect_stderr(notes):  # a bar would be drawn over
            if not self._leaving:
                found = self._file.judge()
        if found is None:  # what was judged is out of date: what is there now comes next
            return
        self._found, self._text = None, ""
        if isinstance(found, str):
            self._text = found
        else:
            self._found = replace(found, commands=False, key="n")
        self._notes, self._asked = notes.getvalue(), ""
        self._show(self._report)
        if self._found and self._solved:  # the verdict stands there already, and is worth more
            with suppress(JudgeError):
                self._found = replace(self._found, standing=standing(self._kata.problem.id, self._common))
                self._draw()

    def _begun(self, screen: Screen) -> RenderableType:
        """The kata, whose file is still to be written."""
        rows = screen.height - _BELOW
        return begun(self._place(screen), self._kata.problem, self._kata.name, screen, rows)

    def _place(self, screen: Screen) -> RenderableType:
        return place(self._kata.problem, self._course(), screen)

    def _course(self) -> Course:
        with history_at(self._common.db, reading=True) as history:
            return read_course(solved(history.runs()), self._common.problems)

    def _key(self, key: str) -> Kata | None:
        """Do what a key says; the kata to go on to, if it says so."""
        sure, self._asked = key == self._asked, ""
        try:
            if key == "n" and (sure or self._solved):
                return self._next()
            if key == "x" and sure:
                write_stub(self._kata.problem, self._kata.path, over=True)
            elif key in _ASKED:
                self._asked = key
                self._say(warning(_ASKED[key]))
            elif key == "h":
                self._hint()
            elif key == "e":
                self._browse()
            elif key in self._views:
                self._show(self._views[key])
        except JudgeError as fault:
            self._say(warning(str(fault)))
        return None

    def _next(self) -> Kata | None:
        """The kata to go on to, taken up; None where all others are solved."""
        following = self._course().next(self._kata.problem.id)
        if following is None:
            self._say(good("All other katas are solved."))
            return None
        kata = Kata(following, self._kata.path.with_name(usual_name(following.id)))
        if not kata.path.exists():
            write_stub(following, kata.path)
        take_up(kata, self._common.db)
        return kata

    def _hint(self) -> None:
        """Show the next hint."""
        (hint,) = hints(self._kata.problem, HintAsk(), self._common.db)
        note_seen(hint, self._common.db)
        self._show(lambda screen: view(hint, screen))

    def _case(self) -> dict[str, Any] | None:
        """The arguments of the case that is shown; None where no case failed."""
        failure = shown_failure(self._found.result) if self._found else None
        return failure.input if failure else None

    def _browse(self) -> None:
        """Open the failing case in the browser, on a page where it can be dragged."""
        problem, page = self._kata.problem, None
        if self._found and self._found.data and (explore := self._found.data.module.hooks.explore):
            page = explore(problem, self._case())
        if page is None:
            self._say(warning(f"There is no page for {problem.id} yet."))
            return
        import click

        with tempfile.NamedTemporaryFile("w", suffix=".html", delete=False, encoding="utf-8") as file:
            file.write(page)
        click.launch(file.name)
        self._say(faint(f"Opened {file.name}"))

    def _statement(self, screen: Screen) -> RenderableType:
        return statement(self._kata.problem, screen)

    def _list(self, screen: Screen) -> RenderableType:
        from judge.cli.commands.look import ListAsk, listed

        return view(listed(None, ListAsk(), self._common), screen)

    def _picture(self, screen: Screen) -> RenderableType:
        """The failing case, drawn below its arguments."""
        if self._found and not has_room(screen):
            return warning("A picture needs a terminal of 60 columns that knows braille.")
        told, drawing = explained(self._found, screen) if self._found else (None, None)
        if told is None or drawing is None:
            return warning("There is no failing case to draw.")
        return magnified(told, drawing, screen.height - _BELOW - 2, screen.width)

    def _report(self, screen: Screen) -> RenderableType:
        if self._found is None:
            return warning(self._text)
        return screenful(self._found, screen, screen.height - _BELOW - self._notes.count("\n"))

    def _end(self) -> RenderableType | None:
        """The last line, whatever else is shown: the verdict."""
        if self._found is not None:
            return verdict_line(told_of(self._found), self._kata.name)
        return warning(self._text) if self._text else None

    @property
    def _solved(self) -> bool:
        return self._found is not None and self._found.result.solved

    def _say(self, text: Text) -> None:
        self._show(lambda _screen: text)

    def _show(self, view: View) -> None:
        self._view = view
        self._draw()

    def _draw(self) -> None:
        """All of it at once; the verdict is last, above the keys."""
        screen = out()
        text = self._notes + drawn(self._view(screen), screen)
        if self._view != self._report and (end := self._end()):
            apart = () if text.endswith("\n\n") else ("",)
            text += drawn(Group(*apart, end), screen)
        redraw(screen, f"{text}\n", keys_line(screen, failed=bool(self._case())))


_ASKED = {  # what is done when the key is pressed again
    "n": "Not solved yet. Press n again to skip it.",
    "x": "Start over? Your text will be kept as a .bak file. Press x again.",
}
