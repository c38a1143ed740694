"""`judge run` keeps its runs; `judge history` and `judge diff` show them."""

from __future__ import annotations

import csv
import io
import json
import os
import re
from pathlib import Path

import pytest
from cli_support import FLOOR, MEAN

from judge.kata.history import History
from judge.problem import Verdict
from judge.run import Mode, Result


@pytest.fixture
def two_runs(judge, submit):
    """A wrong run and a right one of the same file."""
    judge("run", "middle", submit(FLOOR))
    judge("run", "middle", submit(MEAN))


@pytest.mark.parametrize("words", [(), ("-q",), ("--json",), ("--group", "half"), ("-j", "2")])
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


def test_unless_that_is_not_wanted(judge, submit, own_history):
    assert judge("run", "middle", submit(MEAN), "--no-history").status == 0
    assert not own_history.exists()


def test_into_another_file(judge, submit, own_history, tmp_path):
    judge("run", "-q", "middle", submit(MEAN), "--db", tmp_path / "team.db")
    assert not own_history.exists()
    assert "middle" in judge("history", "--db", tmp_path / "team.db").out


@pytest.mark.parametrize(("source", "status"), [(MEAN, 0), (FLOOR, 1)])
@pytest.mark.parametrize("words", [(), ("--json",)])
def test_a_history_that_fails_never_loses_the_verdict(source, status, words, judge, submit, tmp_path):
    (tmp_path / "diary").write_text("Dear diary,\n")
    name = submit(source)
    ended = judge("run", "middle", name, submit(source, "b.py"), "--db", "diary", "--no-shrink", *words)
    assert ended.status == status
    assert ended.err.count("\n") == 1, "one note, however many submissions"
    assert ended.err.startswith("judge: not kept in the history: diary: this is no history of the judge; ")
    assert ("AC" if status == 0 else "WA") in ended.out
    assert (tmp_path / "diary").read_text() == "Dear diary,\n"


def test_what_was_read_from_a_pipe_has_no_path(judge, submit):
    submit(MEAN)
    reading, writing = os.pipe()
    with os.fdopen(writing, "w") as pipe:
        pipe.write(MEAN)
    assert judge("run", "-q", "middle", f"/dev/fd/{reading}").status == 0
    os.close(reading)
    with History.open() as history:
        assert history.run(1).path == ""


def test_the_list(judge, two_runs):
    head, first, second = judge("history").lines
    assert head.split()[:5] == ["run", "when", "problem", "file", "result"]
    assert re.fullmatch(r"  1  \d\d-\d\d \d\d:\d\d  middle   mine.py  WA \d+ .*", first)
    assert re.fullmatch(r"  2  .*  AC( [\d.]+ ×)?", second)


def test_the_last_of_many(judge, two_runs):
    with History.open() as history:
        for _ in range(30):
            history.add(Result("middle", "mine.py", Mode.FUNCTION, Verdict.CE), b"(", "")
    shown = judge("history")
    assert [line.split()[0] for line in shown.lines[1:21]] == [str(number) for number in range(13, 33)]
    assert shown.lines[-1] == "The last 20 runs; --limit N shows more."
    assert len(judge("history", "--limit", 3).lines) == 4
    assert len(judge("history", "--limit", 32).lines) == 33
    assert len(judge("history", "--json").lines) == 32
    assert len(judge("history", "--json", "--limit", 5).lines) == 5


def test_as_json(judge, two_runs):
    first, second = map(json.loads, judge("history", "--json").lines)
    assert (first["schema"], first["run"], second["run"]) == (1, 1, 2)
    assert (first["verdict"], second["verdict"]) == ("WA", "AC")
    assert second["result"]["groups"][0]["verdict"] == "AC"
    assert first["time"] < second["time"]
    assert set(second["passed"]) == {"examples", "whole", "half"}
    assert len(second["source"]) == 64


def test_as_csv(judge, two_runs):
    rows = list(csv.DictReader(io.StringIO(judge("history", "middle", "--csv").out)))
    assert [row["verdict"] for row in rows] == ["WA", "AC"]
    assert rows[1]["passed"] == "examples whole half"
    assert rows[1]["run"] == "2"
    assert judge("history", "--csv", "--json").status == 2


def test_of_one_problem(judge, two_runs):
    assert len(judge("history", "middle").lines) == 3
    assert judge("history", "count").lines == ["No runs yet; 'judge run count FILE' adds one."]
    assert "did you mean 'middle'?" in judge("history", "midle").err


def test_nothing_yet(judge, own_history):
    assert judge("history").lines == ["No runs yet; 'judge run PROBLEM FILE' adds one."]
    assert judge("history", "--json").out == ""
    assert not own_history.exists()


def test_a_problem_that_can_no_longer_be_found(judge, two_runs, monkeypatch):
    monkeypatch.delenv("JUDGE_PROBLEMS")
    assert len(judge("history", "middle").lines) == 3


def test_a_name_that_steers_the_terminal(judge, submit):
    judge("run", "-q", "middle", submit(MEAN, "a\x1b[31m\nb.py"))
    for words in (("history",), ("history", "--csv"), ("history", "--json"), ("diff", 1, 1)):
        shown = judge(*words)
        assert shown.status == 0
        assert "\x1b" not in shown.out
    assert r"a\x1b[31m\nb.py" in judge("history").out


@pytest.mark.parametrize("width", [40, 80, 200])
def test_nothing_is_wider_than_the_terminal(width, judge, two_runs, monkeypatch):
    monkeypatch.setenv("COLUMNS", str(width))
    for words in (("history",), ("diff", 1, 2), ("practice",), ("progress",), ("due",)):
        for line in judge(*words).lines:
            assert len(line) <= width, words


def test_from_one_run_to_another(judge, two_runs):
    lines = judge("diff", 1, 2).lines
    assert lines[0].startswith("run 1")
    assert "  verdict   WA → AC" in lines
    assert "  gained    examples, half" in lines
    assert lines[-4:] == [
        "@@ -1,2 +1,2 @@",
        " def middle(a, b):",
        "-    return (a + b) // 2",
        "+    return (a + b) / 2",
    ]


def test_backwards_and_to_itself(judge, two_runs):
    assert "  lost      examples, half" in judge("diff", 2, 1).lines
    same = judge("diff", 2, 2).lines
    assert same[-1] == "The source is the same."
    assert "  groups    none gained, none lost" in same


def test_the_difference_as_json(judge, two_runs):
    found = json.loads(judge("diff", 1, 2, "--json").out)
    assert (found["gained"], found["lost"], found["same_source"]) == (["examples", "half"], [], False)
    assert (found["old"]["verdict"], found["new"]["verdict"]) == ("WA", "AC")
    assert found["diff"].startswith("--- run 1 mine.py\n+++ run 2 mine.py\n")
    assert "passed" in found["new"]


def test_a_tab_is_not_four_spaces(judge, submit):
    judge("run", "-q", "middle", submit("def middle(a, b):\n\treturn (a + b) / 2\n"))
    judge("run", "-q", "middle", submit(MEAN))
    lines = judge("diff", 1, 2).lines
    assert lines[-2:] == ["-→   return (a + b) / 2", "+    return (a + b) / 2"]


def test_a_run_that_is_not_there(judge, two_runs):
    ended = judge("diff", 1, 9)
    assert (ended.status, ended.out) == (2, "")
    assert ended.err == "judge: there is no run 9; they go from 1 to 2; see 'judge history'\n"


def test_a_broken_history_is_one_line(judge, tmp_path, submit):
    submit(MEAN)
    Path("diary").write_text("Dear diary,\n")
    for words in (("history",), ("diff", 1, 2), ("practice",), ("progress",), ("due",)):
        ended = judge(*words, "--db", "diary")
        assert (ended.status, ended.out) == (3, ""), words
        assert ended.err.count("\n") == 1
        assert "diary: this is no history of the judge" in ended.err


# -- a source brought back -----------------------------------------------------------------------------------


def test_a_source_comes_back_to_its_file(two_runs, judge, tmp_path):
    file = tmp_path / "mine.py"
    file.unlink()
    ended = judge("history", "--restore", "1")
    assert ended.status == 0
    assert re.fullmatch(r"mine\.py  the source of run 1, \S+ \S+, middle\n  Nothing was there\.\n", ended.out)
    assert file.read_text() == FLOOR
    ended = judge("history", "--restore", "1")
    assert ended.lines[-1] == "  It was there already; nothing is written."


@pytest.mark.parametrize(
    ("now", "told"), [(MEAN, "which run 2 keeps."), ("a = 1\n", "which no run keeps.")], ids=["kept", "lost"]
)
def test_nothing_is_written_over_without_a_word(two_runs, judge, submit, tmp_path, now, told):
    file = tmp_path / submit(now)
    ended = judge("history", "--restore", "1")
    assert (ended.status, ended.out) == (2, "")
    assert ended.err == (
        "judge: mine.py: another source is there than the one of run 1; "
        "--force writes over it, --out FILE elsewhere\n"
    )
    assert file.read_text() == now
    ended = judge("history", "--restore", "1", "--force")
    assert ended.lines[-1] == f"  Written over another source, {told}"
    assert file.read_text() == FLOOR


def test_a_source_goes_to_another_file(two_runs, judge, tmp_path):
    (value,) = map(json.loads, judge("history", "--restore", "1", "--out", "old.py", "--json").lines)
    assert (tmp_path / "old.py").read_text() == FLOOR
    assert (tmp_path / "mine.py").read_text() == MEAN
    assert (value["run"], value["file"], value["written"], value["over"]) == (1, "old.py", True, False)
    assert value["kept_in"] is None


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("--restore", "7"), "there is no run 7; they go from 1 to 2"),
        (("--restore", "1", "--csv"), "--restore takes a run's number and no other choice"),
        (("middle", "--restore", "1"), "--restore takes a run's number and no other choice"),
        (("--out", "a.py"), "--out and --force go with --restore RUN"),
        (("--force",), "--out and --force go with --restore RUN"),
        (("--restore", "1", "--out", "."), "it is a folder"),
        (("--restore", "1", "--out", "no/a.py"), "its folder does not exist"),
        (("--restore", "x"), "not a valid integer"),
    ],
)
def test_what_cannot_be_restored_is_one_line(two_runs, judge, words, told):
    ended = judge("history", *words)
    assert (ended.status, ended.out, len(ended.err.splitlines())) == (2, "", 1)
    assert told in ended.err


def test_a_run_of_no_file_needs_a_name(judge, own_history, tmp_path):
    with History.open() as history:
        history.add(Result("middle", "/dev/fd/63", Mode.FUNCTION, Verdict.AC), b"x = 1\n", "")
    ended = judge("history", "--restore", "1")
    assert (ended.status, ended.err) == (
        2,
        "judge: run 1 judged no ordinary file; name one with --out FILE\n",
    )
    assert judge("history", "--restore", "1", "--out", "x.py").status == 0
    assert (tmp_path / "x.py").read_bytes() == b"x = 1\n"
