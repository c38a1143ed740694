"""A problem without a topic works in every command, without a picture and without another topic's words."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from cli_support import FLOOR, MEAN

WORDS = re.compile(r"\b(circles?|rays?|tangents?|segments?|extents?|radius|chord|e away)\b", re.IGNORECASE)


@pytest.mark.parametrize(
    ("words", "status"),
    [
        ("run middle floor.py", 1),
        ("run middle mean.py floor.py --json", 1),
        ("run middle floor.py --junit results.xml", 1),
        ("run middle floor.py --format github", 1),
        ("run middle floor.py --save-regression test_it.py", 1),
        ("stress middle floor.py --for 30", 1),
        ("stress middle mean.py --for 0.2s", 0),
        ("data middle --out data", 0),
        ("show middle", 0),
        ("init middle", 0),
        ("why middle", 0),
        ("verify middle --matrix", 0),
        ("hint middle", 0),
        ("solution middle --give-up", 0),
    ],
)
def test_no_command_speaks_of_circles(words, status, judge, submit):
    submit(FLOOR, "floor.py")
    submit(MEAN, "mean.py")
    ended = judge(*words.split())
    assert ended.status == status
    written = [path for path in Path().rglob("*") if path.is_file() and path.suffix != ".svg"]
    for text in (ended.out, ended.err, *(path.read_text(encoding="utf-8") for path in written)):
        assert WORDS.findall(text) == []


def test_nothing_is_drawn(judge, submit):
    ended = judge("run", "middle", submit(FLOOR), "--svg", "case.svg")
    assert ended.status == 1
    assert ended.err == "judge: nothing to draw, case.svg is not written: no case failed that can be drawn\n"
    assert not Path("case.svg").exists()
    assert judge("report").status == 0
    assert "drawings" not in Path("judge-report.html").read_text(encoding="utf-8").partition("<main")[2]
