"""Judging a class: what is missing is learnt once, every text is judged once, each row is kept at once."""

from __future__ import annotations

import time
from collections import Counter, defaultdict
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from contextlib import closing, suppress
from datetime import datetime
from functools import cached_property, partial
from math import ceil
from pathlib import Path, PurePath
from types import MappingProxyType
from typing import Any

import msgspec

from judge.batch.cohort import cohort_of, counting
from judge.batch.elsewhere import Elsewhere
from judge.batch.equal import equal_files
from judge.batch.folder import ClassFolder, read_class
from judge.batch.forms import Roster
from judge.batch.model import Done, Row, Standard, Task
from judge.batch.plan import Ground, Plan, current, planned, rows_of
from judge.batch.representatives import SmallestCases, representatives
from judge.batch.roster import everyone, read_students
from judge.batch.shards import Shard
from judge.batch.standard import level_here, standard_of
from judge.batch.store import Store
from judge.batch.work import judge_task, learn_task, release
from judge.data.load import is_kept as data_kept
from judge.errors import JudgeError, ProblemError, UsageError
from judge.judging.options import RunOptions
from judge.judging.pool import Executor, Processes
from judge.mistakes.known import is_kept
from judge.problem import Problem
from judge.problem.find import find_problem
from judge.report.published_klass import ClassRow, Cohort
from judge.report.wait import Live, progress
from judge.report.words import counted, shown_name
from judge.run.result import Result

_DAY = 86_400  # seconds
_NAMES = 5  # files that one sentence names
_NOTES = 5  # different notes of the workers that are said


class Classroom:
    """A class that is judged; `cohort` says how far it has come, at any time.

    Raises:
        UsageError: the folder or the list of students cannot be read, or nothing is submitted there.
    """

    def __init__(
        self,
        folder: Path,
        store: Store,
        *,
        students: Path | None = None,
        only: Sequence[str] = (),
        folders: Sequence[Path] = (),
        isolation: str | None = None,
        level: str | None = None,
        due: datetime | None = None,
        weights: Mapping[str, float] = MappingProxyType({}),
        shard: Shard | None = None,
        say: Callable[[str], None],
    ) -> None:
        """`only` are ids of katas, `folders` folders of katas; each sentence goes to `say` once."""
        self._store, self._folders, self._tell = store, folders, say
        self._options = RunOptions(isolation=isolation, diagnosed=False, level=level)  # no smallest case
        self._roster = read_students(students) if students else Roster()
        found = read_class(folder, only=only, folders=folders, roster=self._roster)
        self._found, self._due, self._weights = found, due, weights
        self._handins = [each for each in found.handins if shard is None or shard.holds(each)]
        unread = [each for each in found.unplaced if each.student]
        self.students = {each.id: each for each in everyone(self._roster, [*found.handins, *unread])}
        self._standards: dict[str, Standard] | None = None  # any, until it is known
        self._katas = sorted({each.problem for each in self._handins})
        self._expected = Counter(each.student for each in self._handins)
        self._own: defaultdict[str, list[Row]] = defaultdict(list)  # as they come
        self._said: set[str] = set()
        self._noted: set[str] = set()
        self._live = Live()
        if shard is None or shard.number == 1:
            self._say(*_left_out(found))
        if not found.handins and not self._roster.students:
            remedy = "it holds STUDENT/KATA.py or KATA/STUDENT.py; see 'judge help class'"
            raise UsageError("nothing is submitted here", where=str(folder), remedy=remedy)

    def judge(self, executor: Executor, again: Sequence[str] = ()) -> Iterator[ClassRow]:
        """Judge what is not judged yet; each row is kept before it is given, those of before come first.

        `again` are names of students, katas or files to judge anew.

        Raises:
            UsageError: nothing is called like one of `again`.
            JudgeError: nothing can be judged, or the results cannot be kept.
        """
        self._check_again(again)
        ground = self._ground(executor)
        self._standards = dict(ground.standards)
        plan = planned(self._handins, self._store.every(), ground, again)
        short = [executor.short] if isinstance(executor, Processes) and executor.short else []
        self._say(*ground.said, *short, *plan.said)
        for row in plan.kept:
            yield self._published(row, kept=True)
        with self._live as live:
            self._learn(plan, ground, executor)
            done, began = len(plan.kept), time.monotonic()
            with closing(self._judged(plan, executor)) as judged:
                for texts, rows in enumerate(judged):
                    live.hide()
                    for row in rows:
                        yield self._published(row)
                    done += len(rows)
                    live.show(partial(_pace, plan, done, texts, began, executor.alive()))
        release()
        if len(self._noted) > _NOTES:
            more = counted(len(self._noted) - _NOTES, "further note")
            self._say(f"{more} of the workers; --json has them all")

    def cohort(self) -> Cohort:
        """The class as it stands."""
        every = self._store.every()
        rows = current(self._handins, every, self._standards)
        return self._cohort(
            sorted({row.problem for row in rows.values()}),
            list(rows.values()),
            history=every,
            equal=equal_files(rows, self.problems),
            left=len(self._handins) - len(rows),
        )

    def is_done(self, student: str) -> bool:
        """Whether all that the student has submitted has been judged, or was before."""
        return len(self._own[student]) == self._expected[student]

    def alone(self, student: str) -> tuple[Cohort, dict[tuple[str, str], Result]]:
        """The class with nothing but what one student has submitted, who is done; and what their page shows
        of it, by kata and file, with smallest cases.
        """
        rows = self._own[student]
        handins = [each for each in self._handins if each.student == student]
        return self._cohort(self._katas, rows), self._smallest.of([*counting(rows).values()], handins)

    def _cohort(self, katas: Sequence[str], rows: Sequence[Row], **more: Any) -> Cohort:
        return cohort_of(
            tuple(self.students.values()),
            katas,
            rows,
            titles=self._roster.titles,
            unread=_unread(self._found),
            late=self._late,
            weights=self._weights,
            **more,
        )

    @cached_property
    def _late(self) -> dict[tuple[str, str], int | None]:
        """By how many days each student's file is late, less what the list grants; None where a platform
        says so.
        """
        if self._due is None:
            late = self._found.late
            return {(each.student, each.file): None for each in self._handins if each.student in late}
        due, extra = self._due.timestamp(), {who: each.extra_days for who, each in self.students.items()}
        return {
            (each.student, each.file): max(0, ceil((each.at - due) / _DAY - extra[each.student]))
            for each in self._handins
        }

    @cached_property
    def problems(self) -> dict[str, Problem]:
        """The katas of the class that can be read, by id."""
        found = {}
        for name in self._katas:
            with suppress(JudgeError):  # which the table says
                found[name] = find_problem(name, self._folders)
        return found

    def results(self, cohort: Cohort) -> dict[tuple[str, str], Result]:
        """What the page of the class shows, by kata and file: one file of each mistake."""
        rows = current(self._handins, self._store.every(), self._standards).values()
        return self._smallest.of(representatives(cohort, rows), self._handins)

    @cached_property
    def _smallest(self) -> SmallestCases:
        return SmallestCases(self.problems, self._options, progress, self._store.keep_all)

    def _ground(self, executor: Executor) -> Ground:
        """By what the class is judged; workers elsewhere have an isolation, and find the katas themselves.

        Raises:
            UsageError: the isolation that is demanded cannot be had.
            JudgeError: nothing can be judged here.
        """
        problems: dict[str, Problem] = {}
        faults: dict[str, str] = {}
        for each in dict.fromkeys(each.problem for each in self._handins if not each.why):
            try:
                problem = find_problem(each, self._folders)
                self._options.chosen(problem)
                problems[each] = problem
            except (ProblemError, UsageError) as fault:
                faults[each] = str(fault)
        level, said, folders = "", tuple[str, ...](), tuple[str, ...]()
        if isinstance(executor, Elsewhere):
            level = executor.level
        elif problems:
            level, said = level_here(next(iter(problems.values())), self._options)
            folders = tuple(str(folder.absolute()) for folder in self._folders)
        standards = {each: standard_of(problem, self._options, level) for each, problem in problems.items()}
        return Ground(problems, standards, faults, self._options, folders, said)

    def _learn(self, plan: Plan, ground: Ground, executor: Executor) -> None:
        """Build the data, and find what known mistakes answer, of each kata where that is not there yet; so
        that no two workers do it; elsewhere on each machine. What cannot be learnt is told with each row.
        """
        firsts: dict[str, Task] = {}
        for work in plan.work:
            firsts.setdefault(work.task.problem, work.task)
        if isinstance(executor, Elsewhere):
            tasks = list(firsts.values())
            total, spread = len(tasks) * len(executor.machines()), executor.everywhere
        else:
            tasks = [task for each, task in firsts.items() if not self._is_learnt(ground.problems[each])]
            total, spread = len(tasks), executor.run
        if not tasks:
            return
        self._live.show(partial(_learning, tasks[0], 0, total))
        with closing(spread(learn_task, tasks, lambda _task, why: why)) as outcomes:
            for done, (place, _) in enumerate(outcomes, 1):
                self._live.show(partial(_learning, tasks[place], done, total))

    def _is_learnt(self, problem: Problem) -> bool:
        try:
            return data_kept(problem, None) and is_kept(problem, None)
        except JudgeError:  # whoever judges says so
            return True

    def _judged(self, plan: Plan, executor: Executor) -> Generator[Sequence[Row], None, None]:
        """The rows that are new without judging, then those of each text, when they are kept.

        Close it, so that the work ends.

        Raises:
            UsageError: a worker does not judge by the standard that is asked for.
            StoreError: a row cannot be kept.
        """
        self._store.keep_all(plan.rows)
        yield plan.rows
        outcomes = executor.run(judge_task, [work.task for work in plan.work], _lost)
        with closing(outcomes):
            for place, done in outcomes:
                rows = rows_of(plan.work[place], done)
                self._store.keep_all(rows)
                yield rows

    def _published(self, row: Row, *, kept: bool = False) -> ClassRow:
        """The row as it goes out; new notes of its worker are said."""
        done, student, result = row.done, self.students[row.student], row.result
        self._own[student.id].append(row)
        for text in result.notes:
            if text not in self._noted and len(self._noted) < _NOTES:
                self._say(text)
            self._noted.add(text)
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
        known = {name for each in self._handins for name in (each.student, each.problem, each.file)}
        for name in again:
            if name not in known | set(self.students):
                remedy = "name a student, a kata or a file, as the table does"
                raise UsageError(f"nothing here is called {name!r}", where="--again", remedy=remedy)


def _lost(task: Task, why: str) -> Done:
    return Done.fault(task.problem, task.name, why)


def _learning(task: Task, done: int, total: int) -> str:
    return f"learning {task.problem}, {done} of {total} katas"


def _pace(plan: Plan, done: int, texts: int, began: float, workers: int) -> str:
    """How far it is and how fast it goes, in one line: so many rows are there, and `texts` were judged."""
    equal = done - len(plan.kept) - texts
    said = f"{done} of {counted(plan.total, 'file')}" + (
        f", {equal} of them equal to others" if equal > 0 else ""
    )
    parts = [counted(workers, "worker")] if workers else []
    if texts:
        rate = texts / max(time.monotonic() - began, 1e-9)
        minutes, seconds = divmod(round((len(plan.work) - texts) / rate), 60)
        parts = [f"{rate:.2g} a second", f"about {minutes}:{seconds:02} left", *parts]
    return "; ".join(filter(None, [said, ", ".join(parts)]))


def _left_out(found: ClassFolder) -> list[str]:
    """What in the folder is not judged: each reason with its files, once."""
    reasons: dict[str, dict[str, None]] = {}
    for each in found.unplaced:
        reasons.setdefault(each.why, {})[each.file] = None
    return [f"not judged: {_some([*files])}: {why}" for why, files in reasons.items()]


def _unread(found: ClassFolder) -> dict[str, list[str]]:
    """What of each student is not judged, with the reason, but for what is no program at all."""
    told: dict[str, list[str]] = {}
    for each in found.unplaced:
        if each.student and each.why:
            told.setdefault(each.student, []).append(f"{PurePath(each.file).name}: {each.why}")
    return told


def _some(names: Sequence[str]) -> str:
    more = len(names) - _NAMES
    return ", ".join(map(shown_name, names[:_NAMES])) + (f" and {more} more" if more > 0 else "")
