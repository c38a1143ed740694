"""The model solution of a kata: who may see it, and how it compares with a person's own."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

from judge.cli.resolve import history_at
from judge.errors import JudgeError, UsageError
from judge.languages import language_of
from judge.practice.events import Help, Run
from judge.practice.solutions import approaches
from judge.problem import Problem
from judge.report.published_look import ModelRow
from judge.report.published_practise import SolutionShown


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
