"""Exit codes that no transcript shows: 130 where it is interrupted, 141 where the reader has left.

The others are in the transcripts: 0 accepted, sound, shown; 1 not accepted; 2 usage; 3 the judge's own fault.
"""

from __future__ import annotations

import os
import subprocess
import sys

import pytest
from sampling import daily, nightly

pytestmark = pytest.mark.slow

READERS = ["list", "schema run", "doctor", "list --json"]


@pytest.mark.parametrize("name", ["run", nightly("doctor")])
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


@pytest.mark.parametrize("words", daily([*READERS, "run --help"], ("list", "run --help")))
def test_a_reader_that_has_left_is_141(words):
    assert without_a_reader(words) == (141, b"")
