"""The loop of `judge start` on a terminal: what is drawn again and again, single keys, and the texts."""

from __future__ import annotations

import atexit
import os
import re
import select
import termios
import tty
from collections.abc import Callable, Sequence
from contextlib import suppress
from functools import partial

from rich.console import Group, RenderableType
from rich.text import Text

from judge.drawing.braille import ROWS
from judge.practice.review import Learner
from judge.problem import Problem
from judge.report.parts import beside, facts, faint, first_that_fits, joined, prose, solved_bar, strong, text
from judge.report.picture import drawing, example_picture
from judge.report.screen import Screen, drawn
from judge.report.words import shown_name

_HOME = "\x1b[H"
_REST_OF_LINE = "\x1b[K"
_REST_OF_SCREEN = "\x1b[J"
_TOGETHER = ("\x1b[?2026h", "\x1b[?2026l")  # shown at once where the terminal knows how; ignored elsewhere
_SEQUENCE = re.compile(r"\x1b(\[[0-9;?]*[ -/]*[@-~]|O.|.)?")  # of an arrow, a function key, Alt and a key
GONE = ""  # told instead of a key when nobody is there any more
_TURNS = {"[6": " ", "[B": " ", "[C": " ", "[5": "b", "[A": "b", "[D": "b"}  # PageDown, PageUp, arrows
_NAMED = ("model", "next", "hint", "statement", "list", "picture", "quit")  # keys, by their first letter
_KEYS = {name[0]: name for name in _NAMED} | {"e": "browser", "x": "start over"}
_SAYING = {"open": "nhslxq", "failed": "nhslpexq", "solved": "mnslxq"}  # the keys that say something then
_PAGE_KEYS = {"space": "more", "b": "back", "Enter": "result", "n": "next", "q": "quit"}
_LAST_THIRD = 2 / 3  # of a page, in which it may end at an empty row


def place(problem: Problem, mine: Learner, screen: Screen) -> Group:
    """The kata's title, where it stands in its set, and how many are solved."""
    said = ""
    if found := mine.set_of(problem.id):
        names = [each.id for each in mine.counted(found)]
        said = f"{found.title.lower()}, kata {names.index(problem.id) + 1} of {len(names)}"
    title = apart(strong(f"{problem.id}  {problem.title}"), faint(said), screen)
    return Group(title, solved_bar(len(mine.solved), len(mine.problems), (), screen.width))


def begun(place: RenderableType, problem: Problem, file: str, screen: Screen, rows: int) -> Group:
    """The kata before its file is written, in so many rows: the task as far as there is room."""
    created = text(f"  Created {shown_name(file)}. Open it in your editor.")
    above = Group(place, Text(), created, Text())
    below = Group(Text(), text("  Write the function, then save. I judge it on every save."))
    statement = problem.statement.partition("\n")[2].partition("\n## ")[0].strip()  # the task alone
    task = prose(statement, screen)
    room = max(rows - drawn(Group(above, below), screen).count("\n"), 2)
    cut = [*Text.from_ansi(drawn(task, screen)).split()[: room - 1], faint("  … press s for the rest")]
    _, picture = drawing(partial(example_picture, problem), screen, "the figure")
    pictured = [beside(task, picture(min(room, ROWS)))] if picture else []
    return Group(above, first_that_fits((*pictured, task, Group(*cut)), screen, room), below)


def waiting_line(file: str, seconds: float, screen: Screen) -> Text:
    """What is being judged, and for how long."""
    said = f"judging {shown_name(file)}  {seconds:.1f} s"
    return faint(said[-(screen.width or 80) + 1 :])


def keys_line(screen: Screen, state: str, *, paged: bool = False) -> Text:
    """The keys of a kata that is open, has failed or is solved, or of a page: what they do, if it fits."""
    shown = {key: _KEYS[key] for key in _SAYING[state]}
    if paged:
        shown = {key: about for key, about in _PAGE_KEYS.items() if key != "n" or state == "solved"}
    for gap in ("   ", "  "):
        line = Text(gap).join(joined(strong(key), " ", about) for key, about in shown.items())
        if line.cell_len < (screen.width or 80):
            return line
    few = [key for key in shown if key not in "pe" and (key != "n" or state == "solved")]
    said = (strong("space"), " more  ", strong("b"), " back  ", strong("Enter"), "  ", strong("q"))
    return joined(*said if paged else (strong(" ".join(few)), "  ", strong("?"), " keys"))


def keys_page(state: str) -> RenderableType:
    """What each key does."""
    return facts((strong(key), _KEYS[key]) for key in _SAYING[state])


def pages(rows: Sequence[str], room: int) -> list[list[str]]:
    """Rows in pages of at most so many.

    A page ends at an empty row where one lies in its last third, and never below a row that stands alone, as
    a heading does.
    """
    found, rest = [], list(rows)
    while len(rest) > room:
        ends = [at for at in range(room, int(room * _LAST_THIRD), -1) if not rest[at].strip()]
        end = next((at for at in ends if rest[at - 1].strip() and rest[at - 2].strip()), room)
        found.append(rest[:end])
        rest = rest[end:]
        while rest and not rest[0].strip():
            rest.pop(0)
    return [*found, rest] if rest or not found else found


def page_head(problem: Problem, what: str, number: int, count: int, screen: Screen) -> Text:
    """`segment  Circle and segment          statement, page 2 of 3`."""
    said = f"{what}, page {number} of {count}" if count > 1 else what
    return apart(strong(f"{problem.id}  {problem.title}"), faint(said), screen)


def apart(left: Text, right: Text, screen: Screen) -> Text:
    """One text at each end of a row, or below each other where there is no room."""
    room = (screen.width or 80) - left.cell_len - right.cell_len
    return joined(left, " " * room if room > 1 else Text("\n"), right)


def redraw(screen: Screen, text: str, prompt: Text) -> None:
    """Replace what is seen by `text`, whole lines, and the prompt below it: in one write, line over line.

    What is more than the screen holds scrolls out of its top, and can be scrolled back to.
    """
    rows = [f"{row}{_REST_OF_LINE}\n" for row in text.splitlines()]
    begin, end = _TOGETHER
    screen.write(f"{begin}{_HOME}{''.join(rows)}{_open(prompt, screen)}{_REST_OF_SCREEN}{end}")


def reprompt(screen: Screen, prompt: Text) -> None:
    """Replace the prompt alone, unless the terminal takes nothing now, as after Ctrl-S."""
    if select.select([], [screen.stream], [], 0)[1]:
        screen.write(f"\r{_open(prompt, screen)}{_REST_OF_SCREEN}")


def _open(prompt: Text, screen: Screen) -> str:
    """A prompt without the end of its line."""
    return drawn(prompt, screen).rstrip("\n")


def single_keys(terminal: int) -> Callable[[], None]:
    """Have the terminal give keys at once, and not show them, until the judge ends. Ctrl-C stays as it is.

    What is returned has that done again, after the process was stopped and goes on.
    """
    before = termios.tcgetattr(terminal)

    def give_back() -> None:
        with suppress(termios.error):  # the terminal is gone
            termios.tcsetattr(terminal, termios.TCSANOW, before)

    atexit.register(give_back)  # however it ends
    take = partial(tty.setcbreak, terminal, termios.TCSANOW)
    take()
    return take


def read_keys(terminal: int, seconds: float) -> list[str]:
    """The keys pressed within so many seconds; of those that send a sequence, the ones that turn pages."""
    if not select.select([terminal], [], [], seconds)[0]:
        return []
    found = b""
    with suppress(OSError):
        found = os.read(terminal, 64)
    return list(_SEQUENCE.sub(_turn, found.decode("ascii", "ignore")).lower()) if found else [GONE]


def _turn(sequence: re.Match[str]) -> str:
    return _TURNS.get((sequence[1] or "").rstrip("~"), "")
