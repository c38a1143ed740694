"""A practice set for the screen: its katas, how each stands, which one is in hand, and what to do next."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from judge.kata.sets import PracticeSet
from judge.kata.standing import Standing, State
from judge.problem import Problem
from judge.report.history import day
from judge.report.layout import Cell, Column, Line, Span, Style, Table, beside, hanging, line
from judge.report.names import shown_name

_STYLES = {State.NEW: Style.FAINT, State.TRIED: Style.WARNING, State.PASSED: Style.GOOD}


def practice_lines(
    chosen: PracticeSet,
    katas: Sequence[tuple[Problem, Standing]],
    in_hand: str | None,
    width: int | None,
) -> Iterator[Line]:
    """The set's title and its katas in order; the one in hand is marked."""
    passed = sum(standing.state is State.PASSED for _, standing in katas)
    yield from beside(Span(chosen.title, Style.STRONG), f"{passed} of {len(katas)} passed", width)
    yield from hanging(Span(""), Span(chosen.about, Style.FAINT), width, indent=0, column=0)
    yield line()
    columns = (
        Column("kata"),
        Column("state"),
        Column("since"),
        Column("tries", right=True),
        Column("best", right=True),
        Column("title", flexible=True),
    )
    rows = [_row(problem, standing, problem.id == in_hand) for problem, standing in katas]
    yield from Table(columns, rows).lines(width)
    yield line()


def _row(problem: Problem, standing: Standing, in_hand: bool) -> list[Cell]:
    since = standing.passed or standing.last
    return [
        Span(problem.id, Style.STRONG if in_hand else Style.PLAIN),
        Span(standing.state.value + ", in hand" * in_hand, _STYLES[standing.state]),
        Span(day(since) if since else "", Style.FAINT),
        Span(str(standing.attempts or ""), Style.FAINT),
        Span(str(standing.best) if standing.attempts else "", Style.FAINT),
        problem.title,
    ]


def next_lines(problem: str, file: str, command: str, *, made: bool, width: int | None) -> Iterator[Line]:
    """Which file the kata in hand is, and the command that judges it."""
    text = f"{problem} is in hand; {'begin with' if made else 'its file is'} {shown_name(file)}."
    yield from hanging(Span(""), Span(text), width, indent=0, column=0)
    yield line("  next  ", Span(command, Style.STRONG))


def all_passed_lines(width: int | None) -> Iterator[Line]:
    """Nothing is left to take up."""
    text = "All of it is passed. 'judge due' says what to do again, 'judge progress' what that has shown."
    yield from hanging(Span(""), Span(text, Style.GOOD), width, indent=0, column=0)
