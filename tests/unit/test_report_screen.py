"""Text on a screen: what a stream can take, and what it is spared."""

from __future__ import annotations

import io

import pytest

from judge.problem import Verdict
from judge.report.screen import Screen, note
from judge.report.tell import tell
from judge.report.words import printable
from judge.run.result import Failure, Growth, Ratio, Result, Timing


def test_whatever_steers_a_terminal_is_written_out():
    assert printable("a\x1b[31m\tb\x00\u202e\ud800é") == r"a\x1b[31m\tb\x00\u202e\ud800é"


# -- what a stream can take ----------------------------------------------------------------------------------


class Terminal(io.StringIO):
    """A stream that says it is a terminal, and has no descriptor to ask for its width."""

    def isatty(self):
        return True


@pytest.mark.parametrize("length", [1200, 1201])
def test_the_middle_of_a_sentence_without_end_is_left_out(length, capsys):
    note("what " + "x" * (length - 12) + " remedy")
    said = capsys.readouterr().err
    assert said.startswith("judge: what xxx")
    assert said.endswith("xxx remedy\n")
    assert len(said) == len("judge: \n") + (length if length <= 1200 else 1203)
    assert (" … " in said) is (length > 1200)


@pytest.mark.parametrize(
    ("stream", "settings", "colour", "width"),
    [
        (Terminal(), {}, True, 80),
        (Terminal(), {"NO_COLOR": "1"}, False, 80),
        (Terminal(), {"TERM": "dumb"}, False, 80),
        (Terminal(), {"COLUMNS": "50"}, True, 50),
        (Terminal(), {"COLUMNS": "wide"}, True, 80),
        (io.StringIO(), {}, False, None),
    ],
)
def test_what_a_stream_can_take(stream, settings, colour, width, monkeypatch):
    monkeypatch.setattr("os.environ", settings)
    screen = Screen.of(stream)
    assert (screen.colour, screen.width) == (colour, width)


def test_a_stream_of_a_small_alphabet_is_written_all_the_same():
    raw = io.BytesIO()
    stream = io.TextIOWrapper(raw, encoding="ascii")
    Screen(stream, False, None).write("Δ ≤ 1\n")
    assert raw.getvalue() == b"\\u0394 \\u2264 1\n"


def test_a_long_sentence_is_wrapped_at_words_beside_its_label(monkeypatch):
    stream = Terminal()
    monkeypatch.setattr("sys.stderr", stream)
    monkeypatch.setenv("COLUMNS", "40")
    monkeypatch.setenv("NO_COLOR", "1")
    note("There is no command of that name. judge --help shows the commands")
    assert stream.getvalue() == (
        "judge: There is no command of that name.\n       judge --help shows the commands\n"
    )


def test_what_is_too_slow_by_its_growth_alone_is_told_so():
    """A ratio below its limit is no reason."""
    growth = Growth(1.9, 1.1, 0.4, ("small", "long"), 2)
    failure = Failure("it grows like n^1.9", "long")
    for limit, begins in ((30.0, "Too slow in long: Your time grows"), (1.5, "Too slow in long: 1.7 ×")):
        timing = Timing(ratio=Ratio(1.7, 1.6, 1.8, 5, limit), growth=growth)
        late = Result(problem="k", submission="a.py", verdict=Verdict.TLE, failure=failure, time=timing)
        assert tell(None, late).time.startswith(begins)
