"""The cohort on the screen: of each problem the mistakes and the groups that fail, then who needs a word."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property

from msgspec import Struct

from judge.report.cohort import EQUAL_CAUTION, Cohort, GroupBar, MistakeBar, ProblemView
from judge.report.layout import (
    READABLE,
    Line,
    Span,
    Style,
    beside,
    cells,
    hanging,
    line,
    pad,
    printable,
    wrap,
)
from judge.report.screen import Screen, is_terminal
from judge.report.values import counted

_MISTAKES, _GROUPS, _NAMES, _SETS = 5, 4, 8, 6  # that are shown where not everything is
_SIDE_BY_SIDE = 120  # columns from which the groups stand beside the mistakes
_NARROW = 60  # columns below which a bar stands under its label
_LABEL = 34  # columns of a label at most
_WIDEST = 30  # columns of a bar
_NAME = 32  # columns of a person's name at most
_GAP, _MIDDLE = 4, 80  # between two blocks, and where the second one begins at most


class Glyphs(Struct, frozen=True):
    """What bars and cuts are drawn with."""

    bar: str = "▇"
    cut: str = "…"

    @classmethod
    def of(cls, screen: Screen) -> Glyphs:
        """Blocks, or what a plain terminal has."""
        blocks = cls()
        try:
            (blocks.bar + blocks.cut).encode(getattr(screen.stream, "encoding", None) or "utf-8")
        except UnicodeEncodeError:
            return cls("#", "...")
        dumb = is_terminal(screen.stream) and os.environ.get("TERM", "dumb") == "dumb"
        return cls("#", "...") if dumb else blocks


def cohort_lines(
    cohort: Cohort,
    width: int | None,
    *,
    whole: bool = False,
    glyphs: Glyphs = Glyphs(),  # noqa: B008 - frozen
) -> Iterator[Line]:
    """The cohort within `width` columns, folded unless the `whole` of it is asked for."""
    view = _View(cohort, width, whole, glyphs)
    for problem in cohort.views:
        yield from view.problem(problem)
        yield line()
    yield from view.people()


class _View:
    """One cohort on one screen."""

    def __init__(self, cohort: Cohort, width: int | None, whole: bool, glyphs: Glyphs) -> None:
        self._cohort, self._width, self._whole, self._glyphs = cohort, width, whole, glyphs
        self._names = {each.id: self._cut(each.id) for each in cohort.people}  # as the table has them
        bars = [bar for view in cohort.views for bar in view.mistakes]
        self._label = min(_LABEL, max((cells(printable(_words(bar))) for bar in bars), default=0))

    def problem(self, view: ProblemView) -> Iterator[Line]:
        """How many handed in, the mistakes as bars, and the groups that fail."""
        of = f"{view.handed_in} of {len(self._cohort.people)} handed in, {view.accepted} accepted"
        yield from beside(Span(view.problem, Style.STRONG), of, self._width)
        left = self._mistakes(view)
        if self._width is not None and self._width >= _SIDE_BY_SIDE:
            yield from _side_by_side(left, self._groups(view.groups), self._width)
            return
        yield from left
        if self._whole:
            yield from self._groups(view.groups)
        elif view.groups:
            told = [f"{each.name} {each.failed}" for each in view.groups[:_GROUPS]]
            yield from self._listed("groups failed", told, len(view.groups))

    def _mistakes(self, view: ProblemView) -> list[Line]:
        shown = view.mistakes if self._whole else view.mistakes[:_MISTAKES]
        most = max((bar.count for bar in view.mistakes), default=1)
        laid: list[Line] = []
        for bar in shown:
            style = Style.PLAIN if bar.named else Style.FAINT
            laid += self._bar(Span(_words(bar), style), bar.count, most, view.handed_in)
            if self._whole:
                laid += self._listed("", [self._names[each] for each in bar.students], bar.count, column=4)
        return [*laid, *_more(len(view.mistakes) - len(shown), "mistake or verdict", "mistakes or verdicts")]

    def _groups(self, groups: Sequence[GroupBar]) -> list[Line]:
        shown = groups if self._whole else groups[:_MISTAKES]
        most = max((bar.failed for bar in groups), default=1)
        laid = [
            row for bar in shown for row in self._bar(Span(f"fails {bar.name}"), bar.failed, most, bar.run)
        ]
        return [*laid, *_more(len(groups) - len(shown), "group", "groups")]

    def _bar(self, label: Span, count: int, most: int, of: int) -> list[Line]:
        """One bar; under its label where the screen is narrow."""
        narrow = self._width is not None and self._width < _NARROW
        room = min(_WIDEST, self._width - 16) if narrow and self._width else _WIDEST
        blocks = self._glyphs.bar * max(1, round(count * min(1.0, room / most)))
        tail = (f"{count:>3} ", Span(blocks, Style.WARNING), Span(f" of {of}", Style.FAINT))
        if narrow:
            rows = wrap(label.text, self._width - 2 if self._width else None)
            return [*(line("  ", Span(row, label.style)) for row in rows), line("  ", *tail)]
        first, *rest = wrap(label.text, self._label_room)
        return [
            line("  ", Span(pad(first, self._label_room), label.style), " ", *tail),
            *(line("  ", Span(row, label.style)) for row in rest),
        ]

    @cached_property
    def _label_room(self) -> int:
        groups = [cells(f"fails {bar.name}") for view in self._cohort.views for bar in view.groups]
        beside_it = self._whole or (self._width or 0) >= _SIDE_BY_SIDE
        return max(self._label, min(_LABEL, max(groups, default=0)) if beside_it else 0)

    def _listed(
        self, label: str, texts: Sequence[str], of: int, *, column: int | None = None
    ) -> Iterator[Line]:
        """Words after a label, and how many more there are."""
        told = ", ".join(texts) + (f", and {of - len(texts)} more" if of > len(texts) else "")
        at = column if column is not None else 2 + cells(label) + 2
        yield from hanging(Span(label, Style.FAINT), Span(told), self._width, indent=min(2, at), column=at)

    def people(self) -> Iterator[Line]:
        """Who is stuck, who has nothing accepted, whose files are equal; the table tells the rest."""
        cohort = self._cohort
        if cohort.stuck:
            yield from self._headed("stuck", "the same mistake in the last two hand-ins")
            for each in self._folded(cohort.stuck):
                yield from self._who(f"{each.problem}  {each.mistake}", each.students)
            yield from _more(len(cohort.stuck) - len(self._folded(cohort.stuck)), "mistake", "mistakes")
            yield line()
        if cohort.unaccepted:
            of = f"{len(cohort.unaccepted)} of {counted(len(cohort.people), 'student')}"
            yield from self._headed("nothing accepted", of)
            yield from self._who("", cohort.unaccepted)
            yield line()
        if cohort.equal:
            yield from self._headed("equal files", EQUAL_CAUTION)
            for same in self._folded(cohort.equal):
                yield from self._who(f"{same.problem}  {same.how}", same.students)
            yield from _more(len(cohort.equal) - len(self._folded(cohort.equal)), "set", "sets")
            yield line()

    def _headed(self, head: str, about: str) -> list[Line]:
        return beside(Span(head, Style.STRONG), about, self._width)

    def _folded(self, items: Sequence[object]) -> Sequence:  # type: ignore[type-arg]
        return items if self._whole else items[:_SETS]

    def _who(self, label: str, students: Sequence[str]) -> Iterator[Line]:
        """The students after a label, if there is one, further lines indented."""
        shown = [self._names[each] for each in students[: None if self._whole else _NAMES]]
        left = len(students) - len(shown)
        told = ", ".join(shown) + (f", and {left} more: --all" if left else "")
        text = f"{label}: {told}" if label and told else label or told
        room = None if self._width is None else min(self._width, READABLE) - 4
        rows = [row.rstrip() for row in wrap(text, room)]
        yield from (line("    " if at and label else "  ", row) for at, row in enumerate(rows))

    def _cut(self, name: str) -> str:
        """A name that leaves room for others."""
        name = printable(name)
        if cells(name) <= _NAME:
            return name
        return wrap(name, _NAME - cells(self._glyphs.cut))[0].rstrip() + self._glyphs.cut


def _words(bar: MistakeBar) -> str:
    """A mistake by its name, a verdict with what it means."""
    return bar.label if bar.named else f"{bar.label}, {'not named' if bar.label == 'WA' else bar.meaning}"


def _more(left: int, one: str, several: str) -> Iterable[Line]:
    if left > 0:
        yield line("  ", Span(f"and {left} more {one if left == 1 else several}: --all", Style.FAINT))


def _side_by_side(left: Sequence[Line], right: Sequence[Line], width: int) -> Iterator[Line]:
    """Two blocks; the right one begins in the middle."""
    middle = min(width // 2, _MIDDLE)
    for at in range(max(len(left), len(right))):
        first = left[at] if at < len(left) else ()
        if at >= len(right):
            yield first
            continue
        filling = max(_GAP, middle - sum(cells(span.text) for span in first))
        yield (*first, Span(" " * filling), *right[at])
