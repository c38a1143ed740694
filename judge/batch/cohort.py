"""From the rows of a batch to what a class is shown: which mistakes, who is stuck, what few pass."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterable, Mapping, Sequence

from judge.batch.model import Row
from judge.batch.outcome import Outcome, counting
from judge.problem.model import Verdict
from judge.report.cohort import (
    Cohort,
    Counted,
    EqualFiles,
    GroupBar,
    Machine,
    MistakeBar,
    Person,
    ProblemView,
    Stuck,
)
from judge.run.result import Result

_Pair = tuple[str, str]  # a student and a problem


def cohort_of(outcome: Outcome, history: Iterable[Row] = (), equal: Sequence[EqualFiles] = ()) -> Cohort:
    """The class as it stands: who and what is in the table, in its order.

    `history` are rows of texts that were handed in before and have been replaced since; they tell who is
    stuck and nothing else. `equal` are the sets of equal files.
    """
    counts = counting(outcome.rows)
    handins = Counter((row.student, row.problem) for row in outcome.rows)
    marks = {pair: _mark(row, handins[pair]) for pair, row in counts.items()}
    handed_in = {student for student, _ in counts}
    solved = {student for (student, _), mark in marks.items() if mark.accepted}
    order = [each.id for each in outcome.students]
    met = {problem for _, problem in counts}
    problems = tuple(each for each in outcome.problems if each in met)
    return Cohort(
        people=tuple(Person(each.id, each.name, each.group, each.known) for each in outcome.students),
        problems=problems,
        marks=marks,
        views=tuple(_view(each, counts, order) for each in problems),
        stuck=tuple(_stuck(problems, _in_turn([*history, *outcome.rows]), order)),
        unaccepted=tuple(each for each in order if each in handed_in - solved),
        silent=tuple(each for each in order if each not in handed_in),
        machines=_machines(outcome.rows),
        equal=tuple(equal),
    )


def _in_turn(rows: Iterable[Row]) -> dict[_Pair, list[Row]]:
    """Every text that a student has handed in to a problem, the oldest first, by its newest row."""
    newest = {(row.student, row.problem, row.file, row.digest): row for row in rows}
    found: dict[_Pair, list[Row]] = defaultdict(list)
    for row in sorted(newest.values(), key=lambda row: (row.at, row.file)):
        found[row.student, row.problem].append(row)
    return found


def _mark(row: Row, handins: int) -> Counted:
    return Counted(
        file=row.file,
        verdict=Verdict(row.verdict),
        score=row.score,
        points=row.points,
        mistake=row.mistake,
        handins=handins,
    )


def _view(problem: str, counting: Mapping[_Pair, Row], order: Sequence[str]) -> ProblemView:
    rows = {student: counting[student, problem] for student in order if (student, problem) in counting}
    made: dict[tuple[bool, str], list[str]] = defaultdict(list)
    for student, row in rows.items():
        if not row.accepted:
            made[bool(row.mistake), row.mistake or row.verdict].append(student)
    bars = [
        MistakeBar(label, tuple(found), named, "" if named else Verdict(label).meaning)
        for (named, label), found in made.items()
    ]
    return ProblemView(
        problem=problem,
        handed_in=len(rows),
        accepted=sum(row.accepted for row in rows.values()),
        mistakes=tuple(sorted(bars, key=lambda bar: (not bar.named, -bar.count, bar.label))),
        groups=_groups([row.result for row in rows.values()]),
    )


def _groups(results: Sequence[Result]) -> tuple[GroupBar, ...]:
    """The groups that somebody fails, by how many do, and then in the problem's order."""
    run: Counter[str] = Counter()
    failed: Counter[str] = Counter()
    for result in results:
        for group in result.groups:
            run[group.name] += 1
            failed[group.name] += group.verdict is not Verdict.AC
    bars = [GroupBar(name, failed[name], run[name]) for name in run if failed[name]]
    return tuple(sorted(bars, key=lambda bar: -bar.failed))


def _stuck(problems: Sequence[str], own: Mapping[_Pair, Sequence[Row]], order: Sequence[str]) -> list[Stuck]:
    """By problem, and then the mistake that holds the most students up."""
    found: dict[_Pair, list[str]] = defaultdict(list)
    for student in order:
        for problem in problems:
            rows = own.get((student, problem), ())
            last = {row.mistake for row in rows[-2:]}
            if len(rows) > 1 and len(last) == 1 and last != {""} and not any(row.accepted for row in rows):
                found[problem, last.pop()].append(student)
    place = {problem: at for at, problem in enumerate(problems)}
    told = [Stuck(problem, mistake, tuple(who)) for (problem, mistake), who in found.items()]
    return sorted(told, key=lambda each: (place[each.problem], -len(each.students), each.mistake))


def _machines(rows: Sequence[Row]) -> tuple[Machine, ...]:
    judged = Counter((row.machine, row.isolation) for row in rows if row.machine)
    return tuple(Machine(*where, times) for where, times in sorted(judged.items()))
