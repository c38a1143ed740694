"""The loop of `judge start` on a terminal: the last verdict, what a key asks for, and the keys."""

from __future__ import annotations

import sys
import tempfile
import threading
import time
from collections.abc import Callable, Collection, Iterator, Sequence
from contextlib import ExitStack, closing, contextmanager, redirect_stderr, suppress
from io import StringIO
from queue import SimpleQueue
from types import FrameType
from typing import TYPE_CHECKING, NoReturn

from judge.cli.hints import next_hint, note_seen
from judge.cli.home import standing
from judge.cli.kept import history_at
from judge.cli.options import Common
from judge.cli.picture import Drawing
from judge.cli.watching import Kata, WatchedFile, await_event, handled, take_up
from judge.cli.wish import Wish
from judge.errors import JudgeError
from judge.judging.api import RunOptions
from judge.languages import file_name, language_of
from judge.practice.progress import solved
from judge.practice.saves import Saves
from judge.practice.stub import make_stub, write_stub
from judge.practice.syllabus import PracticeSet, next_kata, set_of, sound_sets
from judge.problem import Problem
from judge.problem.find import sound_problems
from judge.report.parts import FAINT, GOOD, WARNING
from judge.report.picture import has_room
from judge.report.result import Shown, accepted, magnified, result, verdict_line
from judge.report.screen import Screen, drawn, out
from judge.report.statement import prose
from judge.report.tell import Told, tell
from judge.report.terminal import GONE, Keys, height, redraw, reprompt
from judge.report.views import view
from judge.report.watch import begun_text, keys_text, note_text, place_text, waiting_text

if TYPE_CHECKING:
    from rich.console import Group, RenderableType

    from judge.report.published_start import Standing
    from judge.run.result import Failure, Result

_SAVED, _RESIZED = "saved", "resized"
_END = ("q", "\x04", GONE)
_AGAIN = 2.0  # seconds that breaking off may take
_TICK = 0.1  # seconds between two states of the line that says what is being judged
_NO_CASE = "There is no failing case to draw."
_BELOW = 2  # rows that the keys take, and one to spare

View = Callable[[Screen], str]


def loop(kata: Kata, level: str | None, common: Common) -> None:
    """Judge a kata on every save, and those that are gone on to, until the person has enough."""
    screen = out()
    screen.write("\n" * (height(screen) - 1))  # what stood there can be scrolled back to
    following: Kata | None = kata
    with handled(dict.fromkeys(("SIGTERM", "SIGHUP"), _leave)):
        while following is not None:
            following = _Loop(following, level, common).watch()


def _leave(number: int, _frame: FrameType | None) -> NoReturn:
    """End like any program that was asked to, but after clearing up."""
    raise SystemExit(128 + number)


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
        self._kata, self._level, self._common = kata, level, common
        options = RunOptions(isolation=common.isolation, level=level)
        self._file = WatchedFile(kata, Wish(options, db=common.db))
        self._stub = make_stub(kata.problem, language_of(kata.path)).encode()
        self._events: SimpleQueue[str] = SimpleQueue()
        self._found: Drawing | str = ""
        self._notes = ""
        self._standing: Standing | None = None
        self._view: View = self._report
        self._asked = ""  # the key before, where it asks for confirmation
        self._leaving = False

    def watch(self) -> Kata | None:
        """Judge on every save and obey the keys; the kata to go on to, or None to end."""
        try:
            with ExitStack() as stack:
                stack.enter_context(closing(self._file))
                keys = stack.enter_context(Keys(sys.stdin.fileno(), self._pressed))
                stack.enter_context(handled(self._signals(keys)))
                stack.enter_context(Saves(self._kata.path, self._saved))
                return self._obey()
        except KeyboardInterrupt:
            if not self._leaving:
                raise
            return None
        finally:
            reprompt(out(), "")

    def _signals(self, keys: Keys) -> dict[str, Callable[..., None]]:
        def go_on(*_: object) -> None:
            keys.take()
            self._events.put(_RESIZED)

        return {"SIGWINCH": lambda *_: self._events.put(_RESIZED), "SIGCONT": go_on}

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
            event = await_event(self._events)
            if event == _RESIZED:
                self._draw()
            elif event and event != _SAVED and not self._leaving:
                following = self._key(event)
                if following is not None:
                    return following
        return None

    def _judge(self) -> None:
        """Judge what stands in the file, unless that is still the stub."""
        if self._is_stub():
            self._found, self._notes = "", ""
            self._show(self._begun)
            return
        screen = out()
        if not self._found:
            redraw(screen, drawn(self._place(screen), screen), "")
        notes = StringIO()
        found: Drawing | str | None = None
        with self._file.judging:
            if not self._leaving:
                with _waiting(screen, self._kata.name), redirect_stderr(notes):  # a bar would be drawn over
                    found = self._file.judge()
        if found is None:  # what was judged is out of date: what is there now comes next
            return
        self._found, self._notes = found, notes.getvalue()
        self._asked, self._standing = "", None
        self._show(self._report)
        if self._solved():  # the verdict stands there already, and is worth more
            with suppress(JudgeError):
                self._standing = standing(self._kata.problem.id, self._common)
                self._draw()

    def _is_stub(self) -> bool:
        try:
            return self._kata.path.read_bytes() == self._stub
        except OSError:  # judging says so
            return False

    def _begun(self, screen: Screen) -> str:
        """The kata, whose file is still to be written."""
        rows = height(screen) - _BELOW
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
        asked, self._asked = self._asked, ""
        try:
            if key == "n":
                return self._next(confirmed=asked == "n")
            if key == "x":
                self._start_over(confirmed=asked == "x")
            elif key in _VIEWS:
                self._show(_VIEWS[key](self))
        except JudgeError as fault:
            self._say(str(fault))
        return None

    def _next(self, *, confirmed: bool) -> Kata | None:
        """The kata to go on to; one that is not solved is only left when that is asked for twice."""
        problem, common = self._kata.problem, self._common
        if not (confirmed or self._solved()):
            self._ask_again("n", "Not solved yet. Press n again to skip it.")
            return None
        problems, sets, done = self._katas()
        following = next_kata(problem.id, problems, sets, done)
        if following is None:
            self._say("All other katas are solved.", GOOD)
            return None
        kata = Kata(following, self._kata.path.with_name(file_name(following.id.replace("-", "_"))))
        if not kata.path.exists():
            write_stub(following, kata.path)
        take_up(kata, common.db)
        return kata

    def _start_over(self, *, confirmed: bool) -> None:
        """Write the stub again, once that is asked for twice."""
        if not confirmed:
            self._ask_again("x", "Start over? Your text will be kept as a .bak file. Press x again.")
            return
        write_stub(self._kata.problem, self._kata.path, over=True)

    def hint(self) -> View:
        """The next hint."""
        hint = next_hint(self._kata.problem, self._common.db)
        note_seen(hint, self._common.db)
        return lambda screen: drawn(view(hint, screen), screen)

    def statement(self) -> View:
        """The statement."""
        return lambda screen: drawn(prose(self._kata.problem.statement, screen), screen)

    def katas(self) -> View:
        """The katas by set."""
        from judge.cli.commands.look import ListAsk, listed
        from judge.report.katas import kata_list

        found = listed(None, ListAsk(), self._common)
        return lambda screen: drawn(kata_list(found, screen), screen)

    def picture(self) -> View:
        """The failing case, drawn below its arguments."""
        found = self._found
        if isinstance(found, str):
            return lambda screen: note_text(_NO_CASE, screen)
        return lambda screen: picture_text(found, screen, _BELOW + 2)

    def browser(self) -> View:
        """The failing case on a page where it can be dragged, opened in the browser."""
        found = self._found
        explore = None if isinstance(found, str) else found.data.module.hooks.explore
        case = None if isinstance(found, str) else smallest(found.result)
        page = explore(self._kata.problem, case.input if case else None) if explore else None
        if page is None:
            return lambda screen: note_text(f"There is no page for {self._kata.problem.id} yet.", screen)
        import click

        with tempfile.NamedTemporaryFile("w", suffix=".html", delete=False, encoding="utf-8") as file:
            file.write(page)
        click.launch(file.name)
        return lambda screen: note_text(f"Opened {file.name}", screen, FAINT)

    def report(self) -> View:
        """What judging came to."""
        return self._report

    def _report(self, screen: Screen) -> str:
        if isinstance(self._found, str):
            return note_text(self._found, screen)
        after = None
        if self._solved():
            after = accepted(self._kata.problem.id, self._standing, screen.width, key="n")
        return result_text(self._found, screen, _BELOW + self._notes.count("\n"), after)

    def _end(self, screen: Screen) -> str:
        """The last lines, whatever else is shown: the verdict."""
        if isinstance(self._found, str):
            return note_text(self._found, screen) if self._found else ""
        return drawn(verdict_line(told_of(self._found), self._kata.name), screen)

    def _solved(self) -> bool:
        return not isinstance(self._found, str) and self._found.result.solved

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
        failed = not isinstance(self._found, str) and self._found.result.failure is not None
        redraw(screen, "".join([*parts, "\n"]), keys_text(screen, failed=failed))


def smallest(result: Result) -> Failure | None:
    """The smallest case that fails, of those whose arguments are known."""
    return next((each for each in (result.counterexample, result.failure) if each and each.input), None)


def picture_text(found: Drawing, screen: Screen, spare: int) -> str:
    """The failing case and its picture, which leave so many rows of the terminal free."""
    if not has_room(screen):
        return note_text("A picture needs a terminal of 60 columns that knows braille.", screen)
    drawing = found.rows(screen)
    if drawing is None:
        return note_text(_NO_CASE, screen)
    return drawn(magnified(told_of(found), drawing, height(screen) - spare, screen.width), screen)


def result_text(found: Drawing, screen: Screen, spare: int, after: RenderableType | None = None) -> str:
    """A result, and what follows it, that leaves so many rows of the terminal free."""
    shown = Shown(
        told_of(found), found.result.submission, drawing=found.rows(screen), after=after, commands=False
    )
    return drawn(result(shown, screen, height(screen) - spare), screen)


def told_of(found: Drawing) -> Told:
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
