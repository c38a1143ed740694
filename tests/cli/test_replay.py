from __future__ import annotations

import json
import os
import subprocess
import sys

import pytest
from cli_support import FLOOR, MEAN

pytestmark = pytest.mark.slow

PROGRAM = (
    "t = int(input())\nfor _ in range(t):\n    a, b = map(int, input().split())\n    print((a + b) // 2)\n"
)


def counterexample(judge, name):
    ended = judge("run", "middle", name, "--json")
    (result,) = (json.loads(line) for line in ended.lines)
    return result["counterexample"]


@pytest.mark.parametrize("source", [FLOOR, PROGRAM])
def test_the_counterexample_and_its_replay(source, judge, submit):
    name = submit(source)
    found = counterexample(judge, name)
    assert list(found) == ["input", "expected", "got", "message", "replay"]
    assert found["input"] == {"a": 0, "b": 1}
    assert (found["expected"], found["got"]) == ("0.5", "0")
    assert found == counterexample(judge, name)

    again = judge("replay", found["replay"], name, "--json")
    assert again.status == 1
    (result,) = (json.loads(line) for line in again.lines)
    assert result["verdict"] == "WA"
    assert result["failure"]["input"] == found["input"]
    assert judge("replay", found["replay"], submit(MEAN, "right.py")).status == 0


def test_the_screen_shows_it_after_the_failing_case_with_the_verdict_last(judge, submit):
    name = submit(FLOOR, "my file.py")
    assert "  examples, case 1" not in judge("run", "middle", name).lines
    ended = judge("run", "middle", name, "--all")
    at = ended.lines.index("  smallest case found")
    assert at > ended.lines.index("  examples, case 1")
    assert ended.lines[at + 1].split() == ["input", "a=0,", "b=1"]
    again = next(line for line in ended.lines if line.strip().startswith("again"))
    assert again.split(None, 1)[1].startswith("judge replay middle:")
    assert again.endswith(" 'my file.py'")
    assert ended.lines[-1].startswith("WA  wrong answer")


def test_a_replay_looks_as_a_run_does(judge, submit):
    replay = counterexample(judge, submit(FLOOR))["replay"]
    ended = judge("replay", replay, "mine.py")
    assert ended.lines[0] == "WA  mine.py  middle, its function called"
    assert ended.lines[-1].startswith("WA  wrong answer, 0 of 100 points, 0 of 1 case")
    assert judge("replay", replay, submit("x = (\n", "broken.py")).lines[-1].startswith("CE")


def test_nothing_is_shrunk_unless_wanted(judge, submit):
    name = submit(FLOOR)
    (result,) = (json.loads(line) for line in judge("run", "middle", name, "--json", "--no-shrink").lines)
    assert result["verdict"] == "WA"
    assert result["counterexample"] is None
    assert "smallest" not in judge("run", "middle", name, "--no-shrink").out
    assert len(judge("run", "-q", "middle", name).lines) == 1


@pytest.mark.parametrize(
    ("replay", "words"),
    [
        ("nonsense", "'nonsense' is no replay id"),
        ("muddle:whole:v0,1:000000", "no problem is called 'muddle'; did you mean 'middle'?"),
        ("middle:whole:v0,1:000000", "check digits"),
        ("middle:hole:v0,1:000000", "no group 'hole'"),
    ],
)
def test_a_bad_id_is_one_line(replay, words, judge, submit):
    ended = judge("replay", replay, submit(MEAN))
    assert (ended.status, ended.out) == (2, "")
    assert words in ended.err
    assert len(ended.err.splitlines()) == 1


def run_pytest(folder, name):
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", name]
    environment = {key: value for key, value in os.environ.items() if not key.startswith("PYTEST")}
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=60, env=environment)


def test_a_regression_test_fails_until_the_submission_is_right(judge, submit, tmp_path):
    name = submit(FLOOR, "work/mine.py")
    first = judge("run", "middle", name, "--save-regression", "test_mine.py")
    assert first.status == 1
    assert "test_mine.py now holds middle:" in first.err
    written = (tmp_path / "test_mine.py").read_text()
    assert "already held" in judge("run", "middle", name, "--save-regression", "test_mine.py").err
    assert (tmp_path / "test_mine.py").read_text() == written

    other = submit("def middle(a, b):\n    return a\n", "other.py")
    judge("run", "-q", "middle", other, "--save-regression", "test_mine.py")
    assert (tmp_path / "test_mine.py").read_text().startswith(written)
    failing = run_pytest(tmp_path, "test_mine.py")
    assert "2 failed" in failing.stdout

    submit(MEAN, "work/mine.py")
    submit(MEAN, "other.py")
    assert run_pytest(tmp_path, "test_mine.py").returncode == 0


def test_each_regression_test_has_a_name_of_its_own(judge, submit, tmp_path):
    for name in ("a/x².py", "b/x².py", "b/x_.py", "b/-x.py"):
        ended = judge("run", "-q", "middle", "--save-regression", "test_all.py", "--", submit(FLOOR, name))
        assert "now holds" in ended.err
    assert "4 failed" in run_pytest(tmp_path, "test_all.py").stdout


def test_somebody_elses_file_is_left_alone(judge, submit, tmp_path):
    name = submit(FLOOR)
    (tmp_path / "test_own.py").write_text("def test_own(): pass\n")
    ended = judge("run", "middle", name, "--save-regression", "test_own.py")
    assert (ended.status, ended.out) == (2, "")
    assert "was not written by --save-regression" in ended.err
    assert (tmp_path / "test_own.py").read_text() == "def test_own(): pass\n"
    (tmp_path / "binary.py").write_bytes(b"\xff\xfe\x00")
    assert judge("run", "middle", name, "--save-regression", "binary.py").status == 2
    assert judge("run", "middle", name, "--save-regression", "missing/test.py").status == 2


def test_a_program_has_no_regression_test_and_says_so(judge, submit, tmp_path):
    ended = judge("run", "middle", submit(PROGRAM), "--save-regression", "test_mine.py")
    assert "is a program, not a function" in ended.err
    assert not (tmp_path / "test_mine.py").exists()
