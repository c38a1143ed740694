"""What is written for Dolos, and how it is called."""

from __future__ import annotations

import csv
import io
import os
import zipfile

import pytest
from classes import row

from judge.batch.model import Handin, Student
from judge.batch.outcome import Outcome
from judge.batch.similar import compared, similar_folder
from judge.problem.find import find_problem

DOLOS = """#!/bin/sh
echo "$@" > called
case "$*" in *count*) ;; *) echo "no parser for it" >&2; exit 1;; esac
mkdir "$5"
"""
HANDINS = [
    Handin("ann", "count", "ann/count.py", b"a = 1\n"),
    Handin("ann", "count", "ann/count-2.py", b"a = 2\n"),
    Handin("bob", "count", "-f ../b\x1b/count.py", b"b = 1\n"),
    Handin("ann", "segment", "ann/segment.cpp", b"int a;"),
    Handin("bob", "segment", "bob/segment.cpp", b"int b;"),
    Handin("bob", "ray-nearest", "bob/ray.py", b"c"),
]


@pytest.fixture
def outcome():
    """Ann's second file for count is better than her first."""
    rows = [row(each.student, each.problem, fails=("grid",), file=each.file) for each in HANDINS]
    rows[1] = row("ann", "count", file="ann/count-2.py")
    students = (Student("ann", "=1+1", "A"), Student("bob"))
    return Outcome(students, ("count", "ray-nearest", "segment"), tuple(rows))


def compare(folder, outcome):
    return compared(folder, outcome, HANDINS, {"count": find_problem("count")})


def test_an_archive_for_each_problem_and_language(outcome, tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    folder = tmp_path / "geo.judge.similar"
    told = compare(folder, outcome)
    assert [(each.archive.name, each.files, each.report, each.why) for each in told] == [
        ("count-python.zip", 2, None, ""),
        ("segment-cpp.zip", 2, None, ""),
    ]
    with zipfile.ZipFile(told[0].archive) as archive:
        assert archive.namelist() == ["0001.py", "0002.py", "info.csv"]
        assert [archive.read(name) for name in ("0001.py", "0002.py")] == [b"a = 2\n", b"b = 1\n"]
        rows = list(csv.DictReader(io.StringIO(archive.read("info.csv").decode())))
    assert rows[0] == {
        "filename": "0001.py",
        "full_name": "'=1+1",
        "labels": "A",
        "student": "ann",
        "file": "ann/count-2.py",
    }
    assert (rows[1]["full_name"], rows[1]["file"]) == ("bob", "'-f ../b\\x1b/count.py")
    assert b"def line_count" in (folder / "count-python.stub.py").read_bytes()
    before = told[0].archive.read_bytes()
    compare(folder, outcome)
    assert told[0].archive.read_bytes() == before


def test_dolos_is_called_where_it_is_installed(outcome, tmp_path, monkeypatch):
    command = tmp_path / "bin" / "dolos"
    command.parent.mkdir()
    command.write_text(DOLOS)
    command.chmod(0o755)
    monkeypatch.setenv("PATH", f"{command.parent}{os.pathsep}{os.environ['PATH']}")
    folder = tmp_path / "geo.judge.similar"
    count, segment = compare(folder, outcome)
    assert (count.report, count.why) == (folder / "count-python-report", "")
    assert (segment.report, segment.why) == (None, "no parser for it")
    called = (folder / "called").read_text()
    words = "run --output-format csv --output-destination"
    assert called == f"{words} segment-cpp-report segment-cpp.zip\n"
    again, _ = compare(folder, outcome)
    assert again.report == folder / "count-python-report-2"


def test_where_it_is_written(tmp_path):
    assert similar_folder(tmp_path / "geo.judge.sqlite3") == tmp_path / "geo.judge.similar"
    assert similar_folder(tmp_path / "mine.db") == tmp_path / "mine.db.judge.similar"
