"""Files that are no history of this judge's, are damaged in part or cannot be written: nothing is lost."""

from __future__ import annotations

import contextlib
import os
import random
import shutil
import sqlite3
import subprocess
import sys
import zlib
from pathlib import Path

import pytest
from histories import HERE, PRELUDE, ROOT, filled, refusal, started
from msgspec.structs import replace
from past_runs import past_result

from judge.errors import HistoryError
from judge.kata import database, migrations
from judge.kata.answers import Rating
from judge.kata.hacks import Outcome
from judge.kata.history import Current, History

NEWER = len(migrations.MIGRATIONS) + 1
CHANGES = {
    f"PRAGMA user_version = {NEWER}": f"newer judge (version {NEWER}, this one knows {NEWER - 1}); upgrade",
    "PRAGMA user_version = -1": "is damaged; move it away",
    "PRAGMA application_id = 7": "another program's database",
}


def changed(path, statement, *values):
    with contextlib.closing(sqlite3.connect(path)) as connection, connection:
        connection.execute(statement, values)


@pytest.mark.parametrize("reading", [False, True])
@pytest.mark.parametrize("change", CHANGES)
def test_what_another_judge_or_program_made_is_left_as_it_is(change, reading, own_history):
    filled(own_history)
    changed(own_history, "CREATE TABLE marvels (id INTEGER)")
    changed(own_history, change)
    before = own_history.read_bytes()
    assert CHANGES[change] in refusal(own_history, reading=reading)
    assert own_history.read_bytes() == before
    assert sorted(own_history.parent.iterdir()) == [own_history]


@pytest.mark.parametrize("reading", [False, True])
def test_a_file_that_a_newer_judge_has_open(reading, own_history):
    """Then its version may stand in the log beside it only."""
    filled(own_history)
    with contextlib.closing(sqlite3.connect(own_history)) as connection:
        connection.execute("PRAGMA user_version = 99")
        connection.commit()
        before = own_history.read_bytes()
        assert "newer judge (version 99" in refusal(own_history, reading=reading)
        assert own_history.read_bytes() == before


SQLITE = b"SQLite format 3\0"


@pytest.mark.parametrize("reading", [False, True])
def test_what_is_no_database_is_left_as_it_is(reading, tmp_path):
    contents = [b"My diary.\n", b"x", SQLITE, SQLITE + b"\xff" * 5000, bytes(4096)]
    contents += [start + random.Random(seed).randbytes(3000) for start in (b"", SQLITE) for seed in range(9)]
    for number, content in enumerate(contents):
        path = tmp_path / f"{number}"
        path.write_bytes(content)
        told = refusal(path, reading=reading)
        assert "this is no history of the judge; name another file with --db" in told or number < 5
        assert path.read_bytes() == content
    assert len(list(tmp_path.iterdir())) == len(contents)


def test_nobody_else_can_read_it(tmp_path):
    path = tmp_path / "shared.sqlite3"
    before = os.umask(0o022)
    try:
        with History.open(path) as history:
            history.add(past_result(), b"mine", "")
            files = list(tmp_path.iterdir())
            assert len(files) == 3
            assert all(file.stat().st_mode & 0o077 == 0 for file in files)
    finally:
        os.umask(before)


def test_a_folder_or_a_file_stands_in_its_place(tmp_path):
    assert "--db" in refusal(tmp_path)
    (tmp_path / "file").touch()
    assert "--db" in refusal(tmp_path / "file" / "history.sqlite3")
    with pytest.raises(HistoryError, match="no name for a file"):
        History.open(Path("a\0b"))


@pytest.fixture
def read_only(tmp_path):
    """Run a script where `tmp_path/place` cannot be written, as any user."""
    place = tmp_path / "place"
    place.mkdir()

    def run(script: str) -> str:
        command = [sys.executable, "-c", PRELUDE + script, str(place / "history.sqlite3")]
        if os.geteuid() == 0:
            if not shutil.which("bwrap"):
                pytest.skip("bubblewrap is not installed, and root may write everywhere")
            command = ["bwrap", "--bind", "/", "/", "--ro-bind", str(place), str(place), *command]
        else:
            place.chmod(0o555)
        environment = {**os.environ, "PYTHONPATH": f"{ROOT}{os.pathsep}{HERE}"}
        done = subprocess.run(command, capture_output=True, text=True, timeout=60, env=environment)
        place.chmod(0o755)
        if "bwrap:" in done.stderr:
            pytest.skip(done.stderr)
        assert done.returncode == 0, done.stderr
        return done.stdout

    run.place = place
    return run


READ = """
from pathlib import Path
try:
    with History.open(Path(sys.argv[1]), reading=True) as history:
        print(len(history.runs()), history.current())
    with History.open(Path(sys.argv[1])) as history:
        history.add(past_result(), b"", "")
except Exception as fault:
    print(type(fault).__name__, fault)
"""


def test_a_history_in_a_read_only_folder_can_be_read(read_only):
    before = filled(read_only.place / "history.sqlite3")
    first, second = read_only(READ).splitlines()
    assert first == "3 None"
    assert second.startswith("HistoryError ")
    assert "make it writable, or name another file with --db or $JUDGE_DB" in second
    assert (read_only.place / "history.sqlite3").read_bytes() == before


def test_a_log_left_in_a_read_only_folder_is_not_passed_over(read_only):
    """A judge that was killed leaves the last runs in the log: without it they would seem lost."""
    path = read_only.place / "history.sqlite3"
    filled(path)
    script = (
        "from pathlib import Path\n"
        "history = History.open(Path(sys.argv[1]))\n"
        "history.add(past_result(), b'', '')\n"
        "print(1, flush=True)\ntime.sleep(60)\n"
    )
    holder = started(script, path)
    assert holder.stdout.readline() == "1\n"
    holder.kill()
    holder.communicate(timeout=60)
    path.with_name("history.sqlite3-shm").unlink(missing_ok=True)
    assert path.with_name("history.sqlite3-wal").exists()
    (told,) = read_only(READ).splitlines()
    assert "make the folder writable" in told
    with History.open(path) as history:
        assert len(history.runs()) == 4


def test_an_older_judges_file_is_brought_up_to_date(own_history, monkeypatch):
    with monkeypatch.context() as older:
        older.setattr(database, "HISTORY", replace(database.HISTORY, steps=migrations.MIGRATIONS[:1]))
        filled(own_history)
    with History.open() as history:
        assert [history.source(run.id) for run in history.runs()] == [b"0", b"1", b"2"]
        assert history.current() is None
        history.take_up("count", "/count.py")
        history.see_hints("count", 1)
    with History.open() as history:
        assert history.current() == Current("count", "/count.py")
        ((version,),) = history._rows("PRAGMA user_version")
        assert version == len(migrations.MIGRATIONS)


def test_a_migration_that_fails_changes_nothing(own_history, monkeypatch):
    before = filled(own_history)
    steps = (*migrations.MIGRATIONS, ("CREATE TABLE fine (id INTEGER)", "CREATE TABLE runs (id INTEGER)"))
    with monkeypatch.context() as newer:
        newer.setattr(database, "HISTORY", replace(database.HISTORY, steps=steps))
        assert "already exists" in refusal(own_history)
    assert own_history.read_bytes() == before
    with History.open() as history:
        assert len(history.runs()) == 3


DAMAGE = {
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


def damaged(path, share):
    """The file with its end written over; what it then holds."""
    content = path.read_bytes()
    kept = int(len(content) * share)
    path.write_bytes(content[:kept] + b"\xee" * (len(content) - kept))
    return path.read_bytes()


@pytest.mark.parametrize(("table", "change"), [(name, each) for name in DAMAGE for each in DAMAGE[name]])
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
            name: 2 if name == table else 3 for name in DAMAGE
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
