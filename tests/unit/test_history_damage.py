"""A history of which a part is damaged: a row costs itself, a file that cannot be read is set aside."""

from __future__ import annotations

import contextlib
import os
import sqlite3
import zlib

import pytest
from histories import filled
from past_runs import past_result

from judge.errors import HistoryError
from judge.kata.answers import Rating
from judge.kata.hacks import Outcome
from judge.kata.history import History

CHANGES = {
    "runs": [
        "verdict = 'XX'",
        "time = 9223372036854775807",
        "problem = CAST(x'ff' AS TEXT)",  # a text that is no UTF-8
        "submission = 5",
        "source = x'ff'",
        "result = 'text'",
    ],
    "help": ["hints = -1"],
    "hacks": ["outcome = 'odd'"],
    "answers": ["rating = 9"],
}


@pytest.fixture
def whole(own_history):
    """A history with three rows of each kind, and a kata in hand."""
    with History.open() as history:
        for number in range(3):
            history.add(past_result(), str(number).encode(), "")
            history.see_hints("segment", number + 1)
            history.add_hack("segment", "mistake", f"case {number}", Outcome.LOST)
            history.answer("deck/card", "choice", Rating.GOOD, judged=True)
        history.take_up("segment", "/mine.py")
    return own_history


def changed(path, statement, *values):
    with contextlib.closing(sqlite3.connect(path)) as connection, connection:
        connection.execute(statement, values)


def damaged(path, share):
    """The file with its end written over; what it then holds."""
    content = path.read_bytes()
    kept = int(len(content) * share)
    path.write_bytes(content[:kept] + b"\xee" * (len(content) - kept))
    return path.read_bytes()


@pytest.mark.parametrize(("table", "change"), [(name, each) for name in CHANGES for each in CHANGES[name]])
def test_one_damaged_row_is_one_row(table, change, whole):
    changed(whole, f"UPDATE {table} SET {change} WHERE id = 2")
    with History.open(reading=True) as history:
        read = {
            "runs": history.runs,
            "help": history.helps,
            "hacks": history.hacks,
            "answers": history.answers,
        }
        assert {name: len(rows()) for name, rows in read.items()} == {
            name: 2 if name == table else 3 for name in CHANGES
        }
        assert history.left_out == {(table, 2)}
        assert history.current().problem == "segment"
        if table == "runs":
            with pytest.raises(HistoryError, match="run 2 is damaged"):
                history.run(2)
            assert history.source(3) == b"2"


def test_a_kata_in_hand_that_is_damaged_is_none(whole):
    changed(whole, "UPDATE current SET problem = CAST(x'ff' AS TEXT)")
    with History.open(reading=True) as history:
        assert history.current() is None


@pytest.mark.parametrize(
    "content", [b"[]", b'{"levels": [{"level": 5, "passed": true}]}', b'{"score": 1e999}']
)
def test_a_result_that_is_damaged_costs_its_run_where_results_are_asked_for(content, whole):
    changed(whole, "UPDATE runs SET result = ? WHERE id = 2", zlib.compress(content))
    with History.open(reading=True) as history:
        assert len(history.runs()) == 3
        assert [run.id for run in history.with_results(history.runs())] == [1, 3]


@pytest.mark.parametrize(("share", "reading"), [(0.02, False), (0.3, True)])
def test_a_file_that_cannot_be_read_is_set_aside(reading, share, own_history):
    for number in (1, 2):
        filled(own_history, runs=200)
        before = damaged(own_history, share)
        aside = own_history.with_name(f"{own_history.name}.damaged-{number}")
        with History.open(reading=reading) as history:
            assert history.runs() == []
            assert history.set_aside == aside
        assert aside.read_bytes() == before
        with History.open() as history:
            assert history.add(past_result(), b"new", "") == 1
            assert history.set_aside is None
    with History.open() as history:
        assert len(history.runs()) == 1


def test_one_whose_end_was_cut_off_is_set_aside_when_it_is_written(own_history):
    filled(own_history, runs=200)
    os.truncate(own_history, own_history.stat().st_size // 2)
    with History.open() as history:
        assert history.add(past_result(), b"new", "") == 1
        assert history.set_aside is not None


def test_two_judges_meet_it_and_the_new_one_stays(own_history):
    filled(own_history, runs=200)
    damaged(own_history, 0.3)
    with History.open() as first, History.open() as second:
        assert first.add(past_result(), b"new", "") == 1
        assert len(second.runs()) == 1
        assert second.set_aside is None
    assert own_history.with_name(f"{own_history.name}.damaged-1").exists()
    assert not own_history.with_name(f"{own_history.name}.damaged-2").exists()
    with History.open() as history:
        assert len(history.runs()) == 1


def test_another_programs_damaged_file_is_left_as_it_is(tmp_path):
    path = tmp_path / "theirs.db"
    with contextlib.closing(sqlite3.connect(path)) as connection, connection:
        connection.execute("CREATE TABLE theirs (id INTEGER)")
    before = damaged(path, 0.02)
    with pytest.raises(HistoryError), History.open(path) as history:
        history.runs()
    assert (path.read_bytes(), list(tmp_path.iterdir())) == (before, [path])
