"""Classes to show: rows as judging makes them, and a small class with something of everything."""

from __future__ import annotations

from judge.batch.cohort import cohort_of
from judge.batch.model import KeptRow, WorkerResult
from judge.cache import digest
from judge.problem.model import Verdict
from judge.report.published_klass import Alike, Student
from judge.run.result import Failure, GroupResult, Pitfall, Ratio, Result, Timing, earned

GROUPS = ("examples", "grid", "tangent")
INPUT = {"cx": 0, "cy": 0, "r": 1, "A": [-1, 1], "B": [0, 1]}


def row(
    student,
    problem,
    mistake="",
    fails=(),
    *,
    verdict=None,
    file="",
    machine="box",
    isolation="full",
    at=1.0,
    busy="",
):
    """A row: accepted where no group fails and no other verdict is given, and raced then."""
    verdict = verdict or (Verdict.WA if fails else Verdict.AC)
    ran = verdict not in (Verdict.CE, Verdict.JE)
    groups = [
        GroupResult(
            name=name,
            verdict=Verdict.WA if name in fails else Verdict.AC,
            cases=10,
            passed=4 if name in fails else 10,
            points=30,
        )
        for name in (GROUPS if ran else ())
    ]
    failure = Failure("off by one", fails[0], 3, INPUT, "1", "2") if fails else None
    if not ran:
        failure = Failure("line 1: '(' was never closed")
    file = file or f"{student}/{problem}.py"
    ratio = Ratio(1.5, 1.4, 1.6, 9, busy=busy) if busy or verdict is Verdict.AC else None
    result = Result(
        problem=problem,
        submission=file,
        verdict=verdict,
        failure=failure,
        time=Timing(cpu_seconds=0.02, ratio=ratio),
        isolation=isolation,
        pitfall=Pitfall((mistake,), 0.9, ("Do better.",)) if mistake else None,
        **earned(groups),
    )
    own = digest(f"{student}/{file}/{mistake}/{fails}".encode())
    return KeptRow(student, problem, file, own, WorkerResult(result.as_json(), machine, "1"), None, at)


DEE = "dee\x1b[31m王"
STUDENTS = [
    Student("ann", "Ann Lee", "A"),
    Student("bob", "Bob\x1b[31m", "A"),
    Student("cid", "=HYPERLINK(1)", "B"),
    Student(DEE, "王小明", "B"),
    Student("eve", "<script>alert(1)</script>", "B"),
]
ROWS = [
    row("ann", "count", "forgotten-abs", ("tangent",), file="ann/count-1.py"),
    row("ann", "count", file="ann/count-2.py"),
    row("ann", "segment", "tangent-twice", ("grid", "tangent")),
    row("bob", "count", "forgotten-abs", ("grid", "tangent"), file="bob/count-1.py"),
    row("bob", "count", "forgotten-abs", ("tangent",), file="bob/count-2.py"),
    row("cid", "count", "forgotten-abs", ("tangent",), machine="lab", isolation="strong", busy="busy"),
    row("cid", "segment", verdict=Verdict.CE),
    row(DEE, "segment", fails=("grid",)),
    row("zoe", "count", "tight-epsilon", ("examples",)),
]
SAME = "identical after removing names, spacing and comments"
EQUAL = [Alike("count", SAME, ("bob", "cid"), ("bob/count-2.py", "cid/count.py"))]


def class_of(*rows, students=(), problems=("count",), history=(), equal=()):
    """The cohort of these rows, of these students or those who have rows."""
    who = students or [Student(each) for each in sorted({row.student for row in rows})]
    return cohort_of(tuple(who), tuple(problems), rows, history=history, equal_files=equal)


def small_class():
    """Five students of a list, one beside it, two problems."""
    who = (*STUDENTS, Student("zoe", known=False))
    return class_of(*ROWS, students=who, problems=("segment", "count"), equal=EQUAL)
