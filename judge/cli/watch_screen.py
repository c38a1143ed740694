"""The loop of `judge start` on a terminal: a kata's file is judged on every save, and keys ask for more.

All of it is one thread. A timer interrupts it while it judges: to say so, to take keys, and to break off what
is out of date.
"""

from __future__ import annotations

import signal
import sys
import tempfile
from collections.abc import Callable
from contextlib import closing, redirect_stderr, suppress
from io import StringIO
from time import monotonic
from typing import Any, NoReturn

from msgspec.structs import replace
from rich.console import Group, RenderableType
from rich.text import Text

from judge.cli.aid import HintAsk, admit, hints, model_beside, model_row, note_seen
from judge.cli.files import explore_page, opened_in_browser
from judge.cli.judging import WatchedFile, with_standing
from judge.cli.options import Common
from judge.cli.resolve import Kata, history_at, take_up
from judge.errors import JudgeError, UsageError
from judge.languages import language_of
from judge.practice.review import Learner, read_learner
from judge.practice.stub import make_stub, usual_name, write_stub
from judge.problem.find import typed
from judge.report import watch as texts
from judge.report.look import BESIDE, model
from judge.report.parts import faint, good, warning
from judge.report.picture import has_room, statement
from judge.report.published_look import HintShown
from judge.report.published_result import RunReport
from judge.report.result import PAGED, begun, magnified, screenful, told_of, verdict_line
from judge.report.screen import Screen, drawn, out
from judge.report.tell import shown_failure
from judge.report.views import view
from judge.run.result import Result

_END = ("q", "\x04", texts.GONE)
_ASKED = {  # what is done when the key is pressed again
    "n": "Not solved yet. Press n again to skip it.",
    "x": "Start over? Your text will be kept as a .bak file. Press x again.",
}
_TITLES = {"s": "statement", "m": "model", "M": "model", "l": "list", "": "result"}
_LOOK = 0.1  # seconds between two looks at the file and the keys
_AGAIN = 2.0  # seconds after which what was broken off is broken off again, if an import has swallowed it
_BELOW = 2  # rows that the keys take, and one to spare
_LEAST_PAGE = 4  # rows of a page


class _OutdatedError(KeyboardInterrupt):
    """What is being judged is wanted no more; it ends as Ctrl-C would end it."""


def loop(kata: Kata, level: str | None, common: Common) -> None:
    """Judge a kata on every save, and those that are gone on to, until the person has enough."""
    screen = out()
    following: Kata | None = kata
    screen.write("\n" * (screen.height - 1))  # what stood there can be scrolled back to
    signal.signal(signal.SIGTERM, _leave)
    signal.signal(signal.SIGHUP, _leave)
    take = texts.single_keys(sys.stdin.fileno())
    try:
        while following:
            following = _Loop(following, level, common, take).watch()
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        texts.reprompt(out(), Text())


def _leave(number: int, _frame: object) -> NoReturn:
    """End like any program that was asked to, but after clearing up."""
    raise SystemExit(128 + number)


class _Loop:
    """One kata on the screen."""

    def __init__(self, kata: Kata, level: str | None, common: Common, take: Callable[[], None]) -> None:
        self._kata, self._common, self._take = kata, common, take
        self._file = WatchedFile(kata, common, level)
        self._stub = make_stub(kata.problem, language_of(kata.path), typed(kata.problem)).encode()
        self._since: float | None = None  # when judging began, while it goes on
        self._found: RunReport | None = None
        self._why = ""  # there is no result
        self._notes = ""  # that came with either
        self._shown: str | Text | HintShown = ""  # the key of a view, or what it says; "" for the result
        self._page, self._pages = 0, 1  # which of them is shown
        self._covered = False  # whether it must be drawn anew
        self._pressed: list[str] = []
        self._asked = ""  # the key before, where it asks for confirmation

    def watch(self) -> Kata | None:
        """Judge on every save and obey the keys; the kata to go on to, or None to end."""
        signal.signal(signal.SIGALRM, self._tick)
        signal.signal(signal.SIGWINCH, self._cover)
        signal.signal(signal.SIGCONT, self._cover)
        with closing(self._file):
            while not self._is_left:
                with suppress(_OutdatedError):
                    if following := self._turn():
                        return following
                self._since = None  # here too: it may have been broken off at the last moment
        return None

    @property
    def _is_left(self) -> bool:
        return any(key in _END for key in self._pressed)

    def _cover(self, *_: object) -> None:
        """The window has another size, or somebody else had it meanwhile."""
        self._covered = True
        self._take()

    def _tick(self, *_: object) -> None:
        """Again and again while it judges: say for how long, unless that is to be broken off."""
        if self._since is None:
            return
        self._pressed += texts.read_keys(sys.stdin.fileno(), 0)
        outdated = self._is_left or self._file.changed
        signal.setitimer(signal.ITIMER_REAL, _AGAIN if outdated else _LOOK)
        if outdated:
            raise _OutdatedError
        with suppress(OSError):  # the terminal is gone
            screen = out()
            texts.reprompt(screen, texts.waiting_line(self._kata.name, monotonic() - self._since, screen))

    def _turn(self) -> Kata | None:
        """Do one thing, or wait a moment for it; the kata to go on to, if a key says so."""
        if self._file.saved():
            self._judge()
        elif self._covered:
            self._draw()
        elif self._pressed:
            return self._obey(self._pressed.pop(0))
        else:
            self._pressed += texts.read_keys(sys.stdin.fileno(), _LOOK)
        return None

    def _judge(self) -> None:
        """Judge what stands in the file, unless that is still the stub."""
        untouched = False
        with suppress(OSError):  # judging says so
            untouched = self._kata.path.read_bytes() == self._stub
        if untouched:
            self._found, self._why, self._notes = None, "", ""
            self._show("")
            return
        screen, notes = out(), StringIO()
        if not (self._found or self._why):
            texts.redraw(screen, drawn(self._place(screen), screen), Text())
        self._since = monotonic()
        signal.setitimer(signal.ITIMER_REAL, _LOOK)
        try:
            with redirect_stderr(notes):  # a bar would be drawn over
                found = self._file.judge(self._begin)
        finally:
            self._since = None
        self._found, self._why = None, ""
        if isinstance(found, str):
            self._why = found
        else:
            self._found = replace(found, commands=False, key="n")
        self._notes, self._asked = notes.getvalue(), ""
        self._show("")
        if self._found and self._found.result.solved:  # the verdict stands there already, and is worth more
            self._found = with_standing(self._found, self._common)
            if standing := self._found.standing:
                row = model_row(self._kata.problem, self._kata.path, self._found.source)
                self._found = replace(self._found, standing=replace(standing, model=row))
            self._draw()

    def _begin(self, result: Result) -> None:
        """Show a verdict that is still to be explained; the timer goes on below it."""
        signal.setitimer(signal.ITIMER_REAL, 0)
        screen = out()
        with suppress(OSError):  # the terminal is gone
            texts.redraw(screen, drawn(Group(begun(result, self._kata.name), ""), screen), Text())
        signal.setitimer(signal.ITIMER_REAL, _LOOK)

    def _learner(self) -> Learner:
        with history_at(self._common.db, reading=True) as history:
            return read_learner(history, self._common.problems)

    def _place(self, screen: Screen) -> RenderableType:
        return texts.place(self._kata.problem, self._learner(), screen)

    @property
    def _state(self) -> str:
        """Whether the kata is open, its file failed on a case, or is solved."""
        solved = self._found is not None and self._found.result.solved
        return "solved" if solved else "failed" if self._case() else "open"

    def _obey(self, key: str) -> Kata | None:
        """Do what a key says; the kata to go on to, if it says so."""
        sure, self._asked = key == self._asked, ""
        try:
            if key == "n" and (sure or self._state == "solved"):
                return self._next()
            if key in " b" and self._pages > 1:
                self._page = min(max(self._page + (1 if key == " " else -1), 0), self._pages - 1)
                self._draw()
                return None
            if key == "x" and sure:
                write_stub(self._kata.problem, self._kata.path, over=True)
            elif key in _ASKED:
                self._asked = key
                self._show(warning(_ASKED[key]))
            elif key == "h" and self._state == "solved":
                self._show(good("Solved. m shows the model solution."))
            elif key == "h":
                (hint,) = hints(self._kata.problem, HintAsk(), self._common.db)
                note_seen(hint, self._common.db)
                self._show(hint)
            elif key == "e":
                self._show(self._browse())
            elif key == "m":
                self._show("M" if self._shown == "m" and (out().width or 0) >= BESIDE else "m")
            elif key in "slp?":
                self._show(key)
            elif key in " \n":
                self._show("")
        except JudgeError as fault:
            self._show(warning(str(fault)))
        return None

    def _next(self) -> Kata | None:
        """The kata to go on to, taken up; None where all others are solved."""
        following = self._learner().next(self._kata.problem.id)
        if following is None:
            self._show(good("All other katas are solved."))
            return None
        kata = Kata(following, self._kata.path.with_name(usual_name(following.id)))
        if not kata.path.exists():
            write_stub(following, kata.path)
        take_up(kata, self._common.db)
        return kata

    def _case(self) -> dict[str, Any] | None:
        """The arguments of the case that is shown; None where no case failed."""
        failure = shown_failure(self._found.result) if self._found else None
        return failure.input if failure else None

    def _browse(self) -> Text:
        """Open the failing case in the browser, on a page where it can be dragged; what to say of that."""
        page = explore_page(self._kata.problem, self._case())
        with tempfile.NamedTemporaryFile("w", suffix=".html", delete=False, encoding="utf-8") as file:
            file.write(page)
        if opened_in_browser(file.name):
            return faint(f"Opened {file.name}")
        return warning(f"No browser here. Open {file.name}")

    def _show(self, shown: str | Text | HintShown) -> None:
        self._shown, self._page = shown, 0
        self._draw()

    def _draw(self) -> None:
        """All of it at once, or a page of it; the verdict is last, above the keys."""
        self._covered, screen, found, shown = False, out(), self._found, self._shown
        end: list[str] = []
        if shown != "" and (found or self._why):
            last = verdict_line(told_of(found), self._kata.name) if found else warning(self._why)
            end = ["", *drawn(last, screen).splitlines()]
        room = screen.height - _BELOW - len(end)
        rows = (self._notes + drawn(self._view(screen, room), screen)).rstrip("\n").splitlines()
        what = "hint" if isinstance(shown, HintShown) else _TITLES.get(str(shown), "")
        if what and (len(rows) > room or shown == "s"):

            def head(count: int) -> list[str]:
                title = texts.page_head(self._kata.problem, what, self._page + 1, count, screen)
                return [*drawn(title, screen).splitlines(), ""]

            pages = texts.pages(rows, max(room - len(head(2)), _LEAST_PAGE))
            self._page, self._pages = min(self._page, len(pages) - 1), len(pages)
            rows = [*head(len(pages)), *pages[self._page]]
        else:
            self._pages = 1
        keys = texts.keys_line(screen, self._state, paged=self._pages > 1)
        texts.redraw(screen, "\n".join([*rows, *end, "", ""]), keys)

    def _view(self, screen: Screen, rows: int) -> RenderableType:
        """What is shown, in so many rows if that can be."""
        problem = self._kata.problem
        match self._shown:
            case "s":
                return statement(problem, screen, titled=False)
            case "m" | "M":
                return self._model(screen)
            case "?":
                return texts.keys_page(self._state)
            case "l":
                from judge.cli.commands.look import ListAsk, listed

                return view(listed(None, ListAsk(), self._common), screen)
            case "p":
                return self._picture(screen, rows)
            case HintShown() as hint:
                return view(hint, screen)
            case Text() as said:
                return said
        if self._found:
            return screenful(self._found, screen, rows - self._notes.count("\n"), PAGED)
        if self._why:
            return warning(self._why)
        return texts.begun(self._place(screen), problem, self._kata.name, screen, rows)

    def _model(self, screen: Screen) -> RenderableType:
        """The model, why it works, and the person's own."""
        problem = self._kata.problem
        try:
            yours = admit(problem, self._common.db)
        except UsageError:
            return warning("Solve it first, or give up: judge solution --give-up")
        shown = model_beside(problem, self._kata.path)
        return model(shown, yours[1] if yours else b"", screen, whole=self._shown == "M")

    def _picture(self, screen: Screen, rows: int) -> RenderableType:
        """The failing case, drawn below its arguments."""
        if self._found and not has_room(screen):
            return warning("A picture needs a terminal of 40 columns that knows braille.")
        drawn = magnified(self._found, screen, rows - 4) if self._found else None
        return drawn or warning("There is no failing case to draw.")
