"""Program mode behind the boundary: streams, ends and limits of a whole program."""

from __future__ import annotations

import pytest
from sandboxed import limits, run

from judge.sandbox import Stop


def test_stdin_to_stdout():
    result = run("import sys\nfor line in sys.stdin: print(int(line) * 2)", b"1\n20\n")
    assert (result.stop, result.stdout, result.stderr) == (Stop.ANSWERED, b"2\n40\n", b"")
    assert result.usage.memory_bytes > 1 << 20


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


@pytest.mark.parametrize("ending", ["sys.exit()", "sys.exit(0)", "raise SystemExit", "exit()", "pass"])
def test_good_ends(ending):
    result = run(f"import sys\nprint(1)\n{ending}")
    assert (result.stop, result.stdout, result.detail) == (Stop.ANSWERED, b"1\n", "")


@pytest.mark.parametrize(
    ("ending", "detail"),
    [
        ("sys.exit(3)", "exit status 3"),
        ("sys.exit('no')", "exit status 1"),
        ("import os; os._exit(9)", "exit status 9"),
        ("import os; os.abort()", "killed by SIGABRT"),
    ],
)
def test_bad_ends(ending, detail):
    result = run(f"import sys\n{ending}")
    assert (result.stop, result.detail) == (Stop.EXITED, detail)


def test_an_uncaught_exception_has_its_line_and_only_the_submissions_frames():
    result = run("def f():\n    return 1 / 0\nprint(5, flush=True)\nf()")
    assert (result.stop, result.detail) == (Stop.EXCEPTION, "ZeroDivisionError: division by zero (line 2)")
    assert result.stdout == b"5\n"
    assert b"child.py" not in result.stderr
    assert result.stderr.startswith(
        b'Traceback (most recent call last):\n  File "my.py", line 4, in <module>'
    )


def test_an_exception_text_of_several_lines_is_told_in_one():
    assert run("raise ValueError('one\\n  two\\x1b[2J')").detail == "ValueError: one two [2J (line 1)"


def test_reading_past_the_end_of_stdin_is_an_exception():
    assert run("input()").detail == "EOFError: EOF when reading a line (line 1)"


def test_limits_of_time_memory_and_output():
    assert run("while True: pass", within=limits(cpu_seconds=0.3)).stop is Stop.CPU
    assert run("import time\ntime.sleep(60)", within=limits(wall_seconds=0.5)).stop is Stop.WALL
    assert run("x = bytes(1 << 40)").stop is Stop.MEMORY
    assert run("x = bytearray(b'x') * (200 << 20)", within=limits(memory_bytes=64 << 20)).stop is Stop.MEMORY
    assert run("while True: print('x' * 999)").stop is Stop.OUTPUT
    assert run("import sys\nwhile True: sys.stderr.write('x' * 999)").stop is Stop.OUTPUT


def test_exactly_the_output_limit_is_enough():
    result = run("print('x' * 99)", within=limits(output_bytes=100))
    assert (result.stop, len(result.stdout)) == (Stop.ANSWERED, 100)
    result = run("print('x' * 100)", within=limits(output_bytes=100))
    assert (result.stop, len(result.stdout)) == (Stop.OUTPUT, 100)


def test_descriptors_of_the_judge_are_closed():
    source = """
import os
for fd in range(3, 60):
    try: os.fstat(fd)
    except OSError: continue
    print(fd)
"""
    assert run(source).stdout == b""


def test_stderr_is_cut_to_its_end():
    result = run("import sys\nsys.stderr.write('a' * 9999 + 'z')")
    assert len(result.stderr) == 4096
    assert result.stderr.endswith(b"az")
