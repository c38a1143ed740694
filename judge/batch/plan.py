"""What is to be done for a class's hand-ins: which rows are kept, which texts are judged, who gets a copy."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Collection, Iterable, Mapping, Sequence
from pathlib import PurePath

import msgspec
from msgspec import Struct
from msgspec.structs import replace

from judge.batch.model import Done, Handin, Row, Standard, Task
from judge.batch.standard import differing
from judge.cache import digest
from judge.problem import Problem, Verdict
from judge.problem.model import FULL_SCORE
from judge.report.words import counted
from judge.run.result import judge_fault, read_result


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
    terms, as JSON; and the folders of problems. `said` is what is to be said of the isolation.
    """

    problems: Mapping[str, Problem]
    standards: Mapping[str, Standard]
    faults: Mapping[str, str]
    terms: str
    folders: tuple[str, ...]
    said: tuple[str, ...] = ()


def planned(
    handins: Sequence[Handin], every: Sequence[Row], ground: Ground, again: Collection[str] = ()
) -> Plan:
    """The plan for these hand-ins, given every row that there is, the oldest first.

    `again` are names of students, problems or files that are judged anew.
    """
    by_key = {row.key: row for row in every}
    newest = {(row.student, row.problem, row.file): row for row in every}
    judged = {_same(row): row for row in every if row.verdict != Verdict.JE.value}
    kept, rows, back, changed = [], [], 0, Counter[str]()
    todo: dict[tuple[str, ...], list[Handin]] = {}
    for each in handins:
        why = each.why or ground.faults.get(each.problem, "")
        if why:
            rows.append(_row(each, "", _fault(each, why)))
            continue
        standard = _plain(ground.standards[each.problem])
        place = each.student, each.problem, each.file
        old, before = by_key.get(key_of(each, standard)), newest.get(place)
        anew = not {each.student, each.problem, each.file}.isdisjoint(again)
        if old is not None and old.verdict != Verdict.JE.value and not anew:
            if before is old:
                kept.append(old)
            else:  # this text was here before another one: it is the newest again
                rows.append(replace(old, at=time.time()))
                back += 1
            continue
        if old is None and before is not None and before.digest == each.digest:
            changed[_change(before, ground.standards[each.problem])] += 1
        same = (each.problem, each.digest, PurePath(each.file).suffix, standard)
        if same in judged and not anew:
            rows.append(copied(judged[same], each, standard))
        else:
            todo.setdefault(same, []).append(each)
    works = [_work(same[0], same[3], group, ground) for same, group in todo.items()]
    works.sort(key=lambda work: (work.task.problem, work.handins[0].file))  # a worker stays at a problem
    return Plan(tuple(kept), tuple(rows), tuple(works), tuple(_said(len(kept) + back, changed)))


def _work(problem: str, standard: str, handins: Sequence[Handin], ground: Ground) -> Work:
    first = handins[0]  # by its name without folders: it need not know whose it is
    task = Task(problem, PurePath(first.file).name, first.source, ground.terms, standard, ground.folders)
    return Work(task, tuple(handins))


def rows_of(work: Work, text: str) -> list[Row]:
    """The rows that come of a text that was judged: `text` is a `Done`, as JSON."""
    own, *others = work.handins
    first = _row(own, work.task.standard, _named(msgspec.json.decode(text, type=Done), own))
    return [first, *(copied(first, each, work.task.standard) for each in others)]


def copied(row: Row, handin: Handin, standard: str) -> Row:
    """The row of a hand-in whose equal was judged."""
    found = _row(handin, standard, _named(row.done, handin))
    return replace(found, copied=row.copied or row.file)


def key_of(handin: Handin, standard: str) -> str:
    """The digest of the hand-in and its standard."""
    parts = (handin.student, handin.problem, handin.file, handin.digest, standard)
    return digest("\0".join(parts).encode())


def current(
    handins: Iterable[Handin], every: Iterable[Row], standards: Mapping[str, Standard] | None = None
) -> dict[Handin, Row]:
    """The newest row of each hand-in's present text, by its problem's standard where these are given; none
    where there is no row.
    """
    wanted = None if standards is None else {"", *map(_plain, standards.values())}
    fitting = (row for row in every if wanted is None or row.standard in wanted)
    rows = {(row.student, row.problem, row.file, row.digest): row for row in fitting}
    found = ((each, rows.get((each.student, each.problem, each.file, each.digest))) for each in handins)
    return {each: row for each, row in found if row is not None}


def _named(done: Done, handin: Handin) -> str:
    """The same as JSON, with the hand-in's path for the submission's name."""
    return msgspec.json.encode(replace(done, result={**done.result, "submission": handin.file})).decode()


def _same(row: Row) -> tuple[str, ...]:
    return row.problem, row.digest, PurePath(row.file).suffix, row.standard


def _row(handin: Handin, standard: str, text: str) -> Row:
    done = msgspec.json.decode(text, type=Done)
    result = read_result(done.result)
    return Row(
        key_of(handin, standard),
        handin.student,
        handin.problem,
        handin.file,
        handin.digest,
        result.verdict.value,
        result.score,
        done.points or FULL_SCORE,
        result.pitfall.name if result.pitfall else "",
        done.machine,
        "" if result.verdict is Verdict.JE else result.isolation,
        time.time(),
        "",
        text,
        standard,
    )


def _fault(handin: Handin, why: str) -> str:
    result = judge_fault(handin.problem, handin.file, why).as_json()
    return msgspec.json.encode(Done(result)).decode()


def _plain(standard: Standard) -> str:
    return msgspec.json.encode(standard).decode()


def _change(before: Row, standard: Standard) -> str:
    """What is another now than when a row was judged."""
    if not before.standard:
        return ""
    return differing(msgspec.json.decode(before.standard, type=Standard), standard)


def _said(kept: int, changed: Counter[str]) -> list[str]:
    said = [f"{counted(kept, 'result')} kept from before"] if kept else []
    for parts, count in changed.items():
        if parts:
            said.append(f"{count} judged anew, because of {parts}")
    return said
