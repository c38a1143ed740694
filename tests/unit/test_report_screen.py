"""Text on a screen: wrapped, in columns and tables, values in words, and what a stream can take."""

from __future__ import annotations

import io

import pytest

from judge.report.layout import Column, Link, Span, cells, line, printable, wrap
from judge.report.screen import Screen, note


@pytest.mark.parametrize(
    ("text", "width", "rows"),
    [
        ("", 10, [""]),
        ("one two three", 7, ["one two", "three"]),
        ("one\ntwo", 10, ["one", "two"]),
        ("A=(1, 2), B=(3, 4)", 12, ["A=(1, 2),", "B=(3, 4)"]),
        ("1234567890123", 5, ["12345", "67890", "123"]),
        ("some-long-name", 8, ["some-", "long-", "name"]),
        ("日本語", 4, ["日本", "語"]),
    ],
)
def test_wrapping(text, width, rows):
    assert wrap(text, width) == rows


def test_wrapping_loses_nothing():
    text = "cx=-669.32545866, A=(-1890.442842675294, -1514.9179835211764), B=(1" + "0" * 100 + ", 4)"
    for width in range(1, 90):
        rows = wrap(text, width)
        assert "".join(rows).replace(" ", "") == text.replace(" ", "")
        assert max(map(cells, rows)) <= width


def test_whatever_steers_a_terminal_is_written_out():
    assert printable("a\x1b[31m\tb\x00\u202e\ud800é") == r"a\x1b[31m\tb\x00\u202e\ud800é"


COLUMNS = (Column("name"), Column("cases", right=True), Column("about", flexible=True))


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
    ("stream", "settings", "colour", "links", "width"),
    [
        (Terminal(), {}, True, True, 80),
        (Terminal(), {"NO_COLOR": "1"}, False, False, 80),
        (Terminal(), {"TERM": "dumb"}, False, False, 80),
        (Terminal(), {"TERM": "linux"}, True, False, 80),
        (Terminal(), {"COLUMNS": "50"}, True, True, 50),
        (Terminal(), {"COLUMNS": "wide"}, True, True, 80),
        (io.StringIO(), {}, False, False, None),
    ],
)
def test_what_a_stream_can_take(stream, settings, colour, links, width):
    screen = Screen.of(stream, settings)
    assert (screen.colour, screen.links, screen.width) == (colour, links, width)


def test_a_stream_of_a_small_alphabet_is_written_all_the_same():
    raw = io.BytesIO()
    stream = io.TextIOWrapper(raw, encoding="ascii")
    Screen(stream, False, None).show([line("Δ ≤ 1")])
    assert raw.getvalue() == b"\\u0394 \\u2264 1\n"


def shown(laid, *, links):
    stream = io.StringIO()
    Screen(stream, False, None, links).show(laid)
    return stream.getvalue()


def test_a_name_cannot_end_its_link(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    evil = "\x1b\\\x07.py"
    written = shown([line(Span(evil, link=Link(evil)))], links=True)
    assert written.count("\x1b") == 4  # two links' beginnings and ends
    assert "\x07" not in written
