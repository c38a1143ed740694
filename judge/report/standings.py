"""How far a person has come on the levels of the katas, for the screen."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from judge.kata.levels import LevelStanding
from judge.problem.model import KataLevel
from judge.report.history import day
from judge.report.layout import Cell, Column, Line, Span, Style, Table
from judge.report.levels import level_name
from judge.report.values import counted


def standing_lines(standings: Sequence[LevelStanding], width: int | None) -> Iterator[Line]:
    """A row for each kata that has levels: when each was first passed, or how many of its groups were."""
    columns = (Column("kata"), *(Column(level_name(level)) for level in KataLevel))
    katas = dict.fromkeys(each.problem for each in standings)
    rows: list[list[Cell]] = [
        [Span(kata), *(_standing(each) for each in standings if each.problem == kata)] for kata in katas
    ]
    if rows:
        yield from Table(columns, rows).lines(width)


def _standing(each: LevelStanding) -> Span:
    if each.since is not None:
        return Span(f"✓ {day(each.since)}", Style.GOOD)
    return Span(f"{each.best} of {counted(each.groups, 'group')}" if each.best else "", Style.FAINT)
