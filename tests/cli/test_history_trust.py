"""A damaged or locked history as a person and a script see it: every command works, and says so once."""

from __future__ import annotations

import contextlib
import json
import sqlite3

import pytest
from cli_support import FLOOR, MEAN
from sampling import nightly

from judge import database

pytestmark = pytest.mark.slow
SAID = "1 damaged row is left out of the history"


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
    ("history", "--csv"),
    ("progress",),
    ("progress", "--json"),
    ("due",),
    ("report",),
    ("history", "--restore", "3", "--force"),
    ("next", "--json"),
)


@pytest.mark.parametrize("change", ["verdict = 'XX'", nightly("time = 'now'")])
def test_every_command_works_without_the_damaged_run(change, judge, three_runs, own_history):
    changed(own_history, change)
    for words in COMMANDS:
        ended = judge(*words)
        assert ended.status == 0, ended.err
        assert "Traceback" not in ended.err
        assert ended.err.count(SAID) <= 1
        if words[0] in ("history", "progress", "due", "report") and "--restore" not in words:
            assert SAID in ended.err


def test_the_others_are_all_there(judge, three_runs, own_history):
    changed(own_history, "verdict = 'XX'")
    assert [json.loads(line)["run"] for line in judge("history", "--json").lines] == [1, 3]
    ended = judge("history", "--restore", "2")
    assert (ended.status, ended.err.count("\n")) == (3, 1)
    assert "run 2 is damaged" in ended.err


@pytest.mark.parametrize("words", [("history",), ("run", "-q", "middle", "middle.py"), ("next",)])
def test_a_file_that_cannot_be_read_is_set_aside_and_that_is_said_once(words, judge, three_runs, own_history):
    content = own_history.read_bytes()
    own_history.write_bytes(content[:200] + b"\xee" * (len(content) - 200))
    ended = judge(*words)
    assert (ended.status, ended.err.count("\n")) == (0, 1)
    assert f"it is kept as {own_history.with_name(own_history.name)}.damaged-1, and a new one" in ended.err
    assert judge(*words).err == ""


@pytest.mark.parametrize("how", ["IMMEDIATE", "EXCLUSIVE"])
def test_a_locked_history_loses_no_run_and_no_verdict(how, judge, submit, own_history, monkeypatch):
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
    assert "another program locks the history: what is new waits beside it" in ended.err
    found = [json.loads(line) for line in judge("history", "--json").lines]
    assert [(row["run"], row["verdict"]) for row in found] == [(1, "WA"), (2, "WA"), (3, "AC")]
