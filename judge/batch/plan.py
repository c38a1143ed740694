"""What is to be done for a class's hand-ins: which rows are kept, which texts are judged, who gets a copy."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Collection, Iterable, Mapping, Sequence
from pathlib import PurePath

from msgspec import Struct
from msgspec.structs import replace

from judge.batch.model import Done, Handin, Row, Standard, Task, text_of
from judge.batch.standard import differing
from judge.judging.options import RunOptions
from judge.problem import Problem, Verdict
from judge.report.words import counted


class Work(Struct, frozen=True):
    """One text to judge; the first of `handins` is the one that it is judged for, the others get a copy."""

    task: Task
    handins: tuple[Handin, ...]


class Plan(Struct, frozen=True):
    """What is there and what is to be done; `said` are sentences for the person.

    `kept` are rows that need nothing, `rows` those that are new without judging: copies of kept ones, files
    that cannot be read, problems that cannot be judged.
    """

    kept: tuple[Row, ...]
    rows: tuple[Row, ...]
    work: tuple[Work, ...]
    said: tuple[str, ...]

    @property
    def total(self) -> int:
        """How many rows there are in the end."""
        return len(self.kept) + len(self.rows) + sum(len(work.handins) for work in self.work)


class Ground(Struct, frozen=True):
    """By what a class is judged: its problems and the standard of each, or why one cannot be judged; the
    options, and the folders of problems. `said` is what is to be said of the isolation.
    """

    problems: Mapping[str, Problem]
    standards: Mapping[str, Standard]
    faults: Mapping[str, str]
    options: RunOptions
    folders: tuple[str, ...] = ()
    said: tuple[str, ...] = ()


def planned(
    handins: Sequence[Handin], every: Sequence[Row], ground: Ground, again: Collection[str] = ()
) -> Plan:
    """The plan for these hand-ins, given every row that there is, the oldest first.

    `again` are names of students, problems or files that are judged anew.
    """
    judged = [row for row in every if row.result.verdict is not Verdict.JE]
    tried = {(text_of(row), row.standard) for row in every}
    known = {(text_of(row), row.standard): row for row in judged}
    equal = {(row.problem, row.digest, PurePath(row.file).suffix, row.standard): row for row in judged}
    newest = {(row.student, row.problem, row.file): row for row in every}
    kept, rows, back, changed = [], [], 0, Counter[str]()
    todo: dict[tuple[str, str, str, Standard], list[Handin]] = {}
    for each in handins:
        if why := each.why or ground.faults.get(each.problem, ""):
            rows.append(_row(each, Done.fault(each.problem, each.file, why)))
            continue
        standard = ground.standards[each.problem]
        place = each.student, each.problem, each.file
        old, before = known.get((text_of(each), standard)), newest.get(place)
        anew = not {*place}.isdisjoint(again)
        if old is not None and not anew:
            if before is old:
                kept.append(old)
            else:  # this text was here before another one: it is the newest again
                rows.append(replace(old, at=time.time()))
                back += 1
            continue
        if before is not None and before.digest == each.digest and (text_of(each), standard) not in tried:
            changed[differing(before.standard, standard)] += 1
        same = each.problem, each.digest, PurePath(each.file).suffix, standard
        if same in equal and not anew:
            rows.append(_copied(equal[same], each))
        else:
            todo.setdefault(same, []).append(each)
    work = [_work(group, standard, ground) for (*_, standard), group in todo.items()]
    said = [f"{counted(len(kept) + back, 'result')} kept from before"] if kept or back else []
    said += [f"{count} judged anew, because of {parts}" for parts, count in changed.items() if parts]
    return Plan(tuple(kept), tuple(rows), tuple(work), tuple(said))


def _work(handins: Sequence[Handin], standard: Standard, ground: Ground) -> Work:
    first = handins[0]
    name = PurePath(first.file).name  # without folders: it need not know whose it is
    task = Task(first.problem, name, first.source, ground.options, standard, ground.folders)
    return Work(task, tuple(handins))


def rows_of(work: Work, done: Done) -> list[Row]:
    """The rows that come of a text that was judged."""
    own, *others = work.handins
    first = _row(own, done, work.task.standard)
    return [first, *(_copied(first, each) for each in others)]


def _copied(row: Row, handin: Handin) -> Row:
    """The row of a hand-in whose equal was judged; a group's members have submitted one file."""
    copied = row.copied or row.file
    return _row(handin, row.done, row.standard, copied if copied != handin.file else "")


def _row(handin: Handin, done: Done, standard: Standard | None = None, copied: str = "") -> Row:
    return Row(*text_of(handin), done, standard, time.time(), copied)


def current(
    handins: Iterable[Handin], every: Iterable[Row], standards: Mapping[str, Standard] | None = None
) -> dict[Handin, Row]:
    """The newest row of each hand-in's present text, by its problem's standard where these are given; none
    where there is no row.
    """
    wanted = None if standards is None else {None, *standards.values()}
    rows = {text_of(row): row for row in every if wanted is None or row.standard in wanted}
    found = ((each, rows.get(text_of(each))) for each in handins)
    return {each: row for each, row in found if row is not None}
