"""What test groups probe and the mistakes they should catch, for the screen."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from judge.mistakes.told import Told
from judge.problem import Group, Problem
from judge.problem.level import KataLevel, levels_among
from judge.report.layout import Line, Span, Style, beside, cells, hanging, line, wrap
from judge.report.levels import level_name
from judge.report.problems import growth_rule, time_rule, totals
from judge.report.values import counted

_INDENT = 2
_BESIDE = 28  # columns an explanation needs beside the names; with less it goes below them


def why_lines(
    problem: Problem, groups: Sequence[Group], mistakes: Mapping[str, Told], width: int | None
) -> Iterator[Line]:
    """How time may grow; each group's sentence and, below it, its mistakes, with a line that each spoils.

    A mistake is explained where it is met first; later groups only name it.
    """
    yield from beside(Span(problem.id, Style.STRONG), problem.title, width)
    if problem.growth is not None and any(group.name in problem.growth.groups for group in groups):
        yield from _indented(f"CPU time may grow {growth_rule(problem.growth)}.", _INDENT, width)
    names = [name for group in groups for name in group.kills]
    column = 2 * _INDENT + max(map(cells, names), default=0) + 2
    whole = len(groups) == len(problem.groups)
    explained: set[str] = set()
    for group, begun in _by_level(groups) if whole else ((group, None) for group in groups):
        if begun is not None:
            yield from _level_lines(begun, groups, width)
        yield line()
        aside = level_name(group.level) if group.level and not whole else ""
        yield from beside(Span(group.name, Style.STRONG), aside, width)
        yield from _indented(group.about, _INDENT, width)
        if allowed := time_rule(group):
            yield from _indented(f"CPU time: at most {allowed}.", _INDENT, width)
        again = [name for name in group.kills if name in explained]
        for name in group.kills:
            if name in explained:
                continue
            explained.add(name)
            sentence = _sentence(mistakes.get(name))
            if width is None or width - column >= _BESIDE:
                label = Span(name, Style.BAD)
                yield from hanging(label, Span(sentence), width, indent=2 * _INDENT, column=column)
            else:
                yield from _indented(name, 2 * _INDENT, width, Style.BAD)
                yield from _indented(sentence, 3 * _INDENT, width)
        if again:
            label, text = Span("again", Style.FAINT), Span(", ".join(again), Style.BAD)
            yield from hanging(label, text, width, indent=2 * _INDENT, column=2 * _INDENT + len("again") + 2)


def _by_level(groups: Sequence[Group]) -> Iterator[tuple[Group, KataLevel | None]]:
    """The groups, the easier level first, and with the first of each level that one."""
    for level in levels_among(group.level for group in groups) or (None,):
        begun = level
        for group in groups:
            if group.level is level:
                yield group, begun
                begun = None


def _level_lines(level: KataLevel, groups: Sequence[Group], width: int | None) -> Iterator[Line]:
    """What a level asks, how large it is, and which mistakes only its groups catch."""
    own = [group for group in groups if group.level is level]
    adds = "asks for" if level is KataLevel.INTERVIEW else "adds"
    yield line()
    size = f"{counted(len(own), 'group')}, {totals(own)}"
    yield from beside(Span(level_name(level).capitalize(), Style.STRONG), size, width)
    yield from _indented(f"It {adds} {level.meaning}.", _INDENT, width)
    if level is KataLevel.PRODUCTION and (only := only_there(level, groups)):
        yield from _indented(f"Only here caught: {', '.join(only)}.", _INDENT, width)


def only_there(level: KataLevel, groups: Sequence[Group]) -> list[str]:
    """The mistakes that groups of that level should catch and no others."""
    elsewhere = {name for group in groups if group.level is not level for name in group.kills}
    here = dict.fromkeys(name for group in groups if group.level is level for name in group.kills)
    return [name for name in here if name not in elsewhere]


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
