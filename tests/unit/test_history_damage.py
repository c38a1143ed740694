"""A history of which a part is damaged: the rest of it works, and a repair keeps that."""

from __future__ import annotations

import contextlib
import os
import sqlite3
import zlib

import pytest
from histories import ended, filled, started
from past_runs import past_result
from sampling import nightly

from judge.errors import HistoryError
from judge.kata.answers import Rating
from judge.kata.beside import inserted
from judge.kata.hacks import Outcome
from judge.kata.history import History, run_rows
from judge.kata.repair import repair

CHANGES = {
    "runs": [
        "verdict = 'XX'",
        "mode = x'00'",
        "time = 9223372036854775807",
        "time = 'now'",
        "problem = x'ff'",
        "problem = CAST(x'ff' AS TEXT)",  # a text that is no UTF-8
        "submission = 5",
        "score = 'many'",
        "ratio = 'much'",
        "ratio = ''",
        "ratio = 9e999",
        "source = x'ff'",
        "result = 'text'",
    ],
    "help": ["time = 'then'", "hints = 'all'", "hints = -1", "problem = x'00'"],
    "hacks": ["outcome = 'odd'", "time = 'then'", "line = x'ff'"],
    "answers": ["rating = 9", "card = x'ff'", "time = 9223372036854775807"],
}
EACH = [(table, change) for table, changes in CHANGES.items() for change in changes]
FIRST = [(table, changes[0]) for table, changes in CHANGES.items()]
NAMES = {"runs": "run 2", "help": "hint 2", "hacks": "attempt of judge hack 2", "answers": "answer 2"}


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


def changed(path, *statements):
    with contextlib.closing(sqlite3.connect(path)) as connection, connection:
        for statement in statements:
            connection.execute(statement)


def all_of(history):
    read = {"runs": history.runs, "help": history.helps, "hacks": history.hacks, "answers": history.answers}
    return {table: reader() for table, reader in read.items()}


@pytest.mark.parametrize(("table", "change"), EACH)
def test_one_damaged_row_is_one_row(table, change, whole):
    changed(whole, f"UPDATE {table} SET {change} WHERE id = 2")
    with History.open(reading=True) as history:
        counts = {name: len(rows) for name, rows in all_of(history).items()}
        assert counts == {name: 2 if name == table else 3 for name in CHANGES}
        assert history.left_out == [NAMES[table]]
        history.hints_seen("segment")
        history.gave_up("segment")
        assert history.current().problem == "segment"
        if table == "runs":
            with pytest.raises(HistoryError, match="run 2 is damaged"):
                history.run(2)
            assert history.source(3) == b"2"


@pytest.mark.parametrize("change", ["problem = x'05'", "path = 5", "problem = CAST(x'ff' AS TEXT)"])
def test_a_kata_in_hand_that_is_damaged_is_none(change, whole):
    changed(whole, f"UPDATE current SET {change}")
    with History.open(reading=True) as history:
        assert (history.current(), history.left_out) == (None, ["kata in hand"])


@pytest.mark.parametrize(
    "packed",
    [
        b"",
        zlib.compress(b"[]"),
        zlib.compress(b'{"levels": 5}'),
        zlib.compress(b'{"levels": [{"level": 5, "passed": true}]}'),
        zlib.compress(b'{"score": NaN}'),
        zlib.compress(b'{"score": 1e999}'),
    ],
)
def test_a_result_that_is_damaged_costs_its_run_where_results_are_asked_for(packed, whole):
    with contextlib.closing(sqlite3.connect(whole)) as connection, connection:
        connection.execute("UPDATE runs SET result = ? WHERE id = 2", (packed,))
    with History.open(reading=True) as history:
        assert len(history.runs()) == 3
        assert [run.id for run in history.with_results(history.runs())] == [1, 3]
        assert history.left_out == ["run 2"]


def spoiled(path, table):
    """Write over a leaf in the middle of a table or an index."""
    with contextlib.closing(sqlite3.connect(path)) as connection:
        if not connection.execute("SELECT 1 FROM pragma_module_list WHERE name = 'dbstat'").fetchone():
            pytest.skip("this SQLite does not say where its pages are")
        connection.execute("PRAGMA journal_mode = DELETE")
        query = "SELECT pageno FROM dbstat WHERE name = ? AND pagetype = 'leaf'"
        rows = connection.execute(query, (table,)).fetchall()
    content = bytearray(path.read_bytes())
    page = int.from_bytes(content[16:18], "big")
    place = rows[len(rows) // 2][0]
    content[(place - 1) * page : place * page] = b"\xee" * page
    path.write_bytes(content)


def many_runs(path, count):
    """A history of so many runs, each of a source of its own."""
    rows = [run_rows(past_result(), f"# {number}".encode() * 9, "", number) for number in range(count)]
    with History.open(path):
        pass
    with contextlib.closing(sqlite3.connect(path, isolation_level=None)) as connection:
        connection.execute("BEGIN")
        for row, source in rows:
            inserted(connection, "runs", row, source)
        connection.execute("COMMIT")
        connection.execute("PRAGMA journal_mode = DELETE")


@pytest.mark.parametrize("table", ["runs_of_a_problem", "sqlite_sequence"])
def test_what_only_writing_meets_is_repaired_too(table, own_history):
    many_runs(own_history, 300)
    spoiled(own_history, table)
    done = repair(own_history)
    assert (done.runs, done.left_out) == (300, ())
    assert done.before is not None
    with History.open() as history:
        assert history.add(past_result(), b"new", "") == 301


def test_a_part_of_the_sources_costs_those_that_lie_there(own_history):
    many_runs(own_history, 400)
    spoiled(own_history, "sources")
    done = repair(own_history)
    assert done.runs == 400
    assert 0 < len(done.left_out) < 250
    assert all(text.startswith("source ") for text in done.left_out)


@pytest.mark.parametrize("last", [10**15, nightly(-1), nightly("x"), nightly(None)])
def test_the_number_of_the_last_run_may_be_damaged_as_well(last, own_history):
    many_runs(own_history, 300)
    with contextlib.closing(sqlite3.connect(own_history)) as connection, connection:
        connection.execute("UPDATE sqlite_sequence SET seq = ?", (last,))
    spoiled(own_history, "runs")
    with History.open(reading=True) as history:
        found = [run.id for run in history.runs()]
        assert found[0] == 1
        assert found[-1] == 300
        assert len(history.left_out) == 300 - len(found)
    assert repair(own_history).runs == len(found)


@pytest.mark.parametrize("share", [0.5, 0.9, 0.99])
def test_of_a_file_whose_end_is_gone_the_beginning_is_kept(share, own_history):
    many_runs(own_history, 300)
    length = int(own_history.stat().st_size * share)
    os.truncate(own_history, length)
    done = repair(own_history)
    assert done.before is not None
    assert done.before.stat().st_size == length
    named = [text for text in done.left_out if text.startswith("run ")]
    assert done.runs > 0
    assert done.runs + len(named) == 300
    with History.open() as history:
        assert len(history.runs()) == done.runs
        assert history.left_out == []


def test_a_part_of_the_file_that_is_damaged_costs_what_lies_there(own_history):
    filled(own_history, runs=300)
    spoiled(own_history, "runs")
    with History.open(reading=True) as history:
        found = [run.id for run in history.runs()]
        assert 200 < len(found) < 300
        assert found == sorted(found)
        assert len(history.left_out) == 300 - len(found)
    done = repair(own_history)
    assert (done.runs, len(done.left_out)) == (len(found), 300 - len(found))
    with History.open() as history:
        assert [run.id for run in history.runs()] == found
        assert history.add(past_result(), b"new", "") > 290


@pytest.mark.parametrize(("table", "change"), [each if each in FIRST else nightly(*each) for each in EACH])
def test_a_repair_keeps_all_else_and_the_file_as_it_was(table, change, whole):
    changed(whole, f"UPDATE {table} SET {change} WHERE id = 2")
    before = whole.read_bytes()
    done = repair(whole)
    assert done.left_out == (NAMES[table],)
    assert done.runs == (2 if table == "runs" else 3)
    assert done.before.read_bytes()[100:] == before[100:]  # but for how SQLite keeps its log
    assert done.before.stat().st_mode & 0o777 == 0o600
    with History.open() as history:
        counts = {name: len(rows) for name, rows in all_of(history).items()}
        assert counts == {name: 2 if name == table else 3 for name in CHANGES}
        assert history.left_out == []
        assert history.current().path == "/mine.py"
        assert history.source(3) == b"2"
    assert repair(whole).before is None
    assert sorted(path.name for path in whole.parent.iterdir()) == [whole.name, f"{whole.name}.damaged-1"]


def test_a_second_repair_writes_over_no_first_one(whole):
    for number in (1, 2):
        changed(whole, f"UPDATE runs SET verdict = 'XX' WHERE id = {number}")
        assert repair(whole).before.name.endswith(f".damaged-{number}")


HOLD = """
history = History.open(reading=sys.argv[1] == "reading")
history.runs()
if sys.argv[1] == "writing":
    history._connection.execute("BEGIN IMMEDIATE")
print("open", flush=True)
sys.stdin.readline()
"""


@pytest.mark.parametrize("how", ["reading", "writing", "open"])
def test_nothing_is_repaired_while_another_judge_has_it_open(how, whole, monkeypatch):
    monkeypatch.setattr("judge.database._PATIENCE", 0.05)
    changed(whole, "UPDATE runs SET verdict = 'XX' WHERE id = 2")
    holder = started(HOLD, how)
    assert holder.stdout.readline() == "open\n"
    before = sorted(path.name for path in whole.parent.iterdir())
    with pytest.raises(
        HistoryError, match=r"another program has the history open; try again|is writing to it"
    ):
        repair(whole)
    assert sorted(path.name for path in whole.parent.iterdir()) == before
    ended(holder)
    assert repair(whole).left_out == ("run 2",)


def test_there_is_nothing_to_repair(tmp_path, own_history):
    with pytest.raises(HistoryError, match="there is no history yet"):
        repair(own_history)
    (tmp_path / "diary").write_text("Dear diary")
    with pytest.raises(HistoryError, match="no history of the judge"):
        repair(tmp_path / "diary")
