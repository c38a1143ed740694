"""A child of the fork server whose server dies before the child can ask to die with it ends by itself."""

from __future__ import annotations

import subprocess
import sys

import pytest

SCRIPT = """
import os, sys, time
from judge.sandbox.inside.confine import Confinement

config = {"threads": 0, "uid": None, "parent": None, "level": "limits"}
confinement = Confinement(config)
server = os.getpid()
if os.fork() == 0:
    while os.getppid() == server:  # until it has died, as one that is killed right after the fork
        time.sleep(0.001)
    CONFINED
    print("it lives on", flush=True)
os._exit(0)
"""


@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere the hang-up has to do")
@pytest.mark.parametrize("how", ["confine_child(1 << 30, 1 << 20, 1)", "confine_program({})"])
def test_it_ends_before_anything_foreign_runs(how):
    script = SCRIPT.replace("CONFINED", f"confinement.{how}")
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, timeout=60, check=False
    )
    assert (done.stdout, done.stderr) == ("", "")
    alive = subprocess.run(
        [sys.executable, "-c", SCRIPT.replace("CONFINED", "pass")],
        capture_output=True,
        text=True,
        check=False,
    )
    assert alive.stdout == "it lives on\n"  # without the check
