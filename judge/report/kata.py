"""Katas for the screen: what comes after an accepted submission, a file that is about to be written."""

from __future__ import annotations

from judge.problem import Problem
from judge.report.layout import Line, Span, Style, hanging, line
from judge.report.names import shown_name
from judge.report.screen import Screen, is_terminal


def pointer_lines(problem: str, screen: Screen) -> list[Line]:
    """After an accepted submission, on a terminal: where to go from there."""
    if not is_terminal(screen.stream):
        return []
    text = f"judge solution {problem} explains a model solution, judge start goes on"
    return hanging(Span("then", Style.FAINT), Span(text), screen.width, indent=2, column=8)


def writing_lines(problem: Problem, file: str, width: int | None) -> list[Line]:
    """Which file is about to be written, said before that is done."""
    text = f"Writing {shown_name(file)}, which is not there yet: the stub of {problem.id}."
    return [*hanging(Span(""), Span(text, Style.FAINT), width, indent=0, column=0), line()]
