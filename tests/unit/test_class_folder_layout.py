"""Whose file is for which problem: a class's folder in both layouts, odd files, and the list of students.

Lists that are refused are in golden/transcripts: refused/class-list.txt.
"""

from __future__ import annotations

import errno
import os
from pathlib import Path

import pytest
from msgspec.structs import replace

from judge.batch.folder import display_name, read_class
from judge.batch.platforms import Roster
from judge.batch.roster import read_students
from judge.errors import UsageError
from judge.report.published_klass import Student

FIXTURES = Path(__file__).parents[1] / "fixtures"
PROBLEMS = [FIXTURES / "pack" / "problems", FIXTURES / "problems"]  # middle, root-count
MEAN = "def middle(a, b):\n    return (a + b) / 2\n"


@pytest.fixture
def place(tmp_path, monkeypatch):
    monkeypatch.delenv("JUDGE_PROBLEMS", raising=False)
    return tmp_path / "class"


def write(place, *names, text=MEAN):
    for name in names:
        path = place / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def found(place, **more):
    return read_class(place, folders=PROBLEMS, **more)


def placed(place, **more):
    return [(each.student, each.problem, each.file) for each in found(place, **more).submissions]


def test_a_folder_for_each_student(place):
    write(place, "ada/middle.py", "ada/week1/root_count.py", "bob/Root-Count.py", "bob/middle.cpp")
    write(place, "cy/homework one.py")  # which tells by its function
    assert placed(place) == [
        ("ada", "middle", "ada/middle.py"),
        ("ada", "root-count", "ada/week1/root_count.py"),
        ("bob", "middle", "bob/middle.cpp"),
        ("bob", "root-count", "bob/Root-Count.py"),
        ("cy", "middle", "cy/homework one.py"),
    ]
    assert placed(place, only=("root-count",)) == placed(place)[1:2] + placed(place)[3:4]


def test_a_folder_for_each_problem(place):
    write(place, "middle/ada.py", "middle/ada.lovelace.py", "root_count/bob/any.py", text="x = 1\n")
    assert placed(place) == [
        ("ada", "middle", "middle/ada.py"),
        ("ada.lovelace", "middle", "middle/ada.lovelace.py"),
        ("bob", "root-count", "root_count/bob/any.py"),
    ]


def test_a_student_who_is_called_like_a_problem(place):
    write(place, "middle/root-count.py")
    assert placed(place) == [("root-count", "middle", "middle/root-count.py")]
    assert placed(place, roster=Roster([Student("middle")])) == [
        ("middle", "root-count", "middle/root-count.py")
    ]


def test_what_nobody_has_handed_in_is_left_out(place):
    write(place, ".git/ada/middle.py", "ada/__pycache__/middle.py", "ada/.middle.py", "ada/._middle.py")
    write(place, "ada/env/middle.py", "ada/env/pyvenv.cfg", "node_modules/a/middle.py", "ada/middle.py")
    assert placed(place) == [("ada", "middle", "ada/middle.py")]


def test_what_is_not_judged_is_named_with_the_reason(place):
    write(place, "middle.py", "ada\\middle.py", "ada/notes.txt", "README.md")
    write(place, "ada/nothing.py", text="x = 1\n")
    read = found(place)
    assert read.submissions == ()
    assert {each.file: each.why for each in read.unplaced} == {
        "middle.py": "it lies in no student's folder",
        "ada\\middle.py": "its name holds a backslash where folders should be: "
        "unpack the archive again, with 'unzip'",
        "ada/nothing.py": "no kata has that name, and it defines no kata's function",
        "README.md": "not a program, by its name",
        "ada/notes.txt": "not a program, by its name",
    }


def test_a_folder_of_too_many_files_is_refused(place, monkeypatch):
    write(place, "ada/middle.py", "ada/a.txt", "ada/b.txt")
    monkeypatch.setattr("judge.files._MOST", 3)
    with pytest.raises(UsageError, match="more than 3 files"):
        found(place)


def test_an_odd_file_costs_its_own_row(place, tmp_path):
    write(place, "well/middle.py")
    write(place, "empty/middle.py", text="")
    write(place, "huge/middle.py", text="#" * (4 * 2**20 + 1))
    write(tmp_path, "secret.py")
    for name, target in {
        "out": tmp_path / "secret.py",
        "dangling": "gone",
        "loop": "middle.py",
        "within": "../well/middle.py",
    }.items():
        (place / name).mkdir()
        (place / name / "middle.py").symlink_to(target)
    (place / "fifo").mkdir()
    os.mkfifo(place / "fifo" / "middle.py")
    write(place, "folder/middle.py/middle.py")  # a folder like any other
    (place / "linked").symlink_to(tmp_path)
    why = {each.student: each.why for each in found(place).submissions}
    assert why == {
        "well": "",
        "empty": "",
        "within": "it is a link to another student's folder, which is not followed:"
        " put the file itself there",
        "huge": "this file is larger than 4 MB",
        "out": "it is a link out of the folder, which is not followed: put the file itself there",
        "dangling": "it is a link to a file that is not there",
        "loop": "cannot be read (too many levels of symbolic links)",
        "fifo": "it is not an ordinary file",
        "folder": "",
    }
    assert all(each.source == b"" for each in found(place).submissions if each.why)


def test_a_file_or_a_folder_that_may_not_be_read_is_named_with_the_reason(place, monkeypatch):
    write(place, "ada/middle.py", "ada/locked/root_count.py")
    own = os.scandir

    def refused(path, *_):
        if not isinstance(path, str | Path) or not str(path).endswith("locked"):
            return own(path)
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), path)

    def unread(*_):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))

    monkeypatch.setattr(os, "scandir", refused)
    monkeypatch.setattr("judge.files.read_inside", unread)
    seen = found(place)
    (only,) = seen.submissions
    assert (only.problem, only.why) == ("middle", "cannot be read (permission denied)")
    (left_out,) = seen.unplaced
    assert (left_out.file, left_out.why) == ("ada/locked", "cannot be read (permission denied)")


def test_names_that_are_no_text_are_made_legible(place):
    write(place, "a\nb/middle.py", "Zoe\u0308/middle.py")
    write(place, f"{os.fsdecode(bytes([255]))}/middle.py")
    assert sorted(student for student, _, _ in placed(place)) == ["Zoë", "\\xff", "a\nb"]
    assert display_name(os.fsdecode(b"\xff")).encode() == b"\\xff"


def students(tmp_path, content):
    path = tmp_path / "list.csv"
    path.write_text(content, newline="")
    return [replace(each, cells=()) for each in read_students(path).students]


@pytest.mark.parametrize(
    "content",
    [
        "\ufeffid;name;group\r\nada;Ada L;a\r\n\r\nbob;Bob;\r\n",
        "sep=;\r\nid;name;group\r\nada;Ada L;a\r\nbob;Bob;\r\n",
        '"sep=\t"\nid\tname\tgroup\nada\tAda L\ta\nbob\tBob\t\n',
        '\n"id","Name","Group"\n"ada","Ada L","a"\nbob,Bob\n,,\n',
    ],
)
def test_the_list_is_read_as_spreadsheets_write_it(tmp_path, content):
    assert students(tmp_path, content) == [Student("ada", "Ada L", "a"), Student("bob", "Bob")]
    assert students(tmp_path, "login,mail\nada,a@b.c\n") == [Student("ada")]  # without an id the first column
