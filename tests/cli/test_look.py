"""`judge list` says what is solved, and keeps to one screen."""

from __future__ import annotations

import json
import re

import pytest
from cli_support import MEAN
from terminals import on_a_terminal

pytestmark = pytest.mark.slow

TEXTBOOK = """
def line_count(cx, cy, r, A, B):
    (ax, ay), (bx, by) = A, B
    if A == B:
        return None
    dx, dy = bx - ax, by - ay
    cross = dx * (ay - cy) - dy * (ax - cx)
    gap = abs(cross) / (dx * dx + dy * dy) ** 0.5 - r
    return 1 if abs(gap) < 1e-9 else 2 if gap < 0 else 0
"""


@pytest.fixture(autouse=True)
def _own_history(tmp_path, monkeypatch):
    monkeypatch.setenv("JUDGE_DB", str(tmp_path / "history.sqlite3"))


def test_a_solved_kata_is_marked_and_is_no_longer_to_do(judge, submit):
    assert "  middle  The middle" in judge("list", "pack0").lines
    assert judge("run", "middle", submit(MEAN), "-q").status == 0
    assert "✓  middle  The middle" in judge("list", "pack0").out
    assert "All katas of this set are solved." in judge("list", "pack0", "--todo").out
    rows = [json.loads(line) for line in judge("list", "--json").lines]
    assert [row["problem"] for row in rows if row["solved"]] == ["middle"]
    todo = [json.loads(line)["problem"] for line in judge("list", "--json", "--todo").lines]
    assert todo == [row["problem"] for row in rows if not row["solved"]]


def test_the_interview_level_alone_is_one_star(judge, submit):
    assert judge("run", "count", submit(TEXTBOOK), "-q").status == 1
    shown = judge("list", "junior").out
    assert "★  count" in " ".join(shown.split(" "))
    assert "0 of 38 katas   ★ 1" in shown


@pytest.mark.parametrize("words", [("list",), ("list", "path"), ("list", "middle", "--todo")])
def test_the_list_is_one_screen_unless_all_is_asked_for(words):
    _, shown = on_a_terminal(*words)
    assert shown.count("\n") <= 23
    assert "judge list --all" in shown


def test_all_lists_every_set_or_the_whole_set(judge):
    every = judge("list", "--all").lines
    assert [row.split()[0] for row in every if row].count("foot") == 1
    assert len(every) > 40
    assert len(on_a_terminal("list", "path", "--all")[1].splitlines()) > 40


def test_a_kata_counts_in_its_first_set(judge):
    counts = [int(line.split()[3]) for line in judge("list").lines if re.fullmatch(r"\S+ +\d+ of \d+", line)]
    assert counts == [1, 6, 6, 9, 9, 7]
    assert sum(counts) == int(judge("list").lines[0].split()[-2])
    told = json.loads(judge("progress", "--json").out)
    shares = [len(each["katas"]) for each in told["sets"]]
    assert shares[:5] == [6, 6, 9, 9, 7]
    assert "count " in judge("list", "middle").out


def test_a_broken_kata_costs_itself_only(judge, broken_pack):
    ended = judge("list", "--problems", "BROKEN", "--json")
    assert ended.status == 3
    assert "bad-toml/problem.toml:14" in ended.err
    assert "count" in [json.loads(line)["problem"] for line in ended.lines]
