"""Our own suite, run as a person may run it: in the background, red, and with a test that hangs."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys

import pytest
from walk import ROOT

SLEEPER = "import time\nprint('ready', flush=True)\ntime.sleep(300)\n"


def run(*words, deaf=False, folder=ROOT, **settings):
    """Run pytest in a folder that has our settings."""
    return subprocess.run(
        list(map(str, [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", *words])),
        capture_output=True,
        text=True,
        timeout=300,
        cwd=folder,
        env={**os.environ, "COLUMNS": "200", **settings},
        preexec_fn=(lambda: signal.signal(signal.SIGINT, signal.SIG_IGN)) if deaf else None,
    )


def test_what_a_test_starts_hears_an_interrupt():
    child = subprocess.Popen([sys.executable, "-c", SLEEPER], stdout=subprocess.PIPE, text=True)
    try:
        assert child.stdout.readline() == "ready\n"
        child.send_signal(signal.SIGINT)
        assert child.wait(60) == -signal.SIGINT
    finally:
        child.kill()
        child.communicate()


def test_so_it_does_where_the_suite_was_started_with_nohup():
    ended = run(__file__, "-k", "test_what_a_test_starts_hears_an_interrupt", deaf=True)
    assert ended.returncode == 0, ended.stdout


def test_a_suite_in_the_background_is_not_ended_by_the_interrupt_of_another(tmp_path):
    path = tmp_path / "test_deaf.py"
    path.write_text("import os, signal\ndef test_me(): os.kill(os.getpid(), signal.SIGINT)\n")
    ended = run("-p", "conftest", path, deaf=True, PYTHONPATH=str(ROOT / "tests"))
    assert ended.returncode == 0, ended.stdout


def test_a_red_run_names_what_failed(tmp_path):
    shutil.copy(ROOT / "pyproject.toml", tmp_path)
    path = tmp_path / "test_red.py"
    path.write_text("def test_green(): pass\ndef test_red(): assert 1 == 2\n")
    ended = run(path, folder=tmp_path)
    assert ended.returncode == pytest.ExitCode.TESTS_FAILED
    assert "\nFAILED test_red.py::test_red - assert 1 == 2\n" in ended.stdout


def test_a_test_that_hangs_is_ended_and_named(tmp_path):
    shutil.copy(ROOT / "pyproject.toml", tmp_path)
    path = tmp_path / "test_hanging.py"
    path.write_text("import time\ndef test_hangs(): time.sleep(1000)\ndef test_goes_on(): pass\n")
    ended = run(path, "-o", "timeout=1", folder=tmp_path)
    assert ended.returncode == pytest.ExitCode.TESTS_FAILED
    assert "\nFAILED test_hanging.py::test_hangs - Failed: Timeout" in ended.stdout
    assert "1 passed" in ended.stdout
