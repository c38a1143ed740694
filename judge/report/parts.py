"""The parts that every view is made of: one table, facts, a bar, a verdict, commands to type, prose.

Text of others (names, messages, sources) goes in as it is: each part writes out what a terminal would obey.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from rich.console import Console, ConsoleOptions, RenderableType, RenderResult
from rich.measure import Measurement
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from judge.problem import Verdict
from judge.report.screen import ENDLESS
from judge.report.words import printable

Cell = str | Text

STRONG, FAINT, GOOD, BAD, WARNING = "bold", "dim", "green", "red", "yellow"
READABLE = 100  # columns that prose has at most, however wide the screen is
_LEAST = 20  # columns of prose below which it goes under its row
_BAR = 40


def text(content: Cell, style: str = "") -> Text:
    """A piece of text in one style; control characters are written out, line breaks too."""
    return content if isinstance(content, Text) else Text(printable(content), style)


def joined(*parts: Cell) -> Text:
    """Several pieces on one line."""
    return Text.assemble(*map(text, parts))


def indented(what: RenderableType, columns: int = 2) -> Padding:
    """`what`, so many columns to the right."""
    return Padding(what, (0, 0, 0, columns))


class _Table(NamedTuple):
    """Lays a table out for the width that it is given."""

    titles: Sequence[str]
    cells: list[list[Text]]
    right: Sequence[int]
    prose: int | None

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        columns, prose = [*range(len(self.titles))], self.prose
        wide = self._widths()
        spare = options.max_width - sum(wide) - 2 * (len(columns) - 1)
        if prose is None or spare + wide[prose] >= min(_LEAST, wide[prose]):
            yield self._laid(columns, self.cells, options)
            return
        kept = [at for at in columns if at != prose]
        for row in self.cells:
            yield self._laid(kept, [row], options)
            if row[prose].plain:
                yield indented(row[prose])

    def __rich_measure__(self, console: Console, options: ConsoleOptions) -> Measurement:
        return Measurement(1, options.max_width)

    def _widths(self) -> list[int]:
        """How many columns of the screen each column would take."""
        rows = [[Text(title) for title in self.titles], *self.cells]
        return [max(each.cell_len for each in column) for column in zip(*rows, strict=True)]

    def _laid(self, columns: Sequence[int], rows: list[list[Text]], options: ConsoleOptions) -> Table:
        titled = any(self.titles) and rows is self.cells
        laid = Table(box=None, show_header=titled, header_style=FAINT, pad_edge=False, padding=(0, 2, 0, 0))
        readable = READABLE if options.max_width < ENDLESS // 2 else None
        left = max(options.max_width - sum(self._widths()[:-1]) - 2 * (len(columns) - 1), 1)
        for at in columns:
            cut = self.prose is None and at == columns[-1]
            laid.add_column(
                Text(self.titles[at]),
                justify="right" if at in self.right else "left",
                overflow="ellipsis" if cut else "fold",
                max_width=left if cut else readable if at == self.prose else None,
                no_wrap=at != self.prose,
            )
        for row in rows:
            laid.add_row(*(row[at] for at in columns))
        return laid


def table(
    titles: Sequence[str],
    rows: Iterable[Sequence[Cell]],
    *,
    right: Sequence[int] = (),
    prose: int | None = -1,
) -> RenderableType:
    """Rows of cells under titles; a column without any text is left out, and those in `right` end flush.

    The column `prose` is wrapped in the room that the others leave, or below its row where that is little;
    where it is None, a row that is too wide is cut.
    """
    cells = [[text(cell) for cell in row] for row in rows]
    kept = [at for at, title in enumerate(titles) if title or any(row[at].plain for row in cells)]
    last = None if prose is None else prose % len(titles)
    return _Table(
        [titles[at] for at in kept],
        [[row[at] for at in kept] for row in cells],
        [kept.index(at) for at in right if at in kept],
        kept.index(last) if last in kept else None,
    )


def facts(pairs: Iterable[tuple[Cell, Cell]]) -> RenderableType:
    """Labels, each with what is said of it."""
    return table(("", ""), [(text(label, FAINT), said) for label, said in pairs])


def commands(pairs: Iterable[tuple[str, str]]) -> RenderableType:
    """Commands to type, each with what it does."""
    return table(("", ""), [(command, text(about, FAINT)) for command, about in pairs])


def bar(done: int, total: int, said: str, width: int | None = None) -> Text:
    """`[####......]  4 of 37 katas`, or whatever is `said`; shorter where the screen is narrow."""
    length = _BAR if width is None or width >= 2 * _BAR else _BAR // 4
    filled = max(length * done // total, 1) if done else 0
    return Text(f"[{'#' * filled:.<{length}}]  {printable(said)}")


def verdict_style(found: Verdict) -> str:
    """The colour of a verdict."""
    return GOOD if found is Verdict.AC else WARNING if found is Verdict.JE else BAD


def verdict(found: Verdict) -> Text:
    """`WA  Wrong answer`, in its colour."""
    return Text.assemble((found.value, f"{STRONG} {verdict_style(found)}"), f"  {found.meaning.capitalize()}")
