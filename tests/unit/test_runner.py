"""One interface for both ways to run a submission: what it tells, and that nothing goes round it."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from judging import CASES, COUNTS, LIMITS, make_data

import judge
from judge.problem import Verdict
from judge.run.function import FunctionRunner
from judge.run.group import group_limits
from judge.run.program import ProgramRunner
from judge.run.runner import runner_for
from judge.sandbox import Stop, Usage, open_box

PACKAGE = Path(judge.__file__).parent
PROGRAM = (
    "for _ in range(int(input())):\n    n, x, y = map(float, input().split())\n    print(int(n + x + y))\n"
)
FUNCTION = "def answer(n, P):\n    return int(n + P[0] + P[1])\n"


def asked(source, cases=CASES, limits=LIMITS):
    """The runner of the source, and what it answers to the cases."""
    problem = make_data("one", limits=limits).problem
    with open_box(source.encode(), "my.py") as box:
        runner = runner_for(problem, box.inspect(), source.encode())
        return runner, runner.answers(box, cases, group_limits(problem, problem.groups[0], Usage()))


@pytest.mark.parametrize(
    ("source", "kind", "answers"),
    [(FUNCTION, FunctionRunner, COUNTS), (PROGRAM, ProgramRunner, [str(count) for count in COUNTS])],
)
def test_both_ways_give_a_reply_a_case(source, kind, answers):
    runner, replies = asked(source)
    assert type(runner) is kind
    assert [reply.answer for reply in replies.replies] == answers
    assert (replies.stop, replies.lost, replies.breakdown, replies.trouble) == (
        Stop.ANSWERED,
        False,
        None,
        "",
    )


def test_a_call_that_raises_is_a_reply_and_no_breakdown():
    _, replies = asked("def answer(n, P):\n    return 1 // n\n")
    assert [reply.stop for reply in replies.replies] == [
        Stop.ANSWERED, Stop.EXCEPTION, Stop.ANSWERED, Stop.EXCEPTION
    ]  # fmt: skip
    assert replies.breakdown is None
    assert "ZeroDivisionError" in replies.trouble


def test_a_call_that_ends_its_process_is_the_last_reply():
    _, replies = asked("import os\ndef answer(n, P):\n    return 1 if n else os._exit(0)\n")
    assert [reply.stop for reply in replies.replies] == [Stop.ANSWERED, Stop.EXITED]
    assert (replies.stop, replies.lost) == (Stop.EXITED, True)


@pytest.mark.parametrize(
    ("source", "verdict", "detail", "case"),
    [
        ("print(1)\nprint(1)\n", Verdict.WA, "2 lines printed, 4 wanted", 2),
        ("print('1\\n' * 7)\n", Verdict.WA, "7 lines printed, 4 wanted", 3),
        ("print(1, flush=True)\nraise ValueError('no')\n", Verdict.RTE, "ValueError: no", 1),
        ("print('1' * 2**21)\n", Verdict.OLE, "wrote more than 1 MB", 0),
    ],
)
def test_a_program_breaks_down_as_a_whole(source, verdict, detail, case):
    _, replies = asked(source)
    assert (replies.breakdown.verdict, replies.breakdown.case) == (verdict, case)
    assert replies.breakdown.detail.startswith(detail)
    assert replies.lost is (verdict is Verdict.OLE)
    assert replies.trouble == replies.breakdown.detail


def code_of(path: Path) -> str:
    """A file's text without comments."""
    return re.sub(r"#.*", "", path.read_text(encoding="utf-8"))


def places(pattern: str) -> list[str]:
    """Where the package's code matches, a file for each time."""
    return [
        path.relative_to(PACKAGE).as_posix()
        for path in sorted(PACKAGE.rglob("*.py"))
        for _ in re.finditer(pattern, code_of(path))
    ]


def test_only_the_two_runners_look_a_mode_up():
    assert places(r"\bMode\.[A-Z]+\b") == ["run/function.py", "run/program.py"]


def test_a_submission_s_answers_are_decided_in_one_place_for_each_mode():
    assert places(r"\.problem\.answer\.check(_line)?\b") == [
        "packs/export/trial.py",  # the first failing file, as the package's own judge will find it
        "run/function.py",
        "run/program.py",
    ]
    called = set(places(r"box\.(call_many|call_series|run_program)\("))
    assert called - {"sandbox/probe.py", "sandbox/native.py"} == {
        "run/function.py",
        "run/program.py",
        "mistakes/contained.py",  # which compares trusted programs with themselves
        "packs/export/trial.py",
        "packs/foreign/judging.py",  # which has files and validators in place of cases and types
    }  # those two only look around
