from __future__ import annotations

import os
import re
import subprocess
import sys

import pytest
from cli_support import MEAN, ROOT

from judge import __version__
from judge.cli.app import app
from judge.cli.table import COMMANDS, TOPICS
from judge.manual import page, topics

HEAVY = (
    "rich",
    "hypothesis",
    "sqlite3",
    "jinja2",
    "importlib.metadata",
    "msgspec",
    "numpy",
    "platformdirs",
    "tomllib",
    "subprocess",
    "asyncio",
    "judge.exact",
    "judge.problem",
    "judge.run",
)


def imported(*words: str, heavy: tuple[str, ...] = HEAVY) -> list[str]:
    """Which of the heavy modules a fresh process has imported at the end of `judge WORDS`."""
    script = (
        "import sys\n"
        "from judge.cli import main\n"
        f"sys.argv = ['judge', *{list(words)!r}]\n"
        "try:\n    main()\n"
        "except SystemExit as left:\n    assert not left.code, left.code\n"
        f"print(*(name for name in {heavy!r} if name in sys.modules), file=sys.stderr)\n"
    )
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    command = [sys.executable, "-c", script]
    ended = subprocess.run(command, capture_output=True, text=True, timeout=120, check=True, env=environment)
    return ended.stderr.split()


@pytest.mark.parametrize("words", [("--help",), ("-h",), ("--version",), ()])
def test_starting_imports_nothing_heavy(words):
    assert imported(*words) == []


def test_a_warm_run_into_a_pipe_imports_only_what_it_needs(submit, judge):
    name = submit(MEAN)
    assert judge("run", "middle", name).status == 0  # warms the cache
    looked_at = ("rich", "hypothesis", "sqlite3", "jinja2", "importlib.metadata", "numpy", "judge.exact")
    looked_at += ("yaml", "judge.packs.foreign.opening")
    assert imported("run", "middle", name, "--no-history", heavy=looked_at) == []


def test_version(judge):
    ended = judge("--version")
    assert (ended.status, ended.out) == (0, f"judge {__version__}\n")


def test_no_command_shows_the_help(judge):
    assert judge().out == judge("--help").out


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_has_help_that_begins_as_the_table_says(name, judge):
    ended = judge(name, "--help")
    assert ended.status == 0
    assert COMMANDS[name] in ended.out
    command = app.get_command(None, name)
    assert command.help.splitlines()[0] == COMMANDS[name]
    assert all(parameter.help for parameter in command.params if parameter.param_type_name == "option")


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_names_its_page_of_the_manual(name, judge):
    assert judge(name, "--help").out.endswith(f"  More: judge help {TOPICS[name]}\n")
    assert TOPICS[name] in topics()


def test_help_is_one_screen_and_names_every_command(process):
    shown = process("--help", COLUMNS="80").out
    assert shown.count("\n") <= 23
    assert max(map(len, shown.splitlines())) <= 80
    for name in COMMANDS:
        assert re.search(rf"\b{name}\b", shown)


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_is_in_the_manual_and_takes_json(name, judge):
    assert f"`judge {name}" in page("commands").text
    assert "--json" in judge(name, "--help").out
