"""`judge run FOLDER` with a class in it: folders in folders, entries that cannot be read, Ctrl-C."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest
from cli_support import FLOOR, MEAN, ROOT
from jsonschema import Draft202012Validator

from judge.cli.app import app
from judge.schema import schema_of

pytestmark = pytest.mark.slow

SEGMENT = (ROOT / "solutions" / "segment" / "accepted" / "tolerant.py").read_text()
SLOW = "import time\ndef middle(a, b):\n    time.sleep(0.05)\n    return (a + b) / 2\n"


@pytest.fixture
def class_(submit):
    """Two students' files, and what else lies about there."""
    submit(MEAN, "class/ann/middle.py")
    submit(SEGMENT, "class/ann/segment.py")
    submit(FLOOR, "class/bob/try.py")
    submit("x = 1\n", "class/bob/notes.py")
    submit("#" * (5 * 2**20), "class/bob/huge.py")
    submit("", "class/bob/readme.txt")
    for hidden in (".git/a.py", "__pycache__/a.py", "env/lib/a.py"):
        submit(MEAN, f"class/{hidden}")
    submit("", "class/env/pyvenv.cfg")
    Path("class/bob/gone.py").symlink_to("nowhere.py")
    Path("class/bob/friend").symlink_to("../ann")
    os.mkfifo("class/bob/pipe.py")
    return "class"


def test_each_is_judged_on_its_problem_and_what_cannot_be_is_a_row(class_, judge):
    ended = judge("run", "-q", class_, "--no-history")
    assert (ended.status, ended.err) == (3, "")
    assert ended.lines[-1] == "2 of 8 accepted, 5 not judged"
    rows = {name: line for line in ended.lines for name in line.split() if name.startswith("class/")}
    assert sorted(rows) == [
        "class/ann/middle.py",
        "class/ann/segment.py",
        "class/bob/friend",
        "class/bob/gone.py",
        "class/bob/huge.py",
        "class/bob/notes.py",
        "class/bob/pipe.py",
        "class/bob/try.py",
    ]
    for name, words in {
        "ann/middle.py": "AC  100",
        "ann/segment.py": "AC  100",
        "bob/friend": "it is a link to a folder, which is not followed",
        "bob/gone.py": "it is a link to a file that is not there",
        "bob/huge.py": "this file is larger than 4 MB",
        "bob/notes.py": "I cannot tell which kata this file is for",
        "bob/pipe.py": "it is not an ordinary file",
        "bob/try.py": "examples, case 1",
    }.items():
        assert words in rows[f"class/{name}"]


def test_scripts_miss_none(class_, judge):
    ended = judge("run", class_, "--json", "--no-shrink", "--no-name", "--junit", "out.xml")
    results = [json.loads(line) for line in ended.lines]
    assert len(results) == 8, ended
    validator = Draft202012Validator(schema_of(app.get_command(None, "run")))
    for result in results:
        validator.validate(result)
    assert sum(result["verdict"] == "JE" for result in results) == 5
    assert len(ElementTree.parse("out.xml").getroot()) == 8
    assert len(judge("history").lines) == 1 + 3


def test_ctrl_c_shows_the_table_so_far(submit):
    submit(MEAN, "class/a.py")
    submit(SLOW, "class/b.py")
    submit(MEAN, "class/c.py")
    words = [sys.executable, "-m", "judge", "run", "middle", "class", "--junit", "out.xml"]
    with subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as running:
        assert running.stdout is not None
        first = running.stdout.readline()
        running.send_signal(signal.SIGINT)
        out, err = running.communicate(timeout=60)
    assert (first.split()[0], running.returncode, err.strip()) == ("AC", 130, "")
    assert "class/a.py" in first
    assert out.splitlines()[-1] == "1 of 3 accepted, 2 not judged"
    assert len(ElementTree.parse("out.xml").getroot()) == 1


def test_a_folder_that_is_no_class_ends_soon(judge, submit):
    """Not the whole of a disk is read."""
    submit(MEAN, "a/" * 25 + "deep.py")
    submit(MEAN, "a/near.py")
    ended = judge("run", "-q", "middle", "a")
    assert (ended.status, ended.lines[-1]) == (3, "1 of 2 accepted, 1 not judged")
    assert "lies more than 20 levels down" in ended.out


def test_a_student_gets_no_marks_by_a_link(judge, submit):
    submit(MEAN, "class/bob/middle.py")
    submit(FLOOR, "class/eve/middle.py")
    Path("class/ada").mkdir()
    Path("class/ada/middle.py").symlink_to("../bob/middle.py")
    ended = judge("class", "class", "--json")
    rows = {row["student"]: row for row in map(json.loads, ended.lines) if "student" in row}
    assert {name: row["verdict"] for name, row in rows.items()} == {"ada": "JE", "bob": "AC", "eve": "WA"}
    assert rows["ada"]["score"] == 0
    assert ended.status == 3


def test_a_folder_is_left_by_no_link(judge, submit):
    submit(MEAN, "outside.py")
    submit(MEAN, "folder/inside.py")
    Path("folder/out.py").symlink_to("../outside.py")
    Path("folder/in.py").symlink_to("inside.py")
    ended = judge("run", "-q", "middle", "folder", "--no-history")
    rows = {name: line for line in ended.lines for name in line.split() if "folder/" in name}
    assert "JE" in rows["folder/out.py"]
    assert "it is a link out of the folder, which is not followed" in rows["folder/out.py"]
    assert "AC" in rows["folder/in.py"]
    ended = judge("run", "-q", "middle", "folder/out.py", "--no-history")  # named by the person
    assert ended.status == 0


# -- what could not be held ------------------------------------------------------------------------------
