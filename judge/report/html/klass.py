"""A class as one page, and a page for each of its students.

The page of the class has the table, who needs help, and one drawn case of each mistake. The page of a student
has nothing of anybody else.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from datetime import datetime

from msgspec import Struct

from judge.problem import Problem, Verdict
from judge.problem.model import FULL_SCORE
from judge.report.html import page
from judge.report.html.case import Case, Cases
from judge.report.published_klass import EQUAL_CAUTION, Cohort, Counted
from judge.run.result import Result

CLASS_MARK = "judge class page"  # in the head of every such page, also of older ones
FEEDBACK_MARK = "judge feedback page"
_INLINE = 12  # names that are in sight; longer lists are folded away

Results = Mapping[tuple[str, str], Result]  # of hand-ins, by kata and file


class Made(Struct, frozen=True):
    """A mistake, or a verdict where none is named, with who made it and one case of it, if there is one."""

    label: str
    students: tuple[str, ...]
    named: bool
    case: Case | None


class Kata(Struct, frozen=True):
    """One kata of the class: how many submitted something, and what went wrong, the most frequent first."""

    anchor: str
    id: str
    title: str
    submitted: int
    accepted: int
    mistakes: tuple[Made, ...]


class Mark(Struct, frozen=True):
    """What counts of a student on one kata; None where nothing was submitted."""

    id: str
    title: str
    counted: Counted | None
    case: Case | None


def class_page(
    cohort: Cohort, results: Results, problems: Mapping[str, Problem], *, title: str, generated: datetime
) -> bytes:
    """The page of a class.

    Args:
        cohort: the class.
        results: of the hand-in that counts, at least for the first student of each mistake.
        problems: the katas that are still there, by id; of others no case is drawn.
        title: what the class is called.
        generated: when the page is made.
    """
    cases = Cases(problems)
    katas = []
    for at, view in enumerate(cohort.views, 1):
        made = []
        for place, bar in enumerate(view.mistakes, 1):
            first = cohort.marks[bar.students[0], view.problem]
            case = _told(view.problem, first, results, cases, f"kata-{at}-case-{place}")
            made.append(Made(bar.label, bar.students, bar.named, case))
        name = _title(view.problem, problems)
        katas.append(Kata(f"kata-{at}", view.problem, name, view.handed_in, view.accepted, tuple(made)))
    marks = cohort.marks.values()
    tiles = [
        (str(len(cohort.people)), "student" if len(cohort.people) == 1 else "students"),
        (f"{cohort.handins:,}", "submission" if cohort.handins == 1 else "submissions"),
        (f"{sum(mark.accepted for mark in marks)} of {len(marks)}", "solved, by student and kata"),
    ]
    return page(
        "class.html.j2",
        CLASS_MARK,
        title=title,
        generated=generated,
        cohort=cohort,
        katas=katas,
        tiles=tiles,
        names=_names(cohort),
        inline=_INLINE,
        caution=EQUAL_CAUTION,
        drawn=any(made.case and made.case.drawings for kata in katas for made in kata.mistakes),
        verdicts=_verdicts(marks),
    )


def feedback_pages(
    cohort: Cohort, results: Results, problems: Mapping[str, Problem], *, title: str, generated: datetime
) -> Iterator[tuple[str, bytes]]:
    """For each student who submitted something, the name of a file and their page; as class_page."""
    cases, names, files = Cases(problems), _names(cohort), _files(cohort)
    for person in cohort.people:
        marks = [
            Mark(
                problem,
                _title(problem, problems),
                counted := cohort.marks.get((person.id, problem)),
                _told(problem, counted, results, cases, f"case-{at}") if counted else None,
            )
            for at, problem in enumerate(cohort.problems, 1)
        ]
        given = [mark.counted for mark in marks if mark.counted]
        solved = sum(mark.accepted for mark in given)
        tiles = [
            (f"{solved} of {len(marks)}", "katas solved"),
            (str(cohort.total(person.id)), f"points of {FULL_SCORE * len(marks)}"),
        ]
        if given:
            yield (
                files[person.id],
                page(
                    "feedback.html.j2",
                    FEEDBACK_MARK,
                    title=names[person.id],
                    course=title,
                    generated=generated,
                    marks=marks,
                    tiles=tiles,
                    verdicts=_verdicts(given),
                    drawn=any(mark.case and mark.case.drawings for mark in marks),
                ),
            )


def _verdicts(marks: Iterable[Counted]) -> list[Verdict]:
    found = {mark.verdict for mark in marks}
    return [verdict for verdict in Verdict if verdict in found]


def _title(problem: str, problems: Mapping[str, Problem]) -> str:
    return problems[problem].title if problem in problems else problem


def _told(problem: str, mark: Counted, results: Results, cases: Cases, anchor: str) -> Case | None:
    result = results.get((problem, mark.file))
    if mark.accepted or result is None:
        return None
    return cases.tell(problem, mark.verdict, mark.mistake, result, anchor)


def _names(cohort: Cohort) -> dict[str, str]:
    """What each student is called: the name of the list, with the id where two have one name."""
    often = Counter(each.name for each in cohort.people)
    names = {each.id: each.name or each.id for each in cohort.people}
    return {who: name if often[name] <= 1 else f"{name} ({who})" for who, name in names.items()}


def _files(cohort: Cohort) -> dict[str, str]:
    """A file for each student, called by their id; what no file name may hold becomes `_`."""
    found: dict[str, str] = {}
    taken: set[str] = set()
    for each in cohort.people:
        plain = re.sub(r"[^\w .-]", "_", each.id).strip(" .")[:60] or "_"
        name, number = plain, 1
        while name.casefold() in taken:
            number += 1
            name = f"{plain}-{number}"
        taken.add(name.casefold())
        found[each.id] = f"{name}.html"
    return found
