"""Text on a screen: wrapped, in columns and tables, values in words, and what a stream can take."""

from __future__ import annotations

import io
import json
import os
from datetime import UTC, datetime
from fractions import Fraction
from pathlib import Path

import pytest

from judge.kata.history import Run
from judge.problem import Verdict
from judge.report.history import history_lines
from judge.report.layout import (
    Column,
    Link,
    Span,
    Style,
    Table,
    beside,
    cells,
    hanging,
    line,
    pad,
    printable,
    wrap,
)
from judge.report.screen import Screen, note
from judge.report.terminal import height
from judge.report.values import arguments, bound, counted, seconds, size, with_points
from judge.run.result import Mode


def texts(lines):
    return ["".join(span.text for span in spans) for spans in lines]


@pytest.mark.parametrize(
    ("text", "width", "rows"),
    [
        ("", 10, [""]),
        ("one two three", None, ["one two three"]),
        ("one two three", 7, ["one two", "three"]),
        ("one\ntwo", 10, ["one", "two"]),
        ("A=(1, 2), B=(3, 4)", 12, ["A=(1, 2),", "B=(3, 4)"]),
        ("A=(1, 2), B=(3, 4)", 6, ["A=(1,", "2),", "B=(3,", "4)"]),
        ("1234567890123", 5, ["12345", "67890", "123"]),
        ("some-long-name", 8, ["some-", "long-", "name"]),
        ("a (never closed", 6, ["a", "(never", "closed"]),
        ("日本語", 4, ["日本", "語"]),
        ("日", 1, ["日"]),
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


@pytest.mark.parametrize(("text", "columns"), [("abc", 3), ("é", 1), ("e\u0301", 1), ("日本", 4), ("", 0)])
def test_columns(text, columns):
    assert cells(text) == columns
    assert cells(pad(text, 6)) == cells(pad(text, 6, right=True)) == 6


COLUMNS = (Column("name"), Column("cases", right=True), Column("about", flexible=True))
ROWS = [["tangent-turned", "60", "rounding has moved every number a little"], [Span("grid"), "343", "small"]]


def test_no_table_is_wider_than_its_room():
    for width in range(14, 90):
        assert max(map(cells, texts(Table(COLUMNS, ROWS).lines(width)))) <= width


def test_a_table_keeps_styles_and_ends_no_line_in_spaces():
    lines = Table((Column(""), Column("")), [[Span("a", Style.BAD), ""]], indent=0).lines(20)
    assert lines == [(Span(""), Span("a", Style.BAD))]


def past_run(number, problem, file, verdict, mistake, year=2026):
    accepted = verdict is Verdict.AC
    return Run(
        number, datetime(year, 3, 1, 9, tzinfo=UTC), problem, file, "", verdict, 100 if accepted else 88,
        Mode.FUNCTION, "", mistake, 12.3 if accepted else None, (), () if accepted else ("grid",), b"",
    )  # fmt: skip


@pytest.mark.parametrize("file", ["mine.py", "ray_nearest.py"])
def test_a_run_of_the_history_is_one_row_of_80_columns_and_one_of_another_year_shows_it(file):
    runs = [
        past_run(998, "segment", "segment.py", Verdict.AC, None, year=2024),
        past_run(999, "ray-nearest", file, Verdict.WA, "absolute-epsilon"),
    ]
    rows = texts(history_lines(runs, 80))
    assert len(rows) == 1 + len(runs)
    assert max(map(len, rows)) <= 80
    assert rows[1].endswith("AC 12 ×")
    assert ("file" in rows[0]) == (file == "mine.py"), "a usual name says nothing"
    assert [row.split()[1] for row in rows[1:]] == ["2024-03-01", "03-01"]


@pytest.mark.parametrize("width", [100, 101, 140, 400])
def test_no_paragraph_runs_past_a_hundred_columns(width):
    text = "so many words " * 40
    paragraphs = [
        *hanging(Span("why"), Span(text), width, indent=4, column=12),
        *beside(Span(text), "", width),
        *beside(Span(text), text, width),
    ]
    assert 90 < max(map(len, texts(paragraphs))) <= 100


# -- values in words -----------------------------------------------------------------------------------------


def test_arguments_are_written_in_full():
    values = {"cx": 0, "r": 0.1, "A": (10**40, -2.5), "B": [(1, 2), (3, 4)], "w": "lit"}
    assert arguments(values) == f"cx=0, r=0.1, A=({10**40}, -2.5), B=[(1, 2), (3, 4)], w='lit'"
    assert arguments(with_points(json.loads(json.dumps(values)))) == arguments(values)
    assert arguments({"xs": [0] * 41}).endswith("0, …] (41 items)")


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (Fraction(0), "0"),
        (Fraction(-1000), "-1000"),
        (Fraction(2**30), "2^30"),
        (Fraction(-(2**30)), "-2^30"),
        (Fraction(10**120), "10^120"),
        (Fraction(-(10**6000)), "-10^6000"),
        (Fraction(123456), "123,456"),
        (Fraction(10**5000 + 1), "1" + "0" * 4999 + "1"),
        (Fraction(1, 10**12), "1e-12"),
        (Fraction(1, 2**40), str(Fraction(1, 2**40))),
        (Fraction(1, 3), "1/3"),
        (Fraction(5, 2), "2.5"),
    ],
)
def test_bounds(value, text):
    assert bound(value) == text


def test_amounts():
    numbers = [counted(number, "case") for number in (0, 1, 2, 1240)]
    assert numbers == ["0 cases", "1 case", "2 cases", "1,240 cases"]
    times = [seconds(value) for value in (0.0, 0.0004, 0.0123, 0.9, 2.5)]
    assert times == ["0.0 ms", "0.4 ms", "12 ms", "900 ms", "2.50 s"]
    assert size(256 * 2**20) == "256 MB"


# -- what a stream can take ----------------------------------------------------------------------------------


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
