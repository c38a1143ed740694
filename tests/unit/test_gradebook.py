"""The gradebook: every cell where it belongs, and none that a spreadsheet would calculate."""

from __future__ import annotations

import csv
import io

import pytest
from classes import class_of, row, small_class

from judge.batch.model import Student
from judge.report.cohort.gradebook import gradebook, is_gradebook
from judge.report.sheet import cell


def read(content, delimiter=","):
    return list(csv.reader(io.StringIO(content.decode("utf-8-sig"), newline=""), delimiter=delimiter))


def test_a_line_a_student():
    content = gradebook(small_class())
    assert content.startswith(b'\xef\xbb\xbf"student","name","group","segment","count","total",')
    head, *lines = read(content)
    assert head[6:] == ["segment verdict", "segment mistake", "count verdict", "count mistake"]
    assert lines[0] == ["ann", "Ann Lee", "A", "30", "90", "120", "WA", "tangent-twice", "AC", ""]
    assert lines[2][3:] == ["0", "60", "60", "CE", "", "WA", "forgotten-abs"]
    assert lines[3][:6] == ["dee\\x1b[31m王", "王小明", "B", "60", "", "60"]
    assert lines[4] == ["eve", "<script>alert(1)</script>", "B", "", "", "0", "", "", "", ""]
    assert [each[0] for each in lines] == ["ann", "bob", "cid", "dee\\x1b[31m王", "eve", "zoe"]
    assert content.count(b"\r\n") == 7
    assert is_gradebook(content[:100])
    assert is_gradebook(b"\xef\xbb\xbfstudent,name,group,segment\r\n")
    assert not is_gradebook(b"name,student\r\n")


@pytest.mark.parametrize(
    ("name", "shown"),
    [
        ("=1+1", "'=1+1"),
        ("+49", "'+49"),
        ("-x", "'-x"),
        ("@SUM(A1)", "'@SUM(A1)"),
        (" =1", " '=1"),
        ("\t=1", "\\t=1"),
        ("\r=1", "\\r=1"),
        ("a\nb", "a\\nb"),
        ("＝1", "'＝1"),
        ('a";=cmd|x', "a\";'=cmd|x"),
        ("a;=1", "a;'=1"),
        ('",=1', "\",'=1"),
        ("Anna-Maria O'Neil, Dr.", "Anna-Maria O'Neil, Dr."),
    ],
)
def test_no_cell_is_calculated(name, shown):
    assert cell(name) == shown
    content = gradebook(class_of(row("s", "count", file="=f.py"), students=[Student("s", name)]))
    assert read(content)[1][1] == shown
    for delimiter in ",;\t":  # whatever is usual where it is opened
        assert not [
            each
            for line in read(content, delimiter)
            for each in line
            if each.lstrip(' "')[:1] in tuple("=+-@")
        ]


def test_half_a_character_is_no_fault():
    assert "\\udcff" in gradebook(class_of(students=[Student("a\udcff")])).decode()
