"""What goes wrong on the judge's side: one line, status 3, and no traceback but for --debug."""

from __future__ import annotations

import errno
import json
import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from cli_support import FLOOR, MEAN, PACK, ROOT
from sampling import nightly

from judge.cli.commands import look
from judge.errors import ProblemError
from judge.run import execute

pytestmark = pytest.mark.slow


def test_a_fault_in_mid_run_costs_one_submission(judge, submit, monkeypatch):
    real = execute.judge_submission

    def faulty(data, source, name, *how, **more):
        if name == "team/a.py":
            raise ProblemError("the reference fails", where="middle/problem.py:9")
        return real(data, source, name, *how, **more)

    monkeypatch.setattr(execute, "judge_submission", faulty)
    submit(MEAN, "team/a.py")
    submit(MEAN, "team/b.py")
    ended = judge("run", "middle", "team", "--json")
    assert ended.status == 3
    results = [json.loads(line) for line in ended.lines]
    assert [result["verdict"] for result in results] == ["JE", "AC"]
    assert results[0]["failure"]["message"] == "middle/problem.py:9: the reference fails"
    assert judge("run", "middle", "team").lines[-1] == "1 of 2 accepted, 1 not judged"


ENDING = [
    "raise SystemExit",
    "def solve(a, b): exit(0)",
    "def solve(a, b): raise GeneratorExit",
    "def pairs(draw, odd): exit(0)",
]


@pytest.mark.parametrize(
    ("words", "ending"),
    [
        *(("run middle mine.py", ending) for ending in ENDING),
        ("export middle --format files --out data", ENDING[0]),
        ("run middle mine.py --fresh 30s", ENDING[-1]),
    ],
)
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


def test_an_internal_fault_is_one_line_and_debug_shows_the_traceback(judge, monkeypatch):
    def fail(*_):
        raise RuntimeError("the sky\nfell")

    monkeypatch.setattr(look, "listed_problems", fail)
    line = "judge: internal fault: RuntimeError: the sky fell"
    ended = judge("list")
    assert (ended.status, ended.out) == (3, "")
    assert ended.err == f"{line}; run again with --debug for the traceback\n"
    ended = judge("list", "--debug")
    assert (ended.status, ended.out) == (3, "")
    assert ended.err.startswith("Traceback (most recent call last)")
    assert ended.err.splitlines()[-1].startswith(line)


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


@pytest.mark.parametrize("module", ["judge.cli.app", "judge.cli.commands.look"])
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


def test_ctrl_c_inside_executed_text_has_the_usual_status(tmp_path):
    # Python itself would end by SIGINT: it keeps a mark of such an interrupt, handled or not.
    (tmp_path / "executing.py").write_text(
        "from judge.cli import app, main\napp.app.main = lambda: exec('raise KeyboardInterrupt')\nmain()\n"
    )
    ended = subprocess.run(
        [sys.executable, "-m", "executing"],
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        timeout=60,
        check=False,
    )
    assert ended.returncode == 130


@pytest.mark.parametrize(
    "place",
    [
        "diagnose.shrink.shrink",
        "mistakes.namer.Likeness",
        "repair.search.seek",
        "report.picture.result_picture",
    ],
)
def test_a_fault_in_explaining_leaves_the_verdict_alone(place, judge, submit, monkeypatch):
    def faulty(*_arguments, **_settings):
        raise ArithmeticError("too many digits")

    monkeypatch.setattr("judge.report.picture.has_room", lambda _screen: True)
    monkeypatch.setattr(f"judge.{place}", faulty)
    ended = judge("run", "middle", submit(FLOOR), *(["--all"] if "picture" in place else []))
    assert ended.status == 1
    assert ended.lines[-1].startswith("WA  ")
    assert ended.err.startswith("judge: ")
    assert "ArithmeticError" in ended.err
    assert "too many digits" in ended.err
    assert ended.err.count("\n") == 1
    assert ("floor-division" in ended.out) is ("Likeness" not in place)


STREAMS = [  # those that are closed or full, and the status
    ("list >&-", 3, 1),
    ("list > /dev/full", 3, 1),
    ("list > /dev/full 2> /dev/full", 3, 0),
    ("run -q middle floor.py <&- 2>&-", 1, 0),
    ("run -q middle mine.py --db diary 2> /dev/full", 0, 0),
    ("run middle gone.py 2> /dev/full", 2, 0),
]


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no /dev/full")
@pytest.mark.parametrize(
    ("words", "status", "told"), [row if row in STREAMS[1::2] else nightly(*row) for row in STREAMS]
)
def test_streams_that_are_closed_or_full_change_no_status(words, status, told, submit):
    for name, content in (("mine.py", MEAN), ("floor.py", FLOOR), ("diary", "Dear diary,")):
        submit(content, name)
    command = ["sh", "-c", f'"{sys.executable}" -m judge {words}']
    ended = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
    assert (ended.returncode, ended.stderr.count("\n")) == (status, told)
    assert ended.stderr.startswith("judge: cannot write (" if told else "")


def test_what_a_stream_has_no_letter_for_is_written_out():
    command = [sys.executable, "-X", "utf8=0", "-m", "judge", "list", "--help"]
    settings = {**os.environ, "PYTHONIOENCODING": "cp1252"}
    ended = subprocess.run(command, env=settings, capture_output=True, timeout=60, check=False)
    assert (ended.returncode, ended.stderr) == (0, b"")
    assert rb"\u2713" in ended.stdout


# -- interrupted, or without a reader --------------------------------------------------------------------


@pytest.mark.parametrize("words", ["list", nightly("doctor"), nightly("run --help")])
def test_a_reader_that_has_left_is_141(words):
    reading, writing = os.pipe()
    os.close(reading)
    command = [sys.executable, "-m", "judge", *words.split()]
    ended = subprocess.run(command, stdout=writing, stderr=subprocess.PIPE, timeout=60, check=False)
    os.close(writing)
    assert (ended.returncode, ended.stderr) == (141, b"")


# -- shortages -------------------------------------------------------------------------------------------


SHORTAGES = [
    (OSError(errno.EMFILE, "Too many open files"), "the judge has no file descriptor left; use a smaller -j"),
    (MemoryError(), "there is no memory left; use a smaller -j"),
    (RuntimeError("can't start new thread"), "no further process or thread can be started; use a smaller -j"),
    (OSError(errno.EFBIG, "File too large"), "a file may not become as large as it must; raise the limit"),
]


@pytest.mark.parametrize(("fault", "line"), SHORTAGES[:2])
def test_a_shortage_costs_one_submission_and_the_rest_are_judged(fault, line, judge, submit, monkeypatch):
    real = execute.judge_submission

    def short(data, source, name, *how, **more):
        if name == "team/b.py":
            raise fault
        return real(data, source, name, *how, **more)

    monkeypatch.setattr(execute, "judge_submission", short)
    for name in ("a", "b", "c"):
        submit(MEAN, f"team/{name}.py")
    ended = judge("run", "middle", "team", "--json")
    results = [json.loads(row) for row in ended.lines]
    assert [result["verdict"] for result in results] == ["AC", "JE", "AC"]
    assert results[1]["failure"]["message"].startswith(line)
    assert (ended.status, ended.err) == (3, "")


@pytest.mark.parametrize(("fault", "line"), SHORTAGES)
def test_a_shortage_anywhere_else_is_one_line_with_its_remedy(fault, line, judge, monkeypatch):
    def short(*_):
        raise fault

    monkeypatch.setattr(look, "listed_problems", short)
    ended = judge("list")
    assert (ended.status, ended.out) == (3, "")
    assert ended.err.startswith(f"judge: {line}")
    assert ended.err.count("\n") == 1


@pytest.mark.parametrize(
    ("words", "settings", "said"),
    [
        (("history", "9" * 5000, "--restore"), {}, "Which run?"),
        (("new", "x" * 5000), {}, "no file can have a name as long as 'xxx"),
        (("list",), {"_JUDGE_COMPLETE": "bash_complete"}, "only a shell that completes a word sets"),
        (
            ("list",),
            {"_JUDGE_COMPLETE": "zsh_complete", "COMP_WORDS": "judge", "COMP_CWORD": "x"},
            "only a shell",
        ),
    ],
)
def test_a_word_that_nobody_means_is_refused_in_one_line(words, settings, said, judge, monkeypatch):
    for name, value in settings.items():
        monkeypatch.setenv(name, value)
    ended = judge(*words)
    assert (ended.status, ended.err.count("\n")) == (2, 1)
    assert said in ended.err
