"""A class as one page, and a page for each of its students.

The page of the class has the table, who needs help, and one drawn case of each mistake. The page of a student
has nothing of anybody else.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping
from datetime import datetime

from judge.problem import Problem
from judge.problem.model import FULL_SCORE
from judge.report.html import page
from judge.report.html.case import Case, Cases
from judge.report.published_klass import EQUAL_CAUTION, Cohort
from judge.run.result import Result

CLASS_MARK = "judge class page"  # in the head of every such page, also of older ones
FEEDBACK_MARK = "judge feedback page"
_INLINE = 12  # names that are in sight; longer lists are folded away


class ClassPages:
    """The pages of a class that is called `title`, made when they are `generated`.

    `results` are those of the hand-in that counts, by kata and file, at least for the first student of each
    mistake. `problems` are the katas that are still there, by id; of others no case is drawn.
    """

    def __init__(
        self,
        cohort: Cohort,
        results: Mapping[tuple[str, str], Result],
        problems: Mapping[str, Problem],
        title: str,
        generated: datetime,
    ) -> None:
        self._cohort, self._results, self._cases = cohort, results, Cases(problems)
        self._title, self._generated = title, generated
        often = Counter(each.name for each in cohort.students)
        names = {each.id: each.name or each.id for each in cohort.students}
        self._names = {who: name if often[name] <= 1 else f"{name} ({who})" for who, name in names.items()}

    def whole(self) -> bytes:
        """The page of the class."""
        cohort = self._cohort
        katas = [
            (
                view,
                self._called(view.problem),
                [
                    (bar, self._case(bar.students[0], view.problem, f"kata-{at}-case-{place}"))
                    for place, bar in enumerate(view.mistakes, 1)
                ],
            )
            for at, view in enumerate(cohort.problems, 1)
        ]
        return page(
            "class.html.j2",
            CLASS_MARK,
            [case for *_, made in katas for _, case in made],
            [mark.verdict for mark in cohort.every_mark],
            title=self._title,
            generated=self._generated,
            cohort=cohort,
            katas=katas,
            names=self._names,
            inline=_INLINE,
            caution=EQUAL_CAUTION,
        )

    def students(self) -> Iterator[tuple[str, bytes]]:
        """For each student who submitted something, the name of a file and their page."""
        cohort, taken = self._cohort, set[str]()
        for person in cohort.students:
            name = _file(person.id, taken)
            marks = [
                (
                    self._called(view.problem),
                    cohort.mark(person.id, view.problem),
                    self._case(person.id, view.problem, f"case-{at}"),
                )
                for at, view in enumerate(cohort.problems, 1)
            ]
            given = [mark for _, mark, _ in marks if mark]
            if not given:
                continue
            content = page(
                "feedback.html.j2",
                FEEDBACK_MARK,
                [case for *_, case in marks],
                [mark.verdict for mark in given],
                title=self._names[person.id],
                course=self._title,
                generated=self._generated,
                marks=marks,
                solved=sum(mark.accepted for mark in given),
                points=cohort.total(person.id),
                full=FULL_SCORE * len(marks),
            )
            yield name, content

    def _called(self, problem: str) -> str:
        return self._cases.problems[problem].title if problem in self._cases.problems else problem

    def _case(self, student: str, problem: str, anchor: str) -> Case | None:
        mark = self._cohort.mark(student, problem)
        result = self._results.get((problem, mark.file)) if mark else None
        if mark is None or mark.accepted or result is None:
            return None
        return self._cases.tell(problem, mark.verdict, mark.mistake, result, anchor)


def _file(student: str, taken: set[str]) -> str:
    """A file that is called by the student's id, and not `taken`; what no file name may hold becomes `_`."""
    plain = re.sub(r"[^\w .-]", "_", student).strip(" .")[:60] or "_"
    name, number = plain, 1
    while name.casefold() in taken:
        number += 1
        name = f"{plain}-{number}"
    taken.add(name.casefold())
    return f"{name}.html"
