"""A run on some of the groups never claims the whole: not on the screen, in the history or in practice."""

from __future__ import annotations

import json

import pytest
from cli_support import FLOOR, MEAN, ROOT
from test_run_screen import on_a_terminal

pytestmark = pytest.mark.slow

ONE = ("--group", "whole")


def test_the_screen_says_how_many_groups_were_run(judge, submit):
    ended = judge("run", "middle", submit(MEAN), *ONE)
    assert ended.status == 0
    assert "  1 group accepted, 2 not run" in ended.lines
    assert ended.lines[-1].startswith("AC  accepted, on 1 of 3 groups only, 40 of 40 points, 20 cases")
    assert "of 3 groups" not in judge("run", "middle", "mine.py").out
    every = [word for name in ("examples", "whole", "half") for word in ("--group", name)]
    assert "of 3 groups" not in judge("run", "middle", "mine.py", *every).out
    assert "WA  wrong answer, on 2 of 3 groups only" in judge("run", "middle", submit(FLOOR), *every[2:]).out


def test_the_table_and_the_short_form_say_it_too(judge, submit):
    submit(MEAN, "team/a.py")
    submit(FLOOR, "team/b.py")
    assert judge("run", "-q", "middle", "team", *ONE).lines[-1] == (
        "2 of 2 accepted on 1 of 3 groups only  middle"
    )
    assert "on 1 of 3 groups only" in judge("run", "-q", "middle", "team/a.py", *ONE).out


def test_no_solution_is_offered(submit):
    name = submit(MEAN)
    assert "judge solution" in on_a_terminal("run", "middle", name)[1]
    assert "judge solution" not in on_a_terminal("run", "middle", name, *ONE)[1]


def test_nothing_is_passed_by_it(judge, submit):
    judge("run", "middle", submit(MEAN), *ONE)
    judge("run", "middle", "mine.py", "--group", "half")
    judge("run", "middle", "mine.py", "--group", "examples")
    assert "not solved yet" in judge("solution", "middle").err
    history = judge("history", "middle")
    assert "only whole" in history.out
    assert "only half" in history.out
    judge("run", "middle", "mine.py")
    assert "not solved yet" not in judge("solution", "middle").err
    assert "only" not in judge("history", "middle", "--limit", "1").lines[1]


def test_a_kata_of_the_path_is_tried_and_no_more(judge, submit):
    right = (ROOT / "solutions" / "count" / "accepted" / "quadratic.py").read_bytes()
    assert judge("run", "-q", "count", submit(right), "--group", "grid").status == 0
    problems = json.loads(judge("practice", "--json").out)["problems"]
    assert [each["state"] for each in problems if each["problem"] == "count"] == ["tried"]
