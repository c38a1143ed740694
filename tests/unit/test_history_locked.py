"""A history while it is written: two judges at once, a crash, a full disk, a lock that is held for long."""

from __future__ import annotations

import contextlib
import os
import shutil
import signal
import sqlite3

import msgspec
import pytest
from histories import ended, filled, started
from past_runs import past_result

from judge import database
from judge.errors import HistoryError
from judge.kata.answers import Rating
from judge.kata.hacks import Outcome
from judge.kata.history import History, add_beside


@pytest.fixture(autouse=True)
def _impatient(monkeypatch):
    monkeypatch.setattr(database, "_PATIENCE", 0.05)


ADD = """
sys.stdin.readline()
for number in range(int(sys.argv[1])):
    with History.open() as history:
        history.add(past_result(name=sys.argv[2]), b"shared", "")
        history.add(past_result(name=sys.argv[2]), f"{sys.argv[2]} {number}".encode(), "")
"""


def test_several_judges_write_at_once_into_a_file_that_was_not_there():
    judges = [started(ADD, 5, f"{place}.py") for place in range(4)]
    for judge in judges:
        judge.stdin.write("go\n")
        judge.stdin.flush()
    for judge in judges:
        ended(judge)
    with History.open() as history:
        runs = history.runs()
        assert [run.id for run in runs] == list(range(1, 41))
        for place in range(4):
            mine = [run for run in runs if run.submission == f"{place}.py"]
            assert [history.source(run.id) for run in mine] == [
                source for number in range(5) for source in (b"shared", f"{place}.py {number}".encode())
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


def test_a_reader_does_not_wait_for_a_writer_and_a_writer_does(own_history):
    filled(own_history)
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


@contextlib.contextmanager
def locked(path, how="IMMEDIATE"):
    with contextlib.closing(sqlite3.connect(path, isolation_level=None)) as connection:
        if how == "EXCLUSIVE":
            connection.execute("PRAGMA locking_mode = EXCLUSIVE")
        connection.execute(f"BEGIN {how}")
        connection.execute("CREATE TABLE never (kept)")
        yield
        connection.execute("ROLLBACK")


def waiting(path):
    folder = path.with_name(f"{path.name}.waiting")
    return sorted(folder.iterdir()) if folder.exists() else []


def test_what_is_added_waits_beside_it_and_goes_in_when_it_is_next_opened(own_history):
    filled(own_history)
    with locked(own_history), History.open() as history:
        assert history.add(past_result(name="late.py"), b"late", "/late.py") == 0
        history.see_hints("segment", 2)
        history.add_hack("segment", "mistake", "case", Outcome.WON)
        history.answer("deck/card", "choice", Rating.GOOD, judged=True)
        assert (history.waiting, len(history.runs())) == (4, 3)
        assert len(waiting(own_history)) == 4
    with History.open(reading=True) as history:
        run = history.runs()[-1]
        assert (run.id, run.submission, run.path, history.source(4)) == (4, "late.py", "/late.py", b"late")
        assert (history.hints_seen("segment"), len(history.hacks()), len(history.answers())) == (2, 1, 1)
    assert not own_history.with_name(f"{own_history.name}.waiting").exists()


def test_a_row_is_taken_in_once_though_a_judge_was_killed_before_it_took_the_file_away(own_history, tmp_path):
    filled(own_history)
    with locked(own_history), History.open() as history:
        for number in range(3):
            history.add(past_result(), f"late {number}".encode(), "")
    folder = own_history.with_name(f"{own_history.name}.waiting")
    shutil.copytree(folder, tmp_path / "kept")
    for _ in range(2):
        with History.open() as history:
            assert len(history.runs()) == 6
        shutil.copytree(tmp_path / "kept", folder)


def test_a_file_that_cannot_even_be_opened(own_history):
    filled(own_history)
    with locked(own_history, "EXCLUSIVE"):
        with pytest.raises(HistoryError, match="another program is writing") as refused, History.open():
            pass
        assert database.is_busy(refused.value)
        add_beside(None, past_result(name="late.py"), b"late", "", refused.value)
    with History.open() as history:
        assert history.runs()[-1].submission == "late.py"


def test_what_no_judge_wrote_keeps_no_row_out_and_hangs_nobody(own_history):
    filled(own_history)
    folder = own_history.with_name(f"{own_history.name}.waiting")
    folder.mkdir()
    rows = [
        ["help", [2**64 - 1, "count", 1]],
        ["help", [None, None, None]],
        ["help", [1, "count", -5]],
        ["runs", [1] * 13],
        ["sources", [b"body"]],
        ["current", ["count", b"", b""]],
    ]
    for number, (table, row) in enumerate(rows):
        (folder / f"0{number}.row").write_bytes(msgspec.msgpack.encode({"table": table, "row": row}))
    os.mkfifo(folder / "10.row")
    (folder / "12.row").write_bytes(b"no row")
    (folder / "13.row").mkdir()
    (folder / ".judge-0123456789abcdef.tmp").write_bytes(b"half a r")
    (folder / "11.row").symlink_to("/dev/zero")
    (folder / "99.row").write_bytes(msgspec.msgpack.encode({"table": "help", "row": [7, "late", 2]}))
    with History.open() as history:
        assert [(each.problem, each.hints) for each in history.helps("late")] == [("late", 2)]
        assert len(history.helps()) == 1
    assert len(waiting(own_history)) == len(rows) + 5


def test_where_a_file_stands_in_the_folders_place_the_lock_is_told(own_history):
    filled(own_history)
    own_history.with_name(f"{own_history.name}.waiting").write_text("")
    with locked(own_history), History.open() as history, pytest.raises(HistoryError, match="another program"):
        history.add(past_result(), b"late", "")
