"""Completion in a shell, by click's own interface."""

from __future__ import annotations

import pytest
from cli_support import ROOT
from click.shell_completion import ShellComplete

from judge.cli.app import app
from judge.cli.table import COMMANDS

pytestmark = pytest.mark.slow


def offered(*words: str) -> list[str]:
    """What may stand where the last word is being typed; files are left to the shell: <file>."""
    *args, incomplete = words
    found = ShellComplete(app, {}, "judge", "_JUDGE_COMPLETE").get_completions(args, incomplete)
    return [item.value if item.type == "plain" else f"<{item.type}>" for item in found]


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_the_script_of_a_shell(shell, judge, monkeypatch):
    monkeypatch.setenv("_JUDGE_COMPLETE", f"{shell}_source")
    ended = judge()
    assert (ended.status, f"_JUDGE_COMPLETE={shell}_complete" in ended.out) == (0, True)


def test_commands_and_options():
    assert offered("") == list(COMMANDS)
    assert "--junit" in offered("run", "middle", "--j")
    assert offered("run", "middle", "mine.py", "--isolation", "s") == ["strong"]


def test_katas_and_files(pack, monkeypatch):
    shipped = [path.parent.name for path in (ROOT / "problems").glob("*/problem.toml")]
    assert offered("show", "") == sorted([*shipped, "middle"])
    assert offered("run", "mi") == ["middle", "<file>"]
    assert offered("run", "middle", "") == ["<file>"]
    monkeypatch.delenv("JUDGE_PROBLEMS")
    assert offered("show", "mi") == []
    assert offered("show", "--problems", str(pack / "problems"), "mi") == ["middle"]
