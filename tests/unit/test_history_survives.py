"""What befalls a history while it is written: two judges at once, a crash, a full disk."""

from __future__ import annotations

import os
import signal

import pytest
from histories import ended, filled, started
from past_runs import past_result

from judge import database
from judge.errors import HistoryError
from judge.kata.history import History

ADD = """
sys.stdin.readline()
for number in range(int(sys.argv[1])):
    with History.open() as history:
        history.add(past_result(name=sys.argv[2]), b"shared", "")
        history.add(past_result(name=sys.argv[2]), f"{sys.argv[2]} {number}".encode(), "")
"""


def test_several_judges_write_at_once_into_a_file_that_was_not_there():
    judges = [started(ADD, 12, f"{place}.py") for place in range(4)]
    for judge in judges:
        judge.stdin.write("go\n")
        judge.stdin.flush()
    for judge in judges:
        ended(judge)
    with History.open() as history:
        runs = history.runs()
        assert [run.id for run in runs] == list(range(1, 97))
        for place in range(4):
            mine = [run for run in runs if run.submission == f"{place}.py"]
            assert [history.source(run.id) for run in mine] == [
                source for number in range(12) for source in (b"shared", f"{place}.py {number}".encode())
            ]


HOLD = """
from judge.database import writing
from judge.kata.database import HISTORY
history = History.open()
with writing(HISTORY, history._connection, history.path) as connection:
    connection.execute("INSERT INTO sources VALUES ('half', 'written')")
    connection.execute("INSERT INTO current (id, problem, path) VALUES (1, 'half', 'written')")
    print("written", flush=True)
    sys.stdin.readline()
"""


def test_a_reader_does_not_wait_for_a_writer_and_a_writer_does(own_history, monkeypatch):
    filled(own_history)
    monkeypatch.setattr(database, "_PATIENCE", 0.05)
    holder = started(HOLD)
    assert holder.stdout.readline() == "written\n"
    with History.open(reading=True) as history:
        assert len(history.runs()) == 3
        assert history.current() is None
    with History.open() as history:
        with pytest.raises(HistoryError, match="another program is writing to it"):
            history.take_up("segment", "")
        assert history.add(past_result(), b"", "") == 0  # it is kept beside the file
    ended(holder)
    with History.open() as history:
        assert history.add(past_result(), b"", "") == 5


def test_a_judge_that_is_killed_while_it_writes_leaves_the_file_as_it_was(own_history):
    filled(own_history)
    holder = started(HOLD)
    assert holder.stdout.readline() == "written\n"
    holder.send_signal(signal.SIGKILL)
    holder.communicate(timeout=60)
    with History.open(reading=True) as history:
        assert [run.id for run in history.runs()] == [1, 2, 3]
        assert history.current() is None
    with History.open() as history:
        assert history.add(past_result(), b"new", "") == 4
        assert history._rows("PRAGMA integrity_check") == [("ok",)]


def test_a_full_disk_costs_the_run_and_nothing_else(own_history):
    """The file may not grow: what SQLite says is what it says of a full disk."""
    filled(own_history)
    with History.open() as history:
        ((pages,),) = history._rows("PRAGMA page_count")
        history._rows(f"PRAGMA max_page_count = {pages}")
        with pytest.raises(HistoryError, match="the disk is full; make room"):
            history.add(past_result(), os.urandom(100_000), "")
        assert len(history.runs()) == 3
        history._rows("PRAGMA max_page_count = 1000000")
        assert history.add(past_result(), os.urandom(100_000), "") == 4
