"""What `judge run` shows of a failure fits a screen of 80 × 24, with the verdict first and last."""

from __future__ import annotations

import re

import pytest
from cli_support import FLOOR, ROOT
from mistaken import mistaken
from msgspec.structs import replace

from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.report.glance import glance_lines, taken
from judge.report.layout import printable
from judge.run.result import Failure, GroupResult, Mode, Pitfall, Result

pytestmark = pytest.mark.slow

WHERE = ("--problems", str(ROOT / "problems"), "--isolation", "limits")
LINES = (("a = 1\nb = 2", "b = 1"),)
GOLDEN = """\
WA  mine.py  middle, its function called

  group     verdict  passed   points
  examples  WA          1/2  0 of 10
  half      WA         0/30  0 of 50
  1 group accepted

  smallest case found
    input   a=0, b=1
    wanted  0.5
    got     0
    why     the answer is off by 0.5, relative error 1 (4.5e+15 ulps)
    again   judge replay middle:examples:… mine.py

  floor-division  likely, score 0.97
    It rounds the middle down. Divide with `/`.

  more  judge why middle examples, judge hint middle, --all

WA  wrong answer, 40 of 100 points, 21 of 52 cases, …
"""


def masked(text):
    text = re.sub(r"(judge replay \w+:\w+:)\S+", r"\1…", text)
    return re.sub(r"cases, [\d.]+ .*", "cases, …", text)


def test_the_screen_of_a_failure(judge, submit, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    assert masked(judge("run", "middle", submit(FLOOR)).out) == GOLDEN


@pytest.mark.parametrize("name", ["absolute-epsilon", "cancellation", "forgotten-abs", "swapped-answers"])
def test_a_mistake_in_count_fits_with_its_name(name, judge, submit, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    ended = judge("run", "count", submit(mistaken("count", name)), *WHERE)
    rows = sum(-(-max(len(row), 1) // 80) for row in ended.lines)
    assert rows <= 23, ended.out
    assert ended.lines[0].startswith("WA  mine.py  count")
    assert ended.lines[-1].startswith(("WA  wrong answer", "    "))
    for part in ("smallest case found", "wanted", "got", "judge replay", f"  {name}", "judge why count"):
        assert part in ended.out
    assert not re.search(r"^  \S+ +AC ", ended.out, re.MULTILINE)
    whole = judge("run", "count", "mine.py", "--all", *WHERE)
    assert len(re.findall(r"^  \S+ +(?:AC|WA) ", whole.out, re.MULTILINE)) == len(
        find_problem("count").groups
    )


def big(digits, advice=""):
    """A result of thirty rejected groups, whose numbers have so many digits."""
    number = int("7" * digits)
    case = {"a": number, "b": -number}
    groups = tuple(GroupResult(f"group-{at}", Verdict.WA, 9, 0, None, 0.1, 3) for at in range(30))
    failure = Failure("it is off", "group-0", 1, case, str(number), str(-number))
    found = {"input": {"a": 1, "b": number}, "expected": str(number), "got": "1", "message": "it is off"}
    return Result(
        "some-problem",
        "a/rather/long/path/to/some-submission.py",
        Mode.FUNCTION,
        Verdict.WA,
        groups,
        failure,
        counterexample=found | {"replay": f"some-problem:group-0:v{number}:abcdef"},
        pitfall=Pitfall(("some-mistake",), 0.9, (advice,), lines=(("a = 1\nb = 2", "b = 1"),))
        if advice
        else None,
    )


@pytest.mark.parametrize("digits", [1, 60, 200, 1000, 4000])
@pytest.mark.parametrize("advice", ["", "Do it otherwise. " * 4, "Do it otherwise. " * 60])
@pytest.mark.parametrize("width", [60, 80, 200])
def test_whatever_is_long_is_cut(digits, advice, width):
    lines = glance_lines(big(digits, advice), width, 23)
    assert taken(lines, width) <= 23
    text = "\n".join("".join(printable(span.text) for span in laid) for laid in lines)
    assert text.startswith("WA  a/rather")
    assert "\nWA  wrong answer" in text
    for part in ("group-0", "more rejected", "smallest case found", "wanted", "got", "again"):
        assert part in text
    assert ("some-mistake" in text) == bool(advice)


def test_what_a_function_printed_is_cut_too():
    result = big(60, "Do it otherwise. " * 4)
    found = {**(result.counterexample or {}), "printed": "\n".join(["x" * 160] * 6), "cut_short": True}
    lines = glance_lines(replace(result, counterexample=found), 80, 23)
    text = "\n".join("".join(span.text for span in laid) for laid in lines)
    assert taken(lines, 80) <= 23
    assert "smallest case found, the search was cut short\n" in text
    assert re.search(r"^    printed +xxx", text, re.MULTILINE)


def test_a_program_that_cannot_read_its_input_is_told_its_form(judge, submit):
    ended = judge("run", "middle", submit("n, a, b = map(int, input().split())\n", "program.py"))
    form = "its input is a line with the number of cases, then one line each: a b, here "
    assert form in " ".join(ended.out.split())


def test_the_first_case_is_shown_where_there_is_no_smaller_one(judge, submit):
    ended = judge("run", "middle", submit(FLOOR), "--no-shrink")
    assert "  examples, case 1" in ended.lines
    assert "smallest case" not in ended.out
    source = "def middle(a, b):\n    return (a + b) / 2 if (a, b) != (1, 2) else 0\n"
    ended = judge("run", "middle", submit(source))
    assert len(re.findall(r"^    input ", ended.out, re.MULTILINE)) == 1
