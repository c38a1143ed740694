"""What a stream can take: colours, links, a width; and what is written where it can take little."""

from __future__ import annotations

import io
import os
from pathlib import Path

import pytest

from judge.report.layout import Column, Link, Span, Style, Table, line
from judge.report.screen import Screen, note
from judge.report.terminal import height


class Terminal(io.StringIO):
    """A stream that says it is a terminal, and has no descriptor to ask for its width."""

    def isatty(self):
        return True


@pytest.mark.parametrize("length", [100, 1200, 1201, 100_000])
def test_the_middle_of_a_sentence_without_end_is_left_out(length, capsys):
    note("what " + "x" * (length - 12) + " remedy")
    said = capsys.readouterr().err
    assert said.startswith("judge: what xxx")
    assert said.endswith("xxx remedy\n")
    assert len(said) == len("judge: \n") + (length if length <= 1200 else 1203)
    assert (" … " in said) is (length > 1200)


LINES = [line("a ", Span("b", Style.GOOD), Span(" ", Style.BAD))]


@pytest.mark.parametrize(
    ("stream", "settings", "colour", "links", "width"),
    [
        (Terminal(), {}, True, True, 80),
        (Terminal(), {"NO_COLOR": ""}, True, True, 80),
        (Terminal(), {"NO_COLOR": "1"}, False, False, 80),
        (Terminal(), {"TERM": "dumb"}, False, False, 80),
        (Terminal(), {"TERM": "linux"}, True, False, 80),
        (Terminal(), {"COLUMNS": "50"}, True, True, 50),
        (Terminal(), {"COLUMNS": "1"}, True, True, 20),
        (Terminal(), {"COLUMNS": "wide"}, True, True, 80),
        (io.StringIO(), {}, False, False, None),
        (io.StringIO(), {"COLUMNS": "50"}, False, False, 50),
    ],
)
def test_what_a_stream_can_take(stream, settings, colour, links, width):
    screen = Screen.of(stream, settings)
    assert (screen.colour, screen.links, screen.width) == (colour, links, width)


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


def shown(laid, *, links):
    stream = io.StringIO()
    Screen(stream, False, None, links).show(laid)
    return stream.getvalue()


def test_a_link_goes_to_the_line_of_the_file(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    laid = [line("at ", Span("a b.py:3  ", link=Link("a b.py", 3)))]
    assert shown(laid, links=False) == "at a b.py:3  \n"
    address, text = shown(laid, links=True).removeprefix("at \x1b]8;;").split("\x1b\\", 1)
    assert address.startswith("file://")
    assert address.endswith(f"{tmp_path.as_posix()}/a%20b.py#3")
    assert text == "a b.py:3\x1b]8;;\x1b\\  \n"


def test_a_tables_cell_keeps_its_link_and_an_empty_one_has_none():
    table = Table((Column("name"), Column("why", flexible=True)), [[Span("x", link=Link("/x")), "word " * 9]])
    written = shown(table.lines(40), links=True)
    assert written.count("\x1b]8;;file://") == 1
    assert "/x\x1b\\x\x1b]8;;\x1b\\" in written


def test_a_name_cannot_end_its_link(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    evil = "\x1b\\\x07.py"
    written = shown([line(Span(evil, link=Link(evil)))], links=True)
    assert written.count("\x1b") == 4  # two links' beginnings and ends
    assert "\x07" not in written


def test_without_a_current_folder_there_is_no_link(tmp_path, monkeypatch):
    gone = tmp_path / "gone"
    gone.mkdir()
    monkeypatch.chdir(gone)
    gone.rmdir()
    assert shown([line(Span("x", link=Link("x.py")))], links=True) == "x\n"


def test_a_terminal_that_does_not_tell_its_height_has_the_usual_one(monkeypatch):
    monkeypatch.delenv("LINES", raising=False)
    monkeypatch.setattr("os.get_terminal_size", lambda *_: os.terminal_size((0, 0)))
    with Path(os.devnull).open("w", encoding="utf-8") as stream:
        assert height(Screen(stream, colour=False, width=80)) == 24
