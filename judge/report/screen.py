"""What a person reads: a stream, what it can take, and writing to it."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterable
from contextlib import suppress
from typing import IO, TYPE_CHECKING

from msgspec import Struct

from judge.report.words import printable

if TYPE_CHECKING:
    from rich.console import RenderableType
    from rich.segment import Segment

# Only the sixteen colours of the person's own theme, so that light and dark backgrounds both serve.
_BAD, _WARNING, _RESET = "\x1b[31m", "\x1b[33m", "\x1b[0m"
_COMMAND = re.compile(r"^([^\S\n]*)::", re.MULTILINE)
_LEAST_WIDTH = 20
_SENTENCE = 1200  # characters of the judge's own sentences that are shown
_USUAL_WIDTH, _USUAL_ROWS = 80, 24  # of a terminal that does not tell
ENDLESS = 10_000  # columns of a pipe, where nothing is wrapped


class Screen(Struct, frozen=True):
    """Where a person reads: a stream, whether it takes colour, and its width (None: nothing to wrap for)."""

    stream: IO[str]
    colour: bool
    width: int | None

    @classmethod
    def of(cls, stream: IO[str]) -> Screen:
        """The screen behind `stream`: coloured on a terminal without NO_COLOR and TERM=dumb, as wide as
        COLUMNS or the terminal says.
        """
        terminal, settings = is_terminal(stream), os.environ
        colour = terminal and not settings.get("NO_COLOR") and settings.get("TERM") != "dumb"
        columns = settings.get("COLUMNS", "")
        width = int(columns) if columns.isdecimal() else 0
        if not width and terminal:
            width = _size(stream).columns
        return cls(stream, colour, max(width, _LEAST_WIDTH) if width else None)

    @property
    def rows(self) -> int | None:
        """How many rows a person sees at once; None where nobody looks."""
        return self.height if is_terminal(self.stream) else None

    @property
    def height(self) -> int:
        """How many rows can be seen, the usual number where it does not tell."""
        return _size(self.stream).lines

    def write(self, text: str) -> None:
        """Write text that is laid out already; what the stream cannot encode is written out, and so is what
        would be a command to a CI server that reads it.
        """
        encoding = getattr(self.stream, "encoding", None) or "utf-8"
        self.stream.write(_no_command(text).encode(encoding, "backslashreplace").decode(encoding))
        self.stream.flush()


def show(what: RenderableType, screen: Screen, *, paged: bool = False) -> None:
    """Draw what a view returned; with `paged`, what is too long goes to the pager, without colours."""
    text = drawn(what, screen)
    if not (paged and screen.rows and text.count("\n") >= screen.rows):
        screen.write(text)
        return
    import click

    click.echo_via_pager(drawn(what, Screen(screen.stream, False, screen.width)), color=False)


def drawn(what: RenderableType, screen: Screen) -> str:
    """What a view returned, as whole lines of text for that screen.

    Control characters are written out, wherever they come from, and no line ends in blanks.
    """
    from io import StringIO

    from rich.console import Console
    from rich.segment import Segment
    from rich.theme import Theme

    console = Console(
        file=StringIO(),
        width=screen.width or ENDLESS,
        force_terminal=screen.colour,
        color_system="standard" if screen.colour else None,
        markup=False,
        highlight=False,
        emoji=False,
        legacy_windows=False,
        theme=Theme({"markdown.code": "cyan"}),
    )
    rows = Segment.split_lines(console.render(what))  # uncut: what must not be broken may be wider
    return "".join(f"{_row(row, screen)}\n" for row in rows)


def _row(segments: Iterable[Segment], screen: Screen) -> str:
    """One line of rich's, without the blanks that it is filled up with."""
    pieces = [(printable(each.text), each.style) for each in segments if not each.control]
    while pieces and not pieces[-1][0].rstrip(" "):
        pieces.pop()
    if pieces:
        pieces[-1] = (pieces[-1][0].rstrip(" "), pieces[-1][1])
    if not screen.colour:
        return "".join(text for text, _ in pieces)
    from rich.color import ColorSystem

    return "".join(
        style.render(text, color_system=ColorSystem.STANDARD) if style else text for text, style in pieces
    )


def fitted(content: str, columns: int) -> str:
    """The text, control characters written out, in so many columns: the end of a longer one is left out."""
    from rich.cells import cell_len, set_cell_size

    shown = printable(content)
    return shown if cell_len(shown) <= columns else f"{set_cell_size(shown, columns - 1)}…"


def is_terminal(stream: IO[str]) -> bool:
    """Whether a person is looking at `stream`; a closed one is nobody's."""
    try:
        return stream.isatty()
    except ValueError:
        return False


def draws(screen: Screen) -> bool:
    """Whether lines can be drawn over there: a terminal that obeys more than text."""
    return is_terminal(screen.stream) and os.environ.get("TERM", "dumb") != "dumb"


def out() -> Screen:
    """The screen of standard output, looked up now: tests and shells replace it."""
    return Screen.of(sys.stdout)


def err() -> Screen:
    """The screen of standard error."""
    return Screen.of(sys.stderr)


def note(text: str, *, bad: bool = False) -> None:
    """Say a sentence of the judge's own on standard error, beside what the command writes.

    What it quotes may be of any length: of a sentence that is too long the middle is left out. Where that
    stream is full or nobody reads it, nothing is said: what the command does is worth more.
    """
    if len(text) > _SENTENCE:
        text = f"{text[: _SENTENCE * 2 // 3]} … {text[-_SENTENCE // 3 :]}"
    screen, rows = err(), [printable(row) for row in text.splitlines()]
    if screen.width and is_terminal(screen.stream):
        from textwrap import wrap

        rows = [part for row in rows for part in wrap(row, max(screen.width - 7, 20))]
    label = f"{_BAD if bad else _WARNING}judge:{_RESET}" if screen.colour else "judge:"
    try:
        screen.write(f"{label} {f'{chr(10)}       '.join(rows)}\n")
    except OSError:
        hush(sys.stderr)


def hush(stream: IO[str]) -> None:
    """Point a standard stream where nobody minds, so that the interpreter's last flush cannot fail."""
    with suppress(OSError, ValueError):  # already closed, or not a real file: then nothing is left to flush
        descriptor = os.open(os.devnull, os.O_WRONLY)
        os.dup2(descriptor, stream.fileno())
        os.close(descriptor)


def _no_command(text: str) -> str:
    """`text` without GitHub's workflow commands: `::` at a line's start, and `##[` anywhere."""
    return _COMMAND.sub(r"\1\\x3a:", text).replace("##[", r"#\x23[")


class Notes:
    """Says each sentence once, however often a command comes upon it."""

    def __init__(self) -> None:
        self._said: set[str] = set()

    def say(self, texts: Iterable[str]) -> None:
        """Say those of the sentences that were not said yet."""
        for text in texts:
            if text not in self._said:
                self._said.add(text)
                note(text)


def _size(stream: IO[str]) -> os.terminal_size:
    """Of a terminal: as it says, or the usual one."""
    columns = lines = 0
    with suppress(OSError, ValueError):  # a stream that only says it is a terminal
        columns, lines = os.get_terminal_size(stream.fileno())
    return os.terminal_size((columns or _USUAL_WIDTH, lines or _USUAL_ROWS))
