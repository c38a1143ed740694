"""What a source is: names, lines and faults, found in containment."""

from __future__ import annotations

import os
import sys
import tempfile
from pathlib import Path

import pytest
from sandboxed import LIMITS, children, require

from judge.errors import JudgeError
from judge.sandbox import LEVELS, holder, open_box


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


def test_an_empty_source_compiles_and_binds_nothing():
    inspection = inspect(b"")
    assert (inspection.fault, inspection.names) == (None, ())


@pytest.mark.skipif(sys.platform != "linux", reason="processes are told by /proc")
@pytest.mark.parametrize("level", LEVELS)
def test_nothing_is_left_when_a_box_closes(level, tmp_path, monkeypatch):
    require(level)
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    descriptors, processes = len(list(Path("/dev/fd").iterdir())), children()
    with open_box(b"def f(): return 1", "my.py", level=level) as box:
        assert box.call_many("f", [()], LIMITS).replies[0].answer == 1
        assert box.run_program(b"", LIMITS).detail == ""
        assert children() > processes
        assert not list(tmp_path.iterdir())
    assert children() == processes
    assert len(list(Path("/dev/fd").iterdir())) == descriptors
    assert not list(tmp_path.iterdir())


def test_a_box_closes_twice_and_a_box_without_a_use_closes_too():
    with open_box(b"", "my.py") as box:
        box.__exit__(None, None, None)
    assert box.isolation in LEVELS


@pytest.mark.parametrize("python", ["/nowhere/python", "/bin/false"])
@pytest.mark.parametrize("level", [None, *LEVELS])
def test_an_interpreter_that_does_not_start_is_one_clear_error(python, level, monkeypatch):
    if level:
        require(level)
    before = children()
    monkeypatch.setattr(sys, "executable", python)
    monkeypatch.setattr(holder, "PAUSES", (0.0,) * len(holder.PAUSES))
    with pytest.raises(JudgeError) as caught, open_box(b"", "my.py", level=level):
        pass
    what = f"isolation {level} cannot be had here: " if level else "no container can be started: "
    if python == "/bin/false":  # it says nothing, so that it may be a passing fault
        what = "no container could be started: it ended without a word"
    assert caught.value.what.startswith(what)
    assert "\n" not in caught.value.what
    assert children() == before


def test_the_interpreter_is_the_judges_own():
    source = b"import sys\nprint(sys.executable)\nprint(sys.version)"
    with open_box(source, "my.py") as box:
        executable, *version = box.run_program(b"", LIMITS).stdout.decode().splitlines()
    assert os.path.realpath(executable) == os.path.realpath(sys.executable)
    assert version == sys.version.splitlines()
