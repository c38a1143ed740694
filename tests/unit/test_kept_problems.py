"""The index of problems that were read before: warm, stale, torn, forged, and nowhere to be written."""

from __future__ import annotations

import hashlib
import os
import shutil
from pathlib import Path

import pytest
from msgspec.structs import replace

import judge.cache
import judge.problem.load as loading
from judge.problem.find import find_problem, sound_problems
from judge.problem.load import load_problem
from judge.problem.model import Listed

SOUND = Path(__file__).parent.parent / "fixtures" / "problems" / "root-count"


@pytest.fixture
def kata(tmp_path, monkeypatch):
    """A copy of the sound problem, read once; each change counts at once, be the file ever so young."""
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path / "cache"))
    monkeypatch.setattr(judge.cache, "_YOUNG", -1e9)
    loading._code_stamp.cache_clear()
    folder = tmp_path / "problems" / "root-count"
    shutil.copytree(SOUND, folder)
    load_problem(folder)
    yield folder
    loading._code_stamp.cache_clear()


def index(kata, end=""):
    (found,) = (kata.parent.parent / "cache" / "problems").glob(f"{'[0-9a-f]' * 16}{end}")
    return found


def never(*_):
    pytest.fail("it is not asked for")


def test_a_warm_start_reads_the_index_alone(kata, monkeypatch):
    whole = load_problem(kata)
    monkeypatch.setattr(loading, "problem_key", never)
    monkeypatch.setattr("judge.problem.read.read_problem", never)
    assert load_problem(kata) == whole
    listed = loading.Shelf(kata.parent).problem(kata, Listed)
    assert (type(listed), listed.id, listed.title) == (Listed, "root-count", whole.title)
    assert [group.count for group in listed.groups] == [group.count for group in whole.groups]


def test_what_is_touched_is_looked_into_and_not_run(kata, monkeypatch):
    before, text = load_problem(kata), index(kata).read_bytes()
    os.utime(kata / "problem.py")
    monkeypatch.setattr("judge.problem.read.read_problem", never)
    assert load_problem(kata) == before
    assert index(kata).read_bytes() != text


def test_an_edit_that_keeps_the_size_and_the_time_is_seen(kata):
    path = kata / "statement.md"
    was = path.stat()
    path.write_text(path.read_text().replace("square", "SQUARE"))
    os.utime(path, ns=(was.st_atime_ns, was.st_mtime_ns))
    assert path.stat().st_size == was.st_size
    assert "SQUARE" in load_problem(kata).statement


def test_a_file_that_is_young_is_read(kata, monkeypatch):
    """On some file systems two changes of one moment have the same time."""
    monkeypatch.setattr(judge.cache, "_YOUNG", 1e9)
    assert judge.cache.stamp([str(kata / "statement.md")]) == ""
    assert judge.cache.stamp([str(kata / "nothing.md")]) == ""


BODIES = [b"", b"[]", b"[" * 100_000, b'{"root-count": 3}', b'{"root-count": ["", "", {}]}', b"\xff"]


@pytest.mark.parametrize("end", ["", "-root-count"])
@pytest.mark.parametrize("sealed", [True, False])
@pytest.mark.parametrize("body", BODIES, ids=lambda body: repr(body[:20]))
def test_a_torn_or_foreign_file_costs_a_rebuild(body, sealed, end, kata):
    before = load_problem(kata)
    key = (before.key if end else loading._FORMAT).encode()
    seal = hashlib.blake2b(key + b"\n" + body, digest_size=32).hexdigest().encode()
    index(kata, end).write_bytes((seal if sealed else b"0" * 64) + b"\n" + body)
    assert load_problem(kata) == before
    assert b'"root_count"' in index(kata, end).read_bytes()


def test_a_head_that_is_none_under_the_right_stamp_is_read_again(kata):
    shelf = loading.Shelf(kata.parent)
    stamp, key, _ = shelf._heads["root-count"]
    torn = {"root-count": (stamp, key, {"id": "root-count"})}
    loading.DISK.write(shelf._name, loading._FORMAT, torn)
    assert loading.Shelf(kata.parent).problem(kata, Listed).title == load_problem(kata).title


def test_a_folder_that_cannot_be_written_costs_time_alone(kata, tmp_path, monkeypatch):
    before = load_problem(kata)
    (tmp_path / "file").write_text("in the way")
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path / "file"))
    assert load_problem(kata) == before
    assert sound_problems([kata.parent])[0][0].id
    assert load_problem(kata, tmp_path) == replace(before, solutions=tmp_path)


@pytest.mark.parametrize("name", ["segment", "error-bound", "nearest"])
def test_the_answer_of_an_example_keeps_its_form(name, tmp_path, monkeypatch):
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path / "cache"))
    first, again = ([each.wanted for each in find_problem(name).examples] for _ in range(2))
    assert repr(first) == repr(again)
