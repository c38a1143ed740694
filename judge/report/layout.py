"""Laying text out for a terminal of any width: styled spans, wrapping, tables. Pure: nothing is written here.

A line is a tuple of spans. A width of None means that nothing is looking that could be too narrow (a pipe, a
file): then no line is ever broken.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from enum import Enum
from typing import TypeVar

from msgspec import Struct

T = TypeVar("T")


class Style(Enum):
    """What a piece of text is, not how it looks."""

    PLAIN = "plain"
    STRONG = "strong"
    FAINT = "faint"
    GOOD = "good"
    BAD = "bad"
    WARNING = "warning"


class Link(Struct, frozen=True):
    """A file that a piece of text stands for, and a line in it from 1 (0: no line)."""

    path: str
    line: int = 0


class Span(Struct, frozen=True):
    """A run of text in one style; a terminal that can opens its link when it is clicked."""

    text: str
    style: Style = Style.PLAIN
    link: Link | None = None


Line = tuple[Span, ...]

_GAP = 2  # columns between what stands side by side
_SEAM = re.compile(r"[-_/](?=[^\W\d])")


def line(*parts: str | Span) -> Line:
    """One line from plain strings and spans."""
    return tuple(part if isinstance(part, Span) else Span(part) for part in parts)


def printable(text: str) -> str:
    r"""`text` with everything a terminal would obey, or hide, written out, such as `\x1b`.

    A submission's name, message or answer must not steer the terminal it is shown on: no escape sequences,
    no other control characters, no marks that reorder text.
    """
    if text.isprintable():
        return text
    return "".join(
        character if character.isprintable() else character.encode("unicode_escape").decode("ascii")
        for character in text
    )


_COMBINING = "\u0300"  # the first character that takes another number of columns than one


def cells(text: str) -> int:
    """How many columns `text` takes."""
    return len(text) if text.isascii() else sum(_columns(character) for character in text)


def _columns(character: str) -> int:
    if character < _COMBINING:
        return 1
    import unicodedata  # a large table, for what hardly any text holds

    if unicodedata.combining(character):
        return 0
    return 2 if unicodedata.east_asian_width(character) in "WF" else 1


def pad(text: str, width: int, *, right: bool = False) -> str:
    """`text` filled with spaces to `width` columns, at its left where `right` is asked for."""
    filling = " " * (width - cells(text))
    return filling + text if right else text + filling


def wrap(text: str, width: int | None) -> list[str]:
    """`text` in lines of at most `width` columns; its own line breaks stay, what stands in brackets holds
    together where it can, and a word longer than a line is cut.
    """
    paragraphs = [printable(paragraph) for paragraph in text.splitlines()] or [""]
    if width is None:
        return paragraphs
    return [row for paragraph in paragraphs for row in _fill(_chunks(paragraph), max(width, 1))]


def _chunks(text: str) -> Iterator[str]:
    """The words of `text`; words between an opening bracket and its closing one stay one chunk."""
    held: list[str] = []
    depth = 0
    for word in text.split(" "):
        held.append(word)
        depth = max(0, depth + word.count("(") - word.count(")"))
        if not depth:
            yield " ".join(held)
            held = []
    if held:
        yield from held


def _fill(chunks: Iterable[str], width: int) -> list[str]:
    rows: list[str] = []
    row: str | None = None
    for chunk in _fitting(chunks, width):
        if row is None:
            row = chunk
        elif cells(row) + 1 + cells(chunk) <= width:
            row = f"{row} {chunk}"
        else:
            rows.append(row)
            row = chunk
    return [*rows, row or ""]


def _fitting(chunks: Iterable[str], width: int) -> Iterator[str]:
    """The chunks, those wider than a line taken apart at their spaces and then anywhere."""
    for chunk in chunks:
        if cells(chunk) <= width:
            yield chunk
            continue
        for word in chunk.split(" "):
            yield from _cut(word, width)


def _cut(word: str, width: int) -> Iterator[str]:
    """Pieces of a word that is wider than a line; a name or path is cut after a `-`, `_` or `/` if it can."""
    start = 0
    while (end := _fits(word, start, width)) < len(word):
        seam = max((found.end() for found in _SEAM.finditer(word, start, end)), default=0)
        end = seam if seam - start > (end - start) // 3 else end
        yield word[start:end]
        start = end
    if start < end:
        yield word[start:]


def _fits(word: str, start: int, width: int) -> int:
    """Where what fits into `width` columns ends, from `start` on; at least one character does."""
    used = 0
    for index in range(start, len(word)):
        used += _columns(word[index])
        if used > width:
            return max(index, start + 1)
    return len(word)


def hanging(label: Span, text: Span, width: int | None, *, indent: int, column: int) -> list[Line]:
    """`text` beside its label, its further lines below its first; `column` is where it begins."""
    room = None if width is None else min(width, READABLE) - column
    gap = " " * (column - indent - cells(label.text))
    first, *rest = wrap(text.text, room)
    under = " " * column
    return [
        line(" " * indent, label, gap, Span(first, text.style, text.link)),
        *(line(under, Span(row, text.style, text.link)) for row in rest),
    ]


def beside(head: Span, aside: str, width: int | None) -> list[Line]:
    """`head` and a quiet remark to its right, or below it, indented alike, where there is no room."""
    remark = Span(aside, Style.FAINT)
    if not aside:
        room = None if width is None else min(width, READABLE)
        return [line(Span(row, head.style, head.link)) for row in wrap(head.text, room)]
    if width is None or cells(head.text) + _GAP + cells(aside) <= width:
        return [line(head, " " * _GAP, remark)]
    text = head.text.lstrip(" ")
    indent = " " * (len(head.text) - len(text))
    return [
        line(indent, Span(row, span.style, span.link))
        for span in (Span(text, head.style, head.link), remark)
        for row in wrap(span.text, min(width, READABLE) - len(indent))
    ]


class Column(Struct, frozen=True):
    """A column of a table.

    The one that is `flexible` holds prose and gives way when room is short. After it names are broken, those
    of the first column unless another one is `broken` instead. One that is `spare` is left out where no row
    has anything in it.
    """

    title: str
    right: bool = False
    flexible: bool = False
    broken: bool = False
    spare: bool = False


Cell = Span | str

READABLE = 100  # columns that a paragraph has at most, however wide the screen is
_PROSE = 20  # columns below which prose goes under its row instead of beside it
_NAME = 8  # the least that a column of names is narrowed to


class Table(Struct, frozen=True):
    """Rows of cells under titles; `lines` lays it out for a width."""

    columns: tuple[Column, ...]
    rows: Sequence[Sequence[Cell]]
    indent: int = 2

    def lines(self, width: int | None) -> list[Line]:
        """The table within `width` columns: the prose wrapped in its column, or under its row where there is
        no room beside it; then the names of one column are broken, and at last a row becomes a paragraph.
        """
        rows = [[_span(cell) for cell in row] for row in self.rows]
        for index in reversed([at for at, column in enumerate(self.columns) if column.spare]):
            if not any(row[index].text for row in rows):
                kept = [_without(row, index) for row in rows]
                return Table(_without(self.columns, index), kept, self.indent).lines(width)
        widths = self._widths(rows)
        spare = self._spare(widths, width)
        flexible = next((index for index, column in enumerate(self.columns) if column.flexible), None)
        if spare < 0 and flexible is not None:
            if widths[flexible] + spare < _PROSE:
                return self._stacked(rows, flexible, width)
            widths[flexible] += spare
        elif spare < 0 and not self._give_way(widths, spare):
            return self._paragraphs(rows, width)
        head = [row for titles in self._titles() for row in self._row(titles, widths)]
        return [*head, *(laid for row in rows for laid in self._row(row, widths))]

    def _stacked(self, rows: list[list[Span]], flexible: int, width: int | None) -> list[Line]:
        """Every row without its prose, which follows on lines of its own."""
        narrow = Table(_without(self.columns, flexible), (), self.indent)
        bare = [_without(row, flexible) for row in rows]
        widths = narrow._widths(bare)
        if not narrow._give_way(widths, narrow._spare(widths, width)):
            return self._paragraphs(rows, width)
        under = " " * (self.indent + 2)
        room = None if width is None else min(width, READABLE) - len(under)
        laid = [row for titles in narrow._titles() for row in narrow._row(titles, widths)]
        for row, short in zip(rows, bare, strict=True):
            prose = row[flexible]
            laid += narrow._row(short, widths)
            laid += [line(under, Span(text, prose.style)) for text in wrap(prose.text, room) if text]
        return laid

    def _paragraphs(self, rows: list[list[Span]], width: int | None) -> list[Line]:
        """Every row as its name and, below it, what the columns say, each with its title; then its prose."""
        under = " " * (self.indent + 2)
        room = None if width is None else min(width, READABLE) - len(under)
        laid = []
        for name, *rest in rows:
            told = [each for each in zip(rest, self.columns[1:], strict=True) if each[0].text]
            said = [f"{column.title} {span.text}".strip() for span, column in told if not column.flexible]
            prose = [span for span, column in told if column.flexible]
            laid += [
                line(" " * self.indent, Span(text, name.style, name.link)) for text in wrap(name.text, room)
            ]
            laid += [line(under, text) for text in wrap(", ".join(said), room) if text]
            laid += [
                line(under, Span(text, span.style))
                for span in prose
                for text in wrap(span.text, room)
                if text
            ]
        return laid

    def _titles(self) -> list[list[Span]]:
        """The row of titles, if there are any."""
        titles = [Span(column.title, Style.FAINT) for column in self.columns]
        return [titles] if any(title.text for title in titles) else []

    def _widths(self, rows: Sequence[Sequence[Span]]) -> list[int]:
        """How wide each column would like to be."""
        every = [*self._titles(), *rows]
        return [max(cells(printable(row[i].text)) for row in every) for i in range(len(self.columns))]

    def _spare(self, widths: Sequence[int], width: int | None) -> int:
        """The columns left over, negative where there are too few."""
        return 0 if width is None else width - self.indent - sum(widths) - _GAP * (len(widths) - 1)

    def _give_way(self, widths: list[int], spare: int) -> bool:
        """Take what is lacking from the column of names; whether they can bear it."""
        names = next((index for index, column in enumerate(self.columns) if column.broken), 0)
        widths[names] += min(0, spare)
        return spare >= 0 or widths[names] >= _NAME

    def _row(self, row: Sequence[Span], widths: Sequence[int]) -> list[Line]:
        """One row, as many lines high as its highest cell."""
        columns = [wrap(span.text, width) for span, width in zip(row, widths, strict=True)]
        height = max(len(column) for column in columns)
        lines = []
        for level in range(height):
            parts: list[str | Span] = [" " * self.indent]
            for index, column in enumerate(columns):
                text = column[level] if level < len(column) else ""
                filled = pad(text, widths[index], right=self.columns[index].right)
                parts += [Span(filled, row[index].style, row[index].link), " " * _GAP]
            lines.append(_without_trail(line(*parts)))
        return lines


def _without(items: Sequence[T], index: int) -> tuple[T, ...]:
    return (*items[:index], *items[index + 1 :])


def _span(cell: Cell) -> Span:
    return cell if isinstance(cell, Span) else Span(cell)


def _without_trail(laid: Line) -> Line:
    """`laid` without the spaces at its end."""
    spans = list(laid)
    while spans and not (text := spans[-1].text.rstrip(" ")):
        spans.pop()
    if spans:
        spans[-1] = Span(text, spans[-1].style, spans[-1].link)
    return tuple(spans)
