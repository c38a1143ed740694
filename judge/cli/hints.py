"""Which hints are shown, and which were."""

from __future__ import annotations

from pathlib import Path

from msgspec import Struct

from judge.cli.options import opt
from judge.cli.resolve import history_at
from judge.errors import UsageError
from judge.practice.events import Help
from judge.problem import Problem
from judge.problem.texts import read_hints
from judge.report.published_practise import HintShown


class HintAsk(Struct, frozen=True):
    """Which hint."""

    step: int | None = opt("--step N", "Show hint N; the first is 1.")
    whole: bool = opt("--all", "Show all hints.")


def hints(problem: Problem, ask: HintAsk, db: Path | None) -> list[HintShown]:
    """The hints that are asked for, at least one: the first that was not seen, or else the last.

    Raises UsageError where there is none, ProblemError where they are broken.
    """
    found = read_hints(problem)
    if not found:
        remedy = f"'judge show {problem.id} --groups' says what its test groups show"
        raise UsageError(f"there are no hints to {problem.id}", remedy=remedy)
    seen, count = 0 if ask.whole or ask.step is not None else _seen(problem.id, db), len(found)
    step = ask.step if ask.step is not None else min(seen + 1, count)
    if not 1 <= step <= count:
        raise UsageError(f"{problem.id} has no hint {step}", remedy=f"they go from 1 to {count}")
    return [
        HintShown(problem=problem.id, step=each.number, steps=count, title=each.title, text=each.text)
        for each in found
        if ask.whole or each.number == step
    ]


def _seen(problem: str, db: Path | None) -> int:
    """How many of the kata's hints have been seen."""
    with history_at(db, reading=True) as history:
        return history.hints_seen(problem)


def note_seen(hint: HintShown, db: Path | None) -> None:
    """Remember that the hints up to this one have been seen."""
    if hint.step > _seen(hint.problem, db):
        with history_at(db) as history:
            history.keep(Help(hint.problem, hint.step))
