"""The hints to a problem, and which of them the person has seen."""

from __future__ import annotations

from pathlib import Path

from judge.errors import UsageError
from judge.problem import Problem
from judge.problem.hints import Hint, read_hints


def hints_of(problem: Problem) -> tuple[Hint, ...]:
    """The problem's hints. Raises UsageError if it has none, ProblemError if they are broken."""
    hints = read_hints(problem)
    if not hints:
        remedy = f"'judge show {problem.id} --groups' says what its test groups show"
        raise UsageError(f"there are no hints to {problem.id}", remedy=remedy)
    return hints


def next_hint(problem: Problem, hints: tuple[Hint, ...], db: Path | None) -> Hint:
    """The first that was not seen yet; when all were, the last."""
    return hints[min(hints_seen(problem, db), len(hints) - 1)]


def note_seen(problem: Problem, hint: Hint, db: Path | None) -> None:
    """Remember that the hints up to this one have been seen."""
    from judge.cli.kept import history_at
    from judge.kata.events import Help

    if hint.number > hints_seen(problem, db):
        with history_at(db) as history:
            history.keep(Help(problem.id, hint.number))


def hints_seen(problem: Problem, db: Path | None) -> int:
    """How many of the problem's hints have been seen."""
    from judge.cli.kept import history_at
    from judge.kata.events import Help

    with history_at(db, reading=True) as history:
        return max((each.hints for each in history.events(Help, problem.id)), default=0)
