"""What words mean, under the names by which some commands still ask for it."""

from __future__ import annotations

from pathlib import Path

from judge.cli import resolve
from judge.cli.resolve import Task, assigned, problem_meant, problem_of_file, split

__all__ = ["Task", "assigned", "problem_meant", "problem_of_file", "split", "usual_file"]


def usual_file(problem: str, _command: str, db: Path | None) -> str:
    """The problem's file in this folder. Raises UsageError."""
    return resolve.usual_file(problem, db)
