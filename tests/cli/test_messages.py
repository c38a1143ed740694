"""What was typed and what is said of it, a row each: cases, options, packs of one's own."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys

import pytest
from cli_support import FLOOR, PACK

NO_JSON = "A case is not JSON. Write: 0, 0, 5, (-6, 3), (-5, 3)"
CASES = [
    ("0 0 5 -6 3 -5 nan", "nan, number 7 of 7: not a finite number"),
    ("0, 0, -inf, (-6, 3), (-5, 3)", "-inf, number 3 of 7: not a finite number"),
    ("0 0 5 0x10 3 -5 3", "0x10: write 16"),
    ("0 0 5 -6 3 -5 3,5", "3,5: write 3.5"),
    ("3,5", "2 numbers, 7 are needed: cx cy r ax ay bx by"),
    ("0 0 5 -6 3", "5 numbers, 7 are needed: cx cy r ax ay bx by"),
    ('{"a": 1}', NO_JSON),
    ("[0, 0, 5, [-6, 3], [-5, 3]]", NO_JSON),
    ("sqrt(2)", "sqrt(2): write 2**0.5"),
    ("0, 0, sqrt(1 + 1), (-6, 3), (-5, 3)", "sqrt(1 + 1): write (1 + 1)**0.5"),
]


@pytest.mark.parametrize(("case", "said"), CASES)
def test_a_case_that_cannot_be_read(judge, case, said):
    ended = judge("try", "count", case)
    assert (ended.status, ended.out) == (2, "")
    assert ended.err.startswith(f"judge: {said}")


NEARLY = "0, 0, 1, (-1, 1.00000001), (1, 1.00000001)"
NO_CASE = "The line is almost a tangent. No case of this kata: the gap is 1e-8·e."


def test_a_case_outside_the_promise_gets_its_exact_answer(judge):
    ended = judge("try", "count", NEARLY)
    assert ended.status == 0
    assert "exact answer      0" in ended.out
    assert NO_CASE in ended.out
    (line,) = judge("try", "count", NEARLY, "--json").lines
    assert json.loads(line)["broken"].startswith("The line is almost a tangent (gap 1e-8·e).")


def test_a_case_outside_the_promise_breaks_no_program(judge):
    ended = judge("hack", "count", NEARLY)
    assert ended.status == 1
    assert NO_CASE in ended.out


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("run count a.py --format json", "--json writes JSON"),
        ("quiz --level senior", "did you mean 'judge quiz senior'?"),
    ],
)
def test_an_option_that_there_is_not(judge, words, said):
    ended = judge(*words.split())
    assert (ended.status, ended.out) == (2, "")
    assert said in ended.err


def test_every_help_says_that_there_is_json(judge):
    assert judge("run", "--help").lines[-1].endswith("--json writes JSON")


def test_a_schema_is_json_on_any_terminal(judge, monkeypatch):
    monkeypatch.setenv("COLUMNS", "40")
    assert json.loads(judge("help", "--schema", "run").out)["$schema"]


def test_standard_input_is_a_file_to_judge():
    command = [sys.executable, "-m", "judge", "run", "middle", "-", "-q"]
    ended = subprocess.run(command, input=FLOOR, capture_output=True, encoding="utf-8", timeout=120)
    assert ended.returncode == 1
    assert ended.stdout.startswith("WA")


@pytest.fixture
def elsewhere(judge, tmp_path, monkeypatch):
    """A pack that only --problems names."""
    monkeypatch.delenv("JUDGE_PROBLEMS")
    return shutil.copytree(PACK, tmp_path / "mine") / "problems"


def test_a_named_pack_comes_first_under_its_name(judge, elsewhere):
    lines = judge("list", "--problems", elsewhere).lines
    assert lines[2].split() == ["mine", "0", "of", "1"]
    assert lines[lines.index("The katas that you name with --problems.") + 1].split()[0] == "middle"


def test_the_commands_for_a_named_pack_name_it(judge, elsewhere, tmp_path):
    judge("start", "middle", "--problems", elsewhere)
    (tmp_path / "middle.py").write_text(FLOOR)
    for words in (("run", "middle", "--problems", elsewhere), ("run",)):
        assert "judge hint middle --problems mine/problems" in judge(*words).out
    ended = judge("hint", "middle")
    assert (ended.status, ended.err) == (
        2,
        "judge: no kata is called 'middle'; add --problems mine/problems\n",
    )


POINTS = "def line_count(cx, cy, r, A, B):\n    return 2\n"


def test_the_history_writes_a_case_as_the_run_did(judge, submit):
    submit(POINTS, "count.py")
    ran = judge("run", "count", "--no-name", "--group", "examples").lines
    (case,) = (line for line in ran if "cx = " in line)
    assert "A = (" in case
    assert case in judge("history", "1").lines


def test_a_file_with_a_byte_order_mark_is_told_so(judge, elsewhere):
    file = elsewhere / "middle" / "problem.toml"
    file.write_bytes(b"\xef\xbb\xbf" + file.read_bytes())
    said = judge("show", "middle", "--problems", elsewhere).err
    assert "it begins with a byte order mark; save it without a byte order mark" in said


def test_a_new_kata_is_in_no_set(judge, tmp_path):
    judge("new", ".", "two-points")
    assert "path" not in (tmp_path / "problems" / "two-points" / "problem.toml").read_text()
