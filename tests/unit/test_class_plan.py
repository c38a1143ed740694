"""What is to be done for a class: which rows are kept, which texts are judged once, which come back."""

from __future__ import annotations

import pytest
from msgspec.structs import replace

from judge.batch.model import Environment, Submission, Task, WorkerResult
from judge.batch.plan import current, planned
from judge.batch.shards import Shard
from judge.errors import UsageError
from judge.judging import RunOptions
from judge.run.result import judge_fault

ENVIRONMENT = Environment("1", "2", "3", "full", "5")
P, Q = (Task(name, "", b"", RunOptions(), ENVIRONMENT) for name in "pq")
KINDS = {"p": P, "q": Q, "broken": "problem.toml: misspelt"}
ADA, BOB = Submission("ada", "p", "ada/p.py", b"one"), Submission("bob", "p", "bob/p.py", b"one")
CY, OTHER = Submission("cy", "p", "cy/p.cpp", b"one"), Submission("ada", "q", "ada/q.py", b"one")


def done(name, verdict="WA"):
    result = judge_fault("p", name, "why").as_json() | {"verdict": verdict, "score": 40, "isolation": "full"}
    return WorkerResult(result, machine="lab1")


def judged(plan, verdict="WA"):
    """All rows that the plan comes to."""
    rows = [*plan.kept, *plan.rows]
    for work in plan.work:
        rows += work.rows(done(work.task.name, verdict))
    return rows


def test_equal_texts_in_one_language_to_one_problem_are_judged_once():
    plan = planned([ADA, BOB, CY, OTHER], [], KINDS)
    assert [(work.task.problem, work.submissions) for work in plan.work] == [
        ("p", (ADA, BOB)),
        ("p", (CY,)),
        ("q", (OTHER,)),
    ]
    assert plan.total == 4
    assert [work.task.name for work in plan.work] == ["p.py", "p.cpp", "q.py"]  # nobody's name goes along
    ada, bob, *_ = judged(plan)
    assert (ada.copied, bob.copied) == ("", "ada/p.py")
    assert [row.result.submission for row in (ada, bob)] == ["ada/p.py", "bob/p.py"]
    assert (bob.result.verdict.value, bob.result.score, bob.done.machine) == ("WA", 40, "lab1")


def test_what_is_there_is_kept_and_equals_get_copies_later_too():
    rows = judged(planned([ADA], [], KINDS))
    plan = planned([ADA, BOB], rows, KINDS)
    assert (plan.kept, plan.work) == (tuple(rows), ())
    assert [(row.file, row.copied) for row in plan.rows] == [("bob/p.py", "ada/p.py")]
    third = replace(ADA, student="dan", file="dan/p.py")
    (copy,) = planned([third], [*plan.rows], KINDS).rows
    assert copy.copied == "ada/p.py"  # not of the copy
    assert plan.notices == ("1 result kept from before",)


def test_a_file_or_a_problem_that_cannot_be_judged_is_a_row_and_a_fault_is_tried_again():
    odd = Submission("ada", "p", "ada/p.py", why="it is not an ordinary file")
    broken = Submission("ada", "broken", "ada/broken.py", b"x")
    plan = planned([odd, broken], [], KINDS)
    assert [(row.result.verdict.value, row.result.failure.message) for row in plan.rows] == [
        ("JE", "it is not an ordinary file"),
        ("JE", "problem.toml: misspelt"),
    ]
    assert plan.work == ()
    rows = judged(planned([ADA], [], KINDS), "JE")
    plan = planned([ADA, BOB], rows, KINDS)
    assert [work.submissions for work in plan.work] == [(ADA, BOB)]
    assert plan.notices == ()


@pytest.mark.parametrize("name", ["ada", "p", "ada/p.py"])
def test_what_is_asked_for_is_judged_anew(name):
    rows = judged(planned([ADA, OTHER], [], KINDS))
    files = {
        each.file for work in planned([ADA, OTHER], rows, KINDS, [name]).work for each in work.submissions
    }
    assert files == ({"ada/p.py", "ada/q.py"} if name == "ada" else {"ada/p.py"})


def test_another_standard_is_told_and_what_comes_back_is_the_newest():
    rows = judged(planned([ADA, BOB], [], KINDS))
    stronger = replace(ENVIRONMENT, isolation="strong", judge="2")
    plan = planned([ADA, BOB], rows, {"p": replace(P, environment=stronger)})
    assert plan.notices == ("2 judged anew, because of the judge (1 → 2), the isolation (full → strong)",)
    assert [work.submissions for work in plan.work] == [(ADA, BOB)]
    assert current([ADA, BOB], rows, {stronger}) == {}  # until they are
    assert set(current([ADA, BOB], rows)) == {ADA, BOB}
    every = [*rows, *judged(plan)]
    back = planned([ADA, BOB], every, KINDS)
    assert (back.kept, back.work, back.notices) == ((), (), ("2 results kept from before",))
    assert [row.key for row in back.rows] == [row.key for row in rows]
    assert all(row.at >= every[-1].at for row in back.rows)
    changed = replace(ADA, source=b"two")
    later = [*rows, *judged(planned([changed], rows, KINDS))]
    (again,) = planned([ADA], later, KINDS).rows
    assert (again.digest, again.key) == (ADA.digest, rows[0].key)


def test_shards_part_the_texts_and_equal_ones_meet():
    submissions = [Submission(f"s{at}", "p", f"s{at}/p.py", b"%d" % (at // 2)) for at in range(200)]
    parts = [[each for each in submissions if Shard(number, 3).holds(each)] for number in (1, 2, 3)]
    assert sorted((each for part in parts for each in part), key=submissions.index) == submissions
    assert all(30 < len(part) < 110 for part in parts)
    assert all(len({each.digest for each in part}) * 2 == len(part) for part in parts)
    odd = [replace(each, why="it is a folder", source=b"") for each in submissions]
    assert all(any(Shard(number, 3).holds(each) for each in odd) for number in (1, 2, 3))


def test_what_is_no_shard_is_refused():
    for text in ("", "0/3", "1/0", "a/b", "٣/٣"):
        with pytest.raises(UsageError, match="is not a part; write 3/20"):
            Shard.read(text)
    assert Shard.read("3/20") == Shard(3, 20)
