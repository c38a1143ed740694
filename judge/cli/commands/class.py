"""`judge class`: judge what a class has submitted."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import AbstractContextManager, nullcontext
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import click
from msgspec import Struct

from judge.batch.folder import root_of
from judge.batch.run import Classroom, class_options
from judge.batch.store import Store, store_of
from judge.cli.options import Common, command, opt, takes
from judge.cli.target import OutFile, moment
from judge.errors import UsageError, unwritable
from judge.problem.find import find_problem
from judge.problem.model import LEVELS
from judge.report.cohort import ClassLine, ClassRow, Cohort, gradebook, is_gradebook
from judge.report.screen import note
from judge.report.words import counted

if TYPE_CHECKING:
    from judge.judging.pool import Executor


class ClassAsk(Struct, frozen=True):
    """How to judge a class, and what to write of it."""

    students: Annotated[
        Path | None,
        opt("--students", metavar="CSV", help="The list of the class, with the columns id, name and group."),
    ] = None
    jobs: Annotated[
        int, opt("-j", "--jobs", type=click.IntRange(1, 256), metavar="N", help="Judge N files at once.")
    ] = 1
    level: Annotated[
        str | None,
        opt(
            "--level",
            type=click.Choice(LEVELS),
            metavar="|".join(LEVELS),
            help="Only this level of each kata.",
        ),
    ] = None
    again: Annotated[
        tuple[str, ...],
        opt("--again", metavar="NAME", help="Judge a student, a kata or a file again (repeatable)."),
    ] = ()
    csv: Annotated[
        Path | None, opt("--csv", metavar="FILE", help="Write the gradebook, a line a student.")
    ] = None
    html: Annotated[
        Path | None,
        opt("--html", metavar="FILE", help="Write one page of it all, with a picture of each mistake."),
    ] = None
    feedback: Annotated[
        Path | None, opt("--feedback", metavar="DIR", help="Write a page for each student into this folder.")
    ] = None
    where: Annotated[
        str | None,
        opt(
            "--on",
            metavar="WHERE",
            help="Judge with the workers of a dask scheduler: tls://HOST:PORT, or its file.",
        ),
    ] = None


@command("class", ClassRow, ClassLine)
@click.argument("folder", metavar="FOLDER", type=click.Path(path_type=Path))
@click.argument("katas", metavar="[KATA]...", nargs=-1)
@takes(ClassAsk, "ask")
def judge_class(
    folder: Path, katas: tuple[str, ...], ask: ClassAsk, common: Common
) -> Iterator[ClassRow | Cohort]:
    """Judge everything that a class has submitted.

    FOLDER holds STUDENT/KATA.py or KATA/STUDENT.py, in any language. A file of another name is for the kata
    whose function it defines. Each result is kept at once in FOLDER.judge.sqlite3: after Ctrl-C or a crash
    the same command goes on, and judges only what is new. If a student has several files for one kata, the
    best counts. Equal files are judged once. A terminal shows the first names of long lists, a pipe all.

    Exit status: 0 all accepted, 1 not, 2 usage, 3 something could not be judged.
    """
    if ask.where is not None and ask.jobs > 1:
        raise UsageError("--on and -j contradict each other", remedy="leave one out")
    root_of(folder)  # before a file is made beside it
    for each in katas:
        find_problem(each, common.problems)
    files = _Files(ask, folder)
    with Store.open(store_of(folder)) as store:
        classroom = Classroom(
            folder,
            store,
            class_options(common.isolation, ask.level),
            students=ask.students,
            only=katas,
            folders=common.problems,
            say=note,
        )
        try:
            with _executor(ask, common.isolation) as executor:
                for row in classroom.judge(executor, ask.again):
                    if common.json:
                        yield row
        except KeyboardInterrupt:
            if not common.json:
                yield classroom.cohort()
            note(f"{counted(classroom.left, 'file')} left; the same command goes on")
            raise
        found = classroom.cohort()
        yield found
        files.write(classroom, found)


def _executor(ask: ClassAsk, isolation: str | None) -> AbstractContextManager[Executor]:
    """Who judges: this machine, or others."""
    if ask.where is not None:
        from judge.batch.elsewhere import Elsewhere

        return Elsewhere(ask.where, isolation, note)
    from judge.judging.pool import Here, Processes

    return nullcontext(Processes(ask.jobs) if ask.jobs > 1 else Here())


class _Files:
    """The files to write; raises UsageError, before anything is judged, where one cannot be written."""

    def __init__(self, ask: ClassAsk, folder: Path) -> None:
        self._feedback = ask.feedback
        self._title = folder.resolve().name or "class"
        self._csv = OutFile(ask.csv, "--csv", "gradebook", is_gradebook) if ask.csv else None
        self._html = (
            OutFile(ask.html, "--html", "page of a class", partial(_is_page, "CLASS")) if ask.html else None
        )
        for target in (self._csv, self._html):
            if target:
                target.check()
        if ask.html or ask.feedback:
            moment()
        if ask.feedback:
            try:
                ask.feedback.mkdir(exist_ok=True)
            except OSError as fault:
                raise unwritable(ask.feedback, fault, "name another folder with --feedback") from fault

    def write(self, classroom: Classroom, cohort: Cohort) -> None:
        """Write them. Raises UsageError."""
        if self._csv:
            self._csv.write(gradebook(cohort))
        if not (self._html or self._feedback):
            return
        from judge.report.html.klass import class_page, feedback_pages

        results = classroom.results(cohort, everybody=self._feedback is not None)
        problems, title, generated = classroom.problems(), self._title, moment()
        if self._html:
            self._html.write(class_page(cohort, results, problems, title=title, generated=generated))
        if self._feedback:
            for name, content in feedback_pages(cohort, results, problems, title=title, generated=generated):
                target = OutFile(
                    self._feedback / name, "--feedback", "feedback page", partial(_is_page, "FEEDBACK")
                )
                target.check()
                target.write(content)


def _is_page(kind: str, start: bytes) -> bool:
    from judge.report.html import is_page, klass

    return is_page(start, getattr(klass, f"{kind}_MARK"))
