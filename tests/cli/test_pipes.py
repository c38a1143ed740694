"""What is no ordinary file is told in a line, and nothing waits for what may never come."""

from __future__ import annotations

import os
import shutil
import socket
import subprocess
import sys

import pytest
from cli_support import FLOOR, MEAN, PACK, ROOT

from judge.cli import submissions

pytestmark = pytest.mark.slow


def patient(*words: object, shell: str = "") -> subprocess.CompletedProcess[str]:
    """The command as a process of its own, which is given up when it hangs; `shell` goes on after it."""
    command = [sys.executable, "-m", "judge", *map(str, words)]
    if shell:
        command = ["bash", "-c", f'"$@" {shell}', "bash", *command]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    return subprocess.run(command, capture_output=True, text=True, env=environment, timeout=60, check=False)


@pytest.fixture
def named_pipe(submit, tmp_path):
    submit(MEAN)
    os.mkfifo(tmp_path / "pipe.py")
    return "pipe.py"


def refused(ended, name, *words):
    assert (ended.returncode, ended.stdout) == (2, "")
    assert ended.stderr.startswith(f"judge: {name}: ")
    assert ended.stderr.count("\n") == 1
    for word in words:
        assert word in ended.stderr


@pytest.mark.parametrize(
    "words",
    [
        "run middle pipe.py",
        "stress middle pipe.py",
        "replay middle:half:v1,2:000000 pipe.py",
    ],
)
def test_a_named_pipe_is_refused_before_it_is_opened(words, named_pipe):
    refused(patient(*words.split()), "pipe.py", "named pipe", "<(command)")


@pytest.mark.parametrize("words", ["run -q middle .", "run -q middle mine.py pipe.py"])
def test_beside_other_files_it_is_a_row_and_they_are_judged(words, named_pipe):
    ended = patient(*words.split())
    assert (ended.returncode, ended.stderr) == (3, "")
    assert "this is a named pipe, which may never be written to" in ended.stdout
    assert ended.stdout.endswith("1 of 2 accepted  middle\n")


def test_what_is_never_saved_again_is_not_watched(named_pipe):
    refused(patient("watch", "middle", "pipe.py"), "pipe.py", "no ordinary file", "name the file to watch")
    ended = patient("watch", "middle", shell="<(sleep 5 2> /dev/null)")
    assert ended.returncode == 2
    assert "no ordinary file" in ended.stderr


@pytest.mark.parametrize(("source", "status"), [(MEAN, 0), (FLOOR, 1)])
@pytest.mark.parametrize(
    "shell", ["<(cat mine.py)", "<(sleep 0.2; cat mine.py)", "/dev/stdin < <(cat mine.py)"]
)
def test_a_pipe_of_the_shells_is_judged(source, status, shell, submit):
    submit(source)
    ended = patient("run", "-q", "--no-history", "middle", shell=shell)
    assert (ended.returncode, ended.stderr) == (status, "")


def test_a_pipe_that_stays_silent_is_given_up(judge, submit, monkeypatch):
    submit(MEAN)
    monkeypatch.setattr(submissions, "_SILENCE", 0.1)
    reading, writing = os.pipe()
    os.write(writing, b"def middle(a, b):\n")
    ended = judge("run", "middle", f"/dev/fd/{reading}")
    assert ended.status == 2
    assert "nothing came through this pipe for 0.1 seconds; write the program to a file" in ended.err
    os.close(writing)
    os.close(reading)


def test_a_pipe_without_end_is_too_large(submit):
    submit(MEAN)
    ended = patient("run", "middle", shell="<(yes)")
    assert (ended.returncode, ended.stdout) == (2, "")
    assert "this file is larger than 4 MB" in ended.stderr


@pytest.mark.parametrize("name", ["/dev/zero", "/dev/null", "socket.py"])
def test_devices_and_sockets_are_refused(name, submit, tmp_path):
    submit(MEAN)
    with socket.socket(socket.AF_UNIX) as listener:
        listener.bind("socket.py")
        refused(patient("run", "middle", name), name, "no ordinary file; name a Python file")


def test_a_history_that_is_a_pipe(named_pipe):
    for words in ("history", "run middle mine.py -q", "hint middle"):
        ended = patient(*words.split(), "--db", "pipe.py")
        assert ended.returncode == (0 if words.startswith("run") else 3)
        assert "pipe.py: the history cannot be opened (it is no ordinary file)" in ended.stderr


@pytest.mark.parametrize("file", ["problem.toml", "statement.md", "problem.py", "hashes.json"])
def test_a_problems_file_that_is_a_pipe(file, tmp_path):
    shutil.copytree(PACK, tmp_path / "pack")
    pipe = tmp_path / "pack" / "problems" / "middle" / file
    pipe.unlink(missing_ok=True)
    os.mkfifo(pipe)
    ended = patient("verify", "middle", "--problems", tmp_path / "pack" / "problems")
    assert ended.returncode == 3
    assert f"middle/{file}: cannot be read: it is no ordinary file" in ended.stdout


@pytest.mark.parametrize("folder", ["accepted", "wrong"])
def test_a_solution_that_is_a_pipe(folder, tmp_path):
    shutil.copytree(PACK, tmp_path / "pack")
    os.mkfifo(tmp_path / "pack" / "solutions" / "middle" / folder / "a-pipe.py")
    problems = ("--problems", tmp_path / "pack" / "problems")
    ended = patient("verify", "middle", *problems)
    assert ended.returncode == 3
    assert f"middle/{folder}/a-pipe.py" in ended.stdout
    (tmp_path / "floor.py").write_text(FLOOR)
    assert patient("run", "-q", "middle", tmp_path / "floor.py", *problems).returncode == 1
    assert patient("solution", "middle", "--give-up", *problems).returncode == 0  # another one is sound


def test_force_writes_over_no_device_and_no_pipe(named_pipe):
    refused(patient("init", "middle", "pipe.py", "--force"), "pipe.py", "it is no ordinary file")
    assert os.path.exists("pipe.py")  # noqa: PTH110 - and still a pipe
