"""A text in Markdown: drawn on a terminal, as it is in a pipe."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from judge.report.screen import Screen, is_terminal

if TYPE_CHECKING:
    from rich.console import RenderableType

_FIGURE = re.compile(r"^!\[[^]]*\]\([^)]*\)\n\n?", re.MULTILINE)
_READABLE = 88  # columns of prose that an eye follows with ease
_REMARK = re.compile(r"^( *)(>>> .*?) {2,}(# .*)$", re.MULTILINE)


def prose(text: str, screen: Screen) -> RenderableType:
    """The Markdown `text`, drawn where a person is looking; a figure on a line of its own is left out.

    Its colours are those of the person's own theme, without a background, so that light and dark both serve.
    """
    from rich.console import Console, ConsoleOptions, RenderResult
    from rich.markdown import CodeBlock, Heading, Markdown
    from rich.padding import Padding
    from rich.text import Text
    from rich.theme import Theme

    from judge.report.words import printable

    text = _FIGURE.sub("", text)
    if not is_terminal(screen.stream):
        return Text("\n".join(printable(row) for row in text.rstrip("\n").split("\n")))

    class Code(CodeBlock):
        def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
            source = _unbroken(str(self.text).rstrip(), options.max_width - 4)
            yield Padding(Text(source, style="cyan"), (0, 0, 0, 4))

    class Title(Heading):
        def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
            self.text.justify = "left"
            self.text.stylize("bold")
            yield self.text

    class Statement(Markdown):
        elements = {**Markdown.elements, "fence": Code, "code_block": Code, "heading_open": Title}  # noqa: RUF012

        def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
            width = min(options.max_width, _READABLE)
            with console.use_theme(Theme({"markdown.code": "cyan"})):
                yield from super().__rich_console__(console, options.update(width=width))

    return Statement(text, hyperlinks=False)


def _unbroken(source: str, width: int) -> str:
    """Examples with a remark at the end of a row that is too wide: the remark goes above the call."""

    def above(row: re.Match[str]) -> str:
        return row[0] if len(row[0]) <= width else f"{row[1]}{row[3]}\n{row[1]}{row[2]}"

    return _REMARK.sub(above, source)
