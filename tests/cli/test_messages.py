"""What was typed and what is said of it, a row each: cases, options, packs of one's own."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys

import pytest
from cli_support import FLOOR, PACK

from judge.packs.programs import _misfit, _Trial
from judge.problem import Verdict
from judge.problem.find import find_problem, problem_folders
from judge.problem.solutions import SolutionKind

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
    assert lines[lines.index(f"The katas in {elsewhere.resolve()}.") + 1].split()[0] == "middle"


def test_the_commands_for_a_named_pack_name_it(judge, elsewhere, tmp_path):
    judge("start", "middle", "--problems", elsewhere)
    (tmp_path / "middle.py").write_text(FLOOR)
    shown = judge("run", "middle", "--problems", elsewhere).out
    assert "judge hint middle --problems mine/problems" in shown
    for words in ("run", "hint middle", "show middle", "start middle", "run middle x.py", "try middle 1,2"):
        ended = judge(*words.split())
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


def test_a_gap_has_its_unit(judge):
    said = judge("try", "count", "0, 0, 6e-5, (-1e-4, 6.1e-5), (1e-4, 6.1e-5)").out
    assert "the line misses the circle by 1e-2·e (e = 0.0001)" in said


def test_the_cases_that_fail_are_counted(judge, submit):
    assert "fails  examples 1 of 2, half 30 of 30" in judge("run", "middle", submit(FLOOR), "--no-name").out


@pytest.mark.parametrize(
    ("folder", "said"), [("", "three is a package, and"), ("./", "three is another file, and")]
)
@pytest.mark.skipif(not shutil.which("node"), reason="no Node.js here")
def test_a_package_of_javascript_is_told(judge, submit, folder, said):
    program = submit(f"require('{folder}three');\nfunction middle(a, b) {{ return 0; }}\n", "mine.js")
    shown = judge("run", "middle", program, "--no-name").out
    assert f"{said} a submission is one file. Bundle it: npx esbuild --platform=node" in shown


def test_a_slow_program_that_is_too_fast_is_left_out_with_its_margin():
    told = _misfit(SolutionKind.SLOW, _Trial(Verdict.AC, None, 2.61), 1)
    assert told == "too near the package's time limit of 1 s: it takes 2.61 s, and must take 6 s"


@pytest.mark.parametrize(
    ("printed", "said"), [("b'\\xb2'", '"\\xb2" where'), ("b'\\xef\\xbc\\x92'", "'２' (U+FF12)")]
)
def test_what_is_no_digit_is_named(judge, submit, printed, said):
    program = f"import sys\nfor _ in range(int(input())):\n    sys.stdout.buffer.write({printed} + b'\\n')\n"
    assert said in judge("run", "middle", submit(program), "--no-name").out


def test_statements_say_their_bounds_and_what_e_0_asks():
    for folder in problem_folders():
        statement = " ".join(find_problem(folder.name).statement.split())
        assert "2**30 in size" not in statement, folder
        assert "e may be 0" not in statement, folder
