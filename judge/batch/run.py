"""Judging a class: what is missing is learnt once, every text is judged once, each row is kept at once."""

from __future__ import annotations

import time
from collections.abc import Callable, Generator, Iterable, Iterator, Sequence
from contextlib import closing, suppress
from pathlib import Path

import msgspec

from judge.batch.cohort import cohort_of, counting
from judge.batch.elsewhere import Elsewhere
from judge.batch.equal import equal_files
from judge.batch.folder import ClassFolder, read_class
from judge.batch.model import Row, Standard
from judge.batch.plan import Ground, Plan, current, planned, rows_of
from judge.batch.representatives import representatives, smallest_cases
from judge.batch.roster import everyone, read_students
from judge.batch.shards import Shard
from judge.batch.standard import level_here, standard_of
from judge.batch.store import Store
from judge.batch.work import fault_done, judge_task, learn_task, release
from judge.data.load import is_kept as data_kept
from judge.errors import JudgeError, ProblemError, UsageError
from judge.judging.api import RunOptions
from judge.judging.pool import Executor, Processes
from judge.mistakes.known import is_kept
from judge.problem import Problem
from judge.problem.find import find_problem
from judge.report.published_klass import ClassRow, Cohort
from judge.report.views import copied
from judge.report.wait import Live, progress
from judge.report.words import counted
from judge.run.result import Result

_NAMES = 5  # files that one sentence names
_NOTES = 5  # different notes of the workers that are said


def class_options(isolation: str | None, level: str | None) -> RunOptions:
    """How each file of a class is judged: the mistake named, no smallest case."""
    return RunOptions((), None, isolation, diagnosed=False, level=level)


class Classroom:
    """A class that is judged; `cohort` says how far it has come, at any time.

    Attributes:
        left: how many files have no row.

    Raises:
        UsageError: the folder or the list of students cannot be read, or nothing is submitted there.
    """

    def __init__(
        self,
        folder: Path,
        store: Store,
        options: RunOptions,
        *,
        students: Path | None = None,
        only: Sequence[str] = (),
        folders: Sequence[Path] = (),
        shard: Shard | None = None,
        say: Callable[[str], None] = lambda _: None,
    ) -> None:
        """`only` are ids of katas, `folders` folders of katas; each sentence goes to `say` once."""
        self._store, self._options, self._folders, self._tell = store, options, folders, say
        listed = read_students(students) if students else []
        found = read_class(folder, only=only, folders=folders, students={each.id for each in listed})
        self._handins = [each for each in found.handins if shard is None or shard.holds(each)]
        self._students = {each.id: each for each in everyone(listed, found.handins)}
        self._standards: dict[str, Standard] | None = None  # any, until it is known
        self._said: set[str] = set()
        self._noted: set[str] = set()
        self._live = Live()
        if shard is None or shard.number == 1:
            self._say(*_left_out(found))
        if not found.handins and not listed:
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
        ground = ground_of(
            (each.problem for each in self._handins if not each.why),
            self._options,
            self._folders,
            executor.level if isinstance(executor, Elsewhere) else "",
        )
        self._standards = dict(ground.standards)
        plan = planned(self._handins, self._store.every(), ground, again)
        short = [executor.short] if isinstance(executor, Processes) and executor.short else []
        self._say(*ground.said, *short, *plan.said)
        for row in plan.kept:
            yield self._published(row, kept=True)
        with self._live as live:
            for problem, done, total in learnt(plan, ground, self._options, executor):
                live.show(lambda p=problem, d=done, t=total: f"learning {p}, {d} of {t} katas")  # type: ignore[misc]
            pace = _Pace(plan)
            live.show(lambda: pace.text(0))
            with closing(judged(plan, self._store, executor)) as rows:
                for row in rows:
                    self._live.hide()
                    yield self._published(row)
                    pace.add(row)
                    live.show(lambda: pace.text(executor.alive()))
        release()
        if len(self._noted) > _NOTES:
            more = counted(len(self._noted) - _NOTES, "further note")
            self._say(f"{more} of the workers; --json has them all")

    @property
    def left(self) -> int:
        """How many files have no row."""
        return len(self._handins) - len(self._rows())

    def cohort(self) -> Cohort:
        """The class as it stands."""
        rows, every = self._rows(), self._store.every()
        problems = tuple(sorted({each.problem for each in self._handins}))
        present = {(row.problem, row.file) for row in rows}
        handins = [each for each in self._handins if (each.problem, each.file) in present]
        equal = equal_files(handins, self.problems())
        left = len(self._handins) - len(rows)
        return cohort_of(
            tuple(self._students.values()), problems, rows, history=every, equal=equal, left=left
        )

    def problems(self) -> dict[str, Problem]:
        """The katas of the class that can be read, by id."""
        found = {}
        for name in sorted({each.problem for each in self._handins}):
            with suppress(JudgeError):  # which the table says
                found[name] = find_problem(name, self._folders)
        return found

    def results(self, cohort: Cohort, *, everybody: bool) -> dict[tuple[str, str], Result]:
        """What pages show, by kata and file, with smallest cases: one file a mistake, or all that count."""
        rows = self._rows()
        shown = list(counting(rows).values()) if everybody else representatives(cohort, rows)
        return smallest_cases(shown, self._handins, self.problems(), self._options, progress)

    def _rows(self) -> list[Row]:
        return list(current(self._handins, self._store.every(), self._standards).values())

    def _published(self, row: Row, *, kept: bool = False) -> ClassRow:
        """The row as it goes out; new notes of its worker are said."""
        done, student = row.done, self._students[row.student]
        for text in done.notes:
            if text not in self._noted and len(self._noted) < _NOTES:
                self._say(text)
            self._noted.add(text)
        return copied(
            ClassRow,
            row,
            student=student.id,
            name=student.name,
            group=student.group,
            listed=student.known,
            mistake=row.mistake or None,
            copied=row.copied or None,
            kept=kept,
            machine=row.machine or None,
            worker=done.worker or None,
            isolation=row.isolation or None,
            busy=done.busy or None,
            cpu_seconds=done.seconds,
            judged_at=row.at,
            standard=msgspec.json.decode(row.standard) if row.standard else None,
            notes=done.notes,
            result=row.result.as_json(),
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
            if name not in known | set(self._students):
                remedy = "name a student, a kata or a file, as the table does"
                raise UsageError(f"nothing here is called {name!r}", where="--again", remedy=remedy)


class _Pace:
    """How fast it goes, over what this run has judged itself."""

    def __init__(self, plan: Plan) -> None:
        self._total, self._kept, self._texts = plan.total, len(plan.kept), len(plan.work)
        self._new = len(plan.rows)  # which take no time
        self._judged = 0
        self._began = time.monotonic()

    def add(self, row: Row) -> None:
        """One more row is kept."""
        self._kept += 1
        if self._new:
            self._new -= 1
        elif not row.copied:
            self._judged += 1

    def text(self, workers: int) -> str:
        """How far it is, in one line."""
        parts = [f"{self._kept} of {self._total}"]
        if self._judged:
            rate = self._judged / max(time.monotonic() - self._began, 1e-9)
            minutes, seconds = divmod(round((self._texts - self._judged) / rate), 60)
            parts += [f"{rate:.1f} a second", f"{minutes}:{seconds:02} left"]
        return ", ".join([*parts, counted(workers, "worker")] if workers else parts)


def _left_out(found: ClassFolder) -> list[str]:
    """What in the folder is not judged: each reason with its files, once."""
    reasons: dict[str, list[str]] = {}
    for each in found.unplaced:
        reasons.setdefault(each.why, []).append(each.file)
    if found.others:
        reasons["not a program, by its name"] = list(found.others)
    return [f"not judged: {_some(files)}: {why}" for why, files in reasons.items()]


def _some(names: Sequence[str]) -> str:
    more = len(names) - _NAMES
    return ", ".join(names[:_NAMES]) + (f" and {more} more" if more > 0 else "")


def ground_of(ids: Iterable[str], options: RunOptions, folders: Sequence[Path], level: str = "") -> Ground:
    """By what these problems are judged; at `level` by workers elsewhere, which find the problems themselves.

    Raises:
        UsageError: the isolation that is demanded cannot be had.
        JudgeError: nothing can be judged here.
    """
    problems: dict[str, Problem] = {}
    faults: dict[str, str] = {}
    for each in dict.fromkeys(ids):
        try:
            problem = find_problem(each, folders)
            options.chosen(problem)
            problems[each] = problem
        except (ProblemError, UsageError) as fault:
            faults[each] = str(fault)
    standards: dict[str, Standard] = {}
    said: tuple[str, ...] = ()
    if problems:
        if not level:
            level, said = level_here(next(iter(problems.values())), options)
        else:
            folders = ()
        standards = {each: standard_of(problem, options, level) for each, problem in problems.items()}
    plain = msgspec.json.encode(options).decode()
    places = tuple(str(folder.absolute()) for folder in folders)
    return Ground(problems, standards, faults, plain, places, said)


def learnt(
    plan: Plan, ground: Ground, options: RunOptions, executor: Executor
) -> Iterator[tuple[str, int, int]]:
    """Build the data, and find what known mistakes answer, of each problem where that is not there yet; so
    that no two workers do it; elsewhere on each machine. Gives a problem before it is looked at, and how many
    of how many are done.
    """
    first = {work.task.problem: work for work in reversed(plan.work)}
    elsewhere = executor if isinstance(executor, Elsewhere) else None
    unknown = [each for each in sorted(first) if elsewhere or not _is_learnt(ground.problems[each], options)]
    missing = [first[each].task for each in unknown]
    if not missing:
        return
    total = len(missing) * (len(elsewhere.machines()) if elsewhere else 1)
    yield missing[0].problem, 0, total
    spread = elsewhere.everywhere if elsewhere else executor.run
    outcomes = spread(learn_task, missing, lambda _task, why: why)
    with closing(outcomes):  # what cannot be learnt is told with each row
        for done, (place, _) in enumerate(outcomes, 1):
            yield missing[place].problem, done, total


def judged(plan: Plan, store: Store, executor: Executor) -> Generator[Row, None, None]:
    """The rows that are new, each when it is kept; close it, so that the work ends.

    Raises:
        UsageError: a worker does not judge by the standard that is asked for.
        StoreError: a row cannot be kept.
    """
    store.keep_all(plan.rows)
    yield from plan.rows
    tasks = [work.task for work in plan.work]
    outcomes = executor.run(judge_task, tasks, fault_done)
    with closing(outcomes):
        for place, text in outcomes:
            rows = rows_of(plan.work[place], text)
            store.keep_all(rows)
            yield from rows


def _is_learnt(problem: Problem, options: RunOptions) -> bool:
    try:
        there = data_kept(problem, options.seed)
        return there and (not options.named or is_kept(problem, options.seed))
    except JudgeError:  # whoever judges says so
        return True
