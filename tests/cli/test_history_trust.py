"""A damaged or locked history as a person and a script see it: every command works, and says so once."""

from __future__ import annotations

import contextlib
import json
import sqlite3

import pytest
from cli_support import FLOOR, MEAN
from jsonschema import Draft202012Validator
from sampling import nightly

from judge import database
from judge.schema import schema_of

pytestmark = pytest.mark.slow
SAID = "in the history is damaged and left out; 'judge history --repair' keeps the rest"


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
            assert f"run 2 {SAID}" in ended.err


def test_the_others_are_all_there(judge, three_runs, own_history):
    changed(own_history, "verdict = 'XX'")
    assert [json.loads(line)["run"] for line in judge("history", "--json").lines] == [1, 3]
    ended = judge("history", "--restore", "2")
    assert (ended.status, ended.err.count("\n")) == (3, 1)
    assert "run 2 is damaged; 'judge history --repair' takes it away" in ended.err


def test_a_result_that_cannot_be_read_costs_scripts_that_run(judge, three_runs, own_history):
    changed(own_history, "result = x'00'")
    ended = judge("history", "--json")
    assert ([json.loads(line)["run"] for line in ended.lines], ended.status) == ([1, 3], 0)
    assert f"run 2 {SAID}" in ended.err
    assert len(judge("history", "--csv").lines) == 3
    assert len(judge("history").lines) == 4


def test_a_repair(judge, three_runs, own_history):
    ended = judge("history", "--repair")
    assert (ended.status, ended.out, ended.err) == (0, "Nothing is damaged: 3 runs.\n", "")
    changed(own_history, "verdict = 'XX'")
    ended = judge("history", "--repair")
    assert (ended.status, ended.err) == (0, "")
    assert ended.lines[0] == "2 runs kept"
    assert ended.lines[1].split() == ["left", "out", "run", "2"]
    assert f"{own_history.name}.damaged-1" in ended.out
    assert judge("history").err == ""
    changed(own_history, "verdict = 'AC'")
    (value,) = map(json.loads, judge("history", "--repair", "--json").lines)
    Draft202012Validator(schema_of("history")).validate(value)
    assert value == {"schema": 1, "kept": 2, "left_out": [], "before": None}
    ended = judge("history", "--repair", "--csv")
    assert (ended.status, "takes no other choice" in ended.err) == (2, True)


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


def test_a_note_names_a_few_and_counts_the_rest(judge, submit, own_history):
    for number in range(8):
        judge("run", "-q", "middle", submit(f"{MEAN}# {number}\n", "middle.py"))
    with contextlib.closing(sqlite3.connect(own_history)) as connection, connection:
        connection.execute("UPDATE runs SET verdict = 'XX' WHERE id > 1")
    ended = judge("history")
    assert "run 2, run 3, run 4, run 5, run 6 and 2 more in the history are damaged and left out" in ended.err
