"""Histories for tests: files that hold runs, the faults they meet, processes of their own that write them."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from past_runs import past_result

from judge.errors import HistoryError
from judge.kata.history import History

ROOT = Path(__file__).parents[2]
HERE = Path(__file__).parent
PRELUDE = """
import os, sqlite3, sys, time
from past_runs import past_result
from judge.kata.history import History
"""


def started(script: str, *words: object) -> subprocess.Popen[str]:
    """A Python process of its own that runs `script`."""
    return subprocess.Popen(
        [sys.executable, "-c", PRELUDE + script, *map(str, words)],
        env={**os.environ, "PYTHONPATH": f"{ROOT}{os.pathsep}{HERE}"},
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def ended(process: subprocess.Popen[str]) -> str:
    out, err = process.communicate(timeout=60)
    assert process.returncode == 0, err
    return out


def filled(path: Path, runs: int = 3) -> bytes:
    """A history of so many runs, closed; what the file then holds."""
    with History.open(path) as history:
        for number in range(runs):
            history.add(past_result(), str(number).encode(), "")
    return path.read_bytes()


def refusal(path: Path, *, reading: bool = False) -> str:
    with pytest.raises(HistoryError) as caught, History.open(path, reading=reading):
        pass
    assert "\n" not in str(caught.value)
    assert str(path) in str(caught.value)
    return str(caught.value)
