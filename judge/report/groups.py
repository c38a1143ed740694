"""What the test groups of a problem show, and the names of the mistakes that they reject, for the screen."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from judge.problem import Group, Problem
from judge.report.katas import growth_rule, time_rule, totals
from judge.report.layout import Line, Span, Style, beside, hanging, line
from judge.report.levels import level_name

_COLUMN = 14  # where what follows a label begins


def group_lines(problem: Problem, groups: Sequence[Group], width: int | None) -> Iterator[Line]:
    """Each group's sentence, its own time limit, and the mistakes it rejects; the easier level first."""
    yield from beside(Span(problem.id, Style.STRONG), problem.title, width)
    if problem.growth is not None and any(group.name in problem.growth.groups for group in groups):
        yield from _indented(f"CPU time may grow {growth_rule(problem.growth)}.", width)
    for level in problem.levels or (None,):
        own = [group for group in groups if group.level is level]
        if level is not None and own:
            yield line()
            yield from beside(Span(level_name(level).capitalize(), Style.STRONG), totals(own), width)
            yield from _indented(f"{level.meaning[:1].upper()}{level.meaning[1:]}.", width)
        for group in own:
            yield line()
            yield line(Span(group.name, Style.STRONG))
            yield from _indented(group.about, width)
            if allowed := time_rule(group):
                yield from _labelled("CPU time", f"at most {allowed}", Style.PLAIN, width)
            if group.kills:
                yield from _labelled("mistakes", ", ".join(group.kills), Style.BAD, width)


def _labelled(label: str, text: str, style: Style, width: int | None) -> list[Line]:
    return hanging(Span(label, Style.FAINT), Span(text, style), width, indent=2, column=_COLUMN)


def _indented(text: str, width: int | None) -> list[Line]:
    return hanging(Span(""), Span(text), width, indent=2, column=2)
