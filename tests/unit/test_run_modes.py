"""Judging a submission whose entry function is called, or that reads a group and prints a line a case."""

from __future__ import annotations

import re

import pytest
from judging import CASES, GOOD, LIMITS, judged, make_data, make_parameter_data
from msgspec.structs import replace

from judge.data import ProblemData
from judge.errors import JudgeError
from judge.problem import TimeRule, Verdict
from judge.problem.model import GrowthRule, Mode
from judge.report.tell import fault_place, tell
from judge.run import groups, program
from judge.run.execute import judge_submission
from judge.run.group import GroupRun
from judge.run.groups import MOST_LOSSES_IN_ALL, Budget
from judge.run.printed import with_printed
from judge.run.program import answer_lines, render_group
from judge.run.runner import Replies, Runner
from judge.sandbox import Stop, Usage, open_box
from judge.sandbox.available import levels_here
from judge.sandbox.boundary import CallsResult, Inspection, Limits, Reply


def test_an_accepted_submission():
    progress = []
    result = judged(GOOD, make_data("one", "two"), on_progress=lambda *done: progress.append(done))
    assert (result.verdict, result.mode, result.failure) == (Verdict.AC, Mode.FUNCTION, None)
    assert progress == [(4, 8), (8, 8)]
    assert result.isolation == next(level.name for level in levels_here() if level.available)
    assert 0 <= result.time.cpu_seconds < 0.5  # next to nothing, and so is the start
    assert result.time.wall_seconds > 0
    assert result.memory_bytes > 0
    assert result.groups[0].worst_ulps is None


def test_the_time_of_all_calls_is_told():
    body = "    until = time.thread_time() + 0.02\n    while time.thread_time() < until: pass\n    return int"
    result = judged("import time\n" + GOOD.decode().replace("    return int", body), make_data("one", "two"))
    assert result.verdict is Verdict.AC
    assert [group.cpu_seconds > 0.07 for group in result.groups] == [True, True]
    assert result.time.cpu_seconds >= sum(group.cpu_seconds for group in result.groups)  # and the import


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


@pytest.mark.slow
@pytest.mark.parametrize(
    ("body", "verdict", "message"),
    [
        ("1 / 0", Verdict.RTE, "ZeroDivisionError: division by zero (line 4)"),
        ("os._exit(0)", Verdict.RTE, "exit status 0"),
        ("bytes(1 << 40)", Verdict.MLE, "MemoryError (line 4)"),
        ("while True: pass", Verdict.TLE, "used more than 0.2 s of CPU time (line 4)"),
        ("time.sleep(60)", Verdict.TLE, "took more than 2 s, with 0.00 s of CPU time (line 4)"),
        ("while True: print('x' * 999)", Verdict.OLE, "wrote more than 1 MB"),
    ],
)
def test_each_way_to_fail_has_its_verdict(body, verdict, message):
    source = f"import os, time\ndef answer(n, P):\n    if n == 2:\n        {body}\n    return n + int(sum(P))"
    limits = replace(LIMITS, cpu_seconds=0.2, wall_seconds=2.0 if "sleep" in body else 60.0)
    result = judged(source, make_data("one", limits=limits))
    told = re.sub(r"0\.0\d s of", "0.00 s of", result.failure.message)
    assert (result.verdict, told) == (verdict, message)
    assert (result.failure.case, result.failure.expected, result.failure.got) == (3, "2", "no answer")
    assert result.groups[0].passed == (2 if verdict is Verdict.TLE else 3)


def test_a_submission_is_given_up_after_ten_losses_in_all():
    data, told = make_data(*"abcdefgh", cases=[(1, (0, 0))] * 9, counts=[1] * 9), []
    source = "import os\ndef answer(n, P): os._exit(0)"
    result = judged(source, data, on_progress=lambda *done: told.append(done))
    assert (result.verdict, result.failure.group) == (Verdict.RTE, "a")
    assert [group.verdict for group in result.groups] == [Verdict.RTE] * 8
    assert told[-1][0] == 3 * 9  # three losses in each of three groups; the fourth has one and no more


def test_only_what_was_judged_counts_as_failing_and_it_is_said_why_groups_were_not_run():
    source = """
def answer(n, P):
    if n in (12, 22):
        while True: pass
    return 7 if n in (0, 11) else int(n + P[0] + P[1])
"""
    data = make_data(*"abcdefgh", limits=replace(LIMITS, cpu_seconds=0.2), step=10)
    result = judged(source, data)
    assert [each.undecided for each in result.groups] == [0, 1, 1, *[4] * 5]
    told = tell(None, result)
    assert told.fails == ("a 2 of 4", "b 2 of 4 (1 not judged)", "c 1 of 4 (1 not judged)")
    assert told.last.endswith("5 groups not run: time limit exceeded")
    whole = replace(result.groups[0], passed=4)  # it printed a line too many, or is too slow
    assert tell(None, replace(result, groups=(whole,))).fails == ("a",)


@pytest.mark.parametrize(
    ("stops", "verdict"),
    [
        ([Stop.MEMORY] * MOST_LOSSES_IN_ALL, Verdict.MLE),
        ([Stop.OUTPUT] * MOST_LOSSES_IN_ALL, Verdict.OLE),
        ([Stop.MEMORY] * (MOST_LOSSES_IN_ALL - 1) + [Stop.EXITED], Verdict.RTE),
    ],
)
def test_what_is_given_up_has_the_verdict_of_the_losses_where_they_agree(stops, verdict):
    data = make_data(*"ab")
    budget = Budget(data.problem)
    for stop in stops:
        assert budget.over is None
        budget.booked(Replies([Reply(stop, None, "x")], Usage(), stop, lost=True))
    assert budget.over == (verdict, f"its process was lost {MOST_LOSSES_IN_ALL} times")
    never, wrong = (GroupRun(data, group, Runner(data.problem)) for group in data.groups)
    never.give_up(*budget.over)
    wrong.failed(0, Verdict.WA, "wrong")
    wrong.give_up(*budget.over)
    assert (never.given_up, never.failure.message) == (True, "not run: its process was lost 10 times")
    assert (wrong.given_up, wrong.verdict) == (False, Verdict.WA), "what was decided stays"


SLEEPER = "import time\ndef answer(n, P):\n    time.sleep(0.05)\n    return int(n + P[0] + P[1])\n"
SLEEPING_PROGRAM = """
import time
time.sleep(0.2)
for _ in range(int(input())):
    n, x, y = map(float, input().split())
    print(int(n + x + y))
"""


@pytest.mark.slow
@pytest.mark.parametrize("source", [SLEEPER, SLEEPING_PROGRAM])
def test_waiting_just_inside_every_limit_is_waiting_too_long(source):
    """Four calls of a group wait 0.2 s; all groups together may wait three wall limits, 0.9 s."""
    limits = replace(LIMITS, wall_seconds=0.3)
    result = judged(source, make_data(*"abcdefghijkl", limits=limits))
    assert (result.verdict, result.score < 50) == (Verdict.TLE, True)
    assert sum(group.cpu_seconds > 0 for group in result.groups) <= 5
    assert {group.verdict for group in result.groups[5:]} == {Verdict.TLE}


def test_no_process_waits_longer_than_all_groups_together_may():
    problem = make_data("a", limits=replace(LIMITS, wall_seconds=2.0)).problem
    budget, limits = Budget(problem), Limits(1.0, 2.0, 1 << 20, 1 << 20)
    for _ in range(4):
        budget.booked(Replies([Reply(Stop.ANSWERED, 0)], Usage(0.5, 1.75)))
    assert budget.over is None
    assert budget.within(limits).waiting_seconds == 3 * 2.0 - 4 * 1.25
    budget.booked(Replies([Reply(Stop.ANSWERED, 0)], Usage(0.0, 2.0)))
    assert budget.within(limits).waiting_seconds == 0


@pytest.mark.slow
@pytest.mark.parametrize(("loops", "ran"), [("True", 1), ("n == 2", 2)])
def test_an_endless_loop_ends_the_run_at_the_first_call_or_after_two_groups(loops, ran):
    """The groups after it would cost as much again."""
    limits = replace(LIMITS, cpu_seconds=0.2)
    source = f"def answer(n, P):\n    while {loops}: pass\n    return int(n + P[0] + P[1])\n"
    result = judged(source, make_data("a", "b", "c", "d", limits=limits))
    assert [group.verdict for group in result.groups] == [Verdict.TLE] * 4
    assert sum(group.cpu_seconds > 0 for group in result.groups) == ran
    assert result.failure.group == "a"
    assert fault_place(result).line == 2


def test_the_verdict_is_that_of_a_group_that_was_run_though_others_stand_before_it():
    """Those of the rule of growth are judged last, wherever they stand."""
    data = make_data("a", "b", "c", limits=replace(LIMITS, cpu_seconds=0.2))
    growing = replace(data.problem, time=TimeRule(10, "f.py", "p.py"), growth=GrowthRule(("a", "b"), 0.5))
    result = judged("def answer(n, P):\n    while True: pass\n", ProblemData(growing, data.groups))
    assert [group.run for group in result.groups] == [False, False, True]
    assert (result.verdict, result.failure.group, result.failure.case) == (Verdict.TLE, "c", 1)


class Silent:
    """A box whose child ends well and was never called."""

    isolation = "none"
    asked = 0

    def inspect(self):
        return Inspection(None, (("answer", 1),))

    def call(self, entry, calls, limits):
        self.asked += 1
        assert self.asked < 9, "it is asked for ever"
        return CallsResult((), Usage())


@pytest.mark.parametrize("names", ["a", "ab"])
def test_where_the_sandbox_makes_no_call_the_judge_is_at_fault(names):
    with pytest.raises(JudgeError, match="the sandbox made no call at all"):
        judge_submission(make_data(*names), GOOD, "my.py", box=Silent())


def test_worst_ulps_of_accepted_numbers():
    result = judged("def answer(n, P): return n + 2 ** -50", make_parameter_data([2.0, 4.0, 3.0]))
    assert (result.verdict, result.groups[0].worst_ulps) == (Verdict.AC, 2.0)


@pytest.mark.parametrize(
    ("prints", "returns", "printed", "message"),
    [
        ("'[0,1],', n", "7", "[0,1], 2", "2 expected, 7 given"),
        ("n + sum(P)", "None", "2", "it printed 2 and returned nothing: return it"),
        (r"'\x1b[31m' + 'x' * 999", "7", r"\x1b[31mxxx", "2 expected, 7 given"),
    ],
)
def test_what_a_function_prints_is_no_answer_and_is_asked_for_once_more_alone(
    prints, returns, printed, message
):
    source = f"def answer(n, P):\n    print({prints})\n    return {returns} if n == 2 else int(n + sum(P))\n"
    data = make_data("one")
    with open_box(source.encode(), "my.py") as box:
        result, runner, _ = judge_submission(data, source.encode(), "my.py", box=box)
        found = with_printed(result, data, runner, box)
    assert (found.verdict, found.failure.case, found.failure.message) == (Verdict.WA, 3, message)
    assert found.failure.printed.startswith(printed)
    assert "\n" not in found.failure.printed
    assert len(found.failure.printed) < 200


# -- programs: they read a whole group and print a line a case -----------------------------------------------

PROBLEM = make_data("one").problem


def test_a_group_as_standard_input():
    assert render_group(PROBLEM, CASES) == b"4\n1 0 0\n0 0.5 0.5\n2 -1 1\n0 0 0\n"
    assert render_group(PROBLEM, [(10**40, (5e-324, -0.0))]) == b"1\n" + b"1" + b"0" * 40 + b" 5e-324 -0.0\n"


@pytest.mark.parametrize(
    ("stdout", "complete", "lines"),
    [
        (b"1\n2\n", True, ["1", "2"]),
        (b"1\r\n2", True, ["1", "2"]),
        (b"1\n2", False, ["1"]),
        (b"1\n\n2\n \n\n", True, ["1", "", "2"]),
        (b"", True, []),
        (b"\xff\n", True, ["\\xff"]),
    ],
)
def test_lines_of_an_output(stdout, complete, lines):
    assert answer_lines(stdout, complete=complete) == lines


def test_a_flood_of_wrong_lines_is_a_flood():
    result = judged("import sys\nsys.stdin.read()\nwhile True: print(7)\n", make_data("one"))
    assert (result.verdict, result.failure.message) == (Verdict.OLE, "wrote more than 1 MB")


def test_a_flood_is_one_where_its_time_is_up_first():
    body = "import sys, time\nprint('7\\n' * (3 << 19), flush=True)\nwhile True: pass\n"
    limits = replace(LIMITS, cpu_seconds=0.3, output_mb=16)
    result = judged(body, make_data("one", limits=limits))
    assert result.verdict is Verdict.OLE
    assert result.failure.message.startswith("used more than 0.3 s of CPU time")


@pytest.mark.slow
def test_the_search_for_the_case_has_an_end(monkeypatch):
    """It breaks at once when all cases are there, and takes its time when it is run on fewer."""
    monkeypatch.setattr(groups, "SEARCH_SECONDS", 0.2)
    rendered = []
    monkeypatch.setattr(program, "render_group", lambda *case: rendered.append(case) or render_group(*case))
    body = "import time\ncount = int(input())\nwhile count < 4 and time.process_time() < 0.4: pass\n1 / 0\n"
    result = judged(body, make_data(*"abcdefgh"))
    assert {group.verdict for group in result.groups} == {Verdict.RTE}
    assert len(rendered) == 8 + 1


@pytest.mark.slow
def test_a_run_that_takes_long_is_not_repeated_to_find_the_case():
    body = "import time\ntime.sleep(1.1)\nif int(input()): 1 / 0\n"
    assert judged(body, make_data("a")).failure.message.endswith(", after 0 lines of 4")


def test_a_search_for_the_case_that_is_cut_short_blames_none_that_was_answered(monkeypatch):
    """Two lines have arrived; runs on fewer cases take longer than there is time for, and are not made."""
    monkeypatch.setattr(groups, "SEARCH_SECONDS", 0.2)
    body = """
import sys, time
count = int(input())
if not count: sys.exit()
for _ in range(min(count, 2)):
    n, x, y = map(float, input().split())
    print(int(n + x + y), flush=True)
while count < 4 and time.process_time() < 0.4: pass
1 / 0
"""
    failure = judged(body, make_data("a")).failure
    assert failure.case == 3
    assert failure.message.endswith("after 2 lines of 4")
