"""The manual on a terminal: its topics, a page by the pager, where words were found."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from judge.manual import Hit, Page
from judge.report.layout import Column, Line, Span, Style, Table, hanging, line, wrap
from judge.report.screen import Screen, is_terminal
from judge.report.statement import statement_text
from judge.report.terminal import height

_HITS = 12  # that are shown


def topic_lines(pages: Sequence[Page], width: int | None) -> Iterator[Line]:
    """Every topic with its title, and how to read one."""
    columns = (Column(""), Column("", flexible=True))
    yield from Table(columns, [(Span(each.name, Style.STRONG), each.title) for each in pages]).lines(width)
    yield line()
    for row in wrap("judge help TOPIC reads one, judge help --search WORD… finds words", width):
        yield line(row)


def show_page(text: str, screen: Screen) -> None:
    """Write a page of Markdown: rendered for a person, by the pager where it is longer than the terminal."""
    shown = statement_text(text, screen)
    if is_terminal(screen.stream) and shown.count("\n") >= height(screen):
        import click

        click.echo_via_pager(shown, color=None if screen.colour else False)  # None has `less` show colours
    else:
        screen.write(shown)


def found_lines(hits: Sequence[Hit], words: str, width: int | None) -> Iterator[Line]:
    """The sections that have the words, the page's name before each."""
    for hit in hits[:_HITS]:
        head = f"{hit.page}: {hit.heading}" if hit.heading else hit.page
        yield from hanging(Span(head, Style.STRONG), Span(""), width, indent=0, column=len(head) + 1)
        yield from (line(f"  {row}") for row in wrap(hit.line, None if width is None else width - 2))
    if len(hits) > _HITS:
        yield line(Span(f"and {len(hits) - _HITS} more sections", Style.FAINT))
    if not hits:
        yield line(f"The manual does not have '{words}'.")
