"""Programs with a known mistake, as mistakes.py of the shipped problems makes them."""

from __future__ import annotations

from judge.mistakes.family import Family
from judge.problem.find import find_problem


def mistaken(problem: str, name: str, line: str = "") -> bytes:
    """The source of the first program that makes the mistake; if a line is given, by it alone, or with it."""
    family = Family(find_problem(problem))
    makers = [each for each in family.mistakes() if each.name == name]
    if line:
        alone = [each for each in makers if each.line == line]
        makers = alone or [each for each in makers if line in each.program.source.decode()]
    return makers[0].program.source
