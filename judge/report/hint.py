"""One hint, as text for a screen."""

from __future__ import annotations

from judge.problem import Problem
from judge.problem.hints import Hint
from judge.report.layout import Span, Style, beside, line
from judge.report.screen import Screen
from judge.report.statement import statement_text


def hint_text(problem: Problem, hint: Hint, steps: int, screen: Screen) -> str:
    """The hint under its title; after the last one, what is left to do."""
    head = beside(
        Span(hint.title, Style.STRONG), f"{problem.id}, hint {hint.number} of {steps}", screen.width
    )
    text = screen.text([*head, line()]) + statement_text(hint.text, screen)
    if hint.number < steps:
        return f"{text}\n"
    rest = f"That was the last hint. 'judge solution {problem.id} --give-up' shows a solution."
    return text + screen.text([line(), *beside(Span(rest, Style.FAINT), "", screen.width)])
