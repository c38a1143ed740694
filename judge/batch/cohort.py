"""From the rows of a class to what it is shown: whose row counts, which mistakes, who is stuck."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterable, Mapping, Sequence

from judge.batch.model import Row
from judge.problem.model import Verdict
from judge.report.published_klass import (
    Cohort,
    Counted,
    EqualFiles,
    GroupBar,
    Machine,
    MistakeBar,
    ProblemView,
    Stuck,
    Student,
)
from judge.run.result import Result

_Pair = tuple[str, str]  # a student and a problem


def cohort_of(
    students: Sequence[Student],
    problems: Sequence[str],
    rows: Sequence[Row],
    *,
    history: Iterable[Row] = (),
    equal: Sequence[EqualFiles] = (),
    left: int = 0,
) -> Cohort:
    """The class as it stands: the students and problems of the table, in its order, and the present rows.

    `history` are rows of texts that were submitted before and have been replaced since; they tell who is
    stuck and nothing else. `equal` are the sets of equal files, `left` counts files without a row.
    """
    counts = counting(rows)
    handins = Counter((row.student, row.problem) for row in rows)
    marks = {pair: _mark(row, handins[pair]) for pair, row in counts.items()}
    handed_in = {student for student, _ in counts}
    solved = {student for (student, _), mark in marks.items() if mark.accepted}
    order = [each.id for each in students]
    met = tuple(each for each in problems if any(each == problem for _, problem in counts))
    failures = [(row.file, row.result.failure) for row in rows if row.verdict == Verdict.JE.value]
    return Cohort(
        students=len(students),
        handins=len(rows),
        people=tuple(students),
        marks=marks,
        problems=tuple(_view(each, counts, order) for each in met),
        stuck=tuple(_stuck(met, _in_turn([*history, *rows]), order)),
        nothing_accepted=tuple(each for each in order if each in handed_in - solved),
        nothing_handed_in=tuple(each for each in order if each not in handed_in),
        machines=_machines(rows),
        equal_files=tuple(equal),
        unjudged=tuple((file, failure.message if failure else "") for file, failure in failures),
        left=left,
    )


def counting(rows: Iterable[Row]) -> dict[_Pair, Row]:
    """Of each student and problem the row that counts: of several files the best, and of equals the newest.

    The best is an accepted one, then the one of most points; one that could not be judged is the last.
    """
    found: dict[_Pair, Row] = {}
    for row in rows:
        place = row.student, row.problem
        if place not in found or _worth(row) >= _worth(found[place]):
            found[place] = row
    return found


def _worth(row: Row) -> tuple[bool, bool, int, float]:
    return row.accepted, row.verdict != Verdict.JE.value, row.score, row.at


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
        copied=bool(row.copied),
        busy=bool(row.done.busy),
    )


def _view(problem: str, counts: Mapping[_Pair, Row], order: Sequence[str]) -> ProblemView:
    rows = {student: counts[student, problem] for student in order if (student, problem) in counts}
    made: dict[tuple[bool, str], list[str]] = defaultdict(list)
    for student, row in rows.items():
        if not row.accepted:
            made[bool(row.mistake), row.mistake or row.verdict].append(student)
    bars = [
        MistakeBar(label if named else None, None if named else label, tuple(found))
        for (named, label), found in made.items()
    ]
    return ProblemView(
        problem=problem,
        handed_in=len(rows),
        accepted=sum(row.accepted for row in rows.values()),
        mistakes=tuple(sorted(bars, key=lambda bar: (not bar.named, -len(bar.students), bar.label))),
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
    judged = Counter((row.machine, row.isolation) for row in rows if row.isolation)
    return tuple(Machine(*where, times) for where, times in sorted(judged.items()))
