"""Beginning a kata, judging the one in hand, hints, the next one, a model solution."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from cli_support import FLOOR, MEAN, ROOT
from test_run_screen import on_a_terminal

from judge.kata.history import History


def refused(ended, *words):
    assert (ended.status, ended.out) == (2, ""), ended
    assert ended.err.count("\n") == 1, ended.err
    for word in words:
        assert word in ended.err


@pytest.fixture
def solved(judge, submit):
    """`middle` is in hand and solved."""
    judge("init", "middle")
    submit(MEAN, "middle.py")
    assert judge("run").status == 0


def test_init_writes_a_stub_that_fails_and_takes_it_up(judge):
    ended = judge("init", "middle")
    assert (ended.status, ended.err) == (0, "")
    assert ended.lines[0] == "middle.py  middle: The middle, junior"
    assert "judge watch" in ended.out
    rejected = judge("run", "--no-shrink")
    assert rejected.status == 1
    assert "NotImplementedError: middle is still to be written" in rejected.out
    assert rejected.lines[0] == "middle.py  middle, its function called"


def test_init_names_the_file_as_asked(judge, tmp_path):
    (tmp_path / "katas").mkdir()
    ended = judge("init", "middle", "katas/first try.py", "--json")
    assert json.loads(ended.out) == {"schema": 1, "problem": "middle", "file": "katas/first try.py"}
    assert "def middle(" in (tmp_path / "katas" / "first try.py").read_text()
    assert judge("init", "exact-count").lines[0].startswith("exact_count.py  ")


def test_init_never_writes_over_a_file_unasked(judge, submit, tmp_path):
    submit(MEAN, "middle.py")
    refused(
        judge("init", "middle"),
        "middle.py: the file is there already",
        "'judge watch middle middle.py' goes on with it, --force writes over it",
    )
    assert (tmp_path / "middle.py").read_text() == MEAN
    assert judge("init", "middle", "--force").status == 0
    assert "NotImplementedError" in (tmp_path / "middle.py").read_text()


@pytest.mark.parametrize("force", [[], ["--force"]])
def test_init_says_where_nothing_can_be_written(force, judge, tmp_path):
    refused(judge("init", "middle", "nowhere/mine.py", *force), "nowhere/mine.py: ", "nowhere first")
    refused(judge("init", "middle", str(tmp_path), *force), "this is a folder; name a file in it")
    refused(judge("init", "middle", "", *force), "this is a folder")
    refused(judge("init", "middle", "a\0b", *force), "cannot be written")
    refused(judge("init", "middle", "x" * 3000, *force), "cannot be written (file name too long)")
    refused(judge("init", "midle", *force), "did you mean 'middle'?")
    (tmp_path / "link.py").symlink_to("elsewhere.py")
    if not force:
        refused(judge("init", "middle", "link.py"), "there already")


FULL = """
import resource, sys
sys.dont_write_bytecode = True  # half a compiled module would break every process after this one
resource.setrlimit(resource.RLIMIT_FSIZE, (200, resource.RLIM_INFINITY))
sys.argv = ["judge", "init", "middle"]
from judge.cli import main
main()
"""


def test_init_that_runs_out_of_room_leaves_no_half_of_a_file(tmp_path):
    command = [sys.executable, "-c", FULL]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    ended = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=60, check=False)
    assert ended.returncode == 2
    assert ended.stderr == "judge: middle.py: cannot be written (file too large); name another file\n"
    assert list(tmp_path.iterdir()) == []


def test_run_without_arguments_wants_a_kata_in_hand(judge, tmp_path):
    refused(judge("run"), "there is no kata in hand; begin one with 'judge init PROBLEM'")
    refused(judge("run", "--json"), "there is no kata in hand")
    judge("init", "middle")
    (tmp_path / "middle.py").unlink()
    refused(
        judge("run"), "middle.py: the file of the kata in hand, middle, is not there", "'judge init middle'"
    )


def test_the_kata_in_hand_stays_whatever_else_is_judged(judge, submit):
    judge("init", "middle")
    submit(MEAN, "middle.py")
    submit(FLOOR, "other.py")
    assert judge("run", "middle", "other.py").status == 1
    (result,) = [json.loads(line) for line in judge("run", "--json").out.splitlines()]
    assert (result["submission"], result["verdict"]) == ("middle.py", "AC")
    assert judge("run", "-q").out.startswith("AC  accepted")
    assert json.loads(judge("run", "--json", "--group", "half").out)["score"] == 50


def test_the_kata_in_hand_is_judged_from_any_folder(judge, submit, tmp_path, monkeypatch):
    judge("init", "middle")
    submit(MEAN, "middle.py")
    (tmp_path / "deeper").mkdir()
    monkeypatch.chdir(tmp_path / "deeper")
    assert judge("run", "--json").status == 0
    assert f"{tmp_path / 'middle.py'}  middle" in judge("run").out


def test_after_acceptance_a_terminal_is_told_where_to_go(submit):
    file = submit(MEAN)
    _, written = on_a_terminal("run", "middle", file, NO_COLOR="1")
    assert "  then  judge solution middle explains a model solution, judge next goes on\n\nAC" in written
    for words in (["-q"], ["--json"], ["--no-history"]):
        assert "judge solution" not in on_a_terminal("run", "middle", file, *words)[1]


def test_a_pipe_is_not(judge, submit):
    assert "judge solution" not in judge("run", "middle", submit(MEAN)).out


def test_hints_come_one_by_one_and_are_remembered(judge):
    first, second, third, last = (judge("hint", "middle") for _ in range(4))
    assert first.lines == [
        "Half of what?  middle, hint 1 of 3",
        "",
        "Put your finger on -1000 and on 1000: where do they meet?",
        "",
    ]
    assert second.lines[0] == "The sum  middle, hint 2 of 3"
    assert third.lines[0] == "Nearly all of it  middle, hint 3 of 3"
    assert "'judge solution middle --give-up' shows a solution" in third.lines[-1]
    assert last == third
    with History.open() as history:
        assert history.hints_seen("middle") == 3


def test_hints_of_the_kata_in_hand(judge):
    refused(judge("hint"), "no kata in hand")
    judge("init", "middle")
    assert judge("hint").lines[0].endswith("hint 1 of 3")


def test_hints_again_by_number_and_all(judge):
    refused(judge("hint", "middle", "--again"), "no hint to middle was given yet")
    judge("hint", "middle")
    assert judge("hint", "middle", "--again").lines[0].endswith("hint 1 of 3")
    assert judge("hint", "middle", "--step", "2").lines[0].endswith("hint 2 of 3")
    assert judge("hint", "middle", "--again").lines[0].endswith("hint 2 of 3")
    assert judge("hint", "middle", "--step", "1").lines[0].endswith("hint 1 of 3")
    assert judge("hint", "middle").lines[0].endswith("hint 3 of 3")
    told = [json.loads(line) for line in judge("hint", "middle", "--all", "--json").out.splitlines()]
    assert [(hint["problem"], hint["step"], hint["steps"], hint["title"]) for hint in told] == [
        ("middle", 1, 3, "Half of what?"),
        ("middle", 2, 3, "The sum"),
        ("middle", 3, 3, "Nearly all of it"),
    ]
    assert told[2]["text"] == "    (a + b) / 2"


def test_hints_asked_for_wrongly(judge, pack, tmp_path):
    refused(judge("hint", "middle", "--step", "4"), "middle has no hint 4; they go from 1 to 3")
    refused(judge("hint", "middle", "--step", "0"), "no hint 0")
    refused(judge("hint", "middle", "--all", "--again"), "exclude each other")


def test_hints_are_drawn_on_a_terminal():
    _, written = on_a_terminal("hint", "middle", "--step", "2", NO_COLOR="1")
    assert "Add the two numbers." in written


def test_broken_hints_are_the_setters_fault(judge, pack, monkeypatch):
    path = pack / "problems" / "middle" / "hints.md"
    before = path.read_text()
    path.write_text("Think.\n")
    try:
        ended = judge("hint", "middle")
        assert (ended.status, ended.out) == (3, "")
        assert ended.err.startswith("judge: middle/hints.md:1: this text belongs to no step; ")
        verified = judge("verify", "middle")
        assert verified.status == 3
        assert "middle/hints.md:1: this text belongs to no step" in " ".join(verified.out.split())
    finally:
        path.write_text(before)
    assert judge("verify", "middle").status == 0


def test_no_hints_is_said(judge, tmp_path):
    refused(
        judge("hint", "root-count", "--problems", Path(__file__).parents[1] / "fixtures" / "problems"),
        "there are no hints to root-count; 'judge why root-count'",
    )


def test_a_solution_is_shown_when_the_problem_is_solved(judge, solved):
    ended = judge("solution")
    assert (ended.status, ended.err) == (0, "")
    assert ended.lines[0].startswith("middle: ")
    assert "    return " in ended.out
    assert '"""' not in ended.out
    told = json.loads(judge("solution", "middle", "--json").out)
    assert (told["problem"], told["file"], told["solved"]) == ("middle", "mean.py", True)
    assert told["program"].startswith("def middle(")
    with History.open() as history:
        assert not history.gave_up("middle")


def test_before_that_only_who_gives_up_sees_it(judge, submit):
    file = submit(FLOOR)
    refused(judge("solution", "middle"), "middle is not solved yet", "--give-up' shows it all the same")
    judge("run", "middle", file)
    judge("run", "middle", submit(MEAN), "--group", "half")  # a part is not the whole
    refused(judge("solution", "middle"), "not solved yet")
    given = json.loads(judge("solution", "middle", "--give-up", "--json").out)
    assert given["solved"] is False
    with History.open() as history:
        assert history.gave_up("middle")
        assert len(history.helps("middle")) == 1
    assert judge("solution", "middle").status == 0  # it is known now
    assert judge("solution", "middle", "--give-up").status == 0
    with History.open() as history:
        assert len(history.helps("middle")) == 1


def test_giving_up_what_is_solved_is_not_noted(judge, solved):
    assert judge("solution", "--give-up").status == 0
    with History.open() as history:
        assert not history.gave_up("middle")


def test_a_solution_without_one(judge, tmp_path, pack):
    import shutil

    shutil.copytree(pack / "problems", tmp_path / "problems")
    ended = judge("solution", "middle", "--give-up", "--problems", tmp_path / "problems")
    assert ended.status == 3
    assert "there is no accepted solution that defines middle; add one to " in ended.err


def test_next_goes_along_the_path_only_when_asked(judge, submit):
    ended = judge("next")
    assert ended.lines[0].startswith("distance: ")
    assert "judge init distance" in ended.out
    refused(judge("run"), "distance.py: the file of the kata in hand, distance, is not there")
    told = json.loads(judge("next", "--init", "--json").out)
    assert (told["file"], told["exists"]) == (f"{told['problem'].replace('-', '_')}.py", True)
    assert told["problem"] != "distance"


def test_next_takes_up_a_file_that_is_there(judge, submit, tmp_path):
    submit("# mine\n", "distance.py")
    assert judge("next").lines[0].startswith("distance.py  distance: ")
    assert judge("hint").lines[0].endswith("hint 1 of 6")
    assert (tmp_path / "distance.py").read_text() == "# mine\n"


def test_an_unwritable_history_is_one_line(judge, tmp_path, monkeypatch):
    (tmp_path / "no-history").write_text("not a database, and long enough to be seen as none\n" * 9)
    monkeypatch.setenv("JUDGE_DB", str(tmp_path / "no-history"))
    for words in (["run"], ["hint", "middle"], ["next"], ["solution", "middle"], ["watch"]):
        ended = judge(*words)
        assert (ended.status, ended.out) == (3, ""), words
        assert ended.err.count("\n") == 1
        assert "Traceback" not in ended.err


@pytest.mark.parametrize("columns", [40, 80, 200])
def test_nothing_is_wider_than_the_terminal(columns, judge, solved, monkeypatch, tmp_path):
    monkeypatch.setenv("COLUMNS", str(columns))
    for words in (["init", "middle", "again.py", "--force"], ["next"], ["next", "--init"]):
        ended = judge(*words)
        assert max(map(len, ended.lines)) <= columns, words
    _, written = on_a_terminal("hint", "segment", "--all", columns=columns, NO_COLOR="1")
    assert max(map(len, written.splitlines())) <= columns
    assert os.environ["COLUMNS"] == str(columns)


# -- a pack that only --problems finds -------------------------------------------------------------------


@pytest.fixture
def lone(pack, tmp_path, monkeypatch):
    """The folder of a pack that nothing but its name leads to."""
    monkeypatch.delenv("JUDGE_PROBLEMS")
    shutil.copytree(pack, tmp_path / "elsewhere" / "pack")
    return tmp_path / "elsewhere" / "pack" / "problems"


def test_a_packs_kata_is_gone_on_with_by_every_command(lone, judge, submit):
    assert judge("init", "middle", "--problems", lone).status == 0
    submit(FLOOR, "middle.py")
    assert judge("run", "-q").status == 1
    assert judge("hint").lines[0].endswith("middle, hint 1 of 3")
    submit(MEAN, "middle.py")
    assert judge("run", "-q").status == 0
    assert judge("solution").status == 0
    assert judge("next").status == 0


def test_a_packs_kata_is_watched(lone, judge, submit, monkeypatch):
    judge("init", "middle", "--problems", lone)
    submit(MEAN, "middle.py")
    seen = []

    def once(watched, *, as_json):
        assert watched.saved()
        seen.append((watched.judge().result.verdict.value, as_json))
        raise SystemExit(0)

    monkeypatch.setattr("judge.cli.commands.watch._write_on", once)
    assert judge("watch", "--json").status == 0
    assert seen == [("AC", True)]


def test_a_kata_whose_pack_is_gone_says_where_it_was(lone, judge, tmp_path):
    judge("init", "middle", "--problems", lone)
    (tmp_path / "elsewhere" / "pack").rename(tmp_path / "moved")
    for words in (["run"], ["hint"], ["watch"]):
        refused(judge(*words), f"{lone}: the problem of the kata in hand, middle, is not there", "--problems")
    assert judge("run", "-q", "--problems", tmp_path / "moved" / "problems").status == 1


def test_a_kata_of_the_judges_own_keeps_no_folder(judge):
    judge("init", "count")
    with History.open(reading=True) as history:
        assert history.current().problems == ""
