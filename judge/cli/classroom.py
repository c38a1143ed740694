"""Judging a class as a person has asked for it: what is read, said meanwhile, and shown in the end."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from contextlib import closing
from pathlib import Path
from typing import Any

import msgspec
from msgspec import Struct

from judge.batch.elsewhere import Elsewhere
from judge.batch.folder import ClassFolder, read_class
from judge.batch.model import Row, Standard, Student
from judge.batch.outcome import Outcome
from judge.batch.plan import Plan, current, planned
from judge.batch.roster import everyone, read_students
from judge.batch.shards import Shard, merged
from judge.batch.store import Store, store_of
from judge.batch.table import table_lines
from judge.batch.work import release
from judge.cli.class_views import Scene, Views, problems_of
from judge.cli.options import write_json
from judge.errors import UsageError
from judge.judging.executors import Executor
from judge.judging.job import RunOptions
from judge.judging.processes import Processes
from judge.report.live import Live
from judge.report.screen import note, out
from judge.report.values import counted

SCHEMA = 1
_NAMES = 5  # files that one sentence names
_NOTES = 5  # different notes of the workers that are said


class Wanted(Struct, frozen=True):
    """What a person has asked for.

    `again` are the names of students, problems or files to judge anew, `only` ids of problems, `folders`
    folders of problems. `parts` are the files of shards to put together; then nothing is judged. Links are
    followed wherever they lead with `follow`.
    """

    folder: Path
    options: RunOptions
    students: Path | None = None
    out: Path | None = None
    only: tuple[str, ...] = ()
    again: tuple[str, ...] = ()
    folders: tuple[Path, ...] = ()
    shard: Shard | None = None
    parts: tuple[Path, ...] = ()
    as_json: bool = False
    quiet: bool = False
    follow: bool = False

    @property
    def place(self) -> Path:
        """The file of results."""
        if self.out is not None:
            return self.out
        place = store_of(self.folder)
        return place if self.shard is None else self.shard.beside(place)


class Classroom:
    """One class that is being judged; `outcome` says how far it has come, at any time."""

    def __init__(self, wanted: Wanted, store: Store) -> None:
        """Raises UsageError where the folder or the list of students cannot be read."""
        self._wanted = wanted
        self._store = store
        self._listed = read_students(wanted.students) if wanted.students else []
        found = read_class(
            wanted.folder,
            only=wanted.only,
            folders=wanted.folders,
            students={each.id for each in self._listed},
            follow=wanted.follow,
        )
        shard = wanted.shard
        self._handins = [each for each in found.handins if shard is None or shard.holds(each)]
        self._students = everyone(self._listed, found.handins)
        self._by_id = {each.id: each for each in self._students}
        self._said: list[str] = []
        self._live = Live(silent=wanted.quiet)
        self._seen: set[str] = set()
        self._standards: Mapping[str, Standard] | None = None  # any, until it is known
        if shard is None or shard.number == 1:
            self.say(*_left_out(found))
        if not found.handins and not self._listed:
            remedy = "it holds STUDENT/PROBLEM.py or PROBLEM/STUDENT.py; see 'judge help class'"
            raise UsageError("nothing is handed in here", where=str(wanted.folder), remedy=remedy)

    def judge(self, executor: Executor) -> None:
        """Judge what is not judged yet; each row is kept before it is shown.

        Raises:
            JudgeError: nothing can be judged, or the results cannot be kept.
        """
        from judge.batch.run import ground_of, judged, learnt

        wanted = self._wanted
        self._check_again()
        ground = ground_of(
            (each.problem for each in self._handins if not each.why),
            wanted.options,
            wanted.folders,
            executor.level if isinstance(executor, Elsewhere) else "",
        )
        self._standards = ground.standards
        plan = planned(self._handins, self._store.every(), ground, wanted.again)
        short = [executor.short] if isinstance(executor, Processes) and executor.short else []
        self.say(*ground.said, *short, *plan.said)
        for row in plan.kept:
            self._show(row, kept=True)
        with self._live as live:
            for problem, done, total in learnt(plan, ground, wanted.options, executor):
                live.show(lambda p=problem, d=done, t=total: f"learning {p}, {d} of {t} problems")  # type: ignore[misc]
            pace = _Pace(plan)
            live.show(lambda: pace.text(0))
            with closing(judged(plan, self._store, executor)) as rows:
                for row in rows:
                    self._show(row)
                    pace.add(row)
                    live.show(lambda: pace.text(executor.alive()))
        release()

    def merge(self) -> None:
        """Take over the rows of the shards' files. Raises StoreError."""
        self.say(*merged(self._store, self._wanted.parts))
        for row in current(self._handins, self._store.every()).values():
            self._show(row, kept=True)

    def outcome(self) -> Outcome:
        """What it has come to."""
        rows = current(self._handins, self._store.every(), self._standards)
        problems = self._wanted.only or tuple(sorted({each.problem for each in self._handins}))
        students = self._students
        if self._wanted.shard is not None:
            here = {each.student for each in self._handins}
            students = [each for each in students if each.id in here]
        left = len(self._handins) - len(rows)
        return Outcome(tuple(students), tuple(problems), tuple(rows.values()), left)

    def close(self, *, interrupted: bool = False) -> Outcome:
        """Show the table, and say what is left; what it has come to."""
        found = self.outcome()
        if not self._wanted.as_json:
            screen = out()
            screen.show(table_lines(found, screen.width))
        more = len(self._seen) - _NOTES
        if more > 0:
            self.say(f"{counted(more, 'further note')} of the workers; --json has them all")
        if interrupted:
            self.say(f"{counted(found.left, 'file')} left; the same command goes on")
        elif self._wanted.parts and found.left:
            remedy = "the same command without --merge judges them"
            self.say(f"{counted(found.left, 'file')} in none of the files that were merged; {remedy}")
        return found

    def show_views(self, views: Views, found: Outcome) -> None:
        """After the table: the cohort, and the files that were asked for. Raises UsageError."""
        wanted = self._wanted
        screen = not (wanted.quiet or wanted.as_json or wanted.shard)
        if not (screen or views.any_file or (wanted.as_json and views.whole)):
            return
        problems = problems_of(found.problems, wanted.folders)
        history = self._store.every()
        scene = Scene(wanted.folder, wanted.place, found, self._handins, history, problems, wanted.options)
        told = views.show(scene, screen=screen)
        if wanted.as_json and views.whole:
            write_json({"schema": SCHEMA, "cohort": told})

    def _show(self, row: Row, *, kept: bool = False) -> None:
        if self._wanted.as_json:
            self._live.hide()
            write_json(as_json(row, self._by_id[row.student], kept=kept))
        for text in row.done.notes:
            if text not in self._seen:
                self._seen.add(text)
                if len(self._seen) <= _NOTES:
                    self.say(text)

    def say(self, *texts: str) -> None:
        """Say each text once, unless nothing is to be said."""
        for text in texts:
            if not self._wanted.quiet and text not in self._said:
                self._said.append(text)
                self._live.hide()
                note(text)

    def _check_again(self) -> None:
        """Raise UsageError where nothing is called like what is to be judged again."""
        known = {name for each in self._handins for name in (each.student, each.problem, each.file)}
        known |= set(self._by_id)
        for name in self._wanted.again:
            if name not in known:
                remedy = "name a student, a problem or a file, as the table does"
                raise UsageError(f"nothing here is called {name!r}", where="--again", remedy=remedy)


class _Pace:
    """How fast it goes, over what this run has judged itself."""

    def __init__(self, plan: Plan) -> None:
        self._total = plan.total
        self._kept = len(plan.kept)
        self._texts = len(plan.work)
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
            parts += [f"{rate:.1f} a second", f"{clock((self._texts - self._judged) / rate)} left"]
        return ", ".join([*parts, counted(workers, "worker")] if workers else parts)


def clock(seconds: float) -> str:
    """Seconds as `0:32`, `12:05` or `1:04:10`."""
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02}:{rest:02}" if hours else f"{minutes}:{rest:02}"


def as_json(row: Row, student: Student, *, kept: bool) -> dict[str, Any]:
    """The published object of a row; its keys and their order are fixed by the schema number."""
    done = row.done
    return {
        "schema": SCHEMA,
        "student": student.id,
        "name": student.name,
        "group": student.group,
        "listed": student.known,
        "problem": row.problem,
        "file": row.file,
        "verdict": row.verdict,
        "score": row.score,
        "points": row.points,
        "mistake": row.mistake or None,
        "copied": row.copied or None,
        "kept": kept,
        "machine": row.machine or None,
        "worker": done.worker or None,
        "isolation": row.isolation or None,
        "busy": done.busy or None,
        "cpu_seconds": done.seconds,
        "judged_at": row.at,
        "standard": msgspec.json.decode(row.standard) if row.standard else None,
        "notes": list(done.notes),
        "result": row.result.as_json(),
    }


def _left_out(found: ClassFolder) -> list[str]:
    """What in the folder is not judged: each reason with its files, once."""
    reasons: dict[str, list[str]] = {}
    for each in found.unplaced:
        reasons.setdefault(each.why, []).append(each.file)
    if found.others:
        reasons["no program by its name"] = list(found.others)
    return [f"not judged: {_some(files)}: {why}" for why, files in reasons.items()]


def _some(names: Sequence[str]) -> str:
    more = len(names) - _NAMES
    return ", ".join(names[:_NAMES]) + (f" and {more} more" if more > 0 else "")
