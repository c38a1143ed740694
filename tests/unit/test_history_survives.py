"""What befalls a file: two judges at once, a crash, a full disk, a newer judge, another program's data."""

from __future__ import annotations

import contextlib
import os
import shutil
import signal
import sqlite3
import subprocess
import sys
import zlib
from pathlib import Path

import pytest
from past_runs import past_result

from judge.errors import HistoryError
from judge.kata import database, migrations
from judge.kata.history import Current, History

ROOT = Path(__file__).parents[2]
HERE = Path(__file__).parent
PRELUDE = """
import os, sqlite3, sys, time
from past_runs import past_result
from judge.kata.history import History
"""


def started(script: str, *words: object) -> subprocess.Popen[str]:
    """A Python process of its own that runs `script`."""
    return subprocess.Popen(
        [sys.executable, "-c", PRELUDE + script, *map(str, words)],
        env={**os.environ, "PYTHONPATH": f"{ROOT}{os.pathsep}{HERE}"},
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def ended(process: subprocess.Popen[str]) -> str:
    out, err = process.communicate(timeout=60)
    assert process.returncode == 0, err
    return out


def filled(path: Path, runs: int = 3) -> bytes:
    """A history of so many runs, closed; what the file then holds."""
    with History.open(path) as history:
        for number in range(runs):
            history.add(past_result(), str(number).encode(), "")
    return path.read_bytes()


def refusal(path: Path, *, reading: bool = False) -> str:
    with pytest.raises(HistoryError) as caught, History.open(path, reading=reading):
        pass
    assert "\n" not in str(caught.value)
    assert str(path) in str(caught.value)
    return str(caught.value)


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
from judge.kata.database import writing
history = History.open()
with writing(history._connection, history.path) as connection:
    connection.execute("INSERT INTO sources VALUES ('half', 'written')")
    connection.execute("INSERT INTO current VALUES (1, 'half', 'written')")
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
    with History.open() as history, pytest.raises(HistoryError, match="another program is writing to it"):
        history.add(past_result(), b"", "")
    ended(holder)
    with History.open() as history:
        assert history.add(past_result(), b"", "") == 4


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


SLAUGHTER = """
history = History.open()
print("begun", flush=True)
while True:
    history.add(past_result(), os.urandom(20_000), "")
"""


def test_killed_at_any_moment(own_history):
    for _ in range(3):
        judge = started(SLAUGHTER)
        assert judge.stdout.readline() == "begun\n"
        with contextlib.suppress(subprocess.TimeoutExpired):
            judge.wait(0.15)
        judge.kill()
        judge.communicate(timeout=60)
    with History.open() as history:
        assert history._rows("PRAGMA integrity_check") == [("ok",)]
        for run in history.runs()[-5:]:
            assert len(history.source(run.id)) == 20_000


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


def test_a_file_that_may_not_grow(own_history):
    filled(own_history)
    size = own_history.stat().st_size
    judge = started(
        "import resource\n"
        "resource.setrlimit(resource.RLIMIT_FSIZE, (int(sys.argv[1]), resource.RLIM_INFINITY))\n"
        "try:\n"
        "    with History.open() as history:\n        history.add(past_result(), os.urandom(200_000), '')\n"
        "except Exception as fault:\n    print(type(fault).__name__, fault)\n",
        size,
    )
    told = ended(judge)
    assert told.startswith(f"HistoryError {own_history}: ")
    assert "nothing in it is lost" in told or "make room" in told
    with History.open() as history:
        assert [history.source(run.id) for run in history.runs()] == [b"0", b"1", b"2"]


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


@pytest.mark.parametrize("reading", [False, True])
def test_a_newer_judges_file_is_left_as_it_is(reading, own_history):
    filled(own_history)
    newer = len(migrations.MIGRATIONS) + 1
    with contextlib.closing(sqlite3.connect(own_history)) as connection:
        connection.execute("CREATE TABLE marvels (id INTEGER)")
        connection.execute(f"PRAGMA user_version = {newer}")
        connection.commit()
    before = own_history.read_bytes()
    told = refusal(own_history, reading=reading)
    assert f"newer judge (version {newer}, this one knows {newer - 1})" in told
    assert "upgrade the judge" in told
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


@pytest.mark.parametrize("reading", [False, True])
@pytest.mark.parametrize(
    "content",
    [b"My diary.\n", b"x", b"SQLite format 3\0", b"SQLite format 3\0" + b"\xff" * 5000, bytes(4096)],
)
def test_what_is_no_database_is_left_as_it_is(content, reading, tmp_path):
    path = tmp_path / "diary"
    path.write_bytes(content)
    assert refusal(path, reading=reading)
    assert path.read_bytes() == content
    assert list(tmp_path.iterdir()) == [path]


def test_another_programs_database_is_left_as_it_is(tmp_path):
    path = tmp_path / "photos.db"
    with contextlib.closing(sqlite3.connect(path)) as connection:
        connection.execute("CREATE TABLE runs (id INTEGER)")
        connection.commit()
    before = path.read_bytes()
    assert "another program's database" in refusal(path)
    assert path.read_bytes() == before


def test_an_empty_file_becomes_a_history(tmp_path):
    path = tmp_path / "new.db"
    path.touch()
    assert filled(path)


def test_a_damaged_history_says_so(own_history):
    whole = filled(own_history, runs=200)
    own_history.write_bytes(whole[:8192] + b"\xee" * (len(whole) - 8192))
    with History.open() as history, pytest.raises(HistoryError, match="move it away"):
        history.runs()


@pytest.mark.parametrize(
    "change",
    [
        "verdict = 'XX'",
        "mode = 'none'",
        "time = 9223372036854775807",
        "time = 'now'",
        "problem = x'ff'",
        "passed = x'ff'",
    ],
)
def test_a_run_that_no_judge_wrote_is_told_in_a_line(change, own_history):
    filled(own_history, runs=1)
    with contextlib.closing(sqlite3.connect(own_history)) as connection, connection:
        connection.execute(f"UPDATE runs SET {change}")
    with History.open(reading=True) as history:
        with pytest.raises(HistoryError, match="run 1 is damaged"):
            history.runs()
        with pytest.raises(HistoryError, match="run 1 is damaged"):
            history.run(1)


@pytest.mark.parametrize("packed", [b"", zlib.compress(b"[]"), zlib.compress(b"[" * 100_000), "text"])
def test_a_result_that_no_judge_wrote_is_told_in_a_line(packed, own_history):
    filled(own_history, runs=1)
    with contextlib.closing(sqlite3.connect(own_history)) as connection, connection:
        connection.execute("UPDATE runs SET result = ?", (packed,))
    with History.open(reading=True) as history, pytest.raises(HistoryError, match="run 1 is damaged"):
        history.run(1).result  # noqa: B018


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


def test_a_folder_that_cannot_be_written():
    assert "--db" in refusal(Path("/proc/judge/history.sqlite3"))


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
                pytest.skip("root may write everything, and there is no bubblewrap")
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


def test_no_history_in_a_read_only_folder(read_only):
    first, second = read_only(READ).splitlines()
    assert first == "0 None"
    assert "--db" in second
    assert list(read_only.place.iterdir()) == []


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
        older.setattr(migrations, "MIGRATIONS", migrations.MIGRATIONS[:1])
        older.setattr(database, "MIGRATIONS", migrations.MIGRATIONS[:1])
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
        newer.setattr(migrations, "MIGRATIONS", steps)
        newer.setattr(database, "MIGRATIONS", steps)
        assert "already exists" in refusal(own_history)
    assert own_history.read_bytes() == before
    with History.open() as history:
        assert len(history.runs()) == 3
