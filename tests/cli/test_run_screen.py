"""What `judge run` shows on a real terminal and in a real pipe, and that a failure is cut to one screen.

What it shows otherwise is in the transcripts of `run/` and `screens/`.
"""

from __future__ import annotations

import io
import re

import pytest
from cli_support import FLOOR, MEAN
from msgspec.structs import replace
from sampling import nightly
from terminals import on_a_terminal

from judge.problem import Verdict
from judge.report.published_result import RunReport
from judge.report.result import screenful
from judge.report.screen import Screen, drawn
from judge.run.result import Failure, GroupResult, Pitfall, Result, earned

ESCAPE = "\x1b"
PLAIN = {"NO_COLOR": "1"}


@pytest.mark.slow
@pytest.mark.parametrize(
    ("settings", "coloured"),
    [({}, True), nightly({"NO_COLOR": "1"}, False), nightly({"TERM": "dumb"}, False)],
)
def test_a_terminal_is_coloured_unless_it_asks_for_none(settings, coloured, submit):
    status, written = on_a_terminal("run", "middle", submit(MEAN), **settings)
    assert status == 0
    assert (f"{ESCAPE}[1;32mAC{ESCAPE}[0m" in written) is coloured
    assert (ESCAPE in written) is coloured


@pytest.mark.slow
def test_a_verdict_is_said_before_it_is_explained(submit):
    _, written = on_a_terminal("run", "middle", submit(FLOOR), **PLAIN)
    said = "WA  mine.py  21 of 52 cases pass. Looking for the smallest that fails …"
    before, after = written.split(f"\r{ESCAPE}[K{said}")
    assert "WA" not in before
    assert after.startswith(f"\r{ESCAPE}[K")  # it is taken off the screen again
    assert "Smallest failing case" in after


@pytest.mark.slow
@pytest.mark.nightly
def test_the_bar_of_a_class_counts_its_files(submit):
    for name in "ab":
        submit("import time\ndef middle(a, b):\n    time.sleep(0.05)\n    return a\n", f"class/{name}.py")
    _, written = on_a_terminal("run", "-q", "middle", "class", **PLAIN, COLUMNS="100")
    assert "1 of 2: class/a.py" in written
    assert "2 of 2: class/b.py" in written


@pytest.mark.slow
@pytest.mark.parametrize(("settings", "shown"), [(PLAIN, True), ({"PYTHONIOENCODING": "latin-1"}, False)])
def test_a_picture_is_drawn_where_the_terminal_has_its_characters(settings, shown, submit):
    submit("def circle_side(cx, cy, r, P):\n    return 7\n")
    words = ("run", "circle-side", "mine.py", "--all", "--group", "examples", "--no-name")
    status, written = on_a_terminal(*words, **settings, PYTHONUTF8="0")
    assert status == 1
    assert bool(re.search("[\u2801-\u28ff]", written)) is shown
    assert "u28" not in written


# -- cut to one screen, whatever it is -----------------------------------------------------------------------


def big(digits, advice=""):
    """A result of thirty rejected groups, whose numbers have so many digits."""
    number = int("7" * digits)
    groups = [
        GroupResult(name=f"group-{at}", verdict=Verdict.WA, cases=9, passed=0, points=3) for at in range(30)
    ]
    found = Failure(
        "it is off",
        input={"a": 1, "b": number},
        expected=str(number),
        got="1",
        replay=f"some-problem:group-0:v{number}:abcdef",
    )
    return Result(
        problem="some-problem",
        submission="a/rather/long/path/to/some-submission.py",
        verdict=Verdict.WA,
        failure=Failure("it is off", "group-0", 1, {"a": number, "b": -number}, str(number), str(-number)),
        counterexample=found,
        pitfall=Pitfall(("some-mistake",), 0.9, (advice,)) if advice else None,
        **earned(groups),
    )


def screen_of(found, width):
    screen = Screen(io.StringIO(), False, width)
    return drawn(screenful(RunReport(found), screen, 23), screen)


@pytest.mark.parametrize("digits", [1, 200, 4000])
@pytest.mark.parametrize("advice", ["", "Do it otherwise. " * 4, "Do it otherwise. " * 60])
@pytest.mark.parametrize("width", [60, 200])
def test_whatever_is_long_is_cut(digits, advice, width):
    text = screen_of(big(digits, advice), width)
    assert text.count("\n") <= 23
    assert max(map(len, text.splitlines())) <= width
    assert text.startswith("WA  Wrong answer  a/rather")
    assert text.endswith("\nWA  0 of 270 cases pass, 0 of 90 points\n")
    for part in ("Smallest failing case", "expected", "got", "why"):
        assert part in text
    assert ("mistake: some-mistake" in text) == bool(advice)


def test_what_a_function_printed_is_cut_too():
    found = big(60, "Do it otherwise. " * 4)
    small = replace(found.counterexample, printed="\n".join(["x" * 160] * 6), cut_short=True)
    text = screen_of(replace(found, counterexample=small), 80)
    assert text.count("\n") <= 23
    assert "Smallest failing case; a smaller case may exist\n" in text
    assert re.search(r"^ +printed +xxx", text, re.MULTILINE)
