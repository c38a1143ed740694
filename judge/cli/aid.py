"""What helps to solve a kata: hints, and the model solution for who may see it."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

from msgspec import Struct

from judge.cli.options import opt
from judge.cli.resolve import history_at
from judge.errors import JudgeError, UsageError
from judge.languages import language_of
from judge.practice.events import Help, Run
from judge.practice.solutions import approaches
from judge.problem import Problem
from judge.problem.texts import read_hints
from judge.report.published_look import HintShown, ModelRow, SolutionShown


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
    step, count = ask.step, len(found)
    if step is None:
        with history_at(db, reading=True) as history:
            step = min(history.hints_seen(problem.id) + 1, count)
    if not 1 <= step <= count:
        raise UsageError(f"{problem.id} has no hint {step}", remedy=f"they go from 1 to {count}")
    return [
        HintShown(problem=problem.id, step=each.number, steps=count, title=each.title, text=each.text)
        for each in found
        if ask.whole or each.number == step
    ]


def note_seen(hint: HintShown, db: Path | None) -> None:
    """Remember that the hints up to this one have been seen."""
    with history_at(db) as history:
        if hint.step > history.hints_seen(hint.problem):
            history.keep(Help(hint.problem, hint.step))


def admit(problem: Problem, db: Path | None, *, giving_up: bool = False) -> tuple[Run, bytes] | None:
    """The person's latest run that solved it, and its source; None where it was given up, which is noted.

    Raises UsageError where it is neither.
    """
    with history_at(db, reading=not giving_up) as history:
        solved = [run for run in history.runs(problem.id) if run.solved]
        if solved:
            return solved[-1], history.source(solved[-1].id)
        if any(each.gave_up for each in history.events(Help, problem.id)):
            return None
        if giving_up:
            history.keep(Help(problem.id, hints=0))
            return None
    raise UsageError(f"Solve {problem.id} first", remedy="or see it anyway: add --give-up")


def model_beside(problem: Problem, file: Path) -> SolutionShown:
    """The model, in the file's language if there is one. Raises ProblemError."""
    models, language = approaches(problem), language_of(file)
    chosen = next((each for each in models if language and each.code == language.id), models[0])
    return SolutionShown(problem=problem.id, file=chosen.file, approaches=tuple(models), yours=None)


def model_row(problem: Problem, file: Path, source: bytes) -> ModelRow | None:
    """How the model compares with what was accepted; None where it cannot be read."""
    with suppress(JudgeError):
        found = model_beside(problem, file)
        code, first = found.shown.code, found.shown.idea
        ideas = dict.fromkeys([first, *(each.idea for each in found.approaches if each.code == code)])
        return ModelRow(tuple(ideas), _lines(found.shown.program), _lines(source.decode("utf-8", "replace")))
    return None


def _lines(program: str) -> int:
    """How many of its lines hold something."""
    return sum(bool(row.strip()) for row in program.splitlines())
