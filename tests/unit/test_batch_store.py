"""The file of a class's results: a row that was kept is there, one judge writes, what is not ours is left."""

from __future__ import annotations

import contextlib
import sqlite3
import subprocess
import sys

import pytest

from judge.batch.model import Environment, KeptRow, WorkerResult
from judge.batch.store import RESULTS, ResultStore, store_of
from judge.database import connect
from judge.errors import StoreError
from judge.run.result import judge_fault


def row(digest="k", verdict="WA", file="ada/middle.py", at=1.0):
    result = judge_fault("middle", file, "why").as_json() | {"verdict": verdict}
    return KeptRow(
        "ada",
        "middle",
        file,
        digest,
        WorkerResult(result, "lab"),
        Environment("1", "2", "3", "full", "5"),
        at,
    )


def opened(path):
    with ResultStore.open(path) as store:
        return store.every()


def test_rows_are_there_when_the_file_is_opened_again(tmp_path):
    path = store_of(tmp_path / "class")
    assert path == tmp_path / "class.judge.sqlite3"
    old, new, other = row("a"), row("b", "AC", at=2.0), row("c", file="ada/other.py", at=3.0)
    with ResultStore.open(path) as store:
        store.keep_all([new])
        store.keep_all([old, other])
    with ResultStore.read(path) as store:
        assert store.every() == [old, new, other]
        assert [each.accepted for each in store.every()] == [False, True, False]
    assert [each.name for each in tmp_path.iterdir()] == [path.name]


def test_half_of_a_surrogate_pair_costs_no_row(tmp_path):
    """A submission may answer one, and no file of text can hold it."""
    path = tmp_path / "s.sqlite3"
    with ResultStore.open(path) as store:
        store.keep_all([row("a"), row("b", "W\ud800A", at=2.0)])
    first, second = opened(path)
    assert (first, second.done.result["verdict"]) == (row("a"), "W?A")


def test_what_is_kept_is_there_after_a_power_cut(tmp_path):
    """Each commit is synced: `FULL` is 2."""
    with contextlib.closing(connect(RESULTS, tmp_path / "s.sqlite3", reading=False)) as connection:
        assert connection.execute("PRAGMA synchronous").fetchone() == (2,)


def test_one_judge_writes_and_others_may_read(tmp_path):
    path = tmp_path / "s.sqlite3"
    with ResultStore.open(path) as store:
        store.keep_all([row()])
        with pytest.raises(StoreError, match="another judge is writing to it; wait until it has ended"):
            opened(path)
        with ResultStore.read(path) as reader:
            assert len(reader.every()) == 1
    with ResultStore.open(path) as store:
        assert len(store.every()) == 1


KILLED = """
import os, pathlib, sys
from judge import database
from judge.batch.model import WorkerResult, KeptRow
from judge.batch.store import ResultStore
with ResultStore.open(pathlib.Path(sys.argv[1])) as store:
    for at in range(5):
        store.keep_all([KeptRow("ada", "p", str(at), "d", WorkerResult({}), None, at)])
    os.kill(os.getpid(), 9)
"""


def test_a_judge_that_is_killed_loses_no_row_and_leaves_no_lock(tmp_path):
    path = tmp_path / "s.sqlite3"
    subprocess.run([sys.executable, "-c", KILLED, str(path)], check=False, timeout=60)
    with ResultStore.open(path) as store:
        assert [each.file for each in store.every()] == ["0", "1", "2", "3", "4"]


def foreign(path):
    with sqlite3.connect(path) as connection:
        connection.execute("CREATE TABLE mine (id INTEGER)")
    connection.close()


@pytest.mark.parametrize(
    ("make", "told"),
    [
        (lambda path: path.write_text("a diary"), "this is not a file of results of the judge"),
        (foreign, "this is another program's database; move it away, or copy the folder"),
        (lambda path: path.mkdir(), "the file of results cannot be "),
        (lambda path: path.write_bytes(b"SQLite format 3\0" + b"\xff" * 4000), "file of results"),
    ],
)
def test_a_file_that_is_not_ours_is_one_line_and_left_alone(tmp_path, make, told):
    path = tmp_path / "s.sqlite3"
    make(path)
    before = None if path.is_dir() else path.read_bytes()
    with pytest.raises(StoreError, match=told) as refused:
        opened(path)
    assert "\n" not in str(refused.value)
    assert before is None or path.read_bytes() == before
    assert [each.name for each in tmp_path.iterdir()] == ["s.sqlite3"]


def test_a_fault_leaves_no_file_that_holds_nothing(tmp_path):
    path = tmp_path / "s.sqlite3"

    def failing(*rows):
        with contextlib.suppress(ZeroDivisionError), ResultStore.open(path) as store:
            store.keep_all(rows)
            raise ZeroDivisionError

    failing()
    assert list(tmp_path.iterdir()) == []
    failing(row())
    assert [each.name for each in tmp_path.iterdir()] == [path.name]
    path.unlink()
    with pytest.raises(StoreError, match="there is no such file of results"):
        ResultStore.read(path).__enter__()
    with ResultStore.open(path):  # a shard may have nothing to do
        pass
    failing()
    assert path.exists()
    with pytest.raises(StoreError, match="cannot be opened"):
        opened(tmp_path / "no\0name")
