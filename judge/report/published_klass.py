"""A class as it stands: values in the order in which they are shown, what goes out as JSON, the gradebook.

The gradebook is CSV, a line a student. Excel takes a CSV for UTF-8 only by its byte order mark; LibreOffice
and Python's `utf-8-sig` skip it.
"""

from __future__ import annotations

from typing import Any

from msgspec import Struct

from judge.errors import ExitCode
from judge.problem.model import Verdict
from judge.published import Published
from judge.report.formats import csv_text

BOM = "\ufeff"
_HEAD = ("student", "name", "group")
EQUAL_CAUTION = "Short solutions are often alike: equality proves nothing."


class Student(Struct, frozen=True):
    """Somebody of the class: the name of their folder or files, and what the list of students says of them.

    `known` is whether that list holds them; where there is none, everybody is.
    """

    id: str
    name: str = ""
    group: str = ""
    known: bool = True


class Mark(Struct, frozen=True):
    """What counts of one student on one kata: the best of so many `handins`.

    `copied` says whether an equal file was judged in its place, and `busy` whether the machine was busy when
    it was timed.
    """

    file: str
    verdict: Verdict
    score: int
    mistake: str = ""
    handins: int = 1
    copied: bool = False
    busy: bool = False

    @property
    def accepted(self) -> bool:
        """Whether the verdict is AC."""
        return self.verdict is Verdict.AC


class Alike(Struct, frozen=True):
    """Students whose `files` for a kata have something in common: `what`, in words.

    Of failing files that is a mistake, or else (not `named`) what their verdict means.
    """

    problem: str
    what: str
    students: tuple[str, ...]
    files: tuple[str, ...]
    named: bool = True


class ProblemView(Struct, frozen=True):
    """One kata: how many submitted something and whose is accepted; what went wrong, and how many fail each
    test group that somebody fails, the most first.
    """

    problem: str
    handed_in: int
    accepted: int
    mistakes: tuple[Alike, ...]
    groups: dict[str, int]


class Machine(Struct, frozen=True):
    """A machine that judged, at which level of isolation, and how many files."""

    machine: str
    isolation: str
    handins: int


class Cohort(Published, frozen=True):
    """The class, the last line of its JSON, in the order of the table; `marks` are by student and kata.

    Of those with `nothing_accepted` something was submitted. `unjudged` are files with the reason why they
    could not be judged, `left` counts those without a result.
    """

    students: tuple[Student, ...]
    marks: dict[str, dict[str, Mark]]
    problems: tuple[ProblemView, ...]
    stuck: tuple[Alike, ...]
    nothing_accepted: tuple[str, ...]
    nothing_handed_in: tuple[str, ...]
    equal_files: tuple[Alike, ...]
    machines: tuple[Machine, ...]
    unjudged: tuple[tuple[str, str], ...]
    left: int

    @property
    def every_mark(self) -> list[Mark]:
        """The marks of all students on all katas."""
        return [mark for marks in self.marks.values() for mark in marks.values()]

    @property
    def exit_code(self) -> ExitCode:
        """What counts tells the shell: the judge's fault weighs most, then what is not accepted or left."""
        verdicts = {mark.verdict for mark in self.every_mark}
        if Verdict.JE in verdicts:
            return ExitCode.FAULT
        return ExitCode.NOT_ACCEPTED if verdicts - {Verdict.AC} or self.left else ExitCode.ACCEPTED

    def mark(self, student: str, problem: str) -> Mark | None:
        """What counts of that student on that kata; None where nothing was submitted."""
        return self.marks.get(student, {}).get(problem)

    def total(self, student: str) -> int:
        """The points of a student on all katas."""
        return sum(mark.score for mark in self.marks.get(student, {}).values())


class ClassRow(Published, frozen=True):
    """A file of a class: whose it is, what it came to and by what it was judged; `result` as in judge run."""

    student: str
    name: str
    group: str
    listed: bool
    problem: str
    file: str
    verdict: Verdict
    score: int
    mistake: str | None
    copied: str | None
    kept: bool
    machine: str | None
    worker: str | None
    cpu_seconds: float
    judged_at: float
    standard: dict[str, str] | None
    result: dict[str, Any]


def gradebook(cohort: Cohort) -> bytes:
    """The file. Points, empty where nothing was submitted; the total; then verdict and mistake by kata."""
    katas = [each.problem for each in cohort.problems]
    details = [f"{kata} {what}" for kata in katas for what in ("verdict", "mistake")]
    rows: list[list[object]] = [[*_HEAD, *katas, "total", *details]]
    for person in cohort.students:
        marks = [cohort.mark(person.id, kata) for kata in katas]
        points = [mark.score if mark else "" for mark in marks]
        told = [each for mark in marks for each in ((mark.verdict.value, mark.mistake) if mark else ("", ""))]
        rows.append([person.id, person.name, person.group, *points, cohort.total(person.id), *told])
    return (BOM + csv_text(rows)).encode("utf-8", "backslashreplace")


def is_gradebook(start: bytes) -> bool:
    """Whether a file that begins like this is such a gradebook."""
    plain = start.removeprefix(BOM.encode()).replace(b'"', b"")  # a spreadsheet quotes none of its titles
    return plain.startswith(",".join(_HEAD).encode())
