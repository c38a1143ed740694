"""`judge run FILE` and its likes: the file tells its problem, and a problem its file."""

from __future__ import annotations

import json

import pytest
from cli_support import FLOOR, MEAN, ROOT

pytestmark = pytest.mark.slow

SEGMENT = (ROOT / "solutions" / "segment" / "accepted" / "geometric.py").read_bytes()
TWO = "def middle(a, b):\n    return (a + b) / 2\n\n\ndef line_count(*args):\n    return 0\n"


@pytest.fixture
def twice(tmp_path, monkeypatch):
    """A second problem with the entry function `middle`, called other-middle, in a folder of its own."""
    import os
    import shutil

    folder = tmp_path / "more" / "other-middle"
    shutil.copytree(f"{os.environ['JUDGE_PROBLEMS']}/middle", folder)
    (folder / "hashes.json").unlink(missing_ok=True)
    monkeypatch.setenv("JUDGE_PROBLEMS", f"{os.environ['JUDGE_PROBLEMS']}:{folder.parent}")


def judged(ended):
    return [json.loads(line) for line in ended.lines]


@pytest.mark.parametrize("word", ["mine.py", "./mine.py", "middle", "team"])
def test_a_file_alone_or_a_problem_alone(word, judge, submit):
    for name in ("mine.py", "middle.py", "team/anything.py"):
        submit(FLOOR, name)
    ended = judge("run", word, "--json")
    (found,) = judged(ended)
    wanted = {"middle": "middle.py", "team": "team/anything.py"}.get(word, word)
    assert (found["problem"], found["submission"], ended.status) == ("middle", wanted, 1)


def test_a_problems_name_wins_over_a_file_that_is_called_so(judge, submit):
    submit(FLOOR, "middle/a.py")
    submit(MEAN, "mine.py")
    assert judge("run", "-q", "middle", "mine.py").status == 0
    assert judge("run", "-q", "middle").status == 1  # there is no middle.py, but such a folder
    assert judge("run", "-q", "./middle").status == 1
    submit(MEAN, "middle.py")
    assert judge("run", "-q", "middle").status == 0
    assert judge("run", "-q", "./middle").status == 1
    assert "write ./count for a file" in " ".join(judge("run", "--help").out.split())


def test_files_of_several_problems_are_each_judged_on_their_own(judge, submit):
    submit(MEAN, "team/a.py")
    submit(SEGMENT, "team/b.py")
    submit(FLOOR, "team/c.py")
    ended = judge("run", "-q", "team", "--no-history")
    assert ended.status == 1
    rows = [line.split()[:3] for line in ended.lines[1:4]]
    assert rows == [
        ["team/a.py", "middle", "AC"],
        ["team/b.py", "segment", "AC"],
        ["team/c.py", "middle", "WA"],
    ]
    assert ended.lines[-1] == "2 of 3 accepted  middle, segment"


def test_two_that_fit_are_named_and_how_to_choose(judge, submit, twice):
    submit(MEAN)
    ended = judge("run", "mine.py")
    assert (ended.status, ended.out) == (2, "")
    assert ended.err == (
        "judge: mine.py: this file fits middle and other-middle; 'judge run middle mine.py' takes the first\n"
    )
    submit('"""other-middle: A stub."""\n' + MEAN, "stub.py")
    assert judged(judge("run", "stub.py", "--json"))[0]["problem"] == "other-middle"
    submit(MEAN, "other_middle.py")
    assert judged(judge("run", "other_middle.py", "--json"))[0]["problem"] == "other-middle"


def test_the_kata_in_hand_decides_between_two(judge, submit, twice):
    judge("init", "other-middle", "mine.py")
    submit(MEAN)
    assert judged(judge("run", "mine.py", "--json"))[0]["problem"] == "other-middle"


def test_a_problem_alone_means_the_file_of_the_kata_in_hand(judge, submit):
    judge("init", "middle", "sitting.py")
    submit(MEAN, "sitting.py")
    assert judged(judge("run", "middle", "--json"))[0]["submission"] == "sitting.py"


def test_a_file_that_does_not_compile_has_its_problem(judge, submit):
    ended = judge("run", submit("def middle(a, b):\n    return (a +\n"), "--json")
    assert [(each["problem"], each["verdict"]) for each in judged(ended)] == [("middle", "CE")]


def test_nothing_of_the_file_is_run_to_find_out(judge, submit, tmp_path):
    source = f"open({str(tmp_path / 'mark')!r}, 'w')\ndef anything(): pass\n"
    assert judge("why", submit(source)).status == 2
    assert not (tmp_path / "mark").exists()


@pytest.mark.parametrize(
    ("words", "wanted"),
    [
        (
            "run none.py",
            "and is called like none; name the problem: judge run PROBLEM FILE",
        ),
        ("run near.py", "did you mean middle, of middle?; rename it, or write 'judge run middle near.py'"),
        ("run gone.py", "gone.py: no such file"),
        (
            "run middle",
            "write judge run middle FILE, or begin one with 'judge init middle'",
        ),
        ("stress middle", "write judge stress middle FILE"),
        ("watch middle", "write judge watch middle FILE"),
        ("replay middle:half:v1,2:000000", "there is no middle.py here; write judge replay ID FILE"),
        ("why none.py", "name the problem: judge why PROBLEM"),
        ("stress none.py", "name the problem: judge stress PROBLEM"),
    ],
)
def test_what_cannot_be_told_is_one_line(words, wanted, judge, submit):
    submit("print(1)\n", "none.py")
    submit("def midle(a, b):\n    return 1\n", "near.py")
    ended = judge(*words.split())
    assert (ended.status, ended.out, ended.err.count("\n")) == (2, "", 1)
    assert wanted in ended.err


def test_the_other_commands_take_a_file_too(judge, submit):
    submit(FLOOR, "middle.py")
    assert judge("why", "middle.py", "half").out == judge("why", "middle", "half").out
    assert judge("hint", "middle.py").err == judge("hint", "middle").err
    for words in (("stress", "middle.py"), ("stress", "middle")):
        ended = judge(*words, "--for", "1s", "--seed", "1", "--json")
        assert (ended.status, judged(ended)[0]["submission"]) == (1, "middle.py")
    replay = judged(judge("run", "middle.py", "--json"))[0]["counterexample"]["replay"]
    assert judged(judge("replay", replay, "--json"))[0]["submission"] == "middle.py"
