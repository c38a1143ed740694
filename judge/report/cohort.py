"""A class as it stands: values in the order in which they are shown, and the gradebook.

The gradebook is CSV, a line a student. Excel takes a CSV for UTF-8 only by its byte order mark; LibreOffice
and Python's `utf-8-sig` skip it.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from msgspec import Struct

from judge.problem.model import Verdict
from judge.report.sheet import csv_text

BOM = "\ufeff"
_HEAD = ("student", "name", "group")


class Person(Struct, frozen=True):
    """Somebody of the class; `known` is whether the list of students holds them, if there is one."""

    id: str
    name: str = ""
    group: str = ""
    known: bool = True


class Counted(Struct, frozen=True):
    """What counts of one student on one problem: the best of so many `handins`.

    `score` and `points` are what was reached and what there is.
    """

    file: str
    verdict: Verdict
    score: int
    points: int
    mistake: str = ""
    handins: int = 1

    @property
    def accepted(self) -> bool:
        """Whether the verdict is AC."""
        return self.verdict is Verdict.AC


class MistakeBar(Struct, frozen=True):
    """How many, and who: of a mistake or, where none was `named`, of a verdict."""

    label: str
    students: tuple[str, ...]
    named: bool = True
    meaning: str = ""

    @property
    def count(self) -> int:
        """How many students."""
        return len(self.students)


class GroupBar(Struct, frozen=True):
    """How many of those who ran a test group fail it."""

    name: str
    failed: int
    run: int


class ProblemView(Struct, frozen=True):
    """One problem: how many handed in something and whose is accepted; what went wrong, the most first."""

    problem: str
    handed_in: int
    accepted: int
    mistakes: tuple[MistakeBar, ...]
    groups: tuple[GroupBar, ...]

    def as_json(self) -> dict[str, Any]:
        """The problem's object in the published form."""
        mistakes = [
            {
                "mistake": bar.label if bar.named else None,
                "verdict": None if bar.named else bar.label,
                "students": list(bar.students),
            }
            for bar in self.mistakes
        ]
        groups = [{"name": each.name, "failed": each.failed, "run": each.run} for each in self.groups]
        return {
            "problem": self.problem,
            "handed_in": self.handed_in,
            "accepted": self.accepted,
            "mistakes": mistakes,
            "groups": groups,
        }


class Stuck(Struct, frozen=True):
    """Students whose last two hand-ins to a problem make the same mistake."""

    problem: str
    mistake: str
    students: tuple[str, ...]


class EqualFiles(Struct, frozen=True):
    """Files of at least two students that are one program; `same_bytes` where nothing at all differs."""

    problem: str
    students: tuple[str, ...]
    files: tuple[str, ...]
    same_bytes: bool
    words: int

    @property
    def how(self) -> str:
        """In what they are the same."""
        alike = "identical after removing names, spacing and comments"
        return "identical files" if self.same_bytes else alike

    def as_json(self) -> dict[str, Any]:
        """The set's object in the published form."""
        return {
            "problem": self.problem,
            "students": list(self.students),
            "files": list(self.files),
            "same_bytes": self.same_bytes,
        }


EQUAL_CAUTION = "Short solutions are often alike: equality proves nothing."


class Machine(Struct, frozen=True):
    """A machine that judged, at which level of isolation, and how many hand-ins."""

    name: str
    isolation: str
    handins: int


class Cohort(Struct, frozen=True):
    """The class: who and what in the order of the table; `marks` by student and problem.

    `unaccepted` handed in something, of which nothing is accepted; `silent` handed in nothing at all.
    """

    people: tuple[Person, ...]
    problems: tuple[str, ...]
    marks: Mapping[tuple[str, str], Counted]
    views: tuple[ProblemView, ...]
    stuck: tuple[Stuck, ...]
    unaccepted: tuple[str, ...]
    silent: tuple[str, ...]
    machines: tuple[Machine, ...]
    equal: tuple[EqualFiles, ...] = ()

    @property
    def handins(self) -> int:
        """How many hand-ins there are, also those that do not count."""
        return sum(mark.handins for mark in self.marks.values())

    def total(self, student: str) -> int:
        """The points of a student on all problems."""
        return sum(self.marks[student, each].score for each in self.problems if (student, each) in self.marks)

    def as_json(self) -> dict[str, Any]:
        """The class's object in the published form."""
        return {
            "students": len(self.people),
            "handins": self.handins,
            "problems": [each.as_json() for each in self.views],
            "stuck": [
                {"problem": each.problem, "mistake": each.mistake, "students": list(each.students)}
                for each in self.stuck
            ],
            "nothing_accepted": list(self.unaccepted),
            "nothing_handed_in": list(self.silent),
            "equal_files": [each.as_json() for each in self.equal],
            "machines": [
                {"machine": each.name, "isolation": each.isolation, "handins": each.handins}
                for each in self.machines
            ],
        }


def gradebook(cohort: Cohort) -> bytes:
    """The file. Points, empty where nothing was handed in; the total; then verdict and mistake by problem."""
    details = [f"{problem} {what}" for problem in cohort.problems for what in ("verdict", "mistake")]
    rows: list[list[object]] = [[*_HEAD, *cohort.problems, "total", *details]]
    for person in cohort.people:
        marks = [cohort.marks.get((person.id, problem)) for problem in cohort.problems]
        points = ["" if mark is None else mark.score for mark in marks]
        told = [text for mark in marks for text in _told(mark)]
        rows.append([person.id, person.name, person.group, *points, cohort.total(person.id), *told])
    return (BOM + csv_text(rows)).encode("utf-8", "backslashreplace")


def is_gradebook(start: bytes) -> bool:
    """Whether a file that begins like this is such a gradebook."""
    plain = start.removeprefix(BOM.encode()).replace(b'"', b"")  # an older judge quoted none of its titles
    return plain.startswith(",".join(_HEAD).encode())


def _told(mark: Counted | None) -> tuple[str, str]:
    return (mark.verdict.value, mark.mistake) if mark else ("", "")
