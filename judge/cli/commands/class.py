"""`judge class`: judge what a class has submitted."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from contextlib import AbstractContextManager, nullcontext
from datetime import UTC, datetime
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import click
from msgspec import Struct

from judge.batch.classroom import ClassOptions, Classroom
from judge.batch.cohort import anonymous
from judge.batch.folder import root_of
from judge.batch.gradebook import gradebook, is_gradebook
from judge.batch.shards import Shard, merged
from judge.batch.store import ResultStore, store_of
from judge.cli.files import OutFile, writing
from judge.cli.options import Common, command, exclusive, opt
from judge.errors import UsageError
from judge.problem.find import find_problem
from judge.problem.model import LEVELS
from judge.report.html import is_page, is_same
from judge.report.html.pages import CLASS_MARK, FEEDBACK_MARK, ClassPages, ShownCases
from judge.report.published_klass import ClassRow, Cohort
from judge.report.screen import note
from judge.report.words import counted

if TYPE_CHECKING:
    from judge.judging.pool import Executor
    from judge.run.result import Result

_WEIGHT = re.compile(r"[0-9]{1,6}(\.[0-9]{1,9})?")


class ClassAsk(Struct, frozen=True):
    """How to judge a class, and what to write of it."""

    students: Path | None = opt("--students CSV", "The list of the class, or your platform's gradebook.")
    jobs: int = opt("-j --jobs N", "Judge N files at once.", type=click.IntRange(1, 256), default=1)
    level: str | None = opt("--level", "Only this level, of katas that have it.", choices=LEVELS)
    again: tuple[str, ...] = opt("--again NAME", "Judge that student, kata or file again.", default=())
    csv: Path | None = opt("--csv FILE", "Write the gradebook, one line for each student.")
    html: Path | None = opt("--html FILE", "Write one page of it all, with a picture of each mistake.")
    feedback: Path | None = opt("--feedback DIR", "Write a page for each student into this folder.")
    due: str | None = opt("--due TIME", "Count days late from then: 2026-12-01T23:59.")
    weight: tuple[str, ...] = opt(
        "--weight KATA=N", "Weigh a kata; the total is out of 100 then.", default=()
    )
    anonymous: bool = opt("--anonymous", "Numbers for names.")
    where: str | None = opt("--on WHERE", "Judge with the workers of a dask scheduler.")
    shard: str | None = opt("--shard K/N", "Judge part K of N, into a file of its own.")
    merge: bool = opt("--merge", "Take over parts, named after FOLDER.")


@command("class", ClassRow, Cohort, ask=ClassAsk)
@click.argument("folder", metavar="FOLDER", type=click.Path(path_type=Path))
@click.argument("katas", metavar="[KATA]...", nargs=-1)
def judge_class(
    folder: Path, katas: tuple[str, ...], ask: ClassAsk, common: Common
) -> Iterator[ClassRow | Cohort]:
    """Judge everything that a class has submitted.

    FOLDER holds STUDENT/KATA.py or KATA/STUDENT.py, in any language, or what Moodle, Canvas, Gradescope,
    Blackboard or Brightspace hand out. A file of another name is for the kata whose function it defines.
    Each result is kept at once in FOLDER.judge.sqlite3: after Ctrl-C or a crash the same command goes on, and
    judges only what is new. Of several files for one kata the best counts.

    Exit status: 0 all accepted, 1 not, 2 usage, 3 something could not be judged, 130 stopped by Ctrl-C.
    """
    exclusive(ask, "where", "jobs")
    exclusive(ask, "shard", "merge", "csv", "html", "feedback")  # which are for the whole class
    shard = Shard.read(ask.shard) if ask.shard is not None else None
    parts, katas = (tuple(map(Path, katas)), ()) if ask.merge else ((), katas)
    if ask.merge and not parts:
        raise UsageError("--merge takes files", remedy="name those that 'judge class --shard' wrote")
    root = root_of(folder)  # before a file is made beside it
    if ask.feedback and ask.feedback.resolve().is_relative_to(root):
        what = "pages in the class's folder would be read as somebody's files"
        raise UsageError(what, where="--feedback", remedy="name a folder beside it")
    if ask.anonymous and common.json:
        raise UsageError("--json has names", remedy="leave out --anonymous")
    for each in katas:
        find_problem(each, common.problems)
    options = ClassOptions(
        students=ask.students,
        only=katas,
        folders=common.problems,
        isolation=common.isolation,
        level=ask.level,
        due=None if ask.due is None else _time(ask.due),
        weights=dict(_weight(each, common) for each in ask.weight),
        shard=shard,
        anonymous=ask.anonymous,
    )
    csv = OutFile(ask.csv, "--csv", "a gradebook", is_gradebook)
    html = OutFile(ask.html, "--html", "a page of a class", partial(is_page, mark=CLASS_MARK))
    place = store_of(folder)
    with ResultStore.open(shard.beside(place) if shard else place) as store:
        if parts:
            note(merged(store, parts))
        classroom = Classroom(folder, store, options, note)
        pages = _Pages(classroom, folder.resolve().name or "class", ask.anonymous, ask.feedback)
        try:
            with _executor(ask, common.isolation) as executor:
                for row in classroom.judge(executor, ask.again):
                    if common.json:
                        yield row
                    pages.write(row.student)
        except KeyboardInterrupt:
            found = classroom.cohort()
            if not common.json:
                yield anonymous(found)[0] if ask.anonymous else found
            note(f"{counted(found.left, 'file')} left; the same command goes on")
            raise
        found = classroom.cohort()
        yield anonymous(found)[0] if ask.anonymous else found
        csv.write(gradebook(found, classroom.roster.sheet, numbered=ask.anonymous))
        if ask.html:
            html.write(pages.of(found, classroom.results(found)).whole(), is_same)


def _time(said: str) -> datetime:
    """A time of this machine's clock, of a day alone its last second. Raises UsageError."""
    try:
        return datetime.fromisoformat(said + "T23:59:59" * (len(said) <= len("2026-12-01")))
    except ValueError:
        remedy = "write a day, or a day and a time: 2026-12-01T23:59"
        raise UsageError(f"{said!r} is not a time", where="--due", remedy=remedy) from None


def _weight(said: str, common: Common) -> tuple[str, float]:
    """A kata and its weight. Raises UsageError."""
    kata, _, number = said.partition("=")
    if not _WEIGHT.fullmatch(number):
        raise UsageError(f"--weight: {said!r} is not a weight", remedy="write a kata and a number: count=2")
    return find_problem(kata, common.problems).id, float(number)


def _executor(ask: ClassAsk, isolation: str | None) -> AbstractContextManager[Executor]:
    """Who judges: this machine, or others."""
    if ask.where is not None:
        from judge.batch.cluster import ClusterExecutor

        return ClusterExecutor(ask.where, isolation, note)
    from judge.judging.pool import Here, Processes

    return nullcontext(Processes(ask.jobs) if ask.jobs > 1 else Here())


class _Pages:
    """The pages of a class; a student's is written as soon as all that was submitted for it is judged."""

    def __init__(self, classroom: Classroom, title: str, hidden: bool, folder: Path | None) -> None:
        """`hidden` are names, which are numbers then. Make the `folder` of the students' pages, and those
        that need no judging. Raises UsageError.
        """
        self._classroom, self._title, self._hidden = classroom, title, hidden
        self._cases = ShownCases(classroom.problems)
        self._files: dict[str, tuple[int, OutFile]] = {}
        if folder is None:
            return
        with writing(folder, "name another folder with --feedback"):
            folder.mkdir(exist_ok=True)
        own = partial(is_page, mark=FEEDBACK_MARK)
        names = self.of(*classroom.alone("")).files()
        files = [OutFile(folder / name, "--feedback", "a feedback page", own) for name in names]
        self._files = dict(zip(classroom.students, enumerate(files), strict=True))
        for student in self._files:
            self.write(student)

    def of(self, cohort: Cohort, results: Mapping[tuple[str, str], Result]) -> ClassPages:
        """The pages of this class, or of what is judged of it."""
        shown, files = anonymous(cohort) if self._hidden else (cohort, {})
        results = {(kata, files.get(file, file)): each for (kata, file), each in results.items()}
        return ClassPages(shown, results, self._cases, self._title, datetime.now(UTC))

    def write(self, student: str) -> None:
        """Write the page of a student who is done, where it says something new. Raises UsageError."""
        if student in self._files and self._classroom.is_done(student):
            at, file = self._files[student]
            file.write(self.of(*self._classroom.alone(student)).student(at), is_same)
