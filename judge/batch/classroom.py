"""Judging a class: every text is judged once, each row is kept at once.

Looking for a smallest failing case takes seconds, so that it is done only for what a page shows, once for
equal texts, and kept.
"""

from __future__ import annotations

import time
from collections import Counter, defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import closing, suppress
from datetime import datetime
from functools import partial
from math import ceil
from pathlib import Path, PurePath
from types import MappingProxyType
from typing import Any

import msgspec
from msgspec import Struct
from msgspec.structs import replace

from judge.batch.cluster import ClusterExecutor
from judge.batch.cohort import cohort_of, counting, samples
from judge.batch.duplicates import equal_files
from judge.batch.folder import read_class
from judge.batch.model import Environment, KeptRow, Submission, Task, WorkerResult
from judge.batch.plan import ClassPlan, current, planned
from judge.batch.platforms import Roster
from judge.batch.roster import everyone, read_students
from judge.batch.shards import Shard
from judge.batch.store import ResultStore
from judge.batch.work import judge_task, level_here, release
from judge.errors import JudgeError, ProblemError, UsageError
from judge.judging import RunOptions
from judge.judging.pool import Executor, Processes
from judge.judging.session import Session
from judge.problem import Problem, Verdict
from judge.problem.find import find_problem
from judge.report.published_klass import ClassRow, Cohort
from judge.report.wait import Live, progress
from judge.report.words import counted, shown_name
from judge.run.result import Result

_BROKEN = (Verdict.WA, Verdict.RTE, Verdict.TLE, Verdict.MLE)  # which have a smallest failing case
_DAY = 86_400  # seconds
_NAMES = 5  # files that one sentence names
_NOTES = 5  # different notes of the workers that are said


class ClassOptions(Struct, frozen=True):
    """Which of a class's files are judged, and how.

    `students` is the list of the class, `only` are ids of katas, `folders` folders of katas to look in first.
    Only groups of the `level` run. Days late count from `due`; `weights` are those of katas. No
    note names anybody if it is `anonymous`.
    """

    students: Path | None = None
    only: Sequence[str] = ()
    folders: Sequence[Path] = ()
    isolation: str | None = None
    level: str | None = None
    due: datetime | None = None
    weights: Mapping[str, float] = MappingProxyType({})
    shard: Shard | None = None
    anonymous: bool = False


class Classroom:
    """A class that is judged; `cohort` says how far it has come, at any time. `roster` is its list.

    Raises:
        UsageError: the folder or the list of students cannot be read, or nothing is submitted there.
    """

    def __init__(
        self, folder: Path, store: ResultStore, options: ClassOptions, say: Callable[[str], None]
    ) -> None:
        """Each sentence goes to `say` once."""
        self._store, self._options, self._tell = store, options, say
        self._run = RunOptions(isolation=options.isolation, diagnosed=False, level=options.level)
        self.roster = read_students(options.students) if options.students else Roster()
        found = read_class(folder, only=options.only, folders=options.folders, roster=self.roster)
        shard, self._unread = options.shard, [each for each in found.unplaced if each.student]
        self._submissions = [each for each in found.submissions if shard is None or shard.holds(each)]
        self.students = {each.id: each for each in everyone(self.roster, [*found.submissions, *self._unread])}
        self._called_late = found.late | {who for who, each in self.students.items() if each.late}
        self._environments: set[Environment | None] | None = None  # any, until they are known
        self._katas = sorted({each.problem for each in self._submissions})
        self.problems: dict[str, Problem] = {}  # those that can be read, by id
        self._faults: dict[str, str] = {}  # why one cannot be judged
        for each in self._katas:
            try:
                self.problems[each] = find_problem(each, options.folders)
                self._run.chosen(self.problems[each])
            except (ProblemError, UsageError) as fault:
                self._faults[each] = str(fault)
        self._expected = Counter(each.student for each in self._submissions)
        self._own: defaultdict[str, list[KeptRow]] = defaultdict(list)  # as they come
        self._small: dict[tuple[str, str], Result | None] = {}  # by problem and digest, as they are found
        self._said: set[str] = set()
        self._notes: dict[str, None] = {}  # of the workers
        self._live = Live()
        self._say(*_unweighed(options.weights, self._katas))
        if shard is None or shard.number == 1:
            told = [each for each in found.unplaced if not (options.anonymous and each.student)]
            hidden = [replace(each, file="a file") for each in told] if options.anonymous else told
            self._say(*_left_out(hidden), *(() if options.anonymous else self.roster.unclear.values()))
        if not found.submissions and not self.roster.students:
            remedy = "it holds STUDENT/KATA.py or KATA/STUDENT.py; see 'judge help class'"
            raise UsageError("nothing is submitted here", where=str(folder), remedy=remedy)

    def judge(self, executor: Executor, again: Sequence[str] = ()) -> Iterator[ClassRow]:
        """Judge what is not judged yet; each row is kept before it is given, those of before come first.

        `again` are names of students, katas or files to judge anew.

        Raises:
            UsageError: nothing is called like one of `again`, or a worker does not judge by the environment
                that is asked for.
            JudgeError: nothing can be judged, or the results cannot be kept.
        """
        self._check_again(again)
        kinds = self._kinds(executor)
        self._environments = {None, *(each.environment for each in kinds.values() if isinstance(each, Task))}
        plan = planned(self._submissions, self._store.every(), kinds, again)
        self._say(*plan.notices)
        self._store.keep_all(plan.rows)
        with self._live as live:
            yield from (self._published(row, kept=True) for row in plan.kept)
            yield from map(self._published, plan.rows)
            done, began = len(plan.kept) + len(plan.rows), time.monotonic()
            live.show(partial(_pace, plan, done, 0, began))
            tasks = [work.task for work in plan.work]
            with closing(
                executor.run(
                    judge_task, tasks, lambda task, why: WorkerResult.fault(task.problem, task.name, why)
                )
            ) as outcomes:
                for texts, (place, outcome) in enumerate(outcomes, 1):
                    rows = plan.work[place].rows(outcome)
                    self._store.keep_all(rows)
                    live.hide()
                    yield from map(self._published, rows)
                    done += len(rows)
                    live.show(partial(_pace, plan, done, texts, began))
        release()
        if (more := len(self._notes) - _NOTES) > 0:
            self._say(f"{counted(more, 'further note')} of the workers; --json has them all")

    def cohort(self) -> Cohort:
        """The class as it stands."""
        every = self._store.every()
        rows = current(self._submissions, every, self._environments)
        return self._cohort(
            list(rows.values()),
            history=every,
            equal_files=tuple(equal_files(rows, self.problems)),
            left=[each for each in self._submissions if each not in rows],
        )

    def is_done(self, student: str) -> bool:
        """Whether all that the student has submitted has been judged, or was before."""
        return len(self._own[student]) == self._expected[student]

    def alone(self, student: str) -> tuple[Cohort, dict[tuple[str, str], Result]]:
        """The class with nothing but what one student has submitted, who is done; and what their page shows
        of it, by kata and file, with smallest cases.
        """
        rows = self._own[student]
        return self._cohort(rows), self._smallest(list(counting(rows).values()))

    def results(self, cohort: Cohort) -> dict[tuple[str, str], Result]:
        """What the page of the class shows, by kata and file: one file of each mistake."""
        rows = current(self._submissions, self._store.every(), self._environments).values()
        return self._smallest(samples(cohort, rows))

    def _smallest(self, rows: Sequence[KeptRow]) -> dict[tuple[str, str], Result]:
        """The result of each row, by problem and file, with its smallest case; without it where the problem
        is not there, or another verdict comes of the text now.
        """
        found = {(row.problem, row.file): row.result for row in rows}
        broken = [each for each in rows if each.result.verdict in _BROKEN and each.problem in self.problems]
        with progress("smallest failing cases") as advance:
            for done, row in enumerate(broken):
                if advance:
                    advance(done, len(broken))
                if small := row.smallest or self._sought(row):
                    found[row.problem, row.file] = small
        return found

    def _sought(self, row: KeptRow) -> Result | None:
        """It is kept, also that there is none where the text has another verdict now; None on a fault."""
        text = row.problem, row.digest
        if text not in self._small:
            self._small[text] = None
            source = next(each.source for each in self._submissions if each.file == row.file)
            options = replace(self._run, timed=False, diagnosed=True)
            with suppress(JudgeError), Session(self.problems[row.problem], options) as session:
                self._small[text] = session.judge(source, PurePath(row.file).name)
        small = self._small[text]
        if small is None:
            return None
        if small.verdict is not row.result.verdict:
            small = row.result
        self._store.keep_all([replace(row, small=small.as_json())])
        return small

    def _cohort(self, rows: Sequence[KeptRow], **shown: Any) -> Cohort:
        late = {
            (each.student, each.file): self._days_late(each)
            for each in self._submissions
            if self._options.due or each.student in self._called_late
        }
        return cohort_of(
            tuple(self.students.values()),
            self._katas,
            rows,
            titles=self.roster.titles,
            unread=self._unread,
            late=late,
            weights=dict(self._options.weights),
            **shown,
        )

    def _days_late(self, each: Submission) -> int | None:
        """By how many days a file is late, less what the list grants; None where a platform alone says so."""
        if self._options.due is None:
            return None
        days = (each.at - self._options.due.timestamp()) / _DAY - self.students[each.student].extra_days
        return max(0, ceil(days)) or (None if each.student in self._called_late else 0)

    def _kinds(self, executor: Executor) -> dict[str, Task | str]:
        """How each kata is judged, or why it cannot be; workers elsewhere find the katas themselves.

        Raises:
            UsageError: the isolation that is demanded cannot be had.
            JudgeError: nothing can be judged here.
        """
        problems = [found for name, found in self.problems.items() if name not in self._faults]
        level, folders = "", tuple[str, ...]()
        if isinstance(executor, ClusterExecutor):
            level = executor.level
        elif problems:
            level, notices = level_here(problems[0], self._run)
            self._say(*notices)
            folders = tuple(str(folder.absolute()) for folder in self._options.folders)
        if isinstance(executor, Processes) and executor.short:
            self._say(executor.short)
        kinds: dict[str, Task | str] = {**self._faults}
        for each in problems:
            environment = Environment.here(each, self._run, level)
            kinds[each.id] = Task(each.id, "", b"", self._run, environment, folders)
        return kinds

    def _published(self, row: KeptRow, *, kept: bool = False) -> ClassRow:
        """The row as it goes out; new notes of its worker are said, unless it was kept."""
        done, student, result = row.done, self.students[row.student], row.result
        self._own[student.id].append(row)
        self._notes |= {} if kept else dict.fromkeys(result.notes)
        self._say(*[*self._notes][:_NOTES])
        return ClassRow(
            student=student.id,
            name=student.name,
            group=student.group,
            listed=student.known,
            problem=row.problem,
            file=row.file,
            verdict=result.verdict,
            score=result.score,
            mistake=row.mistake or None,
            copied=row.copied or None,
            kept=kept,
            machine=done.machine or None,
            worker=done.worker or None,
            cpu_seconds=done.seconds,
            judged_at=row.at,
            standard=msgspec.to_builtins(row.standard),
            result=result.as_json(),
        )

    def _say(self, *texts: str) -> None:
        for text in texts:
            if text not in self._said:
                self._said.add(text)
                self._live.hide()
                self._tell(text)

    def _check_again(self, again: Sequence[str]) -> None:
        known = {name for each in self._submissions for name in (each.student, each.problem, each.file)}
        for name in again:
            if name not in known | set(self.students):
                remedy = "name a student, a kata or a file, as the table does"
                raise UsageError(f"nothing here is called {name!r}", where="--again", remedy=remedy)


def _pace(plan: ClassPlan, done: int, texts: int, began: float) -> str:
    """How far it is: so many rows are there, and `texts` were judged since it `began`."""
    count = f"{done} of {counted(plan.total, 'file')}"
    if not texts:
        return count
    left = (time.monotonic() - began) / texts * (len(plan.work) - texts)
    return f"{count}; about {round(left) // 60}:{round(left) % 60:02} left"


def _left_out(unplaced: Sequence[Submission]) -> Iterator[str]:
    """What in the folder is not judged: each reason with its files, once."""
    reasons: dict[str, dict[str, None]] = {}
    for each in unplaced:
        reasons.setdefault(each.why, {})[shown_name(each.file)] = None
    for why, files in reasons.items():
        names, more = [*files][:_NAMES], len(files) - _NAMES
        yield f"not judged: {', '.join(names)}{f' and {more} more' if more > 0 else ''}: {why}"


def _unweighed(weights: Mapping[str, float], katas: Sequence[str]) -> Iterator[str]:
    """Weights that weigh nothing."""
    yield from (f"--weight {kata}: it is not in the table" for kata in weights if kata not in katas)
    if katas and not any(weights.get(kata, 1) for kata in katas):
        yield "--weight: all weights are 0, and so is every total"
