"""README's task for VS Code, tried on what the judge really writes."""

from __future__ import annotations

import json
import os
import re
import shlex
import subprocess
import sys

import pytest
from mistaken import mistaken
from pages import ROOT

README = (ROOT / "README.md").read_text(encoding="utf-8")
SOURCES = {
    "wrong.py": mistaken("segment", "tangent-twice"),
    "raises.py": b"def circle_segment(cx, cy, r, A, B):\n    x = 1\n    return x / 0\n",
    "broken.py": b"def circle_segment(cx, cy, r, A, B)\n    return []\n",
}


@pytest.fixture(scope="module")
def task():
    (found,) = [
        block for block in re.findall(r"(?ms)^```json\n(.*?)^```$", README) if "problemMatcher" in block
    ]
    (only,) = json.loads(found)["tasks"]
    return only


@pytest.mark.parametrize(("name", "place"), [("wrong.py", None), ("raises.py", "3"), ("broken.py", "1")])
def test_a_failure_is_a_problem_at_its_line(name, place, task, tmp_path):
    folder = tmp_path / "src"
    folder.mkdir()
    (folder / name).write_bytes(SOURCES[name])
    words = shlex.split(task["command"].replace("${relativeFile}", f"src/{name}"))
    assert words[0] == "judge"
    ended = subprocess.run(
        [sys.executable, "-m", "judge", *words[1:], "--no-history"],
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert (ended.returncode, ended.stderr) == (1, "")
    pattern = task["problemMatcher"]["pattern"]
    found = [re.match(pattern["regexp"], line) for line in ended.stdout.splitlines()]
    assert found
    assert all(found), ended.stdout
    first = found[0]
    assert first[pattern["file"]] == f"src/{name}"
    assert first[pattern["severity"]] == "error"
    assert place in (None, first[pattern["line"]])
    assert first[pattern["message"]].split(" ")[0].rstrip(":") in ("WA", "RTE", "CE")
    assert {each[pattern["severity"]] for each in found[1:]} <= {"note"}
