"""What a source is: names, lines and faults, found in containment."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest
from sandboxed import LIMITS

from judge.errors import JudgeError
from judge.sandbox import open_box


def inspect(source):
    with open_box(source, "my.py") as box:
        return box.inspect()


def test_names_of_every_kind_of_binding_with_their_lines():
    source = b"""import os.path, sys as system
from math import sqrt as root
def f(): inner = 1
async def g(): pass
class C: member = 1
(a, b), *c = [1, 2], 3
d: int = 4
for i in range(3):
    if (w := i): j = w
with open('x') as h: pass
try: k = 1
except OSError: m = 2
n = [q for q in (lambda p: p)(3)]
f = None
"""
    names = dict(inspect(source).names)
    assert names == {
        "os": 1, "system": 1, "root": 2, "f": 3, "g": 4, "C": 5, "a": 6, "b": 6, "c": 6, "d": 7,
        "i": 8, "w": 9, "j": 9, "h": 10, "k": 11, "m": 12, "n": 13,
    }  # fmt: skip


def test_inspecting_runs_nothing(tmp_path):
    proof = tmp_path / "ran"
    inspection = inspect(f"open({str(proof)!r}, 'w').close()\ndef f(): pass".encode())
    assert inspection.defines("f")
    assert not inspection.defines("g")
    assert not proof.exists()


def test_a_syntax_error_has_its_place():
    fault = inspect(b"x = 1\ndef f(:\n    pass\n").fault
    assert fault.message == "SyntaxError: invalid syntax"
    assert (fault.line, fault.text) == (2, "def f(:")


@pytest.mark.parametrize(
    "source",
    [b"x = '\xff'", b"a = 1\0", b"(" * 10**5, b"-" * 10**6 + b"1", b"# coding: klingon\n", b"if x:\nreturn"],
)
def test_sources_that_do_not_compile_are_faults(source):
    assert inspect(source).fault.message


def test_an_empty_source_compiles_and_binds_nothing():
    inspection = inspect(b"")
    assert inspection.fault is None
    assert inspection.names == ()


def test_nothing_is_left_when_a_box_closes():
    before = len(list(Path("/dev/fd").iterdir()))
    with open_box(b"", "my.py") as box:
        box.inspect()
        folder = box._folder
        pid = box._worker.pid
        assert not list(Path(folder).iterdir())
    assert not Path(folder).exists()
    assert len(list(Path("/dev/fd").iterdir())) == before
    with pytest.raises(ProcessLookupError):
        os.kill(pid, 0)


@pytest.mark.parametrize("python", ["/nowhere/python", "/bin/false"])
def test_an_interpreter_that_does_not_start_is_one_clear_error(python):
    with open_box(b"", "my.py", python=python) as box, pytest.raises(JudgeError, match=f"{python}: .*start"):
        box.inspect()


def test_the_child_sees_only_a_minimal_environment(monkeypatch):
    monkeypatch.setenv("JUDGE_SECRET", "answer")
    with open_box(b"import os\ndef f(): return [len(os.environ.get('JUDGE_SECRET', ''))]", "my.py") as box:
        assert box.call_many("f", [()], LIMITS).replies[0].answer == [0]


def test_the_interpreter_is_the_judges_own():
    with open_box(b"import sys\nprint(sys.executable)", "my.py") as box:
        assert box.run_program(b"", LIMITS).stdout.decode().strip() == sys.executable
