"""Writing laid-out lines to a terminal or into a pipe."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Mapping
from typing import IO

from msgspec import Struct

from judge.report.layout import Line, Style, printable

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
_LEAST_WIDTH = 20
_USUAL_WIDTH = 80  # of a terminal that does not tell


class Screen(Struct, frozen=True):
    """Where a person reads: a stream, whether it takes colour, and its width (None: nothing to wrap for)."""

    stream: IO[str]
    colour: bool
    width: int | None

    @classmethod
    def of(cls, stream: IO[str], environment: Mapping[str, str] | None = None) -> Screen:
        """The screen behind `stream`: coloured on a terminal without NO_COLOR and TERM=dumb, as wide as
        COLUMNS or the terminal says.
        """
        settings = os.environ if environment is None else environment
        terminal = is_terminal(stream)
        colour = terminal and not settings.get("NO_COLOR") and settings.get("TERM") != "dumb"
        return cls(stream, colour, _width(stream, terminal, settings.get("COLUMNS", "")))

    def show(self, lines: Iterable[Line]) -> None:
        """Write the lines."""
        self.write(self.text(lines))

    def text(self, lines: Iterable[Line]) -> str:
        """The lines as they are written there, colours and all."""
        return "".join(f"{self._render(spans)}\n" for spans in lines)

    def write(self, text: str) -> None:
        """Write text that is laid out already; what the stream cannot encode is written out."""
        encoding = getattr(self.stream, "encoding", None) or "utf-8"
        self.stream.write(text.encode(encoding, "backslashreplace").decode(encoding))
        self.stream.flush()

    def _render(self, spans: Line) -> str:
        parts = []
        for span in spans:
            text = printable(span.text)
            code = _CODES[span.style] if self.colour and text.strip() else ""
            parts.append(f"{code}{text}{_RESET}" if code else text)
        return "".join(parts)


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
