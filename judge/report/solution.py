"""A model solution, as text for a screen, and the approaches that there are beside it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from judge.kata.events import Run
from judge.kata.model import Model
from judge.problem import Problem
from judge.report.layout import Cell, Column, Line, Span, Style, Table, beside, hanging, line
from judge.report.names import shown_name
from judge.report.screen import Screen, is_terminal
from judge.report.statement import statement_text
from judge.report.values import times

YOURS = "yours"


def solution_text(problem: Problem, model: Model, screen: Screen) -> str:
    """Its idea, why it works, and the program, whose lines are never broken: they can be copied."""
    idea = model.idea.replace("-", " ")
    head = [*beside(Span(f"{problem.id}: {idea}", Style.STRONG), model.path.name, screen.width), line()]
    explained = statement_text(model.explanation, screen) if model.explanation else ""
    fence = [] if is_terminal(screen.stream) else [line("```")]
    tongue = model.language.id if model.language else "python"
    begun = [] if is_terminal(screen.stream) else [line(f"```{tongue}")]
    code = [line(Span(row)) for row in model.program.split("\n")]
    return screen.text(head) + explained + screen.text([line(), *begun, *code, *fence])


def approach_lines(
    problem: Problem,
    models: Sequence[Model],
    shown: Model,
    yours: Run | None,
    ratios: Mapping[str, float | None],
    width: int | None,
) -> Iterator[Line]:
    """A row for each approach, its time beside the person's own; `ratios` has them by file where measured."""
    columns = [Column("approach"), Column("× reference", right=True), Column("idea", flexible=True)]
    rows: list[list[Cell]] = []
    for model in models:
        about = "the one above" if model is shown else model.about
        rows.append([Span(model.call, Style.STRONG), _ratio(ratios.get(model.path.name)), Span(about)])
    if yours is not None:
        name = f"run {yours.id}, {shown_name(yours.submission)}"
        rows.append([Span(YOURS, Style.GOOD), _ratio(ratios.get(YOURS)), Span(name, Style.FAINT)])
    if not ratios:
        columns, rows = [columns[0], columns[2]], [[row[0], row[2]] for row in rows]
    yield line()
    yield from Table(tuple(columns), rows).lines(width)
    others = [model.call for model in models if model is not shown]
    if others:
        yield line()
        text = f"judge solution {problem.id} {others[0]}"
        yield from hanging(
            Span(text), Span("shows another one", Style.FAINT), width, indent=2, column=len(text) + 4
        )


def _ratio(ratio: float | None) -> str:
    return "" if ratio is None else times(ratio)
