"""Links in the folders that `judge run` and `judge class` are given, as a person sees it."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from cli_support import FLOOR, MEAN

pytestmark = pytest.mark.slow


def test_a_student_gets_no_marks_by_a_link(judge, submit):
    submit(MEAN, "class/bob/middle.py")
    submit(FLOOR, "class/eve/middle.py")
    Path("class/ada").mkdir()
    Path("class/ada/middle.py").symlink_to("../bob/middle.py")
    ended = judge("class", "class", "--json", "--no-name")
    rows = {row["student"]: row for row in map(json.loads, ended.lines)}
    assert {name: row["verdict"] for name, row in rows.items()} == {"ada": "JE", "bob": "AC", "eve": "WA"}
    assert rows["ada"]["score"] == 0
    assert ended.status == 3
    ended = judge("class", "class", "--json", "--no-name", "--follow-links")
    rows = {row["student"]: row for row in map(json.loads, ended.lines)}
    assert rows["ada"]["verdict"] == "AC"


def test_a_folder_is_left_by_no_link(judge, submit):
    submit(MEAN, "outside.py")
    submit(MEAN, "folder/inside.py")
    Path("folder/out.py").symlink_to("../outside.py")
    Path("folder/in.py").symlink_to("inside.py")
    ended = judge("run", "-q", "middle", "folder", "--no-history")
    rows = {line.split()[0]: line for line in ended.lines if "folder/" in line}
    assert "JE" in rows["folder/out.py"]
    assert "it is a link out of the folder, which is not followed" in rows["folder/out.py"]
    assert "AC" in rows["folder/in.py"]
    ended = judge("run", "-q", "middle", "folder", "--no-history", "--follow-links")
    assert (ended.status, ended.out.count(" AC ")) == (0, 3)
    ended = judge("run", "-q", "middle", "folder/out.py", "--no-history")  # named by the person
    assert ended.status == 0
