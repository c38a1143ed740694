"""`judge practice`, `judge progress` and `judge due`, from the first kata to the review weeks later."""

from __future__ import annotations

import json
import shutil
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest
from cli_support import FLOOR, MEAN, ROOT

from judge.kata import history as kept
from judge.kata.history import History
from judge.kata.sets import find_set
from judge.kata.stub import file_name
from judge.problem import Verdict
from judge.problem.find import all_problems, find_problem
from judge.run.result import GroupResult, Mode, Pitfall, Result

SET = 'title = "Means"\nabout = "The middle of two numbers."\n'
SKILL = """
[skills."no floor"]
about = "Half of an odd number is no integer."
groups = ["half"]
"""


@pytest.fixture
def own_pack(pack, tmp_path, monkeypatch):
    """The tests' pack with a set and a skill that its problem brings, and an empty current folder."""
    folder = tmp_path / "pack" / "problems"
    shutil.copytree(pack, tmp_path / "pack")
    (folder / "sets").mkdir()
    (folder / "sets" / "means.toml").write_text(SET)
    text = (folder / "middle" / "problem.toml").read_text()
    (folder / "middle" / "problem.toml").write_text(f'sets = ["means"]\n{text}{SKILL}')
    monkeypatch.setenv("JUDGE_PROBLEMS", str(folder))
    monkeypatch.chdir(tmp_path)
    return folder


def passed(problem, *, without=(), mistake=None, when=None):
    """Keep a run that passed the whole problem but for these groups."""
    groups = tuple(
        GroupResult(
            group.name, Verdict.WA if group.name in without else Verdict.AC, 9, 9, None, 0.0, group.points
        )
        for group in find_problem(problem).groups
    )
    verdict = Verdict.WA if without else Verdict.AC
    pitfall = Pitfall((mistake,), 0.9, ("",)) if mistake else None
    with History.open(clock=lambda: when or datetime.now(UTC)) as history:
        source = str(len(history.runs())).encode()
        history.add(Result(problem, "a.py", Mode.FUNCTION, verdict, groups, pitfall=pitfall), source, "/a.py")


def current():
    with History.open(reading=True) as history:
        return history.current()


def test_a_session_from_the_first_kata_to_the_last(judge, own_pack, tmp_path):
    shown = judge("practice", "means")
    assert shown.status == 0
    assert shown.lines[:3] == [
        "Writing middle.py, which is not there yet: the stub of middle.",
        "",
        "Means  0 of 1 passed",
    ]
    assert "middle  new, in hand" in shown.out
    assert shown.lines[-2:] == ["middle is in hand; begin with middle.py.", "  next  judge run"]
    assert (tmp_path / "middle.py").is_file()
    assert (current().problem, current().path) == ("middle", str(tmp_path / "middle.py"))

    judge("run", "-q", "middle", "middle.py")
    assert "middle  tried, in hand" in judge("practice", "means").out

    (tmp_path / "middle.py").write_text(MEAN)
    judge("run", "-q", "middle", "middle.py")
    assert current().problem == "middle", "nothing moves on by itself"
    shown = judge("practice", "means")
    assert shown.lines[0] == "Means  1 of 1 passed"
    assert "middle  passed" in shown.out
    assert "judge due" in shown.lines[-1]
    assert (tmp_path / "middle.py").read_text() == MEAN


def test_it_takes_up_the_first_that_is_not_passed(judge, own_pack):
    first, second, third = [each.id for each in find_set("path").problems][:3]
    passed(first)
    judge("practice")
    assert current().problem == second
    passed(second)
    assert current().problem == second
    judge("practice")
    assert current().problem == third
    assert Path(file_name(find_problem(third))).is_file()


def test_a_kata_of_the_set_that_is_in_hand_stays_in_hand(judge, own_pack, tmp_path):
    (tmp_path / "my-ray.py").write_text(MEAN)
    with History.open() as history:
        history.take_up("ray-nearest", str(tmp_path / "my-ray.py"))
    found = json.loads(judge("practice", "--json").out)
    assert found["current"] == {"problem": "ray-nearest", "file": "my-ray.py", "new": False}
    judge("practice", "junior")  # which does not hold it
    assert current().problem == find_set("junior").problems[0].id


def test_a_file_that_is_there_is_never_written_over(judge, own_pack, tmp_path):
    (tmp_path / "middle.py").write_text(FLOOR)
    found = json.loads(judge("practice", "means", "--json").out)
    assert found["current"]["new"] is False
    assert (tmp_path / "middle.py").read_text() == FLOOR


def test_a_session_as_json(judge, own_pack):
    passed("middle", without=("half",))
    found = json.loads(judge("practice", "means", "--json").out)
    assert (found["schema"], found["set"], found["next"]) == (1, "means", "judge run")
    (middle,) = found["problems"]
    assert (middle["problem"], middle["state"], middle["attempts"]) == ("middle", "tried", 1)
    assert middle["passed"] is None
    passed("middle")
    found = json.loads(judge("practice", "means", "--json").out)
    assert (found["current"], found["next"]) == (None, None)
    assert found["problems"][0]["passed"].endswith("+00:00")


def test_a_folder_where_no_file_can_be_begun(judge, own_pack, tmp_path):
    (tmp_path / "middle.py").symlink_to("/proc/none/middle.py")
    ended = judge("practice", "means")
    assert ended.status == 2
    assert ended.err.startswith("judge: ")
    assert ended.err.count("\n") == 1
    assert current() is None


@pytest.mark.parametrize("command", ["practice", "progress"])
def test_a_set_that_is_not_there(command, judge, own_pack):
    ended = judge(command, "mean")
    assert (ended.status, ended.out) == (2, "")
    assert ended.err == "judge: no practice set is called 'mean'; did you mean 'means'?\n"


@pytest.mark.parametrize("command", ["practice", "progress"])
def test_a_broken_set_is_the_setters_fault(command, judge, own_pack):
    (own_pack / "sets" / "means.toml").write_text(SET + 'problems = ["muddle"]\n')
    ended = judge(command, "means")
    assert (ended.status, ended.out) == (3, "")
    assert ended.err == "judge: sets/means.toml:3: no problem is called 'muddle'; did you mean 'middle'?\n"


@pytest.mark.parametrize("command", ["practice", "progress", "next"])
def test_a_broken_problem_is_told_and_the_others_go_on(command, judge, own_pack):
    text = (own_pack / "middle" / "problem.toml").read_text()
    (own_pack / "middle" / "problem.toml").write_text(text.replace("[[groups]]", "[[groups]"))
    ended = judge(command, "--json")
    assert ended.status == 0
    assert json.loads(ended.out)["schema"] == 1
    assert ended.err.startswith("judge: middle/problem.toml:")
    assert ended.err.count("\n") == 1
    if command != "next":
        assert judge(command, "means").status == 3, "it is the only one of that set"


def test_a_skill_that_nothing_explains_is_told(judge, own_pack):
    text = (own_pack / "middle" / "problem.toml").read_text()
    (own_pack / "middle" / "problem.toml").write_text(text + '[skills]\n"no rof" = ["half"]\n')
    ended = judge("progress", "means", "--json")
    assert [skill["name"] for skill in json.loads(ended.out)["skills"]] == ["no floor"]
    assert "no skill is called 'no rof'" in ended.err
    faults = json.loads(judge("verify", "middle", "--json").out)["faults"]
    assert [fault["what"] for fault in faults if fault["where"].startswith("middle/")] == [
        "no skill is called 'no rof'"
    ]


def test_the_checklist(judge, own_pack):
    assert judge("progress", "means").lines[0] == "Means  0 of 1 skills shown"
    passed("middle", without=("half",), mistake="floor-division")
    assert judge("progress", "means").lines[3].split(maxsplit=3)[:3] == ["no", "floor", "1"]
    passed("middle")
    shown = judge("progress", "means")
    assert shown.lines[0] == "Means  1 of 1 skills shown"
    assert shown.lines[3].split()[:3] == ["no", "floor", "✓"]
    assert "floor-division" in "\n".join(shown.lines[4:])
    passed("middle", without=("half",))
    assert "Fails middle half." in judge("progress", "means").out


def test_the_checklist_as_json(judge, own_pack):
    when = datetime(2026, 3, 1, tzinfo=UTC)
    passed("middle", without=("half",), mistake="floor-division", when=when)
    passed("middle", when=when + timedelta(days=1))
    found = json.loads(judge("progress", "means", "--json").out)
    (skill,) = found["skills"]
    assert (skill["name"], skill["state"], skill["attempts"]) == ("no floor", "shown", 2)
    assert skill["since"] == "2026-03-02T00:00:00+00:00"
    kills = find_problem("middle").group("half").kills
    assert skill["mistakes"] == ({"floor-division": 1} if "floor-division" in kills else {})
    assert found["mistakes"] == {"floor-division": 1}
    assert skill["needs"][0]["groups"] == ["half"]


def test_everything_passed_is_every_skill_shown(judge, own_pack):
    for problem in all_problems():
        passed(problem.id)
    found = json.loads(judge("progress", "--json").out)
    assert len(found["skills"]) >= 25
    assert {skill["state"] for skill in found["skills"]} == {"shown"}


def test_runs_that_passed_nothing_are_not_called_no_runs(judge, own_pack, submit):
    assert judge("run", "middle", submit("def middle(a, b):\n    return None\n"), "--no-shrink").status == 1
    shown = judge("due").out
    assert shown.startswith("No run of yours has passed a test group yet, so none comes again;")


def test_what_is_due(judge, own_pack, monkeypatch):
    assert "tried no kata yet" in judge("due").out
    start = datetime(2026, 3, 1, 9, tzinfo=UTC)
    monkeypatch.setattr(kept, "now", lambda: start)
    passed("middle", when=start)
    passed("count", without=("band",), when=start)
    shown = judge("due")
    assert shown.lines[0] == "Nothing today."
    assert shown.lines[4].split()[:4] == ["count", "in", "1", "day"]
    monkeypatch.setattr(kept, "now", lambda: start + timedelta(days=3))
    shown = judge("due")
    assert shown.lines[0] == "Today  1 kata"
    assert shown.lines[2].split()[:4] == ["count", "2", "days", "ago"]
    assert "never passed" in shown.lines[2]
    assert "  next  judge init count count_0304.py" in shown.lines
    found = json.loads(judge("due", "--json").out)
    assert [review["problem"] for review in found["due"]] == ["count"]
    assert [review["problem"] for review in found["later"]] == ["middle"]
    assert found["due"][0]["rating"] == "again"
    assert 0 < found["due"][0]["recall"] < 1


def test_a_kata_that_cannot_be_found_from_here(judge, own_pack, monkeypatch):
    passed("middle")
    monkeypatch.delenv("JUDGE_PROBLEMS")
    assert judge("due").lines[-1] == "Not to be found from here: middle; see --problems."
    assert json.loads(judge("due", "--json").out)["elsewhere"] == ["middle"]


def test_the_shipped_solutions_are_nobodys_progress(judge, own_pack, process):
    process("run", "-q", "exact-count", ROOT / "solutions" / "exact-count" / "accepted")
    assert f"0 of {len(find_set('path').problems)} passed" in judge("practice").out
    assert "exact-count" in judge("history").out
