"""What is not an ordinary file is told in a line, and nothing waits for what may never come."""

from __future__ import annotations

import os
import shutil
import socket
import subprocess
import sys
from pathlib import Path

import pytest
from cli_support import FLOOR, MEAN, PACK, Outcome
from sampling import nightly

from judge.cli import files

pytestmark = pytest.mark.slow


def patient(*words: object, shell: str = "") -> Outcome:
    """The command as a process of its own, which is given up when it hangs; `shell` goes on after it."""
    command = ["bash", "-c", f'"$@" {shell}', "bash", sys.executable, "-m", "judge", *map(str, words)]
    ended = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
    return Outcome(ended.returncode, ended.stdout, ended.stderr)


@pytest.fixture
def named_pipe(submit, tmp_path):
    submit(MEAN)
    os.mkfifo(tmp_path / "pipe.py")
    return "pipe.py"


def refused(ended, name, *words):
    assert (ended.status, ended.out) == (2, "")
    assert ended.err.startswith(f"judge: {name}: ")
    assert ended.err.count("\n") == 1
    for word in words:
        assert word in ended.err


def test_a_named_pipe_is_refused_before_it_is_opened(judge, named_pipe):
    for words in ("run middle pipe.py", "try middle 1 2 pipe.py"):
        refused(judge(*words.split()), "pipe.py", "named pipe", "<(command)")
    for more in ((), ("--reset",)):
        refused(judge("start", "middle", "pipe.py", *more), "pipe.py", "not an ordinary file", "name a file")
    assert Path("pipe.py").is_fifo()
    assert "not an ordinary file" in patient("start", "middle", shell="<(sleep 5 2> /dev/null)").err


def test_beside_other_files_it_is_a_row_and_they_are_judged(judge, named_pipe):
    ended = judge("run", "-q", "middle", "mine.py", "pipe.py")
    assert (ended.status, ended.err) == (3, "")
    assert "this is a named pipe, which may never be written to" in ended.out
    assert ended.out.endswith("1 of 2 accepted, 1 not judged\n")


@pytest.mark.parametrize("shell", ["<(sleep 0.2; cat mine.py)", nightly("/dev/stdin < <(cat mine.py)")])
def test_a_pipe_of_the_shells_is_judged(shell, submit):
    submit(FLOOR)
    ended = patient("run", "-q", "--no-history", "middle", shell=shell)
    assert (ended.status, ended.err) == (1, "")


def test_a_pipe_that_stays_silent_is_given_up(judge, submit, monkeypatch):
    submit(MEAN)
    monkeypatch.setattr(files, "_SILENCE", 0.1)
    reading, writing = os.pipe()
    os.write(writing, b"def middle(a, b):\n")
    ended = judge("run", "middle", f"/dev/fd/{reading}")
    assert ended.status == 2
    assert "nothing came through this pipe for 0.1 seconds; write the program to a file" in ended.err
    os.close(writing)
    os.close(reading)


def test_a_pipe_without_end_is_too_large(submit):
    submit(MEAN)
    ended = patient("run", "middle", shell="<(tr '\\0' x < /dev/zero)")
    assert (ended.status, ended.out) == (2, "")
    assert "this file is larger than 4 MB" in ended.err


@pytest.mark.parametrize("name", ["/dev/zero", "/dev/null", "socket.py"])
def test_devices_and_sockets_are_refused(name, judge, submit):
    submit(MEAN)
    with socket.socket(socket.AF_UNIX) as listener:
        listener.bind("socket.py")
        refused(judge("run", "middle", name), name, "it is not an ordinary file")


def test_a_history_that_is_a_pipe(judge, named_pipe):
    for words in ("history", "run middle mine.py -q", "hint middle"):
        ended = judge(*words.split(), "--db", "pipe.py")
        assert ended.status == (0 if words.startswith("run") else 3)
        assert "pipe.py: the history cannot be opened (it is not an ordinary file)" in ended.err


@pytest.mark.parametrize("file", ["problem.toml", "problem.py", nightly("pins.json")])
def test_a_problems_file_that_is_a_pipe(file, judge, tmp_path):
    shutil.copytree(PACK, tmp_path / "pack")
    pipe = tmp_path / "pack" / "problems" / "middle" / file
    pipe.unlink(missing_ok=True)
    os.mkfifo(pipe)
    ended = judge("verify", "middle", "--problems", tmp_path / "pack" / "problems")
    assert ended.status == 3
    assert f"middle/{file}: cannot be read: it is not an ordinary file" in ended.out


@pytest.mark.parametrize("folder", ["accepted", nightly("wrong")])
def test_a_solution_that_is_a_pipe(folder, judge, submit, tmp_path):
    shutil.copytree(PACK, tmp_path / "pack")
    os.mkfifo(tmp_path / "pack" / "solutions" / "middle" / folder / "a-pipe.py")
    problems = ("--problems", tmp_path / "pack" / "problems")
    ended = judge("verify", "middle", *problems)
    assert ended.status == 3
    assert f"middle/{folder}/a-pipe.py" in ended.out
    assert judge("run", "-q", "middle", submit(FLOOR, "floor.py"), *problems).status == 1
    assert judge("solution", "middle", "--give-up", *problems).status == 0  # another one is sound
