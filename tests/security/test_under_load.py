"""A loaded machine flips no verdict."""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
from collections.abc import Iterator

from residents import CROWD, RIGHT, WRONG, Resident


def _once(deed: str) -> str:
    """A right program that does this in the first worked example."""
    return f"import os\ndef middle(a, b):\n    if (a, b) == (1, 2):\n        {deed}\n    return (a + b) / 2\n"


SOURCES = {
    "right": RIGHT,
    "exact": "from fractions import Fraction\n" + RIGHT.replace("(a + b) / 2", "float(Fraction(a + b) / 2)"),
    "program": "for _ in range(int(input())):\n    print(sum(map(float, input().split())) / 2)\n",
    "waits": f"import time\ntime.sleep(0.5)\n{RIGHT}",
    "crowd": CROWD,
    "wrong": WRONG,
    "raises": _once("1 / 0"),
    "hogs": _once("rows = []\n        while True: rows.append(bytearray(b'x') * (8 << 20))"),
    "leaves": _once("os._exit(0)"),
    "broken": "def middle(a, b:\n",
}


@contextlib.contextmanager
def _load(count: int) -> Iterator[None]:
    """So many processes that do nothing but work."""
    busy = [subprocess.Popen([sys.executable, "-S", "-c", "while True: pass"]) for _ in range(count)]
    try:
        yield
    finally:
        for process in busy:
            process.kill()
            process.wait()


def test_the_same_verdicts_under_busy_loops(resident: Resident) -> None:
    files = resident.submissions(resident.home / "loaded", **SOURCES)
    quiet = resident.judge(*files)
    assert quiet.verdicts() == ["AC"] * 5 + ["WA", "RTE", "MLE", "RTE", "CE"], quiet.messages()
    with _load(2 * (os.cpu_count() or 1)):
        loaded = resident.judge(*files, "-j", "4")
    assert loaded.verdicts() == quiet.verdicts(), loaded.messages()
    assert (loaded.status, loaded.err) == (quiet.status, "")
