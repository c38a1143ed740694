"""What is to be done for a class: which rows are kept, which texts are judged, who gets a copy."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Collection, Iterable, Mapping, Sequence
from pathlib import PurePath

from msgspec import Struct
from msgspec.structs import replace

from judge.batch.model import Environment, KeptRow, Submission, Task, WorkerResult, text_of
from judge.judging.options import RunOptions
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


class Context(Struct, frozen=True):
    """By what a class is judged: the environment of each problem, or why one cannot be judged; the options,
    and the folders of problems.
    """

    environments: Mapping[str, Environment]
    faults: Mapping[str, str]
    options: RunOptions
    folders: tuple[str, ...] = ()


def planned(
    submissions: Sequence[Submission], every: Sequence[KeptRow], context: Context, again: Collection[str] = ()
) -> ClassPlan:
    """The plan for these submissions, given every row that there is, the oldest first.

    `again` are names of students, problems or files that are judged anew.
    """
    judged = [row for row in every if row.result.verdict is not Verdict.JE]
    known = {(text_of(row), row.standard): row for row in judged}
    equal = {(row.problem, row.digest, PurePath(row.file).suffix, row.standard): row for row in judged}
    newest = {(row.student, row.problem, row.file): row for row in every}
    kept, rows, back, changed = [], [], 0, Counter[str]()
    todo: dict[tuple[str, str, str, Environment], list[Submission]] = {}
    for each in submissions:
        if why := each.why or context.faults.get(each.problem, ""):
            rows.append(_row(each, WorkerResult.fault(each.problem, each.file, why)))
            continue
        own = context.environments[each.problem]
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
            todo.setdefault(same, []).append(each)
    work = [Work(_task(group[0], own, context), tuple(group)) for (*_, own), group in todo.items()]
    notices = [f"{counted(len(kept) + back, 'result')} kept from before"] if kept or back else []
    notices += [f"{count} judged anew, because of {parts}" for parts, count in changed.items() if parts]
    return ClassPlan(tuple(kept), tuple(rows), tuple(work), tuple(notices))


def _task(first: Submission, own: Environment, context: Context) -> Task:
    name = PurePath(first.file).name  # without folders: it need not know whose it is
    return Task(first.problem, name, first.source, context.options, own, context.folders)


def _copied(row: KeptRow, each: Submission) -> KeptRow:
    """The row of a submission whose equal was judged; a group's members have submitted one file."""
    copied = row.copied or row.file
    return _row(each, row.done, row.standard, copied if copied != each.file else "")


def _row(each: Submission, done: WorkerResult, own: Environment | None = None, copied: str = "") -> KeptRow:
    return KeptRow(*text_of(each), done, own, time.time(), copied)


def current(
    submissions: Iterable[Submission],
    every: Iterable[KeptRow],
    environments: Mapping[str, Environment] | None = None,
) -> dict[Submission, KeptRow]:
    """The newest row of each submission's present text, by its problem's environment where these are given;
    none where there is no row.
    """
    wanted = None if environments is None else {None, *environments.values()}
    rows = {text_of(row): row for row in every if wanted is None or row.standard in wanted}
    return {each: rows[text_of(each)] for each in submissions if text_of(each) in rows}
