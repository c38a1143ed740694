"""The two levels of a kata as the commands show them; the kata is the one that `judge new` writes."""

from __future__ import annotations

import json
import re

import pytest

RIGHT = "from math import hypot\n\n\ndef kata(P, Q):\n    return hypot(P[0] - Q[0], P[1] - Q[1])\n"
TEXTBOOK = RIGHT.replace("return hypot", "return min(1e6, hypot").replace("P[1] - Q[1])", "P[1] - Q[1]))")
WRONG = "def kata(P, Q):\n    return 1\n"


@pytest.fixture
def kata(judge, submit, monkeypatch):
    """A kata called `kata`: its groups examples and small are of the interview level, large of the other."""
    assert judge("new", ".", "kata").status == 0
    monkeypatch.setenv("JUDGE_PROBLEMS", "problems")
    monkeypatch.setenv("COLUMNS", "80")
    submit(RIGHT, "right.py")
    submit(TEXTBOOK, "textbook.py")
    submit(WRONG, "wrong.py")
    return "kata"


def objects(ended):
    """What it wrote as JSON."""
    return [json.loads(line) for line in ended.lines]


def rows(ended):
    """The rows of the table of levels, by kata, as words."""
    table = ended.out[ended.out.index("  kata ") :].partition("\n\n")[0].splitlines()
    assert table[0].split() == ["kata", "interview", "level", "production", "level"]
    return {name: rest for name, *rest in map(str.split, table[1:])}


def verdict(ended):
    """The last lines, from the verdict on, as one."""
    text = ended.out[ended.out.rindex("\n\n") + 2 :] if "\n\n" in ended.out else ended.out
    return " ".join(text.split())


def test_a_run_that_passes_the_interview_level_says_so_first(judge, kata):
    ended = judge("run", "--no-name", kata, "textbook.py")
    assert ended.status == 1
    told = "WA interview level passed; production level: 0 of 1 group; wrong answer, 60 of 100 points"
    assert verdict(ended).startswith(told)
    assert verdict(judge("run", "-q", kata, "textbook.py")).startswith(told)


@pytest.mark.parametrize(
    ("file", "told"), [("right.py", "AC accepted, 100"), ("wrong.py", "WA wrong answer, ")]
)
def test_nothing_is_said_of_levels_where_the_verdict_says_it(judge, kata, file, told):
    ended = judge("run", "--no-name", kata, file)
    assert verdict(ended).startswith(told)
    assert "level" not in ended.out


def test_one_level_alone_is_judged_and_is_not_the_whole(judge, kata):
    ended = judge("run", "--level", "interview", kata, "textbook.py")
    assert ended.status == 0
    assert "large" not in ended.out
    assert verdict(ended).startswith(
        "AC interview level passed; production level not judged; accepted, on 2 of 3 groups only"
    )
    ended = judge("run", "--level", "production", "--no-name", kata, "textbook.py")
    assert ended.status == 1
    assert verdict(ended).startswith("WA wrong answer, on 1 of 3 groups only, 0 of 40 points")
    (shown,) = objects(judge("progress", "--json"))
    (skill,) = [each for each in shown["skills"] if each["name"] == "distance of two points"]
    assert skill["state"] == "open"  # it asks for both


def test_json_says_what_was_run_and_accepted(judge, kata):
    (value,) = objects(judge("run", "--json", "--level", "interview", kata, "textbook.py"))
    assert value["levels"] == [
        {"level": "interview", "passed": True, "groups": 2, "run": 2, "accepted": 2},
        {"level": "production", "passed": False, "groups": 1, "run": 0, "accepted": 0},
    ]
    assert [group["level"] for group in value["groups"]] == ["interview", "interview"]
    (row,) = objects(judge("history", "--json"))
    assert row["levels"] == ["interview"]
    assert row["result"]["levels"] == value["levels"]
    header, line = judge("history", "--csv").lines
    assert dict(zip(header.split(","), line.split(","), strict=True))["levels"] == "interview"


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("--level", "interview", "--group", "large"), "no group that is named is of the interview level"),
        (("--level", "intervew"), "'intervew' is not one of 'interview', 'production'"),
    ],
)
def test_a_level_that_chooses_nothing_is_one_line(judge, kata, words, told):
    ended = judge("run", *words, kata, "right.py")
    assert (ended.status, ended.out) == (2, "")
    assert len(ended.err.splitlines()) == 1
    assert told in ended.err


def test_a_kata_without_levels_has_none_to_choose(judge, submit):
    file = submit("def floor_half(a):\n    return a // 2\n")
    ended = judge("run", "--level", "interview", "middle", file)
    assert (ended.status, ended.err) == (2, "judge: middle has one level only; leave the level out\n")
    assert judge("watch", "--level", "interview", "middle", file).err == ended.err
    for words in (("show", "middle"), ("why", "middle"), ("run", "middle", file)):
        assert not re.search(r"(interview|production) level|levels", judge(*words).out)
    assert "middle" not in rows(judge("progress", "--all"))


@pytest.mark.parametrize("command", ["run", "stress"])
def test_the_commands_that_judge_take_a_level(judge, kata, command):
    more = ("--for", "0.1s", "--json") if command == "stress" else ("--json",)
    (value,) = objects(judge(command, "--level", "interview", *more, kata, "right.py"))
    assert {group["name"] for group in value["groups"]} <= {"examples", "small"}
    assert "small" in {group["name"] for group in value["groups"]}


def test_one_case_says_nothing_of_a_level(judge, kata):
    """The production level has one group, and the case is all that is judged of it."""
    (value,) = objects(judge("run", "--json", "--no-name", "--level", "production", kata, "textbook.py"))
    replay = value["counterexample"]["replay"]
    ended = judge("replay", replay, "right.py")
    assert ended.status == 0
    assert "level" not in ended.out
    assert "levels" not in objects(judge("replay", "--json", replay, "right.py"))[0]


SHOWN = """\
Test groups, interview level  63 cases, 60 points
  group     cases  points  about
  examples      3      10  The worked examples of the statement.
  small        60      50  Small coordinates of either sign.

Test groups, production level  60 cases, 40 points
  group  cases  points  about
  large     60      40  Coordinates up to a thousand million.
"""


def test_show_lists_the_groups_of_each_level(judge, kata):
    assert SHOWN in judge("show", kata).out
    (value,) = objects(judge("show", "--json", kata))
    assert [group["level"] for group in value["groups"]] == ["interview", "interview", "production"]


WHY = """\
Interview level  2 groups, 63 cases, 60 points
  It asks for the kinds of cases there are, at sizes that a textbook has.

examples
  The worked examples of the statement.

small
  Small coordinates of either sign.
    sum-of-legs       The legs are added up, which is the way around the corner.

Production level  1 group, 60 cases, 40 points
  It adds sizes from tiny to huge, places far from the origin, the edges of
  bands, last digits, growth.
  Only here caught: no-kata-is-large.

large
"""


def test_why_says_what_production_adds(judge, kata, tmp_path):
    toml = tmp_path / "problems" / "kata" / "problem.toml"
    text = toml.read_text()
    first, last = text.rsplit('kills = ["sum-of-legs"]', 1)
    toml.write_text(f'{first}kills = ["sum-of-legs", "no-kata-is-large"]{last}')
    assert WHY in judge("why", kata).out
    (value,) = objects(judge("why", "--json", kata))
    assert [(each["level"], each["groups"], each["only"]) for each in value["levels"]] == [
        ("interview", 2, []),
        ("production", 1, ["no-kata-is-large"]),
    ]
    assert "large  production level\n" in judge("why", kata, "large").out


def test_progress_shows_both_levels(judge, kata):
    assert rows(judge("progress", "--all"))["kata"] == []
    judge("run", "-q", kata, "textbook.py")
    ticked, _date = rows(judge("progress", "--all"))["kata"]
    assert ticked == "✓"
    (value,) = objects(judge("progress", "--json"))
    interview, production = [each for each in value["levels"] if each["problem"] == "kata"]
    assert (interview["level"], interview["groups"], interview["best"]) == ("interview", 2, 2)
    assert interview["since"].startswith("20")
    assert (production["level"], production["groups"], production["best"]) == ("production", 1, 0)
    assert production["since"] is None
    judge("run", "-q", kata, "right.py")
    assert rows(judge("progress", "--all"))["kata"][::2] == ["✓", "✓"]


def test_a_program_that_passes_neither(judge, kata):
    (value,) = objects(judge("run", "--json", kata, "wrong.py"))
    assert [each["passed"] for each in value["levels"]] == [False, False]
