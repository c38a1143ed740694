"""What a tool, a library or the system says is told in the judge's words, and never as an object's name."""

from __future__ import annotations

import subprocess

import pytest
from native import fault_of

from judge.errors import JudgeError, ProblemError
from judge.languages import find
from judge.languages.model import language_called
from judge.problem import solutions

_HUGE = "static int a[1000000000], b[1000000000]; int main(void) { a[5] = b[7]; return a[3] + b[2]; }"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "source", "told"),
    [
        ("a.c", _HUGE, "its arrays take more than the 2 GB that can be linked"),
        ("a.cpp", f"#include <vector>\n{_HUGE}", "its arrays take more than the 2 GB that can be linked"),
        (
            "a.c",
            "int _start(void) { return 0; } int main(void) { return 0; }",
            "multiple definition of `_start'",
        ),
        ("a.c", "int f(int); int main(void) { return f(1); }", "undefined reference to `f'"),
        (
            "a.rs",
            'extern "C" { fn nowhere() -> i32; }\nfn main() { unsafe { nowhere(); } }',
            "it cannot be linked: is something declared and nowhere defined?",
        ),
        (
            "a.c",
            '__asm__(".globl main\\nmain: .long 1\\n");\nint main(void) { return 0; }',
            "Error: symbol `main' is already defined",
        ),
    ],
)
def test_what_cannot_be_linked(name, source, told):
    assert fault_of(name, source).message == told


@pytest.mark.parametrize(
    ("fault", "told"),
    [
        (PermissionError(13, "Permission denied", "/x"), "/x cannot be started (permission denied)"),
        (subprocess.TimeoutExpired(["/x", "y"], 60.0), "/x y does not answer within 60 s"),
    ],
)
def test_a_tool_that_does_not_answer(monkeypatch, fault, told):
    def failing(*_args, **_more):
        raise fault

    monkeypatch.setattr(find.subprocess, "run", failing)
    with pytest.raises(JudgeError) as caught:
        find._asked(language_called("go"), ["/x", "y"])
    assert caught.value.what == told


def test_a_solution_that_is_no_python_has_its_line(tmp_path):
    (tmp_path / "problems" / "x").mkdir(parents=True)
    folder = tmp_path / "solutions" / "x" / "accepted"
    folder.mkdir(parents=True)
    (folder / "a.py").write_text("a = 1\ndef (:\n")
    with pytest.raises(ProblemError) as caught:
        solutions._read(solutions.Kind.ACCEPTED, folder / "a.py")
    assert caught.value.where.endswith("a.py:2")
    assert caught.value.what == "no Python: invalid syntax"
