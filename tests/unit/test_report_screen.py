from __future__ import annotations

import io

import pytest

from judge.report.layout import Span, Style, line
from judge.report.screen import Screen, is_terminal


class Terminal(io.StringIO):
    """A stream that says it is a terminal, and has no descriptor to ask for its width."""

    def isatty(self):
        return True


LINES = [line("a ", Span("b", Style.GOOD), Span(" ", Style.BAD))]


@pytest.mark.parametrize(
    ("stream", "settings", "colour", "width"),
    [
        (Terminal(), {}, True, 80),
        (Terminal(), {"NO_COLOR": ""}, True, 80),
        (Terminal(), {"NO_COLOR": "1"}, False, 80),
        (Terminal(), {"TERM": "dumb"}, False, 80),
        (Terminal(), {"COLUMNS": "50"}, True, 50),
        (Terminal(), {"COLUMNS": "1"}, True, 20),
        (Terminal(), {"COLUMNS": "wide"}, True, 80),
        (io.StringIO(), {}, False, None),
        (io.StringIO(), {"COLUMNS": "50"}, False, 50),
    ],
)
def test_what_a_stream_can_take(stream, settings, colour, width):
    screen = Screen.of(stream, settings)
    assert (screen.colour, screen.width) == (colour, width)


def test_colours_only_where_they_serve():
    coloured, plain = io.StringIO(), io.StringIO()
    Screen(coloured, True, None).show(LINES)
    Screen(plain, False, None).show(LINES)
    assert coloured.getvalue() == "a \x1b[32mb\x1b[0m \n"
    assert plain.getvalue() == "a b \n"


def test_a_stream_of_a_small_alphabet_is_written_all_the_same():
    raw = io.BytesIO()
    stream = io.TextIOWrapper(raw, encoding="ascii")
    Screen(stream, False, None).show([line("Δ ≤ 1")])
    assert raw.getvalue() == b"\\u0394 \\u2264 1\n"


def test_a_closed_stream_is_nobodys():
    stream = io.StringIO()
    stream.close()
    assert not is_terminal(stream)
