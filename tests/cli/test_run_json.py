from __future__ import annotations

import json

import pytest
from cli_support import BROKEN, FLOOR, MEAN

KEYS = [
    "schema",
    "problem",
    "submission",
    "mode",
    "verdict",
    "score",
    "groups",
    "failure",
    "counterexample",
    "pitfall",
    "thresholds",
    "time",
    "memory_bytes",
    "isolation",
]
GROUP_KEYS = ["name", "verdict", "cases", "passed", "worst_ulps", "cpu_seconds"]
FAILURE_KEYS = ["group", "case", "input", "expected", "got", "message"]
TIME_KEYS = ["cpu_seconds", "wall_seconds", "ratio", "borderline"]


def objects(ended):
    return [json.loads(line) for line in ended.lines]


def test_an_accepted_function(judge, submit):
    ended = judge("run", "middle", submit(MEAN), "--json")
    assert (ended.status, ended.err) == (0, "")
    (result,) = objects(ended)
    assert list(result) == KEYS
    assert [list(group) for group in result["groups"]] == [GROUP_KEYS] * 3
    assert list(result["time"]) == TIME_KEYS
    assert result["schema"] == 1
    assert (result["problem"], result["submission"]) == ("middle", "mine.py")
    assert (result["mode"], result["verdict"], result["score"]) == ("function", "AC", 100)
    assert [group["name"] for group in result["groups"]] == ["examples", "whole", "half"]
    assert [group["passed"] for group in result["groups"]] == [2, 20, 30]
    for name in ("failure", "counterexample", "pitfall"):
        assert result[name] is None
    assert result["time"]["ratio"] is None
    assert result["time"]["borderline"] is False
    assert result["memory_bytes"] > 0
    assert result["isolation"] in ("full", "strong", "limits")


def test_a_wrong_function(judge, submit):
    ended = judge("run", "middle", submit(FLOOR), "--json")
    assert ended.status == 1
    (result,) = objects(ended)
    assert (result["verdict"], result["score"]) == ("WA", 40)
    failure = result["failure"]
    assert list(failure) == FAILURE_KEYS
    assert (failure["group"], failure["case"]) == ("examples", 1)
    assert failure["input"] == {"a": 1, "b": 2}
    assert (failure["expected"], failure["got"]) == ("1.5", "1")
    assert "off by 0.5" in failure["message"]


def test_several_submissions_are_a_line_each_in_their_order(judge, submit):
    submit(FLOOR, "team/b.py")
    submit(MEAN, "team/a.py")
    submit("no python", "team/notes.txt")
    last = submit("def middle(a, b)\n", "c.py")
    ended = judge("run", "--json", "middle", "team", last)
    assert ended.status == 1
    found = [(result["submission"], result["verdict"]) for result in objects(ended)]
    assert found == [("team/a.py", "AC"), ("team/b.py", "WA"), ("c.py", "CE")]


def test_a_submission_that_does_not_compile(judge, submit):
    (result,) = objects(judge("run", "middle", submit("def middle(a, b)\n"), "--json"))
    assert (result["verdict"], result["score"], result["groups"]) == ("CE", 0, [])
    assert "line 1" in result["failure"]["message"]
    assert result["failure"]["group"] is None


@pytest.mark.parametrize("stream", ["stdout", "stderr"])
def test_what_a_submission_prints_never_mixes_with_the_result(stream, process, submit, tmp_path):
    submit(f"import sys\nprint('noise', file=sys.{stream})\n{MEAN}")
    ended = process("run", "middle", tmp_path / "mine.py", "--json")
    assert (ended.status, ended.err) == (0, "")
    assert [result["verdict"] for result in objects(ended)] == ["AC"]


def test_a_program(judge, submit):
    source = "for _ in range(int(input())):\n    print(sum(map(float, input().split())) / 2)\n"
    (result,) = objects(judge("run", "middle", submit(source), "--json"))
    assert (result["mode"], result["verdict"]) == ("program", "AC")


def test_one_group(judge, submit):
    ended = judge("run", "middle", submit(FLOOR), "--json", "--group", "whole")
    (result,) = objects(ended)
    assert ended.status == 0
    assert [group["name"] for group in result["groups"]] == ["whole"]


def test_a_seed_gives_other_cases_and_the_same_ones_again(judge, submit):
    name = submit("def middle(a, b):\n    return a\n")
    runs = [
        judge("run", "middle", name, "--json", "--group", "half", *seed)
        for seed in ((), ("--seed", 7), ("--seed", 7), ("--seed", -8))
    ]
    inputs = [objects(ended)[0]["failure"]["input"] for ended in runs]
    assert inputs[1] == inputs[2]
    assert inputs[0] != inputs[1] != inputs[3]


def test_a_broken_problem_is_the_judges_fault_for_each_submission(judge, submit):
    submit(MEAN, "team/a.py")
    submit(MEAN, "team/b.py")
    ended = judge("run", "misspelt-key", "team", "--json", "--problems", BROKEN)
    assert ended.status == 3
    results = objects(ended)
    assert [list(result) for result in results] == [KEYS] * 2
    assert {result["verdict"] for result in results} == {"JE"}
    assert {result["failure"]["message"] for result in results} == {ended.err.strip().removeprefix("judge: ")}
    assert "problem.toml" in ended.err
