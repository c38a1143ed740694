"""The screen of `judge watch`: the last verdict, what is asked for by a key, and the keys."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from contextlib import ExitStack, closing, redirect_stderr
from io import StringIO
from pathlib import Path
from queue import SimpleQueue

from judge.cli.hints import next_hint, note_seen
from judge.cli.kata import Kata, next_problem, take_up, the_path, write_stub
from judge.cli.picture import Drawing
from judge.cli.watching import WatchedFile, await_event, handled
from judge.cli.wish import Wish
from judge.errors import ExitCode, JudgeError
from judge.kata.saves import Saves
from judge.kata.stub import file_name
from judge.report.layout import Line, Style, line
from judge.report.picture import has_room
from judge.report.practice import practice_lines
from judge.report.results import verdict_lines
from judge.report.screen import Screen, drawn, out
from judge.report.terminal import GONE, Keys, height, redraw, reprompt
from judge.report.views import view
from judge.report.watch import note_text, prompt_text, report_lines

_SAVED, _RESIZED = "saved", "resized"
_END = ("q", "\x04", GONE)
_AGAIN = 2.0  # seconds that breaking off may take
_BELOW = 2  # rows that the keys take, and one to spare

View = Callable[[Screen], str]


def watch_on_screen(kata: Kata, wish: Wish, folders: Sequence[Path]) -> ExitCode:
    """Watch a kata, and those that are gone on to, until the person has enough."""
    screen = out()
    screen.write("\n" * (height(screen) - 1))  # what stood there can be scrolled back to
    following: Kata | None = kata
    while following is not None:
        following = _WatchScreen(following, wish, folders).watch()
    return ExitCode.ACCEPTED


class _WatchScreen:
    """One kata on the screen."""

    def __init__(self, kata: Kata, wish: Wish, folders: Sequence[Path]) -> None:
        self._kata = kata
        self._wish = wish
        self._folders = folders
        self._file = WatchedFile(kata, wish)
        self._events: SimpleQueue[str] = SimpleQueue()
        self._found: Drawing | str = ""
        self._notes = ""
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
        screen = out()
        busy = note_text(f"judging {self._kata.name} …", screen, Style.FAINT).splitlines()[0]
        if self._found:
            reprompt(screen, busy)
        else:
            problem = self._kata.problem
            redraw(screen, note_text(f"{problem.id}: {problem.title}", screen, Style.STRONG) + "\n", busy)
        notes = StringIO()
        found: Drawing | str | None = None
        with self._file.judging:
            if not self._leaving:
                with redirect_stderr(notes):  # which would be drawn over; a progress bar does without
                    found = self._file.judge()
        if found is None:  # what was judged is out of date: what is there now comes next
            return
        self._found, self._notes = found, notes.getvalue()
        self._view, self._asked = self._report, ""
        self._draw()

    def _key(self, key: str) -> Kata | None:
        """Do what a key says; the kata to go on to, if it says so."""
        asked, self._asked = self._asked, ""
        try:
            if key == "n":
                return self._next(confirmed=asked == "n")
            if key == "r":
                self._judge()
            elif key in _VIEWS:
                self._show(_VIEWS[key](self))
        except JudgeError as fault:
            self._say(str(fault))
        return None

    def _next(self, *, confirmed: bool) -> Kata | None:
        """The kata to go on to; one that is not solved is only left when that is asked for twice."""
        problem = self._kata.problem
        if not (confirmed or self._solved()):
            self._asked = "n"
            self._say(f"{problem.id} is not solved yet; n once more leaves it for now")
            return None
        following = next_problem(problem.id, the_path(self._folders, self._wish.db)[1])
        if following is None:
            self._say("every other kata of the path is passed", Style.GOOD)
            return None
        kata = Kata(following, self._kata.path.with_name(file_name(following)))
        if not kata.path.exists():
            write_stub(following, kata.path)
        if self._wish.kept:
            take_up(kata, self._wish.db)
        return kata

    def hint(self) -> View:
        """The next hint."""
        hint = next_hint(self._kata.problem, self._wish.db)
        note_seen(hint, self._wish.db)
        return lambda screen: drawn(view(hint, screen), screen)

    def path(self) -> View:
        """The path, and how far one is."""
        path, katas = the_path(self._folders, self._wish.db)
        in_hand = self._kata.problem.id
        return lambda screen: screen.text(practice_lines(path, katas, in_hand, screen.width))

    def why(self) -> View:
        """What the failing group shows, and the mistakes that it rejects."""
        problem = self._kata.problem
        failure = None if isinstance(self._found, str) else self._found.result.failure
        group = problem.group(failure.group) if failure and failure.group else None
        if group is None:
            text = f"no test group fails; judge show {problem.id} --groups lists them all"
            return lambda screen: note_text(text, screen)
        from judge.report.katas import group_details  # which imports rich

        return lambda screen: drawn(group_details(problem, [group]), screen)

    def picture(self) -> View:
        """The failing case, drawn."""
        found = self._found

        def shown(screen: Screen) -> str:
            if not has_room(screen):
                return note_text("a picture wants a terminal of 60 columns that knows braille", screen)
            lines = [] if isinstance(found, str) else found.lines(screen, height(screen) - _BELOW - 2)
            return screen.text(lines) if lines else note_text("there is no failing case to draw", screen)

        return shown

    def report(self) -> View:
        """What judging came to."""
        return self._report

    def _report(self, screen: Screen) -> str:
        if isinstance(self._found, str):
            return note_text(self._found, screen)
        found, spare = self._found, _BELOW + self._notes.count("\n")
        rows, hurdle = height(screen) - spare, found.hurdle(screen.width)

        def laid(drawn: Sequence[Line]) -> list[Line]:
            return report_lines(found.result, screen, rows, drawn, hurdle)

        return screen.text(found.beside(laid, screen, spare=spare))

    def _end(self, screen: Screen) -> str:
        """The last lines, whatever else is shown: the verdict."""
        if isinstance(self._found, str):
            return note_text(self._found, screen)
        return screen.text(verdict_lines(self._found.result, screen.width, alone=True))

    def _solved(self) -> bool:
        return not isinstance(self._found, str) and self._found.result.solved

    def _say(self, text: str, style: Style = Style.WARNING) -> None:
        self._show(lambda screen: note_text(text, screen, style))

    def _show(self, view: View) -> None:
        self._view = view
        self._draw()

    def _draw(self) -> None:
        """All of it at once; the verdict is last, above the keys."""
        screen = out()
        parts = [screen.text(line(row) for row in self._notes.splitlines()), self._view(screen)]
        if self._view != self._report:
            parts += ["" if parts[-1].endswith("\n\n") else "\n", self._end(screen)]
        redraw(screen, "".join([*parts, "\n"]), prompt_text(screen))


_VIEWS: dict[str, Callable[[_WatchScreen], View]] = {
    "h": _WatchScreen.hint,
    "l": _WatchScreen.path,
    "w": _WatchScreen.why,
    "p": _WatchScreen.picture,
    " ": _WatchScreen.report,
    "\n": _WatchScreen.report,
}
