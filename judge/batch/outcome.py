"""What a class has come to: whose rows count, and what they tell the shell."""

from __future__ import annotations

from collections.abc import Iterable

from msgspec import Struct

from judge.batch.model import Row, Student
from judge.errors import ExitCode
from judge.problem import Verdict


class Outcome(Struct, frozen=True):
    """The students in the order of the table, the ids of the problems, and the row of each hand-in.

    `left` is how many hand-ins have no row, because judging was broken off or a shard is missing.
    """

    students: tuple[Student, ...]
    problems: tuple[str, ...]
    rows: tuple[Row, ...]
    left: int = 0

    @property
    def exit_code(self) -> ExitCode:
        """What the rows that count tell the shell: the judge's fault weighs most, then a rejection."""
        verdicts = {row.verdict for row in counting(self.rows).values()}
        if Verdict.JE.value in verdicts:
            return ExitCode.FAULT
        return ExitCode.NOT_ACCEPTED if verdicts - {Verdict.AC.value} or self.left else ExitCode.ACCEPTED


def counting(rows: Iterable[Row]) -> dict[tuple[str, str], Row]:
    """Of each student and problem the row that counts: of several files the best, and of equals the newest.

    The best is an accepted one, then the one of most points; one that could not be judged is the last.
    """
    found: dict[tuple[str, str], Row] = {}
    for row in rows:
        place = row.student, row.problem
        if place not in found or _worth(row) >= _worth(found[place]):
            found[place] = row
    return found


def _worth(row: Row) -> tuple[bool, bool, int, float]:
    return row.accepted, row.verdict != Verdict.JE.value, row.score, row.at
