"""The hints to a kata, and which of them the person has seen."""

from __future__ import annotations

from pathlib import Path

from judge.errors import UsageError
from judge.problem import Problem
from judge.problem.texts import read_hints
from judge.report.published_practice import HintShown


def hints_of(problem: Problem) -> list[HintShown]:
    """All hints to a kata. Raises UsageError if it has none, ProblemError if they are broken."""
    hints = read_hints(problem)
    if not hints:
        remedy = f"'judge show {problem.id} --groups' says what its test groups show"
        raise UsageError(f"there are no hints to {problem.id}", remedy=remedy)
    return [
        HintShown(problem=problem.id, step=each.number, steps=len(hints), title=each.title, text=each.text)
        for each in hints
    ]


def hints_seen(problem: str, db: Path | None) -> int:
    """How many of the kata's hints have been seen."""
    from judge.cli.kept import history_at
    from judge.practice.events import Help

    with history_at(db, reading=True) as history:
        return max((each.hints for each in history.events(Help, problem)), default=0)


def note_seen(hint: HintShown, db: Path | None) -> None:
    """Remember that the hints up to this one have been seen."""
    from judge.cli.kept import history_at
    from judge.practice.events import Help

    if hint.step > hints_seen(hint.problem, db):
        with history_at(db) as history:
            history.keep(Help(hint.problem, hint.step))


def next_hint(problem: Problem, db: Path | None) -> HintShown:
    """The first that was not seen yet; when all were, the last. Raises as `hints_of`."""
    hints = hints_of(problem)
    return hints[min(hints_seen(problem.id, db), len(hints) - 1)]
