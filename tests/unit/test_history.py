"""The history gives back what it was given, whatever happens to its file, and whoever writes to it."""

from __future__ import annotations

import contextlib
import hashlib
import os
import random
import shutil
import signal
import sqlite3
import subprocess
import sys
import zlib
from datetime import timedelta
from pathlib import Path

import msgspec
import pytest
from past_runs import START, keep, past_result
from sampling import nightly

from judge import database
from judge.errors import StoreError, UsageError
from judge.practice.events import Answer, Hack, Help, Outcome, Rating, Run, Started
from judge.practice.history import APPLICATION, STEPS, History, run_of
from judge.problem import Verdict
from judge.problem.model import Mode
from judge.run.result import judge_fault

ROOT, HERE = Path(__file__).parents[2], Path(__file__).parent
KINDS = (Run, Started, Help, Hack, Answer)


def kept(path, runs=3):
    """A history of so many runs and one event of each other kind a run, closed; what the file then holds."""
    with History(path) as history:
        for number in range(runs):
            keep(history, past_result(), str(number).encode())
            history.keep(Started("segment", "/mine.py", when=START))
            history.keep(Help("segment", number + 1, when=START))
            history.keep(Hack("segment", "mistake", f"case {number}", Outcome.LOST, when=START))
            history.keep(Answer("deck/card", "choice", Rating.GOOD, judged=True, when=START))
    return path.read_bytes()


def counts(history):
    return [len(history.events(kind)) for kind in KINDS]


def changed(path, statement, *values):
    with contextlib.closing(sqlite3.connect(path)) as connection, connection:
        connection.execute(statement, values)


def damaged(path, share):
    """The file with its end written over; what it then holds."""
    content = path.read_bytes()
    whole = int(len(content) * share)
    path.write_bytes(content[:whole] + b"\xee" * (len(content) - whole))
    return path.read_bytes()


def refusal(path, *, reading=False):
    with pytest.raises(StoreError) as caught, History(path, reading=reading):
        pass
    assert "\n" not in str(caught.value)
    assert str(path) in str(caught.value)
    return str(caught.value)


PRELUDE = """
import sys, time
from pathlib import Path
from past_runs import keep, past_result
from judge.practice.events import Help
from judge.practice.history import History
"""


def environment():
    return {**os.environ, "PYTHONPATH": f"{ROOT}{os.pathsep}{HERE}"}


def started(script, *words):
    """A Python process of its own that runs `script`."""
    return subprocess.Popen(
        [sys.executable, "-c", PRELUDE + script, *map(str, words)],
        env=environment(),
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )


# -- what is kept ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["mine.py", os.fsdecode(b"caf\xe9 \x1b[31m\n\xff.py")])
def test_a_run_comes_back_whole(name, own_history):
    result = past_result(passed=("grid",), failed=("tangent",), name=name, mistake="no-clamp", ratio=1.25)
    with History() as history:
        assert keep(history, result, b"\xff\x00x = 1\n", f"/home/me/{name}") == 1
    with History(reading=True) as history:
        (run,) = history.runs("segment")
        assert history.run(1) == run
        assert history.source(1) == b"\xff\x00x = 1\n"
    assert (run.id, run.when, run.problem, run.submission, run.path) == (
        *(1, START, "segment"),
        *(name, f"/home/me/{name}"),
    )
    assert (run.verdict, run.score, run.mode) == (Verdict.WA, 50, Mode.FUNCTION)
    assert (run.passed, run.failed, run.mistake, run.ratio) == (("grid",), ("tangent",), "no-clamp", 1.25)
    assert run.source_hash == hashlib.sha256(b"\xff\x00x = 1\n").hexdigest()
    assert run.result == result


def test_every_other_event_comes_back_as_it_was():
    events = [
        Started("segment", os.fsdecode(b"/home/me/\xff.py"), "/problems", when=START),
        Help("count", 2, when=START + timedelta(microseconds=1)),
        Help("count", 0),
        Hack("count", "no-clamp", "0 0 1 0 0 1 1", Outcome.GIVEN_UP),
        Answer("deck/card", "choice", Rating.AGAIN, judged=False, given="two\n"),
    ]
    with History() as history:
        for event in events:
            assert history.keep(event) >= 1
        assert [each for kind in KINDS for each in history.events(kind)] == events
        assert history.places() == events[:1]
        assert [each.gave_up for each in history.events(Help, "count")] == [False, True]
        assert history.events(Help, "segment") == []


def test_the_last_runs_are_listed_and_one_that_is_not_there_is_refused():
    with History() as history:
        with pytest.raises(UsageError, match="there is no run 1; 'judge run' adds the first one"):
            history.run(1)
        for problem in ("count", "segment", "count", "count"):
            keep(history, past_result(problem))
        assert [run.id for run in history.runs("count", limit=2)] == [3, 4]
        assert (history.runs(limit=0), len(history.runs(limit=10**30))) == ([], 4)
        for number in (0, 5, 2**63):
            with pytest.raises(UsageError, match=f"there is no run {number}; the last one is 4"):
                history.source(number)


def test_only_a_whole_problem_is_solved_and_a_model_solution_says_nothing_of_the_person():
    fault = judge_fault("segment", "a.py", "?")
    model = "/judge/solutions/segment/accepted/a.py"
    found = [
        run_of(past_result(passed=("grid",)), b"", ""),  # as with --group
        run_of(past_result(), b"", "/judge/solutions/segment/a.py"),
        run_of(fault, b"", ""),
        run_of(past_result(), b"", model),
    ]
    assert [(run.whole, run.counts, run.solved) for run in found] == [
        (False, True, False),
        (True, True, True),
        (False, False, False),
        (True, False, False),
    ]


def test_it_is_where_the_settings_say_and_reading_makes_no_file(monkeypatch, tmp_path, own_history):
    with History(reading=True) as history:
        assert (history.path, history.runs(), history.places()) == (own_history, [], [])
    assert not own_history.parent.exists()
    other = tmp_path / "a" / "b" / "other ?#%.db"
    kept(other)
    assert other.is_file()
    monkeypatch.delenv("JUDGE_DB")
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    with History() as history:
        assert history.path.name == "history.sqlite3"
        assert history.path.is_relative_to(tmp_path)


def test_nobody_else_can_read_it(tmp_path):
    before = os.umask(0o022)
    try:
        with History(tmp_path / "shared.sqlite3") as history:
            keep(history, past_result(), b"mine")
            files = list(tmp_path.iterdir())
            assert len(files) == 3
            assert all(file.stat().st_mode & 0o077 == 0 for file in files)
    finally:
        os.umask(before)


# -- files of older judges, of newer ones and of other programs ------------------------------------------


@pytest.mark.parametrize("version", range(1, len(STEPS)))
def test_an_older_judges_file_is_brought_up_to_date(version, own_history):
    own_history.parent.mkdir(parents=True)
    row = msgspec.structs.replace(run_of(past_result(), b"old", "/old.py"), when=START)
    with contextlib.closing(sqlite3.connect(own_history)) as connection, connection:
        for step in STEPS[:version]:
            for statement in step:
                connection.execute(statement)
        connection.execute("INSERT INTO sources VALUES (?, ?)", (row.source_hash, zlib.compress(b"old")))
        connection.execute(
            "INSERT INTO runs VALUES (1, ?, ?, ?, ?, 'AC', 100, 'function', NULL, 0.5, 'a b', '', ?, ?)",
            (1772355600_000_000, "segment", b"old.py", b"/old.py", row.source_hash, row.packed),
        )
        if version > 1:
            connection.execute("INSERT INTO current (id, problem, path) VALUES (1, 'segment', x'2f612e7079')")
        connection.execute(f"PRAGMA application_id = {APPLICATION}")
        connection.execute(f"PRAGMA user_version = {version}")
    with History() as history:
        run = history.run(1)
        assert (run.when, run.passed, run.failed, run.solved) == (START, ("a", "b"), (), True)
        assert history.source(1) == b"old"
        started = [("segment", "/a.py")] if version > 1 else []
        assert [(each.problem, each.path) for each in history.places()] == [("segment", "/old.py"), *started]
        history.keep(Started("count", "/count.py"))
        assert counts(history) == [1, 1 + (version > 1), 0, 0, 0]
    with History() as history:
        assert history.places()[0].problem == "count"


NEWER = len(STEPS) + 1
CHANGES = {
    f"PRAGMA user_version = {NEWER}": f"newer judge (version {NEWER}, this one knows {NEWER - 1}); upgrade",
    "PRAGMA user_version = -1": "is damaged; move it away",
    "PRAGMA application_id = 7": "another program's database",
}


@pytest.mark.parametrize("reading", [False, True])
@pytest.mark.parametrize("change", CHANGES)
def test_what_another_judge_or_program_made_is_left_as_it_is(change, reading, own_history):
    kept(own_history)
    changed(own_history, "CREATE TABLE marvels (id INTEGER)")
    changed(own_history, change)
    before = own_history.read_bytes()
    assert CHANGES[change] in refusal(own_history, reading=reading)
    assert own_history.read_bytes() == before
    assert sorted(own_history.parent.iterdir()) == [own_history]


SQLITE = b"SQLite format 3\0"


@pytest.mark.parametrize("reading", [False, True])
def test_what_is_no_database_is_left_as_it_is(reading, tmp_path):
    contents = [b"My diary.\n", b"x", SQLITE, SQLITE + b"\xff" * 5000, bytes(4096)]
    contents += [start + random.Random(seed).randbytes(3000) for start in (b"", SQLITE) for seed in range(3)]
    for number, content in enumerate(contents):
        path = tmp_path / f"{number}"
        path.write_bytes(content)
        assert "history" in refusal(path, reading=reading)
        assert path.read_bytes() == content
    assert len(list(tmp_path.iterdir())) == len(contents)


def test_another_programs_damaged_file_a_folder_or_a_file_in_its_way(tmp_path):
    path = tmp_path / "theirs.db"
    changed(path, "CREATE TABLE theirs (id INTEGER)")
    before = damaged(path, 0.02)
    with pytest.raises(StoreError), History(path) as history:
        history.runs()
    assert (path.read_bytes(), list(tmp_path.iterdir())) == (before, [path])
    assert "--db" in refusal(tmp_path)
    assert "--db" in refusal(path / "history.sqlite3")
    with pytest.raises(StoreError, match="no name for a file"):
        History(Path("a\0b"))


READ = """
try:
    with History(Path(sys.argv[1]), reading=True) as history:
        print(len(history.runs()))
    with History(Path(sys.argv[1])) as history:
        keep(history, past_result())
except Exception as fault:
    print(type(fault).__name__, fault)
"""


@pytest.fixture
def read_only(tmp_path):
    """Read a history where `tmp_path/place` cannot be written, as any user."""
    place = tmp_path / "place"
    place.mkdir()

    def run():
        command = [sys.executable, "-c", PRELUDE + READ, str(place / "history.sqlite3")]
        if os.geteuid() == 0:
            if not shutil.which("bwrap"):
                pytest.skip("bubblewrap is not installed, and root may write everywhere")
            command = ["bwrap", "--bind", "/", "/", "--ro-bind", str(place), str(place), *command]
        else:
            place.chmod(0o555)
        done = subprocess.run(command, capture_output=True, text=True, timeout=60, env=environment())
        place.chmod(0o755)
        if "bwrap:" in done.stderr:
            pytest.skip(done.stderr)
        assert done.returncode == 0, done.stderr
        return done.stdout

    run.path = place / "history.sqlite3"
    return run


def test_a_history_in_a_read_only_folder_can_be_read(read_only):
    before = kept(read_only.path)
    first, second = read_only().splitlines()
    assert first == "3"
    assert "make it writable, or name another file with --db or $JUDGE_DB" in second
    assert read_only.path.read_bytes() == before


# -- damage ----------------------------------------------------------------------------------------------


DAMAGE = {
    "runs": [
        *("verdict = 'XX'", "time = 9223372036854775807", "time = -1", "time = 'now'", "submission = 5"),
        *("problem = CAST(x'ff' AS TEXT)", "source = x'ff'", "result = 5", "score = -1", "ratio = 9e999"),
    ],
    "started": ["problem = CAST(x'ff' AS TEXT)"],
    "help": ["hints = -1"],
    "hacks": ["outcome = 'odd'"],
    "answers": ["rating = 9"],
}


@pytest.mark.parametrize(("table", "change"), [(name, each) for name in DAMAGE for each in DAMAGE[name]])
def test_one_damaged_row_is_one_row(table, change, own_history):
    kept(own_history)
    changed(own_history, f"UPDATE {table} SET {change} WHERE id = 2")
    with History(reading=True) as history:
        assert counts(history) == [2 if name == table else 3 for name in DAMAGE]
        assert history.left_out == {(table, 2)}
        if table == "runs":
            with pytest.raises(StoreError, match="run 2 is damaged"):
                history.run(2)
        assert history.source(3) == b"2"


@pytest.mark.parametrize(
    "content", [b"[]", b'{"levels": [{"level": 5, "passed": true}]}', b'{"score": 1e999}', b"[" * 5000]
)
def test_a_result_that_is_damaged_costs_its_run_where_results_are_asked_for(content, own_history):
    kept(own_history)
    changed(own_history, "UPDATE runs SET result = ? WHERE id = 2", zlib.compress(content))
    with History(reading=True) as history:
        assert len(history.runs()) == 3
        assert [run.id for run in history.with_results(history.runs())] == [1, 3]
        assert history.left_out == {("runs", 2)}


@pytest.mark.parametrize(("share", "reading"), [(0.02, False), (0.3, True)])
def test_a_file_that_cannot_be_read_is_set_aside(reading, share, own_history):
    for number in (1, 2):
        kept(own_history, runs=100)
        before = damaged(own_history, share)
        aside = own_history.with_name(f"{own_history.name}.damaged-{number}")
        with History(reading=reading) as history:
            assert history.runs() == []
            assert history.set_aside == aside
        assert aside.read_bytes() == before
        with History() as history:
            assert keep(history, past_result(), b"new") == 1
            assert history.set_aside is None
    with History() as history:
        assert len(history.runs()) == 1


def test_one_whose_end_was_cut_off_is_set_aside_when_it_is_written(own_history):
    kept(own_history, runs=100)
    os.truncate(own_history, own_history.stat().st_size // 2)
    with History() as history:
        assert keep(history, past_result(), b"new") == 1
        assert history.set_aside is not None


def test_two_judges_meet_a_damaged_file_and_the_new_one_stays(own_history):
    kept(own_history, runs=100)
    damaged(own_history, 0.3)
    with History() as first, History() as second:
        assert keep(first, past_result(), b"new") == 1
        assert len(second.runs()) == 1
        assert keep(second, past_result(), b"newer") == 2
        assert second.set_aside is None
    names = [path.name for path in own_history.parent.iterdir()]
    assert f"{own_history.name}.damaged-1" in names
    assert not [name for name in names if "damaged-2" in name]


# -- while it is written ---------------------------------------------------------------------------------


ADD = """
sys.stdin.readline()
for number in range(5):
    with History() as history:
        keep(history, past_result(name=sys.argv[1]), b"shared")
        keep(history, past_result(name=sys.argv[1]), f"{sys.argv[1]} {number}".encode())
"""


def test_several_judges_write_at_once_into_a_file_that_was_not_there():
    names = [f"{place}.py" for place in range(4)]
    judges = [started(ADD, name) for name in names]
    for judge in judges:
        judge.stdin.write("go\n")
        judge.stdin.flush()
    for judge in judges:
        judge.communicate(timeout=60)
        assert judge.returncode == 0
    with History() as history:
        runs = history.runs()
        assert [run.id for run in runs] == list(range(1, 41))
        for name in names:
            assert [history.source(run.id) for run in runs if run.submission == name] == [
                source for number in range(5) for source in (b"shared", f"{name} {number}".encode())
            ]


WRITE = """
with History() as history:
    for number in range(10**6):
        run = keep(history, past_result(name=f"{number}.py"), b"x = 1" * (number % 5000))
        print(run, flush=True)  # what is shown
        history.keep(Help("segment", number))
"""


@pytest.mark.parametrize("kills", [4, nightly(40)])
def test_a_judge_that_is_killed_while_it_writes_loses_nothing_that_was_shown(kills, own_history):
    chance, shown = random.Random(kills), 0
    for _ in range(kills):
        writer = started(WRITE)
        for line in writer.stdout:  # to the end: what was written before the kill was shown too
            shown = int(line)
            if chance.random() < 0.1:
                writer.send_signal(signal.SIGKILL)
        writer.communicate(timeout=60)
        assert writer.returncode == -signal.SIGKILL
        with History(reading=True) as history:
            numbers = [run.id for run in history.runs()]
            assert numbers == list(range(1, len(numbers) + 1))
            assert len(numbers) in (shown, shown + 1)
            assert history.left_out == set()
            assert history.set_aside is None
    with contextlib.closing(sqlite3.connect(own_history)) as connection:
        assert connection.execute("PRAGMA integrity_check").fetchall() == [("ok",)]


def test_a_locked_history_is_waited_for_then_said(own_history, monkeypatch):
    monkeypatch.setattr(database, "_PATIENCE", 0.05)
    kept(own_history)
    with contextlib.closing(sqlite3.connect(own_history, isolation_level=None)) as connection:
        connection.execute("BEGIN IMMEDIATE")
        with History() as history:
            assert counts(history) == [3, 3, 3, 3, 3]  # a reader waits for nobody
            with pytest.raises(StoreError, match="another program is writing to it; try again"):
                keep(history, past_result())
            connection.execute("ROLLBACK")
            assert keep(history, past_result()) == 4


def test_a_full_disk_costs_the_run_and_nothing_else(own_history):
    """The file may not grow: what SQLite says is what it says of a full disk."""
    kept(own_history)
    with History() as history:
        ((pages,),) = history._connection.execute("PRAGMA page_count").fetchall()
        history._connection.execute(f"PRAGMA max_page_count = {pages}")
        with pytest.raises(StoreError, match="the disk is full; make room"):
            keep(history, past_result(), os.urandom(100_000))
        assert len(history.runs()) == 3
        history._connection.execute("PRAGMA max_page_count = 1000000")
        assert keep(history, past_result(), os.urandom(100_000)) == 4
