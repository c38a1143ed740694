"""A failing case as pages and notebooks show it; a class as one page, and a page for each of its students.

The kata of a case may have changed since, or be gone. The page of the class has the table, who needs help,
and one drawn case of each mistake. The page of a student has nothing of anybody else.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping
from contextlib import suppress
from datetime import datetime
from functools import cached_property
from itertools import chain, count

from msgspec import Struct
from msgspec.structs import replace

from judge.drawing import Picture
from judge.drawing.svg import style
from judge.errors import JudgeError
from judge.practice.syllabus import read_pack
from judge.problem import Problem, Verdict
from judge.problem.find import find_problem
from judge.problem.module import Module, load_module
from judge.report.html import page, rendered
from judge.report.picture import case_picture
from judge.report.published_klass import EQUAL_CAUTION, Alike, Cohort
from judge.report.tell import shown_failure, tell
from judge.report.words import shown_name
from judge.run.result import Result

_LONGEST = 2000  # characters of a submission's own words that are shown
CLASS_MARK = "judge class page"  # in the head of every such page, also of older ones
FEEDBACK_MARK = "judge feedback page"
_PART = 100  # rows of a table; a browser lays out one after another, and those in sight first
_SIDES, _COLUMN = 18, 9  # rem of the first and last column of a table in parts, and of one between
_INLINE = 12  # names that are in sight; longer lists are folded away


class ShownCase(Struct, frozen=True):
    """A failing case. `place` says which one it is, `advice` what is wrong, by each of its mistakes."""

    anchor: str
    title: str
    place: str = ""
    facts: tuple[tuple[str, str], ...] = ()  # label and text
    picture: Picture | None = None
    advice: tuple[str, ...] = ()


class ShownCases:
    """Tells failing cases of these katas, by id. A kata's code is loaded with the first case drawn of it."""

    def __init__(self, problems: Mapping[str, Problem]) -> None:
        self.problems = problems
        self._modules: dict[str, Module] = {}

    def tell(self, problem: str, mistake: str, result: Result, anchor: str) -> ShownCase:
        """The smallest failing case of a result, or else its first one.

        `mistake` is its name, two as "a + b", or empty. `anchor` is the id of the case in its page.
        """
        known = self.problems.get(problem)
        where = f", {result.failure.group}" if result.failure and result.failure.group else ""
        title = mistake or f"{result.verdict.meaning}{where}".capitalize()
        with suppress(ValueError, TypeError):  # it has other parameters now
            result = result.typed(known) if known else result
        picture = self.picture(known, result)
        told = tell(known, result, why=picture.why if picture else "")
        facts = (("input", ", ".join(told.input)), *told.facts, ("why", told.happened))
        said = tuple((label, _cut(text)) for label, text in facts if text)
        return ShownCase(anchor, title, told.case, said, picture, told.advice)

    def picture(self, problem: Problem | None, result: Result) -> Picture | None:
        """The failing case, where the kata is there and draws it."""
        shown = shown_failure(result)
        if problem is None or shown is None or result.failure is None:
            return None
        with suppress(JudgeError):
            module = self._modules[problem.id] = self._modules.get(problem.id) or load_module(problem)
            return case_picture(problem, module, shown, result.failure.group)
        return None


def _cut(text: str) -> str:
    return text if len(text) <= _LONGEST else text[: _LONGEST - 1] + "…"


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
            anchors = (f"kata-{at}-case-{place}" for place in count(1))
            shown = [
                (it, self._case(it.students[0], view.problem, next(anchors), it)) for it in view.mistakes
            ]
            katas.append((view, self._called(view.problem), shown))
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
        katas = [view.problem for view in cohort.problems]
        cases = [self._case(person.id, kata, f"case-{at}") for at, kata in enumerate(katas, 1)]
        own = [cohort.mark(person.id, kata) for kata in katas]
        marks = list(zip(map(self._called, katas), own, cases, strict=True))
        given = [mark for mark in own if mark]
        return page(
            "feedback.html.j2",
            FEEDBACK_MARK,
            cases,
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
    names = chain([plain], (f"{plain}-{number}" for number in count(2)))
    name = next(each for each in names if each.casefold() not in taken)
    taken.add(name.casefold())
    return f"{name}.html"


def notebook(result: Result) -> str:
    """A result as an element of HTML with its own style sheet; without a drawing if its kata is not found."""
    told, anchor, picture = tell(None, result), f"judge-{id(result):x}", None
    with suppress(JudgeError):
        picture = ShownCases({}).picture(find_problem(result.problem), result)
    return rendered(
        "notebook.html.j2",
        anchor=anchor,
        style=style(f"#{anchor} figure"),
        head=f"{told.verdict.value}  {told.meaning}  {shown_name(result.submission)}  {told.stars}".rstrip(),
        text="\n".join((*told.lines, told.last)),
        picture=picture,
    ).decode()
