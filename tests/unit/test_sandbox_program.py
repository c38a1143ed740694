"""Program mode behind the boundary: how a program ends; its limits at every level are in tests/security."""

from __future__ import annotations

import pytest
from sandboxed import run

from judge.sandbox import Stop


def test_it_is_main_and_ends_as_a_program_does():
    source = """
import atexit, threading, time
atexit.register(lambda: print("last"))
def work():
    time.sleep(0.05)
    print("thread")
if __name__ == "__main__":
    threading.Thread(target=work).start()
    print(__file__, input(), end=" ")
"""
    assert run(source, b"hello\n").stdout == b"my.py hello thread\nlast\n"


@pytest.mark.parametrize(
    ("ending", "stop", "detail"),
    [
        ("sys.exit()", Stop.ANSWERED, ""),
        ("sys.exit(0)", Stop.ANSWERED, ""),
        ("exit()", Stop.ANSWERED, ""),
        ("sys.exit(3)", Stop.EXITED, "exit status 3"),
        ("sys.exit('no')", Stop.EXITED, "exit status 1"),
        ("import os; os._exit(9)", Stop.EXITED, "exit status 9"),
        ("import os; os.abort()", Stop.EXITED, "killed by SIGABRT"),
    ],
)
def test_a_program_ends_well_or_says_how(ending, stop, detail):
    result = run(f"import sys\nprint(1, flush=True)\n{ending}")
    assert (result.stop, result.stdout, result.detail) == (stop, b"1\n", detail)


def test_an_uncaught_exception_has_its_line_and_only_the_submissions_frames():
    result = run("def f():\n    return 1 / 0\nprint(5, flush=True)\nf()")
    assert (result.stop, result.detail) == (Stop.EXCEPTION, "ZeroDivisionError: division by zero (line 2)")
    assert result.stdout == b"5\n"
    assert b"child.py" not in result.stderr
    assert result.stderr.startswith(
        b'Traceback (most recent call last):\n  File "my.py", line 4, in <module>'
    )


@pytest.mark.parametrize(
    ("source", "detail"),
    [
        ("raise ValueError('one\\n  two\\x1b[2J')", "ValueError: one two [2J (line 1)"),
        ("input()", "EOFError: EOF when reading a line (line 1)"),
    ],
)
def test_an_exception_is_told_in_one_line(source, detail):
    assert run(source).detail == detail


def test_stderr_is_cut_to_its_end():
    result = run("import sys\nsys.stderr.write('a' * 9999 + 'z')")
    assert len(result.stderr) == 4096
    assert result.stderr.endswith(b"az")
