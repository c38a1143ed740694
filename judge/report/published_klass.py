"""A class as it stands: values in the order in which they are shown, and what goes out as JSON."""

from __future__ import annotations

from typing import Any

from msgspec import Struct, field

from judge.errors import ExitCode
from judge.problem.model import FULL_SCORE, Verdict
from judge.published import Published

EQUAL_CAUTION = "Short solutions are often alike: equality proves nothing."


class Student(Struct, frozen=True):
    """Somebody of the class: the name of their folder or files, and what the list of students says of them.

    `known` is whether that list holds them; where there is none, everybody is. `cells` are all of the list's
    own in its order, `note` is what it has to say on the student's page, `extra_days` what it grants beyond
    the date that is due, and `late` whether its Status says so.
    """

    id: str
    name: str = ""
    group: str = ""
    known: bool = True
    cells: tuple[str, ...] = ()
    note: str = ""
    extra_days: float = 0.0
    late: bool = False


class Grade(Struct, frozen=True):
    """What counts of one student on one kata: the best of so many `handins`.

    `copied` says whether an equal file was judged in its place, and `busy` whether the machine was busy when
    it was timed. It is `late` where the platform says so or a date was due, by so many days.
    """

    file: str
    verdict: Verdict
    score: int
    mistake: str = ""
    handins: int = 1
    copied: bool = False
    busy: bool = False
    late: bool = False
    late_days: int | None = None

    @property
    def accepted(self) -> bool:
        """Whether the verdict is AC."""
        return self.verdict is Verdict.AC


class Alike(Struct, frozen=True):
    """Students whose `files` for a kata have something in common: `what`, in words.

    Of failing files that is a mistake, or else (not `named`) what their verdict means; one reason holds for
    each of them if it is `shared`.
    """

    problem: str
    what: str
    students: tuple[str, ...]
    files: tuple[str, ...]
    named: bool = True
    shared: bool = True


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
    could not be judged, `left` counts those without a result, `waiting` are their katas by student. `titles`
    are the columns of the list of students, and `unread` is what of a student could not be judged, with the
    reason. With `weights`
    of katas the points of a student are out of 100.
    """

    students: tuple[Student, ...]
    marks: dict[str, dict[str, Grade]]
    problems: tuple[ProblemView, ...]
    stuck: tuple[Alike, ...]
    nothing_accepted: tuple[str, ...]
    nothing_handed_in: tuple[str, ...]
    equal_files: tuple[Alike, ...]
    machines: tuple[Machine, ...]
    unjudged: tuple[tuple[str, str], ...]
    left: int
    waiting: dict[str, list[str]]
    titles: tuple[str, ...] = ()
    unread: dict[str, tuple[str, ...]] = field(default_factory=dict)
    weights: dict[str, float] = field(default_factory=dict)

    @property
    def every_mark(self) -> list[Grade]:
        """The marks of all students on all katas."""
        return [mark for marks in self.marks.values() for mark in marks.values()]

    @property
    def exit_code(self) -> ExitCode:
        """What counts tells the shell: the judge's fault weighs most, then what is not accepted or left."""
        verdicts = {mark.verdict for mark in self.every_mark}
        if Verdict.JE in verdicts:
            return ExitCode.FAULT
        return ExitCode.NOT_ACCEPTED if verdicts - {Verdict.AC} or self.left else ExitCode.ACCEPTED

    def mark(self, student: str, problem: str) -> Grade | None:
        """What counts of that student on that kata; None where nothing was submitted."""
        return self.marks.get(student, {}).get(problem)

    def total(self, student: str) -> float:
        """The points of a student on all katas."""
        marks = self.marks.get(student, {})
        if not self.weights:
            return sum(mark.score for mark in marks.values())
        every = sum(self.weights.get(each.problem, 1.0) for each in self.problems)
        own = sum(mark.score * self.weights.get(kata, 1.0) for kata, mark in marks.items())
        share = round(own / every, 1) if every else 0.0
        return int(share) if share == int(share) else share

    def days_late(self, student: str) -> int:
        """By how many days the latest of a student's files that count is late."""
        return max((mark.late_days or 0 for mark in self.marks.get(student, {}).values()), default=0)

    @property
    def full(self) -> int:
        """The most points that a student can have."""
        return FULL_SCORE * (1 if self.weights else len(self.problems))


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
