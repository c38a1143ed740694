"""What is to be done for a class: which rows are kept, which texts are judged, who gets a copy."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Collection, Container, Iterable, Mapping, Sequence
from pathlib import PurePath

from msgspec import Struct
from msgspec.structs import replace

from judge.batch.model import Environment, KeptRow, Submission, Task, WorkerResult, text_of
from judge.problem import Verdict
from judge.report.words import counted


class Work(Struct, frozen=True):
    """One text to judge, for the first of the `submissions`; the others get a copy."""

    task: Task
    submissions: tuple[Submission, ...]

    def rows(self, done: WorkerResult) -> list[KeptRow]:
        """The rows that come of it."""
        own, *others = self.submissions
        first = _row(own, done, self.task.environment)
        return [first, *(_copied(first, each) for each in others)]


class ClassPlan(Struct, frozen=True):
    """What is there and what is to be done; `notices` are sentences for the person.

    `kept` are rows that need nothing, `rows` those that are new without judging: copies of kept ones, files
    that cannot be read, problems that cannot be judged.
    """

    kept: tuple[KeptRow, ...]
    rows: tuple[KeptRow, ...]
    work: tuple[Work, ...]
    notices: tuple[str, ...]

    @property
    def total(self) -> int:
        """How many rows there are in the end."""
        return len(self.kept) + len(self.rows) + sum(len(work.submissions) for work in self.work)


def planned(
    submissions: Sequence[Submission],
    every: Sequence[KeptRow],
    kinds: Mapping[str, Task | str],
    again: Collection[str] = (),
) -> ClassPlan:
    """The plan for these submissions, given every row that there is, the oldest first.

    `kinds` are by problem its task, still without a file, or why it cannot be judged; `again` are names of
    students, problems or files that are judged anew.
    """
    judged = [row for row in every if row.result.verdict is not Verdict.JE]
    known = {(text_of(row), row.standard): row for row in judged}
    equal = {(row.problem, row.digest, PurePath(row.file).suffix, row.standard): row for row in judged}
    newest = {(row.student, row.problem, row.file): row for row in every}
    kept, rows, back, changed = [], [], 0, Counter[str]()
    todo: dict[tuple[str, str, str, Environment], tuple[Task, list[Submission]]] = {}
    for each in submissions:
        kind = each.why or kinds[each.problem]
        if isinstance(kind, str):
            rows.append(_row(each, WorkerResult.fault(each.problem, each.file, kind)))
            continue
        own = kind.environment
        place = each.student, each.problem, each.file
        old, before = known.get((text_of(each), own)), newest.get(place)
        anew = not {*place}.isdisjoint(again)
        if old is not None and not anew:
            if before is old:
                kept.append(old)
            else:  # this text was here before another one: it is the newest again
                rows.append(replace(old, at=time.time()))
                back += 1
            continue
        if before is not None and before.digest == each.digest:
            changed[own.changes(before.standard)] += 1
        same = each.problem, each.digest, PurePath(each.file).suffix, own
        if same in equal and not anew:
            rows.append(_copied(equal[same], each))
        else:
            name = PurePath(each.file).name  # without folders: a worker need not know whose it is
            todo.setdefault(same, (replace(kind, name=name, source=each.source), []))[1].append(each)
    work = [Work(task, tuple(group)) for task, group in todo.values()]
    notices = [f"{counted(len(kept) + back, 'result')} kept from before"] if kept or back else []
    notices += [f"{count} judged anew, because of {parts}" for parts, count in changed.items() if parts]
    return ClassPlan(tuple(kept), tuple(rows), tuple(work), tuple(notices))


def _copied(row: KeptRow, each: Submission) -> KeptRow:
    """The row of a submission whose equal was judged; a group's members have submitted one file."""
    copied = row.copied or row.file
    return _row(each, row.done, row.standard, copied if copied != each.file else "")


def _row(each: Submission, done: WorkerResult, own: Environment | None = None, copied: str = "") -> KeptRow:
    return KeptRow(*text_of(each), done, own, time.time(), copied)


def current(
    submissions: Iterable[Submission],
    every: Iterable[KeptRow],
    environments: Container[Environment | None] | None = None,
) -> dict[Submission, KeptRow]:
    """The newest row of each submission's present text, by one of the environments where these are given;
    none where there is no row.
    """
    rows = {text_of(row): row for row in every if environments is None or row.standard in environments}
    return {each: rows[text_of(each)] for each in submissions if text_of(each) in rows}
