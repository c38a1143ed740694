"""The race against the reference: a submission must answer there as it did when it was judged."""

from __future__ import annotations

import pytest
from judging import CASES, COUNTS, GOOD, judged, make_data
from msgspec.structs import replace
from sampling import nightly

from judge.data import ProblemData
from judge.errors import JudgeError
from judge.problem import TimeRule, Verdict

pytestmark = pytest.mark.slow

PROGRAM = """
import sys
rows = [tuple(map(float, line.split())) for line in sys.stdin.read().splitlines()[1:]]
again = len(rows) < 400  # a race runs a sample of all groups
{deed}
for n, x, y in rows: print(int(n + x + y))
"""
CALLS = """
import os, sys, time
def raced():
    frame = sys._getframe()
    while "calls" not in frame.f_locals:
        frame = frame.f_back
    return len(frame.f_locals["calls"]) < 400  # a race makes a sample of them
def answer(n, P):
    if raced():
        {deed}
    return int(n + P[0] + P[1])
"""


REFERENCE = b"def answer(n, P):\n    for _ in range(20_000): pass\n    return int(n + P[0] + P[1])\n"


@pytest.fixture
def timed(tmp_path):
    """Judge on two groups of four cases with a time limit that nothing here comes near."""

    def judge(source, reference=REFERENCE, times=1, **options):
        folder = tmp_path / "accepted"
        folder.mkdir()
        (folder / "calls.py").write_bytes(reference)
        (folder / "program.py").write_text(PROGRAM.format(deed="for _ in range(200_000): pass"))
        data = make_data("one", "two", step=1, cases=times * CASES, counts=times * COUNTS)
        rule = TimeRule(1e6, "calls.py", "program.py")
        problem = replace(data.problem, solutions=tmp_path, time=rule)
        return judged(source, ProblemData(problem, data.groups), **options)

    return judge


WORK = "for _ in range(3_000_000): pass"
EAGER = f"{WORK}\n{GOOD.decode()}"
LAZY = f"""
done = []
def answer(n, P):
    if not done:
        done.append(1)
        {WORK}
    return int(n + P[0] + P[1])
"""


def test_work_done_at_import_is_told_and_has_no_part_in_the_ratio(timed):
    eager = timed(EAGER)
    assert eager.verdict is Verdict.AC
    assert eager.time.import_tells
    assert eager.time.import_tells
    assert eager.time.import_seconds > eager.time.cpu_seconds / 2
    assert eager.time.ratio.median < 1


def test_work_put_off_to_the_first_call_is_charged(timed):
    lazy = timed(LAZY)
    assert not lazy.time.import_tells
    assert not lazy.time.import_tells
    assert lazy.time.ratio.median > 3


@pytest.mark.parametrize("source", [GOOD, CALLS.format(deed="pass"), PROGRAM.format(deed="")])
def test_who_answers_alike_has_a_ratio(timed, source):
    result = timed(source)
    assert (result.verdict, result.failure) == (Verdict.AC, None)
    assert result.time.ratio.pairs == 1  # it is nowhere near the limit


@pytest.mark.parametrize(
    ("source", "deed", "verdict", "message"),
    [
        (CALLS, "return 7", Verdict.WA, "expected, 7 given"),
        nightly(CALLS, "raise ValueError('timed')", Verdict.RTE, "ValueError: timed"),
        (CALLS, "os._exit(0)", Verdict.RTE, "exit status 0"),
        nightly(PROGRAM, "if again: sys.exit()", Verdict.WA, "0 lines printed, 270 expected"),
        (PROGRAM, "if again: rows.reverse()", Verdict.WA, "expected"),
    ],
)
def test_who_answers_otherwise_when_timed_is_not_accepted(timed, source, deed, verdict, message):
    result = timed(source.format(deed=deed), times=101)
    assert result.verdict is verdict
    assert message in result.failure.message
    assert "when it was run again to be timed" in result.failure.message
    assert sum(group.passed for group in result.groups) == 807
    assert result.score < 100


def test_a_reference_that_fails_is_no_fault_of_the_submission(timed):
    with pytest.raises(JudgeError, match="the reference solution cannot be timed: exit status 0"):
        timed(GOOD, reference=b"import os\ndef answer(n, P): os._exit(0)\n")
