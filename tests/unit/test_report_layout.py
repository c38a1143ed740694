from __future__ import annotations

from datetime import UTC, datetime

import pytest

from judge.kata.history import Run
from judge.problem import Verdict
from judge.report.history import history_lines
from judge.report.layout import (
    Column,
    Span,
    Style,
    Table,
    beside,
    cells,
    hanging,
    pad,
    printable,
    wrap,
)
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


def test_a_hanging_indent():
    lines = hanging(Span("why"), Span("one two three"), 16, indent=2, column=8)
    assert texts(lines) == ["  why   one two", "        three"]


def test_a_remark_goes_below_where_there_is_no_room_beside():
    assert texts(beside(Span("name"), "remark", None)) == ["name  remark"]
    assert texts(beside(Span("name"), "remark", 12)) == ["name  remark"]
    assert texts(beside(Span("name"), "remark", 11)) == ["name", "remark"]


COLUMNS = (Column("name"), Column("cases", right=True), Column("about", flexible=True))
ROWS = [["tangent-turned", "60", "rounding has moved every number a little"], [Span("grid"), "343", "small"]]


def test_a_table_with_room():
    assert texts(Table(COLUMNS, ROWS).lines(None)) == [
        "  name            cases  about",
        "  tangent-turned     60  rounding has moved every number a little",
        "  grid              343  small",
    ]


def test_prose_is_wrapped_in_its_column():
    assert texts(Table(COLUMNS, ROWS).lines(50)) == [
        "  name            cases  about",
        "  tangent-turned     60  rounding has moved every",
        "                         number a little",
        "  grid              343  small",
    ]


def test_prose_goes_below_its_row():
    assert texts(Table(COLUMNS, ROWS).lines(30)) == [
        "  name            cases",
        "  tangent-turned     60",
        "    rounding has moved every",
        "    number a little",
        "  grid              343",
        "    small",
    ]


def test_names_are_broken():
    assert texts(Table(COLUMNS[:2], [row[:2] for row in ROWS]).lines(17)) == [
        "  name      cases",
        "  tangent-     60",
        "  turned",
        "  grid        343",
    ]


def test_at_last_a_row_is_a_paragraph():
    assert texts(Table(COLUMNS, ROWS).lines(16)) == [
        "  tangent-",
        "  turned",
        "    cases 60",
        "    rounding has",
        "    moved every",
        "    number a",
        "    little",
        "  grid",
        "    cases 343",
        "    small",
    ]


def test_a_mark_without_a_title_is_no_gap_in_a_paragraph():
    columns = (Column("row"), Column(""), Column("drill with"), Column("question", flexible=True))
    rows = [["Q1", "", "judge init exact-count", "How many?"], ["Q2", "✓", "judge init foot", "Where is it?"]]
    assert texts(Table(columns, rows).lines(26)) == [
        "  Q1",
        "    drill with judge init",
        "    exact-count",
        "    How many?",
        "  Q2",
        "    ✓, drill with judge",
        "    init foot",
        "    Where is it?",
    ]


def test_no_table_is_wider_than_its_room():
    for width in range(14, 90):
        assert max(map(cells, texts(Table(COLUMNS, ROWS).lines(width)))) <= width


def test_a_table_keeps_styles_and_ends_no_line_in_spaces():
    lines = Table((Column(""), Column("")), [[Span("a", Style.BAD), ""]], indent=0).lines(20)
    assert lines == [(Span(""), Span("a", Style.BAD))]


def test_a_remark_that_has_no_room_stands_below_its_head_and_as_far_in():
    laid = beside(Span("  two mistakes: one + other"), "likely, score 0.87", 20)
    rows = ["".join(span.text for span in each) for each in laid]
    assert rows == ["  two mistakes: one", "  + other", "  likely, score 0.87"]


def past_run(number, problem, file, verdict, mistake, *, when=datetime(2026, 3, 1, 9, tzinfo=UTC)):
    score = 100 if verdict is Verdict.AC else 88
    failed = () if verdict is Verdict.AC else ("grid",)
    ratio = 12.3 if verdict is Verdict.AC else None
    return Run(
        number, when, problem, file, "", verdict, score, Mode.FUNCTION, "", mistake, ratio, (), failed, b""
    )


@pytest.mark.parametrize("file", ["mine.py", "ray_nearest.py"])
def test_a_run_of_the_history_is_one_row_of_80_columns(file):
    runs = [
        past_run(998, "segment", "segment.py", Verdict.AC, None),
        past_run(999, "ray-nearest", file, Verdict.WA, "absolute-epsilon"),
    ]
    rows = texts(history_lines(runs, 80))
    assert len(rows) == 1 + len(runs)
    assert max(map(len, rows)) <= 80
    assert rows[1].endswith("AC 12 ×")
    assert ("file" in rows[0]) == (file == "mine.py"), "a usual name says nothing"


def test_a_run_of_another_year_shows_it():
    runs = [
        past_run(1, "count", "count.py", Verdict.AC, None, when=datetime(2024, 3, 1, 9, tzinfo=UTC)),
        past_run(2, "count", "count.py", Verdict.AC, None),
    ]
    assert [row.split()[1] for row in texts(history_lines(runs, 80))[1:]] == ["2024-03-01", "03-01"]


@pytest.mark.parametrize("width", [100, 101, 140, 400])
def test_no_paragraph_runs_past_a_hundred_columns(width):
    text = "so many words " * 40
    paragraphs = [
        *hanging(Span("why"), Span(text), width, indent=4, column=12),
        *beside(Span(text), "", width),
        *beside(Span(text), text, width),
    ]
    assert 90 < max(map(len, texts(paragraphs))) <= 100
