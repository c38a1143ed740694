"""Beginning a kata, judging the one in hand, hints, the next one, a model solution."""

from __future__ import annotations

import json
import os
import re
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
    assert "middle is still to be written: fill in its body" in rejected.out
    assert rejected.lines[0] == "RTE  middle.py  middle, its function called"


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


@pytest.fixture
def two_ways(pack, tmp_path, monkeypatch):
    """A pack whose problem `middle` has two approaches and a program; its code has lines of 130 columns."""
    shutil.copytree(pack, tmp_path / "ways")
    accepted = tmp_path / "ways" / "solutions" / "middle" / "accepted"
    long = " + ".join(["0"] * 30)
    (accepted / "half_way.py").write_text(
        f'"""from-a-on\n\nHalf of the way from a to b. Then on.\n"""\n\n\n'
        f"def middle(a, b):\n    return a + (b - a) / 2 + {long}\n"
    )
    toml = tmp_path / "ways" / "problems" / "middle" / "problem.toml"
    rule = '[time]\nlimit = 1000\nfunction = "mean.py"\n\n'
    toml.write_text(toml.read_text().replace("[tolerance]", f"{rule}[tolerance]", 1))
    monkeypatch.setenv("JUDGE_PROBLEMS", str(tmp_path / "ways" / "problems"))
    return long


TABLE = """\
  approach  × reference  idea
  mean              1.0  the one above
  half-way           12  Half of the way from a to b.
  yours                  run 1, mine.py

  judge solution middle half-way  shows another one
"""


def test_the_approaches_stand_side_by_side_with_yours(judge, submit, two_ways, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    assert judge("run", "-q", "middle", submit(MEAN)).status == 0
    asked = []

    def paces(problem, programs, bars):
        asked.extend((problem.id, name, source.decode()) for name, source in programs)
        return [1.0, 12.3, None]  # so that nothing depends on how busy the machine is

    monkeypatch.setattr("judge.judging.pace.paces", paces)
    ended = judge("solution", "middle")
    assert (ended.status, ended.err) == (0, "")
    assert ended.out.endswith(f"\n```\n\n{TABLE}")
    assert [name for _, name, _ in asked] == ["mean.py", "half_way.py", "mine.py"]
    assert asked[2][2] == MEAN
    told = json.loads(judge("solution", "middle", "--json").out)
    assert [each["ratio"] for each in told["approaches"]] == [1.0, 12.3]
    assert told["yours"] == {"run": 1, "file": "mine.py", "ratio": None}


def test_times_that_cannot_be_measured_cost_a_line(judge, two_ways, tmp_path):
    (tmp_path / "ways" / "problems" / "middle" / "problem.py").write_text("BUILDERS = {}\n")
    ended = judge("solution", "middle", "--give-up")
    assert ended.status == 0
    assert ended.err.startswith("judge: the times are not measured: ")
    assert len(ended.err.splitlines()) == 1
    assert "reference" not in ended.out


@pytest.mark.parametrize("name", ["half-way", "half_way.py", "from-a-on", "from a on"])
def test_an_approach_by_its_name(judge, two_ways, name):
    told = json.loads(judge("solution", "middle", name, "--give-up", "--json").out)
    assert (told["file"], told["idea"]) == ("half_way.py", "from-a-on")
    assert [each["name"] for each in told["approaches"]] == ["mean", "half-way"]
    assert all(each["ratio"] is None or each["ratio"] >= 0 for each in told["approaches"])
    assert told["yours"] is None
    refused(
        judge("solution", "middle", "halfway"), "middle has no approach 'halfway'; did you mean 'half-way'?"
    )


def test_without_times_there_is_no_column(judge, two_ways):
    ended = judge("solution", "middle", "--give-up", "--no-time")
    assert "reference" not in ended.out
    assert "  half-way  Half of the way from a to b." in ended.lines
    told = json.loads(judge("solution", "middle", "--no-time", "--json").out)
    assert {each["ratio"] for each in told["approaches"]} == {None}


@pytest.mark.parametrize("columns", [30, 80, 200])
def test_code_is_never_broken_into_lines(judge, two_ways, monkeypatch, columns):
    monkeypatch.setenv("COLUMNS", str(columns))
    whole = f"    return a + (b - a) / 2 + {two_ways}"
    words = ("solution", "middle", "half-way", "--give-up", "--no-time")
    assert whole in judge(*words).lines
    assert whole in on_a_terminal(*words, NO_COLOR="1", COLUMNS=str(columns))[1].replace("\r", "")


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
    assert ended.lines[0].startswith("distance-squared: ")
    assert "judge init distance-squared" in ended.out
    absent = "distance_squared.py: the file of the kata in hand, distance-squared, is not there"
    refused(judge("run"), absent)
    told = json.loads(judge("next", "--init", "--json").out)
    assert (told["file"], told["exists"]) == (f"{told['problem'].replace('-', '_')}.py", True)
    assert told["problem"] != "distance-squared"


@pytest.mark.parametrize("words", [("next", "--init"), ("practice",)])
def test_what_is_written_is_said_before_it_is(judge, tmp_path, words, monkeypatch, pack):
    usual = ("distance_squared", "middle")  # whichever of them comes first
    for name in usual:
        (tmp_path / f"{name}.py").symlink_to("elsewhere.py")  # no file yet, and none can be made there
    ended = judge(*words)
    assert ended.status == 2
    assert re.fullmatch(r"Writing \w+\.py, which is not there yet: the stub of [\w-]+\.\n\n", ended.out), (
        ended.out
    )
    assert "the file is there already" in ended.err
    assert judge(*words, "--json").out == ""
    for name in usual:
        (tmp_path / f"{name}.py").unlink()
    ended = judge(*words)
    assert ended.lines[0].startswith("Writing ")
    assert (tmp_path / ended.lines[0].split()[1].rstrip(",")).is_file()
    assert "Writing" not in judge("practice").out  # it is there


def test_next_takes_up_a_file_that_is_there(judge, submit, tmp_path):
    submit("# mine\n", "distance_squared.py")
    assert judge("next").lines[0].startswith("distance_squared.py  distance-squared: ")
    assert judge("hint").lines[0].endswith("hint 1 of 4")
    assert (tmp_path / "distance_squared.py").read_text() == "# mine\n"


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
