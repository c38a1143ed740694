"""What `judge run` shows on a real terminal and in a real pipe, and that a failure is cut to one screen.

What it shows otherwise is in the transcripts of `run/` and `screens/`.
"""

from __future__ import annotations

import re

import pytest
from cli_support import MEAN
from msgspec.structs import replace
from sampling import nightly
from terminals import on_a_terminal

from judge.problem import Verdict
from judge.report.glance import glance_lines, taken
from judge.report.layout import printable
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
    assert (f"{ESCAPE}[32mAC{ESCAPE}[0m" in written) is coloured
    assert (ESCAPE in written) is coloured


@pytest.mark.slow
@pytest.mark.nightly
def test_the_bar_of_a_class_counts_its_files(submit):
    for name in "ab":
        submit("import time\ndef middle(a, b):\n    time.sleep(0.05)\n    return a\n", f"class/{name}.py")
    _, written = on_a_terminal("run", "-q", "middle", "class", **PLAIN, COLUMNS="100")
    assert "1 of 2: class/a.py" in written
    assert "2 of 2: class/b.py" in written


@pytest.mark.slow
@pytest.mark.parametrize(("settings", "drawn"), [(PLAIN, True), ({"PYTHONIOENCODING": "latin-1"}, False)])
def test_a_picture_is_drawn_where_the_terminal_has_its_characters(settings, drawn, submit):
    submit("def circle_side(cx, cy, r, P):\n    return 7\n")
    words = ("run", "circle-side", "mine.py", "--picture", "--group", "examples", "--no-name")
    status, written = on_a_terminal(*words, **settings, PYTHONUTF8="0")
    assert status == 1
    assert bool(re.search("[\u2801-\u28ff]", written)) is drawn
    assert "u28" not in written


# -- cut to one screen, whatever it is -----------------------------------------------------------------------


def big(digits, advice=""):
    """A result of thirty rejected groups, whose numbers have so many digits."""
    number = int("7" * digits)
    case = {"a": number, "b": -number}
    groups = [
        GroupResult(name=f"group-{at}", verdict=Verdict.WA, cases=9, passed=0, points=3) for at in range(30)
    ]
    failure = Failure("it is off", "group-0", 1, case, str(number), str(-number))
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
        failure=failure,
        counterexample=found,
        **earned(groups),
        pitfall=Pitfall(("some-mistake",), 0.9, (advice,), lines=(("a = 1\nb = 2", "b = 1"),))
        if advice
        else None,
    )


@pytest.mark.parametrize("digits", [1, 200, 4000])
@pytest.mark.parametrize("advice", ["", "Do it otherwise. " * 4, "Do it otherwise. " * 60])
@pytest.mark.parametrize("width", [60, 200])
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
    printed = "\n".join(["x" * 160] * 6)
    found = replace(result.counterexample, printed=printed, cut_short=True)
    lines = glance_lines(replace(result, counterexample=found), 80, 23)
    text = "\n".join("".join(span.text for span in laid) for laid in lines)
    assert taken(lines, 80) <= 23
    assert "smallest case found, the search was cut short\n" in text
    assert re.search(r"^    printed +xxx", text, re.MULTILINE)
