"""What befalls a history while it is written: two judges at once, a crash, a full disk."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess

import pytest
from histories import ended, filled, refusal, started
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


HALT = """
real = sqlite3.connect
class Connection(sqlite3.Connection):
    def execute(self, statement, *values):
        if "user_version =" in statement:
            print("halfway", flush=True)
            time.sleep(60)
        return super().execute(statement, *values)
sqlite3.connect = lambda *words, **settings: real(*words, factory=Connection, **settings)
History.open()
"""


def test_a_first_start_that_was_killed_halfway():
    holder = started(HALT)
    assert holder.stdout.readline() == "halfway\n"
    holder.kill()
    holder.communicate(timeout=60)
    with History.open() as history:
        assert history.add(past_result(), b"", "") == 1


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


@pytest.fixture
def small_disk(tmp_path):
    """A file system of 256 kB."""
    disk = tmp_path / "disk"
    disk.mkdir()
    command = ["mount", "-t", "tmpfs", "-o", "size=256k", "judge-test", str(disk)]
    if os.geteuid() != 0 or subprocess.run(command, capture_output=True, timeout=20).returncode:
        pytest.skip("no file system can be mounted here")
    yield disk
    subprocess.run(["umount", str(disk)], check=True, timeout=20)


def test_a_disk_that_is_really_full(small_disk):
    path = small_disk / "history.sqlite3"
    filled(path)
    with (small_disk / "filler").open("wb", buffering=0) as filler, contextlib.suppress(OSError):
        while filler.write(b"\0" * 4096):
            pass
    for _ in range(2):
        with pytest.raises(HistoryError) as caught, History.open(path) as history:
            history.add(past_result(), os.urandom(50_000), "")
        assert "make room" in str(caught.value)
    (small_disk / "filler").unlink()
    with History.open(path) as history:
        assert [history.source(run.id) for run in history.runs()] == [b"0", b"1", b"2"]
        assert history.add(past_result(), b"", "") == 4
    with (small_disk / "filler").open("wb", buffering=0) as filler, contextlib.suppress(OSError):
        while filler.write(b"\0" * 4096):
            pass
    fresh = small_disk / "fresh.sqlite3"
    assert "make room" in refusal(fresh) or "cannot be" in refusal(fresh)
