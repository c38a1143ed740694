"""A class as one page, and a page for each of its students.

The page of the class has the table, who needs help, and one drawn case of each mistake. The page of a student
has nothing of anybody else.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping
from datetime import datetime
from functools import cached_property

from msgspec import Struct
from msgspec.structs import replace

from judge.practice.syllabus import read_pack
from judge.problem import Verdict
from judge.report.html import page
from judge.report.html.case import ShownCase, ShownCases
from judge.report.published_klass import EQUAL_CAUTION, Alike, Cohort
from judge.run.result import Result

CLASS_MARK = "judge class page"  # in the head of every such page, also of older ones
FEEDBACK_MARK = "judge feedback page"
_PART = 100  # rows of a table; a browser lays out one after another, and those in sight first
_SIDES, _COLUMN = 18, 9  # rem of the first and last column of a table in parts, and of one between
_INLINE = 12  # names that are in sight; longer lists are folded away


class ClassPages(Struct, frozen=True, dict=True):
    """The pages of a class that is called `title`, made when they are `generated`.

    `results` are those of the file that counts, by kata and file, at least for the first student of each
    mistake. `cases` tells those of the katas that are still there; of others no case is drawn.
    """

    cohort: Cohort
    results: Mapping[tuple[str, str], Result]
    cases: ShownCases
    title: str
    generated: datetime

    @cached_property
    def names(self) -> dict[str, str]:
        """What each student is called, by their id, which stands beside a name that two have."""
        often = Counter(each.name for each in self.cohort.students)
        names = {each.id: each.name or each.id for each in self.cohort.students}
        return {who: name if often[name] <= 1 else f"{name} ({who})" for who, name in names.items()}

    def whole(self) -> bytes:
        """The page of the class."""
        cohort = self.cohort
        katas = []
        for at, view in enumerate(cohort.problems, 1):
            cases = [
                self._case(each.students[0], view.problem, f"kata-{at}-case-{place}", each)
                for place, each in enumerate(view.mistakes, 1)
            ]
            katas.append((view, self._called(view.problem), list(zip(view.mistakes, cases, strict=True))))
        columns = len(katas) + any(each.group for each in cohort.students)
        return page(
            "class.html.j2",
            CLASS_MARK,
            [case for *_, made in katas for _, case in made],
            [mark.verdict for mark in cohort.every_mark],
            f"@media screen{{.tall .parts{{min-width:{_SIDES + _COLUMN * columns}rem}}}}",
            title=self.title,
            topic=self._topic,
            generated=self.generated,
            cohort=cohort,
            katas=katas,
            names=self.names,
            inline=_INLINE,
            part=_PART,
            caution=EQUAL_CAUTION,
        )

    def files(self) -> list[str]:
        """What the file of each student's page is called, in the order of the class."""
        taken = set[str]()
        return [_file(each.id, taken) for each in self.cohort.students]

    def student(self, place: int) -> bytes:
        """The page of the student at that place of the class."""
        cohort, person = self.cohort, self.cohort.students[place]
        marks = [
            (
                self._called(view.problem),
                cohort.mark(person.id, view.problem),
                self._case(person.id, view.problem, f"case-{at}"),
            )
            for at, view in enumerate(cohort.problems, 1)
        ]
        given = [mark for _, mark, _ in marks if mark]
        return page(
            "feedback.html.j2",
            FEEDBACK_MARK,
            [case for *_, case in marks],
            [mark.verdict for mark in given],
            title=self.names[person.id],
            course=self.title,
            topic=self._topic,
            generated=self.generated,
            marks=marks,
            solved=sum(mark.accepted for mark in given),
            points=cohort.total(person.id),
            full=cohort.full,
            note=person.note,
            unread=cohort.unread.get(person.id, ()),
        )

    @cached_property
    def _topic(self) -> str:
        """What the katas are about, where they are of one pack."""
        folders = {each.folder.parent for each in self.cases.problems.values()}
        return read_pack(folders.pop()).title if len(folders) == 1 else ""

    def _called(self, problem: str) -> str:
        return self.cases.problems[problem].title if problem in self.cases.problems else problem

    def _case(self, student: str, problem: str, anchor: str, alike: Alike | None = None) -> ShownCase | None:
        """The student's case; of several who are `alike`, without what does not hold for each."""
        mark = self.cohort.mark(student, problem)
        result = self.results.get((problem, mark.file)) if mark else None
        if mark is None or mark.accepted or mark.verdict is Verdict.JE or result is None:
            return None
        if alike and len(alike.students) > 1 and result.pitfall:
            result = replace(result, pitfall=replace(result.pitfall, steps=()))
        case = self.cases.tell(problem, mark.mistake, result, anchor)
        if alike is None or alike.shared:
            return case
        facts = tuple(each for each in case.facts if each[0] != "why")
        return replace(case, title=alike.what.capitalize(), advice=(), facts=facts)


def _file(student: str, taken: set[str]) -> str:
    """A file that is called by the student's id, and not `taken`; what no file name may hold becomes `_`."""
    plain = re.sub(r"[^\w .-]", "_", student).strip(" .")[:60] or "_"
    name, number = plain, 1
    while name.casefold() in taken:
        number += 1
        name = f"{plain}-{number}"
    taken.add(name.casefold())
    return f"{name}.html"
