"""Writing laid-out lines to a terminal or into a pipe."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import IO, TYPE_CHECKING

from msgspec import Struct

from judge.report.layout import Line, Link, Span, Style, line, printable, wrap

if TYPE_CHECKING:
    from rich.console import RenderableType
    from rich.segment import Segment

# Only the sixteen colours of the person's own theme, so that light and dark backgrounds both serve.
_CODES = {
    Style.PLAIN: "",
    Style.STRONG: "\x1b[1m",
    Style.FAINT: "\x1b[2m",
    Style.GOOD: "\x1b[32m",
    Style.BAD: "\x1b[31m",
    Style.WARNING: "\x1b[33m",
}
_RESET = "\x1b[0m"
_LINK = "\x1b]8;;{}\x1b\\"  # OSC 8: what follows is a link to this address, up to one without an address
_COMMAND = re.compile(r"^([^\S\n]*)::", re.MULTILINE)
_LEAST_WIDTH = 20
_SENTENCE = 1200  # characters of the judge's own sentences that are shown
_USUAL_WIDTH, _USUAL_ROWS = 80, 24  # of a terminal that does not tell
ENDLESS = 10_000  # columns of a pipe, where nothing is wrapped


class Screen(Struct, frozen=True):
    """Where a person reads: a stream, whether it takes colour, its width (None: nothing to wrap for), and
    whether it can be clicked on.
    """

    stream: IO[str]
    colour: bool
    width: int | None
    links: bool = False

    @classmethod
    def of(cls, stream: IO[str], environment: Mapping[str, str] | None = None) -> Screen:
        """The screen behind `stream`: coloured on a terminal without NO_COLOR and TERM=dumb, as wide as
        COLUMNS or the terminal says.
        """
        settings = os.environ if environment is None else environment
        terminal = is_terminal(stream)
        colour = terminal and not settings.get("NO_COLOR") and settings.get("TERM") != "dumb"
        links = colour and settings.get("TERM") != "linux"  # old consoles of it show the address
        return cls(stream, colour, _width(stream, terminal, settings.get("COLUMNS", "")), links)

    @property
    def rows(self) -> int | None:
        """How many rows a person sees at once; None where nobody looks."""
        if not is_terminal(self.stream):
            return None
        try:
            return os.get_terminal_size(self.stream.fileno()).lines or _USUAL_ROWS
        except (OSError, ValueError):
            return _USUAL_ROWS

    def show(self, lines: Iterable[Line]) -> None:
        """Write the lines."""
        self.write(self.text(lines))

    def text(self, lines: Iterable[Line]) -> str:
        """The lines as they are written there, colours and all."""
        return "".join(f"{self._render(spans)}\n" for spans in lines)

    def write(self, text: str) -> None:
        """Write text that is laid out already; what the stream cannot encode is written out, and so is what
        would be a command to a CI server that reads it.
        """
        encoding = getattr(self.stream, "encoding", None) or "utf-8"
        self.stream.write(_no_command(text).encode(encoding, "backslashreplace").decode(encoding))
        self.stream.flush()

    def _render(self, spans: Line) -> str:
        parts = []
        for span in spans:
            text = printable(span.text)
            if self.links and span.link and text.strip() and (target := _address(span.link)):
                end = len(text.rstrip(" "))  # the filling of a column is no part of it
                text = f"{_LINK.format(target)}{text[:end]}{_LINK.format('')}{text[end:]}"
            code = _CODES[span.style] if self.colour and text.strip() else ""
            parts.append(f"{code}{text}{_RESET}" if code else text)
        return "".join(parts)


def show(what: RenderableType, screen: Screen) -> None:
    """Draw what a view returned."""
    screen.write(drawn(what, screen))


def show_paged(what: RenderableType, screen: Screen) -> None:
    """Draw it; what is longer than the terminal is shown by the pager, without colours."""
    if screen.rows is None or drawn(what, screen).count("\n") < screen.rows:
        show(what, screen)
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

    console = Console(
        file=StringIO(),
        width=screen.width or ENDLESS,
        force_terminal=screen.colour,
        color_system="standard" if screen.colour else None,
        markup=False,
        highlight=False,
        emoji=False,
        legacy_windows=False,
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


def is_terminal(stream: IO[str]) -> bool:
    """Whether a person is looking at `stream`; a closed one is nobody's."""
    try:
        return stream.isatty()
    except ValueError:
        return False


def out() -> Screen:
    """The screen of standard output, looked up now: tests and shells replace it."""
    return Screen.of(sys.stdout)


def err() -> Screen:
    """The screen of standard error."""
    return Screen.of(sys.stderr)


def note(text: str, style: Style = Style.WARNING) -> None:
    """Say a sentence of the judge's own on standard error, beside what the command writes.

    What it quotes may be of any length: of a sentence that is too long the middle is left out. Where that
    stream is full or nobody reads it, nothing is said: what the command does is worth more.
    """
    if len(text) > _SENTENCE:
        text = f"{text[: _SENTENCE * 2 // 3]} … {text[-_SENTENCE // 3 :]}"
    screen = err()
    room = screen.width - 7 if screen.width and is_terminal(screen.stream) else None
    first, *rest = wrap(text, room)
    try:
        screen.show([line(Span("judge:", style), f" {first}"), *(line(f"       {row}") for row in rest)])
    except OSError:
        hush(sys.stderr)


def hush(stream: IO[str]) -> None:
    """Point a standard stream where nobody minds, so that the interpreter's last flush cannot fail."""
    try:
        descriptor = os.open(os.devnull, os.O_WRONLY)
        os.dup2(descriptor, stream.fileno())
        os.close(descriptor)
    except (OSError, ValueError):  # already closed, or not a real file: then nothing is left to flush
        return


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


def _width(stream: IO[str], terminal: bool, columns: str) -> int | None:
    if columns.isdecimal() and int(columns) > 0:
        return max(int(columns), _LEAST_WIDTH)
    if not terminal:
        return None
    try:
        found = os.get_terminal_size(stream.fileno()).columns
    except (OSError, ValueError):  # a stream that only says it is a terminal
        found = 0
    return max(found, _LEAST_WIDTH) if found else _USUAL_WIDTH


def _address(link: Link) -> str:
    """The link as an address, with this machine's name so that nobody opens a file of their own for it."""
    try:
        path = Path(link.path).absolute().as_uri().removeprefix("file://")
    except OSError:  # the current folder is gone
        return ""
    return f"file://{os.uname().nodename}{path}" + (f"#{link.line}" if link.line else "")
