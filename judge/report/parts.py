"""The parts that every view is made of: one table, facts, a bar, a verdict, commands to type, Markdown.

Text of others (names, messages, sources) goes in as it is: each part writes out what a terminal would obey.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from functools import partial
from itertools import zip_longest
from typing import NamedTuple

from rich.console import Console, ConsoleOptions, Group, RenderableType, RenderResult
from rich.padding import Padding
from rich.segment import Segment
from rich.table import Table
from rich.text import Text

from judge.problem import Verdict
from judge.report.screen import ENDLESS, Screen, drawn, is_terminal
from judge.report.words import counted, printable, shown_name

Cell = str | Text

STRONG, FAINT, GOOD, BAD, WARNING = "bold", "dim", "green", "red", "yellow"
READABLE = 100  # columns that prose has at most, however wide the screen is
_LEAST = 20  # columns of prose below which it goes under its row
_BAR = 40
_GAP = 3  # columns between a drawing and what stands beside it
_NARROW, _ROOMY = 56, 116  # columns from which a drawing stands beside the text; that has few then
_TEXT = 72  # columns of that text
_STATEMENT = 88  # columns of a statement
_VERDICTS = dict.fromkeys((Verdict.TLE, Verdict.MLE, Verdict.OLE, Verdict.JE), WARNING) | {Verdict.AC: GOOD}
FIGURE = re.compile(r"^!\[[^]]*\]\([^)]*\)\n\n?", re.MULTILINE)
_REMARK = re.compile(r"^( *)(>>> .*?) {2,}(# .*)$", re.MULTILINE)


def text(content: Cell, style: str = "") -> Text:
    """A piece of text in one style; control characters are written out, line breaks too."""
    return content if isinstance(content, Text) else Text(printable(content), style)


strong = partial(text, style=STRONG)  # what a row is about …
faint = partial(text, style=FAINT)  # … and what is said beside it
good = partial(text, style=GOOD)
bad = partial(text, style=BAD)
warning = partial(text, style=WARNING)  # what is worth a look


def joined(*parts: Cell) -> Text:
    """Several pieces on one line."""
    return Text.assemble(*map(text, parts))


def head(name: Cell, *said: Cell) -> Text:
    """A strong name and what is said of it, on one line; what is empty is left out."""
    return joined(strong(name), *(part for each in said if each for part in ("  ", each)))


def blocks(*parts: RenderableType | None) -> Group:
    """The parts below each other, an empty row between two; None is left out."""
    rows = [row for part in parts if part is not None for row in (Text(), part)]
    return Group(*rows[1:])


def heading(name: Cell, *below: RenderableType) -> Group:
    """A name, and what belongs to it right below, indented."""
    return Group(strong(name), *map(indented, below))


def indented(what: RenderableType, columns: int = 2) -> Padding:
    """`what`, so many columns to the right."""
    return Padding(what, (0, 0, 0, columns))


def first_that_fits(layouts: Iterable[RenderableType], screen: Screen, rows: int | None) -> RenderableType:
    """The first of the layouts that takes at most so many rows, or else the last; None for any number."""
    laid: RenderableType = Text()
    for laid in layouts:
        if rows is None or drawn(laid, screen).count("\n") <= rows:
            break
    return laid


class beside(NamedTuple):  # noqa: N801 - it is used as the functions here are
    """A drawing to the right of where its text ends, or below it where there is little room."""

    left: RenderableType
    rows: Sequence[Text]

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        wide, width = max((row.cell_len for row in self.rows), default=0), options.max_width
        room = width - wide - _GAP
        if width < _NARROW or room < width // 2 - _GAP:
            yield Group(self.left, Text(), *self.rows)
            return
        room = min(room, _TEXT) if width >= _ROOMY else room
        lines = console.render_lines(self.left, options.update(width=room), pad=False)
        end = max(map(Segment.get_line_length, lines), default=0) + _GAP
        for line, row in zip_longest(lines, self.rows, fillvalue=None):
            yield from line or ()
            if row is not None:
                yield Segment(" " * (end - Segment.get_line_length(line or [])))
                yield from row.render(console)
            yield Segment.line()


class _Table(NamedTuple):
    """Lays a table out for the width that it is given."""

    titles: Sequence[str]
    cells: list[list[Text]]
    right: Sequence[int]
    prose: int | None

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        columns, prose = [*range(len(self.titles))], self.prose
        cells = zip(map(Text, self.titles), *self.cells, strict=True)
        wide = [max(each.cell_len for each in column) for column in cells]
        spare = options.max_width - sum(wide) - 2 * (len(columns) - 1)
        if prose is None:
            yield self._laid(columns, self.cells, max(sum(wide[-1:]) + spare, 1))
            return
        if spare + wide[prose] >= min(_LEAST, wide[prose]):
            yield self._laid(columns, self.cells, READABLE if options.max_width < ENDLESS // 2 else None)
            return
        kept = [at for at in columns if at != prose]
        for row in self.cells:
            yield self._laid(kept, [row], None)
            if row[prose].plain:
                yield indented(row[prose])

    def _laid(self, columns: Sequence[int], rows: list[list[Text]], most: int | None) -> Table:
        """These columns; the one that is wrapped, or the last that is cut, is so wide at most."""
        titled = any(self.titles) and rows is self.cells
        laid = Table(box=None, show_header=titled, header_style=FAINT, pad_edge=False, padding=(0, 2, 0, 0))
        for at in columns:
            cut = self.prose is None and at == columns[-1]
            laid.add_column(
                Text(self.titles[at]),
                justify="right" if at in self.right else "left",
                overflow="ellipsis" if cut else "fold",
                max_width=most if cut or at == self.prose else None,
                no_wrap=at != self.prose,
            )
        for row in rows:
            laid.add_row(*(row[at] for at in columns))
        return laid


def table(
    rows: Iterable[Sequence[Cell]], *titles: str, right: Sequence[int] = (), prose: int | None = -1
) -> RenderableType:
    """Rows of cells under titles; a column without any text is left out, and those in `right` end flush.

    The column `prose` is wrapped in the room that the others leave, or below its row where that is little;
    where it is None, a row that is too wide is cut.
    """
    cells = [[text(cell) for cell in row] for row in rows]
    named = titles or ("",) * max(map(len, cells), default=0)
    kept = [at for at in range(len(named)) if any(row[at].plain for row in cells)]
    last = None if prose is None or not named else prose % len(named)
    return _Table(
        [named[at] for at in kept],
        [[row[at] for at in kept] for row in cells],
        [kept.index(at) for at in right if at in kept],
        kept.index(last) if last in kept else None,
    )


def paragraph(said: Cell) -> RenderableType:
    """A text that is wrapped."""
    return table([(said,)])


def facts(pairs: Iterable[tuple[Cell, Cell]]) -> RenderableType:
    """Labels, each with what is said of it."""
    return table([(faint(label), said) for label, said in pairs])


def under(name: Cell, rows: Iterable[Cell]) -> Iterator[tuple[Cell, Cell]]:
    """Rows for `facts`, of which the first alone has a label."""
    yield from ((name if at == 0 else "", row) for at, row in enumerate(rows))


def commands(pairs: Iterable[tuple[str, str]]) -> RenderableType:
    """Commands to type, each with what it does."""
    return table([(command, faint(about)) for command, about in pairs])


def bar(done: int, total: int, said: str, width: int | None = None) -> Text:
    """`[####......]  4 of 37 katas`, or whatever is `said`; shorter where the screen is narrow."""
    length = _BAR if width is None or width >= 2 * _BAR else _BAR // 4
    filled = max(length * done // total, 1) if done else 0
    return Text(f"[{'#' * filled:.<{length}}]  {printable(said)}")


def solved_bar(solved: int, katas: int, stars: Sequence[int], width: int | None) -> Text:
    """How many katas are solved, and how many have one star and two, where any has."""
    said = "".join(f"   {'★' * at} {count}" for at, count in enumerate(stars, 1) if count)
    return bar(solved, katas, f"{solved} of {counted(katas, 'kata')}{said}", width)


def verdict_style(found: Verdict) -> str:
    """The colour of a verdict."""
    return _VERDICTS.get(found, BAD)


def label(found: Verdict, said: str = "") -> Text:
    """The verdict in its colour, strong, or what is `said` instead."""
    return text(said or found.value, f"{STRONG} {verdict_style(found)}")


def verdict_head(found: Verdict, meaning: str, name: str, *more: Cell) -> Text:
    """The verdict, its meaning in words, and the file of that name."""
    return joined(label(found), f"  {meaning}  ", strong(shown_name(name)), *more)


def prose(markdown: str, screen: Screen) -> RenderableType:
    """Markdown, drawn where a person is looking; a figure on a line of its own is left out.

    Its colours are those of the person's own theme, without a background, so that light and dark both serve.
    """
    markdown = FIGURE.sub("", markdown)
    if not is_terminal(screen.stream):
        return Text("\n".join(map(printable, markdown.rstrip("\n").split("\n"))))
    from rich.constrain import Constrain
    from rich.markdown import CodeBlock, Heading, Markdown

    class Code(CodeBlock):
        def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
            source = _unbroken(str(self.text).rstrip(), options.max_width - 4)
            yield indented(Text(source, style="cyan"), 4)

    class Title(Heading):
        def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
            self.text.justify = "left"
            self.text.stylize(STRONG)
            yield self.text

    class Statement(Markdown):
        elements = {**Markdown.elements, "fence": Code, "code_block": Code, "heading_open": Title}  # noqa: RUF012

    return Constrain(Statement(markdown, hyperlinks=False), _STATEMENT)


def _unbroken(source: str, width: int) -> str:
    """Examples with a remark at the end of a row that is too wide: the remark goes above the call."""

    def above(row: re.Match[str]) -> str:
        return row[0] if len(row[0]) <= width else f"{row[1]}{row[3]}\n{row[1]}{row[2]}"

    return _REMARK.sub(above, source)
