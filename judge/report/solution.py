"""A model solution, as text for a screen."""

from __future__ import annotations

from judge.kata.model import Model
from judge.problem import Problem
from judge.report.layout import Span, Style, beside, line
from judge.report.screen import Screen
from judge.report.statement import statement_text


def solution_text(problem: Problem, model: Model, screen: Screen) -> str:
    """Its idea, why it works, and the program."""
    idea = model.idea.replace("-", " ")
    head = [*beside(Span(f"{problem.id}: {idea}", Style.STRONG), model.path.name, screen.width), line()]
    parts = [model.explanation] if model.explanation else []
    parts.append(f"```python\n{model.program}\n```")
    return screen.text(head) + statement_text("\n\n".join(parts), screen)
