"""`judge run` keeps its runs, whatever they are of; `judge history` brings their sources back.

What `judge history` shows is in the transcripts of `history/`.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from cli_support import FLOOR, MEAN

from judge.kata.history import History
from judge.problem import Verdict
from judge.run import Mode, Result


@pytest.mark.parametrize("words", [("-q",), ("--json",), ("--group", "half"), ("-j", "2")])
def test_every_run_is_kept(words, judge, submit, tmp_path):
    shown = judge("run", "middle", submit(MEAN), submit(FLOOR, "floor.py"), *words)
    with History.open() as history:
        runs = history.runs()
        assert [run.submission for run in runs] == ["mine.py", "floor.py"]
        assert [run.path for run in runs] == [str(tmp_path / "mine.py"), str(tmp_path / "floor.py")]
        assert [run.verdict.value for run in runs] == ["AC", "WA"]
        assert [history.source(run.id).decode() for run in runs] == [MEAN, FLOOR]
    if words == ("--json",):
        assert [run.result for run in runs] == [json.loads(line) for line in shown.lines]


def test_unless_that_is_not_wanted(judge, submit, own_history, tmp_path):
    assert judge("run", "middle", submit(MEAN), "--no-history").status == 0
    assert judge("run", "-q", "middle", "mine.py", "--db", tmp_path / "team.db").status == 0
    assert judge("history", "--json").out == ""
    assert not own_history.exists()


def test_a_file_that_is_no_history_is_left_alone(judge, submit):
    Path("diary").write_text("Dear diary,\n")
    assert judge("run", "middle", submit(MEAN), "--db", "diary").status == 0
    assert judge("history", "--db", "diary").status == 3
    assert Path("diary").read_text() == "Dear diary,\n"


def test_the_last_of_many(judge):
    with History.open() as history:
        for _ in range(32):
            history.add(Result("middle", "mine.py", Mode.FUNCTION, Verdict.CE), b"(", "")
    shown = judge("history")
    assert [line.split()[0] for line in shown.lines[1:21]] == [str(number) for number in range(13, 33)]
    assert shown.lines[-1] == "The last 20 runs; --limit N shows more."
    assert len(judge("history", "--limit", 32).lines) == 33
    assert len(judge("history", "--json").lines) == 32
    assert len(judge("history", "--json", "--limit", 5).lines) == 5


def test_a_name_that_steers_the_terminal(judge, submit):
    judge("run", "-q", "middle", submit(MEAN, "a\x1b[31m\nb.py"))
    for words in (("history",), ("history", "--csv"), ("history", "--json")):
        shown = judge(*words)
        assert shown.status == 0
        assert "\x1b" not in shown.out
    assert r"a\x1b[31m\nb.py" in judge("history").out


def test_a_run_of_no_file_needs_a_name(judge):
    with History.open() as history:
        history.add(Result("middle", "/dev/fd/63", Mode.FUNCTION, Verdict.AC), b"x = 1\n", "")
    ended = judge("history", "--restore", "1")
    assert (ended.status, ended.err) == (
        2,
        "judge: run 1 judged no ordinary file; name one with --out FILE\n",
    )
    assert judge("history", "--restore", "1", "--out", "x.py").status == 0
    assert Path("x.py").read_bytes() == b"x = 1\n"
