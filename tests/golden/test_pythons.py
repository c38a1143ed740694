"""A right and a wrong program of each kata have one verdict, smallest case and name on every Python."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from sampling import daily

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parents[2]
NAMES = sorted(path.parent.name for path in ROOT.glob("problems/*/problem.toml"))
# Interpreters of other versions that have what the judge needs; .ci/run names those of the machine.
OTHERS = [path for path in os.environ.get("PYTHONS", "").split(os.pathsep) if path]


def told(python, cache, kata):
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "JUDGE_CACHE": str(cache)}
    command = [python, str(Path(__file__).with_name("verdicts.py")), kata]
    run = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=500)
    assert run.returncode == 0, run.stderr
    return [json.loads(line) for line in run.stdout.splitlines()]


@pytest.mark.timeout(1800)  # several interpreters, each of which draws the data
@pytest.mark.skipif(not OTHERS, reason="$PYTHONS names no other Python")
@pytest.mark.parametrize("kata", daily(NAMES, ["exact-count", "on-circle"]))
def test_a_right_and_a_wrong_program_come_to_the_same_on_every_python(kata, shared, built):
    right, wrong = here = told(sys.executable, built, kata)
    assert (right["verdict"], wrong["verdict"]) == ("AC", "WA")
    assert wrong["smallest"]
    for place, python in enumerate(OTHERS):
        assert told(python, shared / f"other-python-{place}", kata) == here, python
