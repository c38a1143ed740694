"""What goes wrong on the judge's side: one line, status 3, and no traceback but for --debug."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from cli_support import BROKEN, FLOOR, MEAN, PACK, ROOT

from judge.cli.commands import list as list_module
from judge.errors import ProblemError
from judge.judging import session as judging

pytestmark = pytest.mark.slow

FAULTY = [
    "example-answer-text",
    "missing-key",
    "misspelt-key",
    "bad-bound",
    "bad-toml",
    "example-contradicts",
    "module-raises",
]


@pytest.mark.parametrize("name", FAULTY)
def test_a_broken_problem_is_one_line_with_its_file(name, judge, submit):
    ended = judge("run", name, submit(MEAN), "--problems", BROKEN)
    assert (ended.status, ended.out) == (3, "")
    assert ended.err.count("\n") == 1
    assert ended.err.startswith(f"judge: {name}/")


def test_a_list_names_the_broken_ones_and_shows_the_others(judge):
    ended = judge("list", "--problems", BROKEN)
    assert ended.status == 3
    assert "middle" in ended.out
    assert "judge: misspelt-key/problem.toml" in ended.err
    assert "Traceback" not in ended.err


def test_a_fault_in_mid_run_costs_one_submission(judge, submit, monkeypatch):
    real = judging.run_in

    def faulty(box, problem, data, source, name, **how):
        if name == "team/a.py":
            raise ProblemError("the reference fails", where="middle/problem.py:9")
        return real(box, problem, data, source, name, **how)

    monkeypatch.setattr(judging, "run_in", faulty)
    submit(MEAN, "team/a.py")
    submit(MEAN, "team/b.py")
    ended = judge("run", "middle", "team", "--json")
    assert ended.status == 3
    results = [json.loads(line) for line in ended.lines]
    assert [result["verdict"] for result in results] == ["JE", "AC"]
    assert results[0]["failure"]["message"] == "middle/problem.py:9: the reference fails"
    assert judge("run", "middle", "team").lines[-1] == "1 of 2 accepted  middle"


@pytest.mark.parametrize("fault", [ProblemError("the reference fails"), ArithmeticError("too many digits")])
def test_a_fault_in_the_search_for_a_smaller_case_leaves_the_verdict_alone(fault, judge, submit, monkeypatch):
    def faulty(*_arguments, **_settings):
        raise fault

    monkeypatch.setattr("judge.diagnose.shrink.shrink", faulty)
    ended = judge("run", "middle", submit(FLOOR), "--json")
    assert (ended.status, json.loads(ended.out)["verdict"]) == (1, "WA")
    assert ended.err.startswith("judge: no smaller case for mine.py: ")
    assert ended.err.count("\n") == 1
    assert str(fault) in ended.err


@pytest.mark.parametrize("fault", [ProblemError("the reference fails"), ArithmeticError("too many digits")])
def test_a_fault_in_naming_the_mistake_leaves_the_verdict_alone(fault, judge, submit, monkeypatch):
    def faulty(*_arguments, **_settings):
        raise fault

    monkeypatch.setattr("judge.mistakes.namer.Vetoes", faulty)
    ended = judge("run", "middle", submit(FLOOR), "--json")
    assert (ended.status, json.loads(ended.out)["verdict"]) == (1, "WA")
    assert ended.err.startswith("judge: the mistake is not named: ")
    assert str(fault) in ended.err


def test_a_fault_in_drawing_leaves_the_verdict_alone(judge, submit, monkeypatch):
    def faulty(*_arguments, **_settings):
        raise ArithmeticError("too many digits")

    monkeypatch.setattr("judge.report.picture.has_room", lambda _screen: True)
    monkeypatch.setattr("judge.cli.picture.Drawing.picture", faulty)
    ended = judge("run", "middle", submit(FLOOR), "--no-shrink", "--no-name", "--picture")
    assert ended.status == 1
    assert ended.lines[-1].startswith("WA  ")
    assert "judge: the failing case is not drawn: internal fault: ArithmeticError" in ended.err


def test_verify_reports_a_broken_problem_as_its_fault(judge):
    ended = judge("verify", "bad-toml", "--problems", BROKEN)
    assert ended.status == 3
    assert "fault  bad-toml/problem.toml" in ended.out
    assert ended.lines[-1] == "1 fault  1 problem checked"


ENDING = [
    "raise SystemExit",
    "exit(5)",
    "raise GeneratorExit",
    "def solve(a, b): exit(0)",
    "def solve(a, b): raise GeneratorExit",
    "def pairs(draw, odd): exit(0)\nBUILDERS = {'pairs': pairs}",
]


@pytest.mark.parametrize("ending", ENDING)
@pytest.mark.parametrize("words", ["run middle mine.py", "data middle --out data", "stress middle mine.py"])
def test_a_problem_that_ends_the_process_is_a_fault_and_not_accepted(words, ending, judge, submit, tmp_path):
    shutil.copytree(PACK, tmp_path / "pack")
    with (tmp_path / "pack" / "problems" / "middle" / "problem.py").open("a") as module:
        module.write(f"\n{ending}\n")
    submit(MEAN)
    ended = judge(*words.split(), "--problems", tmp_path / "pack" / "problems")
    assert (ended.status, ended.out) == (3, "")
    assert ended.err.startswith("judge: middle/problem.")
    assert ended.err.count("\n") == 1
    assert "Exit" in ended.err


def test_an_internal_fault_is_one_line(judge, monkeypatch):
    def fail(_folders):
        raise RuntimeError("the sky\nfell")

    monkeypatch.setattr(list_module, "sound_problems", fail)
    ended = judge("list")
    assert (ended.status, ended.out) == (3, "")
    assert ended.err == (
        "judge: internal fault: RuntimeError: the sky fell; run again with --debug for the traceback\n"
    )


@pytest.mark.parametrize("words", [("list", "--debug"), ("--debug", "list")])
def test_debug_shows_the_traceback(words, judge, monkeypatch):
    def fail(_folders):
        raise RuntimeError("the sky")

    monkeypatch.setattr(list_module, "sound_problems", fail)
    ended = judge(*words)
    assert (ended.status, ended.out) == (3, "")
    assert ended.err.startswith("Traceback (most recent call last)")
    assert "judge: internal fault: RuntimeError: the sky" in ended.err.splitlines()[-1]


def test_debug_is_not_for_the_callers_own_faults(judge):
    assert judge("show", "middel", "--debug").err.count("\n") == 1


def test_an_interrupt(judge, monkeypatch):
    def interrupt(_folders):
        raise KeyboardInterrupt

    monkeypatch.setattr(list_module, "sound_problems", interrupt)
    ended = judge("list")
    assert ended.status == 130
    assert "Traceback" not in ended.err


def test_ctrl_c_in_mid_run(submit, tmp_path):
    submit("import time\ndef middle(a, b):\n    time.sleep(60)\n")
    running = subprocess.Popen(
        [sys.executable, "-m", "judge", "run", "middle", str(tmp_path / "mine.py")],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
    )
    with pytest.raises(subprocess.TimeoutExpired):  # it sleeps: it is in the middle of the run now
        running.communicate(timeout=1.5)
    running.send_signal(signal.SIGINT)
    out, err = running.communicate(timeout=30)
    assert running.returncode == 130
    assert out == ""
    assert "Traceback" not in err


@pytest.mark.parametrize("module", ["judge.cli.app", "judge.cli.commands.list"])
def test_ctrl_c_while_modules_are_imported_is_quiet_and_never_lost(module):
    script = f"""
import os, signal, sys
class Interrupting:
    def find_spec(self, name, *rest):
        if name == {module!r}:
            try:
                os.kill(os.getpid(), signal.SIGINT)
            except KeyboardInterrupt:  # as in a callback of the import's own locks, which only prints it
                pass
sys.meta_path.insert(0, Interrupting())
sys.argv = ["judge", "list"]
from judge.cli import main
main()
"""
    command = [sys.executable, "-c", script]
    ended = subprocess.run(command, capture_output=True, timeout=60, check=False)
    assert (ended.returncode, ended.stdout, ended.stderr) == (130, b"", b"")


def test_a_reader_that_leaves_is_no_fault():
    script = f"{sys.executable} -m judge show segment | head -n 1; echo ${{PIPESTATUS[0]}}"
    ended = subprocess.run(["bash", "-c", script], capture_output=True, text=True, timeout=60, check=True)
    first, status = ended.stdout.splitlines()
    assert first.startswith("# ")
    assert status in ("0", "141")  # 0 where everything fitted into the pipe
    assert ended.stderr == ""


def test_standard_output_that_is_closed_or_full(process):
    for target in (">&-", ">/dev/full"):
        if target.endswith("full") and not Path(target[1:]).exists():
            continue
        ended = subprocess.run(
            ["bash", "-c", f"{sys.executable} -m judge list {target}"],
            capture_output=True,
            text=True,
            timeout=60,
        )
        assert ended.returncode == 3, target
        assert ended.stderr.startswith("judge: cannot write (")
        assert ended.stderr.count("\n") == 1


FULL = [  # where standard error is full: the status is that of the command
    ("nothing", 2),
    ("run middle mine.py --nothing", 2),
    ("run middle gone.py", 2),
    ("--nothing", 2),
    (f"list --problems {BROKEN}", 3),
    (f"show bad-toml --debug --problems {BROKEN}", 3),
    ("run middle mine.py -q --db diary", 0),
    ("run middle floor.py -q --db diary", 1),
    ("list > /dev/full", 3),
]


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no /dev/full")
@pytest.mark.parametrize(("words", "status"), FULL)
def test_a_full_standard_error_changes_no_status(words, status, submit, broken_pack):
    words = words.replace(BROKEN, str(broken_pack))
    for name, content in (("mine.py", MEAN), ("floor.py", FLOOR), ("diary", "Dear diary,")):
        submit(content, name)
    ended = subprocess.run(
        ["sh", "-c", f'"{sys.executable}" -m judge {words} 2> /dev/full'],
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert ended.returncode == status
    if " -q " in words:
        assert ended.stdout.startswith(("AC  ", "WA  "))


CLOSED = ["<&-", "2>&-", "<&- 2>&-"]


@pytest.mark.parametrize("closed", CLOSED)
@pytest.mark.parametrize(("source", "status"), [(MEAN, 0), ("def middle(a, b):\n    return 0\n", 1)])
def test_closed_standard_streams_change_no_status(closed, source, status, tmp_path):
    (tmp_path / "own.py").write_text(source)
    settings = {"PYTHONPATH": str(ROOT), "JUDGE_CACHE": str(tmp_path / "cache")}
    ended = subprocess.run(
        [
            "sh",
            "-c",
            f'"{sys.executable}" -m judge run -q middle own.py --problems "{PACK}/problems" {closed}',
        ],
        cwd=tmp_path,
        env={**os.environ, **settings},
        capture_output=True,
        timeout=60,
        check=False,
    )
    assert ended.returncode == status
