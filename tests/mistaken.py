"""Programs with a known mistake, as mistakes.py of the shipped problems makes them."""

from __future__ import annotations

from judge.mistakes.family import Family
from judge.problem.find import find_problem


def mistaken(problem: str, name: str, line: str = "") -> bytes:
    """The source of the first program that makes the mistake; if a line is given, by it alone, or with it."""
    family = Family(find_problem(problem))
    choices = [choice for choice, each in family.named if each == name]
    if line:
        alone = [choice for choice in choices if line in [each.wrong for each in family.lines(choice)]]
        choices = alone or [choice for choice in choices if line in family.program(choice)]
    return family.program(choices[0]).encode()
