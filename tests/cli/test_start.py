"""What the start of the command imports: nothing that it does not need."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest
from cli_support import MEAN, ROOT
from sampling import nightly

pytestmark = pytest.mark.slow

HEAVY = (
    *("hypothesis", "sqlite3", "jinja2", "importlib.metadata", "msgspec", "numpy", "platformdirs"),
    *("tomllib", "subprocess", "asyncio", "judge.exact", "judge.problem", "judge.run"),
)


def imported(*words: str, heavy: tuple[str, ...] = HEAVY) -> list[str]:
    """Which of the heavy modules a fresh process has imported at the end of `judge WORDS`."""
    script = (
        "import atexit, sys\n"
        "from judge.cli import main\n"
        f"sys.argv = ['judge', *{list(words)!r}]\n"
        f"show = lambda: print(*(name for name in {heavy!r} if name in sys.modules), file=sys.stderr)\n"
        "atexit.register(show)\n"
        "main()\n"
    )
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    command = [sys.executable, "-c", script]
    ended = subprocess.run(command, capture_output=True, text=True, timeout=120, check=True, env=environment)
    return ended.stderr.split()


@pytest.mark.parametrize("words", [("--help",), nightly(("--version",))])
def test_starting_imports_nothing_heavy(words):
    assert imported(*words) == []


def test_a_warm_run_into_a_pipe_imports_only_what_it_needs(submit, judge):
    name = submit(MEAN)
    assert judge("run", "middle", name).status == 0  # warms the cache
    looked_at = ("hypothesis", "sqlite3", "jinja2", "importlib.metadata", "numpy", "judge.exact")
    assert imported("run", "middle", name, "--no-history", heavy=looked_at) == []


SCRIPT = """
import atexit, sys
from judge.cli import main
class Last:
    __del__ = lambda self, write=sys.stderr.write: write("torn down")
last = Last()
last.itself = last
atexit.register(print, "exit functions")
sys.argv = ["judge", "--version"]
{}
"""


@pytest.mark.parametrize(
    ("call", "torn_down"), [("main()", ""), ("def wrapped(): main()\nwrapped()", "torn down")]
)
def test_a_program_that_is_the_judge_alone_ends_without_taking_its_modules_down(call, torn_down):
    command = [sys.executable, "-c", SCRIPT.format(call)]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    ended = subprocess.run(command, capture_output=True, text=True, timeout=60, check=True, env=environment)
    assert ended.stdout.splitlines()[1:] == ["exit functions"]
    assert ended.stderr == torn_down


def test_a_verdict_alone_needs_no_layout(submit, judge):
    name = submit(MEAN)
    assert judge("run", "middle", name).status == 0
    assert imported("run", "-q", "middle", name, "--no-history", heavy=("rich.console", "random")) == []
