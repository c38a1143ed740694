"""Both ways to run a submission have one interface, and nothing goes round it."""

from __future__ import annotations

import re
from pathlib import Path

import judge

PACKAGE = Path(judge.__file__).parent


def code_of(path: Path) -> str:
    """A file's text without comments."""
    return re.sub(r"#.*", "", path.read_text(encoding="utf-8"))


def places(pattern: str) -> list[str]:
    """Where the package's code matches, a file for each time."""
    return [
        path.relative_to(PACKAGE).as_posix()
        for path in sorted(PACKAGE.rglob("*.py"))
        for _ in re.finditer(pattern, code_of(path))
    ]


def test_only_the_two_runners_look_a_mode_up():
    assert places(r"\bMode\.[A-Z]+\b") == ["run/function.py", "run/program.py"]


def test_a_submission_s_answers_are_decided_in_one_place_for_each_mode():
    assert places(r"\.problem\.answer\.check(_line)?\b") == [
        "packs/export/trial.py",  # the first failing file, as the package's own judge will find it
        "run/function.py",
        "run/program.py",
    ]
    called = set(places(r"box\.(call_many|call_series|run_program)\("))
    assert called - {"sandbox/probe.py", "sandbox/native.py"} == {
        "run/function.py",
        "run/program.py",
        "mistakes/contained.py",  # which compares trusted programs with themselves
        "packs/export/trial.py",
        "packs/foreign/judging.py",  # which has files and validators in place of cases and types
    }  # those two only look around
