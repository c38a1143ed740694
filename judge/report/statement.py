"""A problem's statement: drawn on a terminal, as its own Markdown in a pipe."""

from __future__ import annotations

import re

from judge.report.layout import line
from judge.report.screen import Screen, is_terminal

_FIGURE = re.compile(r"^!\[[^]]*\]\([^)]*\)\n\n?", re.MULTILINE)
_READABLE = 88  # columns of prose that an eye follows with ease


def show_statement(text: str, screen: Screen) -> None:
    """Write the Markdown `text`, rendered where a person is looking."""
    screen.write(statement_text(text, screen))


def statement_text(text: str, screen: Screen) -> str:
    """The Markdown `text` for that screen, ready to be written: rendered where a person is looking.

    A figure on a line of its own is left out.
    """
    text = _FIGURE.sub("", text)
    if is_terminal(screen.stream):
        return _rendered(text, screen)
    return screen.text(line(row) for row in text.rstrip("\n").split("\n"))


def _rendered(text: str, screen: Screen) -> str:
    """Draw it in the colours of the person's own theme: no background, so that light and dark both serve."""
    from io import StringIO

    from rich.console import Console, ConsoleOptions, RenderResult
    from rich.markdown import CodeBlock, Heading, Markdown
    from rich.padding import Padding
    from rich.text import Text
    from rich.theme import Theme

    class Code(CodeBlock):
        def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
            yield Padding(Text(str(self.text).rstrip(), style="cyan"), (0, 0, 0, 4))

    class Title(Heading):
        def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
            self.text.justify = "left"
            yield self.text

    class Statement(Markdown):
        elements = {**Markdown.elements, "fence": Code, "code_block": Code, "heading_open": Title}  # noqa: RUF012

    styles = {"markdown.code": "cyan", "markdown.h1": "bold underline", "markdown.h2": "bold"}
    drawn = StringIO()
    console = Console(
        file=drawn,
        force_terminal=True,
        width=min(screen.width or _READABLE, _READABLE),
        color_system="standard" if screen.colour else None,
        no_color=not screen.colour,
        highlight=False,
        theme=Theme(styles),
    )
    console.print(Statement(text, hyperlinks=False))
    return drawn.getvalue()
