"""`judge try`: the exact answer to a case of one's own, and what a file says of it."""

from __future__ import annotations

import json

import pytest
from cli_support import FLOOR, MEAN
from test_run_screen import on_a_terminal

from judge.sandbox import levels

BEST = next(level.name for level in levels() if level.available)
COUNT = """\
count  Line and circle: how many common points

  input       cx=0, cy=0, r=1, A=(-1, 1), B=(1, 1)
  as a line   0 0 1 -1 1 1 1
  exact       1
"""
SEGMENT = """\
segment  Circle and segment

  input       cx=0, cy=0, r=5, A=(-6, 3), B=(6, 3.5)
  as a line   0 0 5 -6 3 6 3.5
  exact       [(-3.933965004916555629757669378817239700979,
              3.086084791461810182093430442549281679126),
              (3.663601053443418714679679777430757898552,
              3.402650043893475779778319990726281579106)]
  in doubles  [(-3.9339650049165558, 3.0860847914618104),
              (3.663601053443419, 3.402650043893476)]
  accepted    [0][0]  -3.933965010916557 to -3.933964998916554
              [0][1]  3.0860847854618085 to 3.0860847974618117
              [1][0]  3.663601047443417 to 3.6636010594434203
              [1][1]  3.402650037893474 to 3.4026500498934773
"""
PROGRAM = "for _ in range(int(input())):\n    a, b = map(float, input().split())\n    print((a + b) / 2)\n"


@pytest.fixture(autouse=True)
def _eighty(monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")


@pytest.mark.parametrize("words", [("0, 0, 1, (-1, 1), (1, 1)",), ("0", "0", "1", "-1", "1", "1", "1")])
def test_a_count(judge, words):
    ended = judge("try", "count", *words)
    assert (ended.status, ended.out, ended.err) == (0, COUNT, "")


def test_numbers_have_their_interval(judge):
    ended = judge("try", "segment", "0, 0, 5, (-6, 3), (6, 3.5)")
    assert (ended.status, ended.err) == (0, "")
    assert ended.out == SEGMENT


def test_a_number_by_itself_and_none(judge):
    assert judge("try", "ray-nearest", "0 0 1 -3 0 2 0").lines[2:] == [
        "  input       cx=0, cy=0, r=1, O=(-3, 0), D=(2, 0)",
        "  as a line   0 0 1 -3 0 2 0",
        "  exact       1",
        "  in doubles  1.0",
        "  accepted    0.999999999 to 1.0000000009999999",
    ]
    assert judge("try", "ray-nearest", "0 0 1 3 0 2 0").lines[4:] == ["  exact       None"]


def test_another_groups_tolerance(judge):
    words = ("try", "ray-nearest", "0 0 1 -3 0 2 0")
    assert judge(*words, "--group", "cancellation").lines[-1] == (
        "  accepted    0.9999999999999929 to 1.000000000000007"
    )
    ended = judge(*words, "--group", "cancelation")
    assert (ended.status, ended.err) == (
        2,
        "judge: ray-nearest has no group 'cancelation'; did you mean 'cancellation'?\n",
    )


@pytest.mark.parametrize(
    ("source", "status", "told"),
    [
        (MEAN, 0, ["  got         1.5", "", "AC  accepted, mine.py"]),
        (PROGRAM, 0, ["  got         1.5", "", "AC  accepted, mine.py"]),
        (FLOOR, 1, ["", "WA  wrong answer, mine.py"]),
        (
            "def middle(a, b):\n    return a / 0\n",
            1,
            [
                "  got         no answer",
                "  why         ZeroDivisionError: division by zero (line 2)",
                "",
                "RTE  run-time error, mine.py",
            ],
        ),
        ("def middle(a, b)\n", 1, ["", "CE  does not compile, mine.py"]),
        ("print('x')\n", 1, ["", "WA  wrong answer, mine.py"]),
        ("print(1)\nprint(2)\n", 1, ["", "WA  wrong answer, mine.py"]),
        ("raise SystemExit(3)\n", 1, ["", "RTE  run-time error, mine.py"]),
    ],
)
def test_what_a_file_says(judge, submit, source, status, told):
    ended = judge("try", "middle", "1, 2", submit(source))
    assert (ended.status, ended.err) == (status, "")
    assert ended.lines[-len(told) :] == told
    assert "  exact       1.5" in ended.lines


def test_json(judge, submit):
    (line,) = judge("try", "middle", "a=1, b=2", submit(FLOOR), "--json").lines
    assert json.loads(line) == {
        "schema": 1,
        "problem": "middle",
        "group": None,
        "input": {"a": 1, "b": 2},
        "line": "1 2",
        "exact": "1.5",
        "expected": "1.5",
        "accepted": json.loads(line)["accepted"],
        "said": {
            "submission": "mine.py",
            "mode": "function",
            "verdict": "WA",
            "got": "1",
            "message": "the answer is off by 0.5, relative error 0.33 (2.25e+15 ulps)",
            "isolation": BEST,
        },
    }
    low, high = json.loads(line)["accepted"]
    assert low <= 1.5 <= high
    (line,) = judge("try", "middle", "1 2", "--json").lines
    assert json.loads(line)["said"] is None


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("count",), "this is no case of count: it is empty; write cx, cy, r, A, B as Python arguments"),
        (
            ("test-writer", ""),
            "cases() of test-writer takes nothing, so there is no case; 'judge run test-writer FILE'",
        ),
        (("test-writer", "[1]"), "takes nothing, so there is no case"),
        (("count", "0 0 1 0 0"), "this is no case of count: the line ends before B is whole"),
        (
            ("count", "0 0 -1 0 0 1 1"),
            "r has -1, outside 0 to 1073741824; 'judge show count' tells the bounds",
        ),
        (("count", "0 0 1e-40 0 0 1 1"), "r has 1e-40, nearer to 0 than 1e-30 but not 0"),
        (("count", "0, 0, 1, (-1, 1.00000001), (1, 1.00000001)"), "inside the forbidden band"),
        (("count", "0, 0, '1', (0, 0), (1, 1)"), "r has '1', a str, where a number is meant"),
        (("count", "0, 0, 1, (0, 0, 0), (1, 1)"), "A must be a pair of numbers, not (0, 0, 0)"),
        (("count", "mine.py"), "this is no case of count: it is empty"),
        (("count", "0 0 1 -1 1 1 1", "gone.py"), "gone.py: no such file"),
        (("count", "--jsn", "0 0 1 -1 1 1 1"), "no such option '--jsn'; see 'judge try --help'"),
        (("cuont", "1 2"), "did you mean 'count'?"),
    ],
)
def test_what_cannot_be_tried_is_one_line(judge, submit, words, told):
    submit(MEAN)
    ended = judge("try", *words)
    assert (ended.status, ended.out, len(ended.err.splitlines())) == (2, "", 1), ended
    assert told in ended.err
    assert ended.err.startswith("judge: ")


def test_a_negative_number_first_is_no_option(judge):
    assert judge("try", "middle", "-1", "-2").lines[2] == "  input       a=-1, b=-2"
    assert judge("try", "middle", "-1 -2").lines[2] == "  input       a=-1, b=-2"


def test_the_picture(judge, submit, tmp_path):
    wrong = submit("def circle_segment(cx, cy, r, A, B):\n    return [(0, 3)]\n", "wrong.py")
    ended = judge("try", "segment", "0, 0, 5, (-6, 3), (6, 3)", wrong, "--svg", "case.svg")
    assert (ended.status, ended.err) == (1, "")
    drawn = (tmp_path / "case.svg").read_text()
    assert drawn.startswith("<svg")
    assert "your case" in drawn
    _, written = on_a_terminal("try", "segment", "0, 0, 5, (-6, 3), (6, 3)", wrong, NO_COLOR="1")
    assert "o wanted" in written
    assert "x got" in written
    assert len(written.splitlines()) <= 24


def test_no_picture_is_a_line(judge, tmp_path):
    ended = judge("try", "middle", "1 2", "--svg", "case.svg")
    assert ended.status == 0
    assert ended.err == "judge: nothing to draw, case.svg is not written: the problem has no picture of it\n"
    assert not (tmp_path / "case.svg").exists()
