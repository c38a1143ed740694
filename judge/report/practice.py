"""A practice set for the screen: its katas, how each stands, and which one is in hand."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from judge.kata.progress import Standing
from judge.kata.sets import PracticeSet
from judge.problem import Problem
from judge.report.history import day
from judge.report.layout import Cell, Column, Line, Span, Style, Table, beside, hanging, line
from judge.report.values import counted, score_text

Katas = Sequence[tuple[Problem, Standing]]

_MOST = 15  # katas that are shown each on a row of its own
_AHEAD = 8  # of more than that, the next ones that are new
_STYLES = {"new": Style.FAINT, "tried": Style.WARNING, "passed": Style.GOOD}


def practice_lines(
    chosen: PracticeSet,
    katas: Katas,
    in_hand: str | None,
    width: int | None,
) -> Iterator[Line]:
    """The set's title and its katas in order; the one in hand is marked. Of a long set the near ones."""
    passed = sum(standing.passed is not None for _, standing in katas)
    yield from beside(Span(chosen.title, Style.STRONG), f"{passed} of {len(katas)} passed", width)
    yield from hanging(Span(""), Span(chosen.about, Style.FAINT), width, indent=0, column=0)
    yield line()
    columns = (
        Column("kata"),
        Column("state"),
        Column("since", spare=True),
        Column("tries", right=True, spare=True),
        Column("best", right=True, spare=True),
        Column("title", flexible=True),
    )
    near = _near(katas, in_hand) if len(katas) > _MOST else list(katas)
    rows = [_row(problem, standing, problem.id == in_hand) for problem, standing in near]
    yield from Table(columns, rows).lines(width)
    yield line()
    shown = {problem.id for problem, _ in near}
    folded = [each for each in katas if each[0].id not in shown]
    done = [problem.id for problem, standing in folded if standing.passed is not None]
    if done:
        yield from _labelled("passed", ", ".join(done), width)
    if len(folded) > len(done):
        text = f"{counted(len(folded) - len(done), 'more kata')}; judge list has them all"
        yield from _labelled("later", text, width)
    if folded:
        yield line()


def _near(katas: Katas, in_hand: str | None) -> Katas:
    """Of a set that is too long for a screen: the kata in hand, what was tried, and the next new ones."""
    new = [problem.id for problem, standing in katas if not standing.attempts]
    kept = {in_hand, *new[:_AHEAD]}
    return [each for each in katas if each[0].id in kept or _state(each[1]) == "tried"]


def _labelled(label: str, text: str, width: int | None) -> list[Line]:
    return hanging(Span(label, Style.FAINT), Span(text), width, indent=2, column=10)


def _row(problem: Problem, standing: Standing, in_hand: bool) -> list[Cell]:
    since = standing.passed or standing.last
    return [
        Span(problem.id, Style.STRONG if in_hand else Style.PLAIN),
        Span(_state(standing) + ", in hand" * in_hand, _STYLES[_state(standing)]),
        Span(day(since) if since else "", Style.FAINT),
        Span(str(standing.attempts or ""), Style.FAINT),
        Span(_best(standing) if standing.attempts else "", Style.FAINT),
        problem.title,
    ]


def _state(standing: Standing) -> str:
    return "passed" if standing.passed else "tried" if standing.attempts else "new"


def _best(standing: Standing) -> str:
    return score_text(standing.best, accepted=standing.passed is not None)
