"""What a tool, a library or the system says is told in the judge's words, and never as an object's name."""

from __future__ import annotations

import subprocess

import pytest
from native import fault_of

from judge.errors import JudgeError
from judge.languages import find
from judge.languages.model import language_called

_HUGE = "static int a[1000000000], b[1000000000]; int main(void) { a[5] = b[7]; return a[3] + b[2]; }"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "source", "told"),
    [
        ("a.c", _HUGE, "its arrays take more than the 2 GB that can be linked"),
        ("a.c", "int f(int); int main(void) { return f(1); }", "undefined reference to `f'"),
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
