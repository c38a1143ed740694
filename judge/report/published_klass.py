"""A class as it stands: values in the order in which they are shown, what goes out as JSON, the gradebook.

The gradebook is CSV, a line a student. Excel takes a CSV for UTF-8 only by its byte order mark; LibreOffice
and Python's `utf-8-sig` skip it.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from msgspec import Struct

from judge.errors import ExitCode
from judge.problem.model import Verdict
from judge.published import Published
from judge.report.formats import csv_text
from judge.report.views import copied

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


class Counted(Struct, frozen=True):
    """What counts of one student on one kata: the best of so many `handins`.

    `score` and `points` are what was reached and what there is. `copied` says whether an equal file was
    judged in its place, and `busy` whether the machine was busy when it was timed.
    """

    file: str
    verdict: Verdict
    score: int
    points: int
    mistake: str = ""
    handins: int = 1
    copied: bool = False
    busy: bool = False

    @property
    def accepted(self) -> bool:
        """Whether the verdict is AC."""
        return self.verdict is Verdict.AC


class MistakeBar(Struct, frozen=True):
    """Who made a mistake; where none was named, whose files got that verdict."""

    mistake: str | None
    verdict: str | None
    students: tuple[str, ...]

    @property
    def named(self) -> bool:
        """Whether it is a mistake, and not only a verdict."""
        return self.mistake is not None

    @property
    def label(self) -> str:
        """The mistake, or what the verdict means."""
        if self.mistake is not None or self.verdict is None:
            return self.mistake or ""
        meaning = Verdict(self.verdict).meaning
        return f"{meaning}, no mistake named" if self.verdict == Verdict.WA.value else meaning


class GroupBar(Struct, frozen=True):
    """How many of those who ran a test group fail it."""

    name: str
    failed: int
    run: int


class ProblemView(Struct, frozen=True):
    """One kata: how many submitted something and whose is accepted; what went wrong, the most first."""

    problem: str
    handed_in: int
    accepted: int
    mistakes: tuple[MistakeBar, ...]
    groups: tuple[GroupBar, ...]


class Stuck(Struct, frozen=True):
    """Students whose last two files for a kata make the same mistake."""

    problem: str
    mistake: str
    students: tuple[str, ...]


class EqualFiles(Struct, frozen=True):
    """Files of at least two students that are one program; `same_bytes` where nothing at all differs."""

    problem: str
    students: tuple[str, ...]
    files: tuple[str, ...]
    same_bytes: bool

    @property
    def how(self) -> str:
        """In what they are the same."""
        alike = "identical after removing names, spacing and comments"
        return "identical files" if self.same_bytes else alike


class Machine(Struct, frozen=True):
    """A machine that judged, at which level of isolation, and how many files."""

    machine: str
    isolation: str
    handins: int


class ClassSummary(Struct, frozen=True, kw_only=True):
    """How many students and files, each kata, who needs help, which files are equal, who judged."""

    students: int
    handins: int
    problems: tuple[ProblemView, ...]
    stuck: tuple[Stuck, ...]
    nothing_accepted: tuple[str, ...]
    nothing_handed_in: tuple[str, ...]
    equal_files: tuple[EqualFiles, ...] = ()
    machines: tuple[Machine, ...]


class ClassLine(Published, frozen=True):
    """The last line of a class's JSON."""

    cohort: ClassSummary


class Cohort(ClassSummary, frozen=True, kw_only=True):
    """The class: who and what in the order of the table; `marks` by student and kata.

    Of those with `nothing_accepted` something was submitted. `unjudged` are files with the reason why they
    could not be judged, `left` counts those without a result.
    """

    people: tuple[Student, ...]
    marks: Mapping[tuple[str, str], Counted]
    unjudged: tuple[tuple[str, str], ...] = ()
    left: int = 0

    @property
    def exit_code(self) -> ExitCode:
        """What counts tells the shell: the judge's fault weighs most, then what is not accepted or left."""
        verdicts = {mark.verdict for mark in self.marks.values()}
        if Verdict.JE in verdicts:
            return ExitCode.FAULT
        return ExitCode.NOT_ACCEPTED if verdicts - {Verdict.AC} or self.left else ExitCode.ACCEPTED

    @property
    def published(self) -> tuple[ClassLine]:
        """The class in one object."""
        return (ClassLine(copied(ClassSummary, self)),)

    def total(self, student: str) -> int:
        """The points of a student on all katas."""
        return sum(mark.score for (who, _), mark in self.marks.items() if who == student)


class ClassRow(Published, frozen=True):
    """A file of a class: whose it is, what it came to and by what it was judged; `result` as in judge run."""

    student: str
    name: str
    group: str
    listed: bool
    problem: str
    file: str
    verdict: str
    score: int
    points: int
    mistake: str | None
    copied: str | None
    kept: bool
    machine: str | None
    worker: str | None
    isolation: str | None
    busy: str | None
    cpu_seconds: float
    judged_at: float
    standard: dict[str, str] | None
    notes: tuple[str, ...]
    result: dict[str, Any]


def gradebook(cohort: Cohort) -> bytes:
    """The file. Points, empty where nothing was submitted; the total; then verdict and mistake by kata."""
    katas = [each.problem for each in cohort.problems]
    details = [f"{kata} {what}" for kata in katas for what in ("verdict", "mistake")]
    rows: list[list[object]] = [[*_HEAD, *katas, "total", *details]]
    for person in cohort.people:
        marks = [cohort.marks.get((person.id, kata)) for kata in katas]
        points = [mark.score if mark else "" for mark in marks]
        told = [each for mark in marks for each in ((mark.verdict.value, mark.mistake) if mark else ("", ""))]
        rows.append([person.id, person.name, person.group, *points, cohort.total(person.id), *told])
    return (BOM + csv_text(rows)).encode("utf-8", "backslashreplace")


def is_gradebook(start: bytes) -> bool:
    """Whether a file that begins like this is such a gradebook."""
    plain = start.removeprefix(BOM.encode()).replace(b'"', b"")  # a spreadsheet quotes none of its titles
    return plain.startswith(",".join(_HEAD).encode())
