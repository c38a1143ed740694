"""A damaged or locked history as a person and a script see it: every command works, and says so once."""

from __future__ import annotations

import contextlib
import json
import os
import shutil
import sqlite3
import subprocess
import sys
import tracemalloc
import zlib
from pathlib import Path

import pytest
from cli_support import FLOOR, MEAN, ROOT
from sampling import daily, nightly

from judge import database
from judge.practice.events import Help, Started
from judge.practice.history import History, run_of
from judge.problem import Verdict
from judge.run.result import Result

pytestmark = pytest.mark.slow
SAID = "1 damaged row left out of the history"


@pytest.fixture
def three_runs(judge, submit):
    submit(FLOOR, "middle.py")
    for source in (FLOOR, MEAN, f"{MEAN}# again\n"):
        submit(source, "middle.py")
        judge("run", "-q", "middle", "middle.py")


def changed(path, change):
    with contextlib.closing(sqlite3.connect(path)) as connection, connection:
        connection.execute(f"UPDATE runs SET {change} WHERE id = 2")


COMMANDS = (
    ("history",),
    ("history", "--json"),
    ("progress",),
    ("progress", "--json"),
    ("progress", "--due"),
    ("history", "--restore", "3"),
    ("start", "--json"),
)


@pytest.mark.parametrize("change", ["verdict = 'XX'", nightly("time = 'now'")])
def test_every_command_works_without_the_damaged_run(change, judge, three_runs, own_history):
    changed(own_history, change)
    for words in COMMANDS:
        ended = judge(*words)
        assert ended.status == 0, ended.err
        assert "Traceback" not in ended.err
        assert ended.err.count(SAID) <= 1
        if words[0] in ("history", "progress") and "--restore" not in words:
            assert SAID in ended.err


def test_the_others_are_all_there(judge, three_runs, own_history):
    changed(own_history, "verdict = 'XX'")
    assert [json.loads(line)["run"] for line in judge("history", "--json").lines] == [1, 3]
    ended = judge("history", "--restore", "2")
    assert (ended.status, ended.err.count("\n")) == (3, 1)
    assert "run 2 is damaged" in ended.err


@pytest.mark.parametrize("words", [("history",), ("run", "-q", "middle", "middle.py"), ()])
def test_a_file_that_cannot_be_read_is_set_aside_and_that_is_said_once(words, judge, three_runs, own_history):
    content = own_history.read_bytes()
    own_history.write_bytes(content[:200] + b"\xee" * (len(content) - 200))
    ended = judge(*words)
    assert (ended.status, ended.err.count("\n")) == (0, 1)
    assert f"it is kept as {own_history.with_name(own_history.name)}.damaged-1, and a new one" in ended.err
    assert judge(*words).err == ""


@pytest.mark.parametrize("how", ["IMMEDIATE", "EXCLUSIVE"])
def test_a_locked_history_costs_a_note_and_no_verdict(how, judge, submit, own_history, monkeypatch):
    monkeypatch.setattr(database, "_PATIENCE", 0.05)
    first, second = submit(FLOOR, "a.py"), submit(MEAN, "b.py")
    judge("run", "-q", "middle", first)
    with contextlib.closing(sqlite3.connect(own_history, isolation_level=None)) as connection:
        connection.execute(f"PRAGMA locking_mode = {'EXCLUSIVE' if how == 'EXCLUSIVE' else 'NORMAL'}")
        connection.execute(f"BEGIN {how}")
        connection.execute("CREATE TABLE never (kept)")
        ended = judge("run", "-q", "middle", first, second)
        connection.execute("ROLLBACK")
    assert ended.status == 1
    assert ended.lines[-1].startswith("1 of 2 accepted")
    assert ended.err.count("\n") == 1
    assert "not kept in the history: " in ended.err
    assert "another program is writing to it; try again when that has ended" in ended.err
    assert len(judge("history", "--json").lines) == 1


def test_a_source_is_restored_and_what_was_there_is_kept(judge, three_runs):
    assert judge("history", "--restore", "3").lines[1:] == ["  It was there already."]
    for number in (1, 2):
        Path("middle.py").write_text(f"mine = {number}\n")
        assert "What was there is kept as middle.py.bak" in judge("history", "--restore", "1").out
        assert Path("middle.py").read_text() == FLOOR
    assert Path("middle.py.bak").read_text() == "mine = 1\n"
    assert Path("middle.py.bak-2").read_text() == "mine = 2\n"


@pytest.mark.parametrize("there", [True, False])
def test_nothing_is_written_where_a_row_says_but_in_this_folder(
    judge, three_runs, own_history, tmp_path, there
):
    """A history may be anybody's."""
    outside = tmp_path / "outside"
    for place in (outside / "mine.py", Path("sub/mine.py"), Path(".profile"), outside / "x/../../.profile"):
        target = place.absolute()
        if there:
            target.parent.mkdir(exist_ok=True, parents=True)
            target.write_text("as it was\n")
        changed(own_history, f"path = '{target}'")
        ended = judge("history", "--restore", "2")
        assert (ended.status, ended.err.count("\n")) == (2, 1)
        assert "which is no program of this folder; go to its folder, or name a file with --out" in ended.err
        assert target.exists() is there
        assert not there or target.read_text() == "as it was\n"


def test_no_kata_is_loaded_from_where_a_history_says(judge, own_history, pack, tmp_path, monkeypatch):
    monkeypatch.delenv("JUDGE_PROBLEMS")
    bad = shutil.copytree(pack, tmp_path / "bad") / "problems"
    code = bad / "middle" / "problem.py"
    code.write_text(f"{code.read_text()}\n__import__('pathlib').Path({str(tmp_path / 'ran')!r}).touch()\n")
    Path("middle.py").write_text(FLOOR)
    with History() as history:
        history.keep(Started("middle", str(Path("middle.py").absolute()), str(bad)))
    for words in ("", "run", "start", "hint", "run middle.py", "show", "progress", "list", "quiz"):
        judge(*words.split())
        assert not (tmp_path / "ran").exists(), words
    judge("run", "middle", "middle.py", "--problems", bad)
    assert (tmp_path / "ran").exists(), "it would run"


def test_a_row_that_unpacks_to_more_than_any_program_is_damaged(judge, three_runs, own_history):
    """A thousand times as much memory is not taken for it first."""
    with contextlib.closing(sqlite3.connect(own_history)) as connection, connection:
        connection.execute("UPDATE sources SET body = ?", (zlib.compress(bytes(64 << 20)),))
        connection.execute("UPDATE runs SET result = ?", (zlib.compress(b"[" + b" " * (64 << 20) + b"]"),))
    tracemalloc.start()
    ended = [judge("history", "--restore", "2"), judge("history", "2"), judge("history")]
    most = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert [each.status for each in ended][:2] == [3, 3]
    assert "the source of run 2 is damaged" in ended[0].err
    assert most < 48 << 20


# -- what is kept ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("words", [("-q",), ("--json",), ("--group", "half"), ("-j", "2")])
def test_every_run_is_kept(words, judge, submit, tmp_path):
    shown = judge("run", "middle", submit(MEAN), submit(FLOOR, "floor.py"), *words)
    with History() as history:
        runs = history.runs()
        assert [run.submission for run in runs] == ["mine.py", "floor.py"]
        assert [run.path for run in runs] == [str(tmp_path / "mine.py"), str(tmp_path / "floor.py")]
        assert [run.verdict.value for run in runs] == ["AC", "WA"]
        assert [history.source(run.id).decode() for run in runs] == [MEAN, FLOOR]
    if words == ("--json",):
        assert [run.result.as_json() for run in runs] == [json.loads(line) for line in shown.lines]


def test_unless_that_is_not_wanted(judge, submit, own_history, tmp_path):
    assert judge("run", "middle", submit(MEAN), "--no-history").status == 0
    assert judge("run", "-q", "middle", "mine.py", "--db", tmp_path / "team.db").status == 0
    assert judge("history", "--json").out == ""
    assert not own_history.exists()


def test_a_file_that_is_no_history_is_left_alone(judge, submit):
    Path("diary").write_text("Dear diary,\n")
    assert judge("run", "middle", submit(MEAN), "--db", "diary").status == 0
    assert judge("history", "--db", "diary").status == 3
    assert Path("diary").read_text() == "Dear diary,\n"


def test_a_run_of_no_file_needs_a_name(judge):
    with History() as history:
        result = Result(problem="middle", submission="/dev/fd/63", verdict=Verdict.AC)
        history.keep(run_of(result, b"x = 1\n", ""), b"x = 1\n")
    ended = judge("history", "--restore", "1")
    assert (ended.status, ended.err) == (
        2,
        "judge: run 1 judged no ordinary file; name one with --out FILE\n",
    )
    assert judge("history", "--restore", "1", "--out", "x.py").status == 0
    assert Path("x.py").read_bytes() == b"x = 1\n"


# -- what was shown is kept, whenever the judge is killed ------------------------------------------------


TEAM = {f"team/{number:02}.py": (MEAN, FLOOR)[number % 2] + f"# {number}\n" for number in range(8)}
FORMATS = {  # and what a line of each says of a submission
    "json": lambda line: json.loads(line)["submission"],
    "github": lambda line: (
        "team" + line.partition("file=team")[2].partition(",")[0] if "file=" in line else None
    ),
    "text": lambda line: next((word for word in line.split() if word.startswith("team/")), None),
}


def killed(form: str, db: Path, after: int) -> list[str]:
    """Judge the team and kill the judge as soon as so many are shown; all that were shown."""
    words = [
        "run",
        "middle",
        "team",
        "-j",
        "3",
        *(["--json"] if form == "json" else ["--format", form]),
        "--db",
        str(db),
    ]
    quick = ["--no-shrink", "--no-name", "--isolation", "limits"]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    shown = []
    with subprocess.Popen(
        [sys.executable, "-m", "judge", *words, *quick], stdout=subprocess.PIPE, text=True, env=environment
    ) as running:
        assert running.stdout is not None
        for line in running.stdout:  # to the end: what had been written before the kill was shown too
            name = FORMATS[form](line)
            if name:
                shown.append(name)
            if len(shown) == after:
                running.kill()
    assert len(shown) >= after
    return shown


@pytest.mark.parametrize("form", daily(FORMATS, ("text",)))
def test_a_judge_that_is_killed_has_kept_what_it_has_shown(form, submit, tmp_path):
    for name, source in TEAM.items():
        submit(source, name)
    for after in (1, 5):
        db = tmp_path / f"{after}.sqlite3"
        shown = killed(form, db, after)
        with History(db) as history:
            kept = {run.submission: history.source(run.id).decode() for run in history.runs()}
        assert {name: kept.get(name) for name in shown} == {name: TEAM[name] for name in shown}


def test_a_hint_that_was_shown_counts_as_seen():
    reading, writing = os.pipe()
    os.close(reading)  # showing it is the last thing that happens
    words = [sys.executable, "-m", "judge", "hint", "middle"]
    ended = subprocess.run(words, stdout=writing, stderr=subprocess.PIPE, cwd=ROOT, timeout=60, check=False)
    os.close(writing)
    assert ended.returncode == 141
    with History() as history:
        assert [each.hints for each in history.events(Help)] == [1]
