"""Groups of equal limits share a process; what passes a limit there is blamed on the group whose it is."""

from __future__ import annotations

import pytest
from judging import GOOD, judged, make_data
from msgspec.structs import replace

from judge.data import ProblemData
from judge.problem import TimeRule, Verdict
from judge.problem.model import GroupLimits
from judge.run import groups
from judge.sandbox import Limits, open_box

pytestmark = pytest.mark.slow

LIMITS = GroupLimits(cpu_seconds=0.4, wall_seconds=10.0, memory_mb=128, output_mb=1)
NAMES = ("one", "two", "three", "four")
SPIN = "from time import thread_time as t\ndef spin(s):\n    end = t() + s\n    while t() < end: pass\n"
ANSWER = "def answer(n, P):\n    {deed}\n    return int(n + P[0] + P[1])\n"


def verdicts(deed, before=""):
    """What the four groups come to; n is 0 to 2 in the first of them, 10 to 12 in the second, and so on."""
    source = SPIN + before + ANSWER.format(deed=deed)
    result = judged(source, make_data(*NAMES, limits=LIMITS, step=10))
    return [group.verdict.value for group in result.groups], result


def test_all_groups_have_one_process():
    found, _ = verdicts("asked.append(n)\n    if n > 30 and len(asked) < 12: return 7", "asked = []\n")
    assert found == ["AC"] * 4


@pytest.mark.parametrize(("most", "ends"), [(1, "WA"), (1 << 20, "AC")])
def test_they_do_not_share_it_where_their_arguments_are_too_many(monkeypatch, most, ends):
    """The memory that arguments are handed over in is bounded: what fits alone must not fail together."""
    monkeypatch.setattr(groups, "MOST_ARGUMENTS", most)
    found, _ = verdicts("asked.append(n)\n    if n >= 30 and len(asked) < 12: return 7", "asked = []\n")
    assert found == [*["AC"] * 3, ends]


def test_each_has_the_whole_of_its_limit_where_all_together_pass_it():
    found, result = verdicts("spin(0.06)")
    assert found == ["AC"] * 4
    assert all(0.2 < group.cpu_seconds < 0.4 for group in result.groups)


@pytest.mark.parametrize(("place", "late"), [(0, "n < 10"), (1, "10 <= n < 20"), (3, "n >= 30")])
def test_the_slow_group_is_blamed_and_no_other(place, late):
    found, result = verdicts(f"spin(0.15 if {late} else 0.01)")
    assert found == ["TLE" if at == place else "AC" for at in range(4)]
    assert result.failure.group == NAMES[place]


@pytest.mark.parametrize(
    ("deed", "verdict"),
    [
        ("if n >= 20: bytearray(b'1') * (300 << 20)", "MLE"),
        ("if n >= 20: print('x' * 400_000)", "OLE"),
    ],
)
def test_memory_and_output_are_blamed_on_the_group_that_takes_them(deed, verdict):
    found, _ = verdicts(deed)
    assert found == ["AC", "AC", verdict, verdict]


def test_a_group_that_goes_on_after_too_much_output_is_blamed_itself():
    deed = "if 10 <= n < 20:\n        try: os.write(1, b'x' * 400_000)\n        except OSError: pass"
    assert verdicts(deed, "import os\n")[0] == ["AC", "OLE", "AC", "AC"]


def test_a_group_with_limits_of_its_own_has_a_process_of_its_own():
    data = make_data(*NAMES, limits=LIMITS, step=10)
    own = replace(data.groups[1].group, limits=replace(LIMITS, cpu_seconds=0.1))
    groups = tuple(replace(each, group=own) if place == 1 else each for place, each in enumerate(data.groups))
    problem = replace(data.problem, groups=tuple(each.group for each in groups))
    source = SPIN + ANSWER.format(deed="spin(0.2 if n == 12 else 0)")
    result = judged(source, ProblemData(problem, groups))
    assert [group.verdict.value for group in result.groups] == ["AC", "TLE", "AC", "AC"]


def test_output_of_all_groups_together_may_pass_the_limit_of_one():
    assert verdicts("print('x' * 100_000)")[0] == ["AC"] * 4


def test_a_call_that_is_lost_costs_itself_in_the_middle_of_a_process():
    found, result = verdicts("if n == 11: os._exit(0)", "import os\n")
    assert found == ["AC", "RTE", "AC", "AC"]
    assert [group.passed for group in result.groups] == [4, 3, 4, 4]


def test_work_at_import_is_told_apart_and_counted_once():
    _, result = verdicts("pass", "spin(0.3)\n")
    assert result.verdict is Verdict.AC
    assert 0.29 < result.time.cpu_seconds < 0.45
    assert sum(group.cpu_seconds for group in result.groups) < 0.1


def test_too_slow_names_the_slowest_group(tmp_path):
    (tmp_path / "accepted").mkdir()
    (tmp_path / "accepted" / "f.py").write_bytes(GOOD)
    data = make_data(*NAMES, step=10)
    problem = replace(data.problem, solutions=tmp_path, time=TimeRule(10, "f.py", "p.py"))
    slow = SPIN + ANSWER.format(deed="spin(0.05 if 20 <= n < 30 else 0.01)")
    result = judged(slow, ProblemData(problem, data.groups))
    assert (result.verdict, result.failure.group) == (Verdict.TLE, "three")


def test_a_process_finds_nothing_of_the_one_before_it():
    body = b"""
import sys
def f(n):
    frame = sys._getframe()
    while "region" not in frame.f_locals:
        frame = frame.f_back
    memory = frame.f_locals["region"].memory
    found = memory.find(b"left by " + b"the last")
    if n == 1:
        memory[64 << 20 : (64 << 20) + 16] = b"left by " + b"the last"
    return found
"""
    bounds = Limits(cpu_seconds=2.0, wall_seconds=10.0, memory_bytes=256 << 20, output_bytes=1 << 20)
    with open_box(body, "my.py") as box:
        first, second, third = (
            box.call("f", calls, bounds).replies for calls in ([(0,), (1,), (0,)], [(0,)], [(0,)])
        )
    assert [reply.answer for reply in first] == [-1, -1, 64 << 20]
    assert [reply.answer for reply in (*second, *third)] == [-1, -1]
