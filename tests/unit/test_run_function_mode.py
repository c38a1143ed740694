"""Judging a submission whose entry function is called."""

from __future__ import annotations

import pytest
from judging import GOOD, LIMITS, judged, make_data, make_parameter_data
from msgspec.structs import replace

from judge.problem import Verdict
from judge.run import Mode
from judge.run.budget import MOST_LOSSES, Budget
from judge.run.function import FunctionRunner
from judge.run.group import GroupRun, group_limits
from judge.run.replies import Replies
from judge.sandbox import Reply, Stop, Usage, levels


def test_an_accepted_submission():
    progress = []
    result = judged(GOOD, make_data("one", "two"), on_progress=lambda *done: progress.append(done))
    assert (result.verdict, result.mode, result.failure) == (Verdict.AC, Mode.FUNCTION, None)
    assert (result.score, result.points, int(result.exit_code)) == (100, 100, 0)
    assert [(group.name, group.passed, group.cases) for group in result.groups] == [
        ("one", 4, 4),
        ("two", 4, 4),
    ]
    assert progress == [(4, 8), (8, 8)]
    assert result.isolation == next(level.name for level in levels() if level.available)
    assert 0 <= result.time.cpu_seconds < 0.5  # next to nothing, and so is the start
    assert result.time.wall_seconds > 0
    assert result.memory_bytes > 0
    assert result.groups[0].worst_ulps is None


def test_the_time_of_all_calls_is_told():
    body = "    until = time.thread_time() + 0.02\n    while time.thread_time() < until: pass\n    return int"
    result = judged("import time\n" + GOOD.decode().replace("    return int", body), make_data("one", "two"))
    assert result.verdict is Verdict.AC
    assert [group.cpu_seconds > 0.07 for group in result.groups] == [True, True]
    assert result.time.cpu_seconds == sum(group.cpu_seconds for group in result.groups)


def test_a_wrong_answer_shows_the_first_failing_case():
    result = judged("def answer(n, P): return n")
    assert (result.verdict, result.score, int(result.exit_code)) == (Verdict.WA, 0, 1)
    assert result.groups[0].passed == 3
    failure = result.failure
    assert (failure.group, failure.case) == ("one", 2)
    assert failure.input == {"n": 0, "P": (0.5, 0.5)}
    assert (failure.expected, failure.got) == ("1", "0")


def test_all_groups_run_and_the_first_failing_one_decides():
    data = make_data("one", "two", "three", "four", step=10)
    source = """
def answer(n, P):
    if n == 10: return 7
    if n == 21: raise ValueError("late")
    return int(n + P[0] + P[1])
"""
    result = judged(source, data)
    assert [group.verdict.value for group in result.groups] == ["AC", "WA", "RTE", "AC"]
    assert (result.verdict, result.score) == (Verdict.WA, 50)
    assert (result.failure.group, result.failure.case) == ("two", 2)


def test_only_the_groups_asked_for():
    result = judged(GOOD, make_data("one", "two"), groups={"two"})
    assert [group.name for group in result.groups] == ["two"]
    assert (result.verdict, result.score, result.points) == (Verdict.AC, 50, 50)


@pytest.mark.parametrize(
    ("body", "verdict", "message"),
    [
        ("1 / 0", Verdict.RTE, "ZeroDivisionError: division by zero (line 3)"),
        ("import os; os._exit(0)", Verdict.RTE, "exit status 0"),
        ("bytes(1 << 40)", Verdict.MLE, "MemoryError (line 3)"),
        ("while True: pass", Verdict.TLE, "used more than 0.5 s of CPU time (line 3)"),
        ("while True: print('x' * 999)", Verdict.OLE, "wrote more than 1 MB"),
    ],
)
def test_each_way_to_fail_has_its_verdict(body, verdict, message):
    source = f"def answer(n, P):\n    if n == 2:\n        {body}\n    return int(n + P[0] + P[1])\n"
    result = judged(source, make_data("one", limits=replace(LIMITS, cpu_seconds=0.5)))
    assert (result.verdict, result.failure.message) == (verdict, message)
    assert (result.failure.case, result.failure.expected, result.failure.got) == (3, "2", "no answer")
    assert result.groups[0].passed == (2 if verdict is Verdict.TLE else 3)


def test_a_group_is_given_up_after_three_losses():
    result = judged(
        "import os\ndef answer(n, P): os._exit(0)", make_data("one", cases=[(1, (0, 0))] * 9, counts=[1] * 9)
    )
    assert (result.verdict, result.failure.case, result.groups[0].passed) == (Verdict.RTE, 1, 0)


def test_a_submission_is_given_up_after_ten_losses_in_all():
    data, told = make_data(*"abcdefgh", cases=[(1, (0, 0))] * 9, counts=[1] * 9), []
    source = "import os\ndef answer(n, P): os._exit(0)"
    result = judged(source, data, on_progress=lambda *done: told.append(done))
    assert (result.verdict, result.failure.group) == (Verdict.RTE, "a")
    assert [group.verdict for group in result.groups] == [Verdict.RTE] * 8
    assert told[-1][0] == 3 * 9  # three losses in each of three groups; the fourth has one and no more


def ended(stop, usage=Usage()):  # noqa: B008 - it is frozen
    """A call that ended its process, unless it answered."""
    return Replies([Reply(stop, None, "x")], usage, stop, lost=stop is not Stop.ANSWERED)


def test_what_is_given_up_says_why_and_never_decides():
    data = make_data(*"abcdefgh", cases=[(1, (0, 0))] * 9, counts=[1] * 9)
    budget = Budget(data.problem)
    runs = [GroupRun(data, group, FunctionRunner(data.problem)) for group in data.groups]
    for _ in range(MOST_LOSSES):
        assert budget.over is None
        budget.booked(ended(Stop.TAMPERED))
    runs[0].give_up(*budget.over)
    runs[1].failed(0, Verdict.WA, "wrong")
    runs[1].give_up(*budget.over)
    assert [run.given_up for run in runs[:2]] == [True, False]
    assert runs[0].failure.message == "not run: its process was lost 10 times"
    assert [run.verdict for run in runs[:2]] == [Verdict.RTE, Verdict.WA]


@pytest.mark.parametrize(
    ("stops", "verdict"),
    [
        ([Stop.MEMORY] * MOST_LOSSES, Verdict.MLE),
        ([Stop.OUTPUT] * MOST_LOSSES, Verdict.OLE),
        ([Stop.MEMORY] * (MOST_LOSSES - 1) + [Stop.EXITED], Verdict.RTE),
    ],
)
def test_what_is_given_up_has_the_verdict_of_the_losses_where_they_agree(stops, verdict):
    budget = Budget(make_data("a").problem)
    for stop in stops:
        budget.booked(ended(stop))
    assert budget.over == (verdict, f"its process was lost {MOST_LOSSES} times")


SLEEPER = "import time\ndef answer(n, P):\n    time.sleep(0.05)\n    return int(n + P[0] + P[1])\n"
SLEEPING_PROGRAM = """
import time
time.sleep(0.2)
for _ in range(int(input())):
    n, x, y = map(float, input().split())
    print(int(n + x + y))
"""


@pytest.mark.parametrize("source", [SLEEPER, SLEEPING_PROGRAM])
def test_waiting_just_inside_every_limit_is_waiting_too_long(source):
    """Four calls of a group wait 0.2 s; all groups together may wait three wall limits, 0.9 s."""
    limits = replace(LIMITS, wall_seconds=0.3)
    result = judged(source, make_data(*"abcdefghijkl", limits=limits))
    ran = [group.name for group in result.groups if group.cpu_seconds]
    assert result.verdict is Verdict.TLE
    assert result.score < 50
    assert len(ran) <= 5
    assert {group.verdict for group in result.groups[5:]} == {Verdict.TLE}


def test_who_has_waited_too_long_is_told_so():
    limits = replace(LIMITS, wall_seconds=10.0)
    data = make_data("one", "two", limits=limits)
    budget, one = Budget(data.problem), group_limits(data.problem, data.problem.groups[0], Usage())
    assert budget.within(one).waiting_seconds == 30.0
    budget.booked(ended(Stop.ANSWERED, Usage(2.0, 31.0)))
    assert budget.within(one).waiting_seconds == 1.0
    assert budget.over is None
    told = budget.booked(ended(Stop.WAITING, Usage(0.0, 0.999)))
    verdict, reason = budget.over
    assert (verdict, reason) == (Verdict.TLE, "it waited more than 30 s in all its groups together before")
    assert budget.within(one).waiting_seconds == 0.0
    assert told.trouble == "it waited more than 30 s in all its groups together"
    assert budget.booked(ended(Stop.WALL)).trouble == "x"


def test_a_first_call_that_never_ends_ends_the_run():
    limits = replace(LIMITS, cpu_seconds=0.2)
    result = judged("def answer(n, P):\n    while True: pass\n", make_data("a", "b", limits=limits))
    assert [group.verdict for group in result.groups] == [Verdict.TLE] * 2
    assert [group.cpu_seconds > 0 for group in result.groups] == [True, False]


def test_an_endless_loop_ends_the_run_after_two_groups():
    limits = replace(LIMITS, cpu_seconds=0.2)
    source = "def answer(n, P):\n    while n == 2: pass\n    return int(n + P[0] + P[1])\n"
    result = judged(source, make_data("a", "b", "c", "d", limits=limits))
    assert [group.verdict for group in result.groups] == [Verdict.TLE] * 4
    assert [group.cpu_seconds > 0 for group in result.groups] == [True, True, False, False]
    assert result.failure.group == "a"


@pytest.mark.parametrize("answer", ["True", "'1'", "1.0", "float('nan')", "[1]", "(1,)", "lambda: 1", "1j"])
def test_wrong_types_are_wrong_answers_with_a_reason(answer):
    result = judged(f"def answer(n, P): return {answer}")
    assert result.verdict is Verdict.WA
    assert result.failure.message


def test_worst_ulps_of_accepted_numbers():
    result = judged("def answer(n, P): return n + 2 ** -50", make_parameter_data([2.0, 4.0, 3.0]))
    assert result.verdict is Verdict.AC
    assert result.groups[0].worst_ulps == 2.0


@pytest.mark.parametrize(
    ("source", "message"),
    [
        (
            b"def answer(n, P)\n    return 1",
            "SyntaxError: expected ':' (line 1, column 17): def answer(n, P)",
        ),
        (b"x = 1\ny = '\xe9'\n", "the file is not UTF-8: byte 0xe9 (line 2); save it as UTF-8"),
        (b"x = 1\0", "source code string cannot contain null bytes"),
    ],
)
def test_what_does_not_compile(source, message):
    result = judged(source)
    assert (result.verdict, result.groups, int(result.exit_code)) == (Verdict.CE, (), 1)
    assert result.failure.message.endswith(message)


def test_groups_that_fill_memory_until_their_time_is_up_are_given_up_too():
    """A hog is known for one only at its end, and nobody wants to wait for that in each group."""
    data = make_data(
        "one", "two", "three", "four", limits=replace(LIMITS, cpu_seconds=0.5, memory_bytes=64 << 20)
    )
    result = judged("def answer(n, P):\n    while True: bytearray(b'1') * (80 << 20)\n", data)
    verdicts = [group.verdict for group in result.groups]
    assert verdicts == [Verdict.MLE, Verdict.MLE, Verdict.TLE, Verdict.TLE]
