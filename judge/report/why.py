"""What test groups probe and the mistakes they should catch, for the screen."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from judge.mistakes.told import Told
from judge.problem import Group, Problem
from judge.report.layout import Line, Span, Style, beside, cells, hanging, line, wrap

_INDENT = 2
_BESIDE = 28  # columns an explanation needs beside the names; with less it goes below them


def why_lines(
    problem: Problem, groups: Sequence[Group], mistakes: Mapping[str, Told], width: int | None
) -> Iterator[Line]:
    """Each group's sentence and, below it, its mistakes, each with its own and a line that it spoils."""
    yield from beside(Span(problem.id, Style.STRONG), problem.title, width)
    names = [name for group in groups for name in group.kills]
    column = 2 * _INDENT + max(map(cells, names), default=0) + 2
    for group in groups:
        yield line()
        yield line(Span(group.name, Style.STRONG))
        yield from _indented(group.about, _INDENT, width)
        for name in group.kills:
            sentence = _sentence(mistakes.get(name))
            if width is None or width - column >= _BESIDE:
                label = Span(name, Style.BAD)
                yield from hanging(label, Span(sentence), width, indent=2 * _INDENT, column=column)
            else:
                yield from _indented(name, 2 * _INDENT, width, Style.BAD)
                yield from _indented(sentence, 3 * _INDENT, width)


def _sentence(told: Told | None) -> str:
    if told is None:
        return ""
    if told.line is None or "\n" in told.line.wrong:
        return told.sentence
    instead = f" for `{told.line.right}`" if told.line.right else ""
    return f"{told.sentence} Such as `{told.line.wrong}`{instead}."


def _indented(text: str, indent: int, width: int | None, style: Style = Style.PLAIN) -> Iterator[Line]:
    for row in wrap(text, None if width is None else width - indent):
        yield line(" " * indent, Span(row, style))
