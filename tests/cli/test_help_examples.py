"""The examples that end each command's help can be typed as they stand."""

from __future__ import annotations

import importlib
import shlex

import pytest

from judge.cli.table import COMMANDS, EXAMPLES, FIRST, FURTHER, TOPICS
from judge.manual import topics

EVERY = [(name, example) for name, examples in EXAMPLES.items() for example in examples]
QUIET = (  # need no file of one's own, no history, and no time
    "judge progress --row Q7",
    "judge list --json",
    "judge show count",
    "judge help quiz",
    "judge help --search tolerance",
    "judge why count close-points",
    'judge try count "0, 0, 1, (-1, 1), (1, 1)"',
    "judge hack count --list",
    "judge schema run",
    "judge completion bash",
    'judge explore count "0, 0, 1, (-1, 1), (1, 1)"',
)


def test_every_command_has_examples_and_a_page():
    assert [*EXAMPLES] == [*COMMANDS] == [*TOPICS]
    assert {*TOPICS.values()} <= {*topics()}
    assert len(FURTHER) + sum(map(len, FIRST.values())) == len(COMMANDS)


@pytest.mark.parametrize("name", COMMANDS)
def test_they_stand_in_the_help_unbroken(name, judge):
    shown = judge(name, "--help").lines
    start = shown.index("  For example:") + 1
    assert tuple(line.strip() for line in shown[start : start + len(EXAMPLES[name])]) == EXAMPLES[name]
    assert shown[-1] == f"  More: judge help {TOPICS[name]}"
    assert max(map(len, shown)) < 80


@pytest.mark.parametrize(("name", "example"), EVERY, ids=[example for _, example in EVERY])
def test_each_has_the_commands_own_words_and_options(name, example):
    program, first, *words = shlex.split(example)
    assert (program, first) == ("judge", name)
    command = importlib.import_module(f"judge.cli.commands.{name}").command
    with command.make_context(name, words) as parsed:  # raises where an option or a number is none
        assert parsed.args == []


@pytest.mark.parametrize("example", QUIET)
def test_those_that_need_nothing_succeed(example, judge):
    assert example in {each for _, each in EVERY}
    ended = judge(*shlex.split(example)[1:])
    assert (ended.status, ended.err) == (0, "")
    assert ended.out
