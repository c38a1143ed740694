"""Exit codes that no transcript shows: 130 where it is interrupted, 141 where the reader has left.

The others are in the transcripts: 0 accepted, sound, shown; 1 not accepted; 2 usage; 3 the judge's own fault.
"""

from __future__ import annotations

import os
import subprocess
import sys

import pytest
from cli_support import FLOOR
from sampling import daily

from judge.cli.table import COMMANDS

pytestmark = pytest.mark.slow

BY_DAY = ("run", "quiz", "doctor")
READERS = ["list", "show segment", "why segment", "schema run", "completion zsh", "doctor", "list --json"]


@pytest.mark.parametrize("name", daily(COMMANDS, BY_DAY))
def test_an_interrupt_is_130(name):
    script = f"""
import os, signal, sys
class Interrupting:
    def find_spec(self, name, *rest):
        if name == "judge.cli.commands.{name}":
            os.kill(os.getpid(), signal.SIGINT)
sys.meta_path.insert(0, Interrupting())
sys.argv = ["judge", {name!r}]
from judge.cli import main
main()
"""
    command = [sys.executable, "-c", script]
    ended = subprocess.run(command, capture_output=True, timeout=60, check=False)
    assert (ended.returncode, ended.stdout, ended.stderr) == (130, b"", b"")


def without_a_reader(words: str) -> tuple[int, bytes]:
    """The status and the errors of a command whose output nobody reads."""
    reading, writing = os.pipe()
    os.close(reading)
    command = [sys.executable, "-m", "judge", *words.split()]
    ended = subprocess.run(command, stdout=writing, stderr=subprocess.PIPE, timeout=60, check=False)
    os.close(writing)
    return ended.returncode, ended.stderr


@pytest.mark.parametrize(
    "words", daily([*READERS, *(f"{name} --help" for name in COMMANDS)], ("list", "doctor", "run --help"))
)
def test_a_reader_that_has_left_is_141(words):
    assert without_a_reader(words) == (141, b"")


@pytest.mark.parametrize("more", ["-q", "--format github"])
def test_results_that_nobody_reads_are_141(more, submit):
    assert without_a_reader(f"run middle {submit(FLOOR)} --no-shrink {more}") == (141, b"")
