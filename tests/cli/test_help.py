"""`judge help` and `--help`: the manual goes out as it is, and each command's examples can be typed.

What they say is in the transcripts of `help/` and `screens/help`.
"""

from __future__ import annotations

import json
import random
import re
import shlex
import subprocess
import sys

import pytest
from cli_support import ROOT
from terminals import on_a_terminal

from judge.cli.app import app
from judge.cli.options import Common
from judge.cli.table import COMMANDS
from judge.errors import nearest
from judge.manual import page, topics
from judge.sandbox.boundary import LEVELS

pytestmark = pytest.mark.slow

QUIET = (  # need no file of one's own, no history, and no time
    "judge progress --due",
    "judge help interview",
    "judge help tolerance zero",
    'judge hack count 1 "0, 0, 1, (-1, 1), (1, 1)"',
    "judge hack count",
)


def test_pages_go_into_a_pipe_as_they_are(judge):
    for name in topics():
        ended = judge("help", name)
        assert (ended.status, ended.out.rstrip()) == (0, page(name).text.rstrip())
    assert judge("help", "New", "kata").out == judge("help", "new-kata").out


@pytest.mark.parametrize(
    ("former", "now"), [("languages", "programs"), ("quiz", "interview"), ("problem toml", "problem")]
)
def test_a_former_name_finds_the_page_that_replaced_it(former, now, judge):
    assert judge("help", *former.split()).out == judge("help", now).out
    told = json.loads(judge("help", *former.split(), "--json").out)
    assert told["topic"] == now


@pytest.mark.slow
def test_a_page_that_is_longer_than_the_terminal_goes_through_the_pager(tmp_path):
    seen, pager = tmp_path / "seen", tmp_path / "pager"
    pager.write_text(f"#!/bin/sh\ncat > {seen}\n")
    pager.chmod(0o755)
    _, shown = on_a_terminal("help", "problem", PAGER=str(pager))
    paged = seen.read_text(encoding="utf-8")
    assert "Sets and skills" in paged
    assert "## " not in paged  # it is rendered
    assert "Sets and skills" not in shown
    assert "Nothing leaves your machine" in on_a_terminal("help", "privacy", rows=60, PAGER="false")[1]


# -- the help of each command -------------------------------------------------------------------------------


@pytest.mark.parametrize("name", COMMANDS)
def test_help_begins_as_the_table_says_and_ends_with_examples_and_a_page(name, judge):
    ended = judge(name, "--help")
    command = app.get_command(None, name)
    entry = COMMANDS[name]
    assert entry.sentence in ended.out
    assert command.help.splitlines()[0] == entry.sentence
    options = [each for each in command.params if each.param_type_name == "option"]
    assert all(each.help for each in options if each.name not in Common.__struct_fields__)
    start = ended.lines.index("  For example:") + 1
    shown = [line.strip() for line in ended.lines[start : start + len(entry.examples)]]
    assert shown == entry.examples
    assert ended.lines[-1] == f"  More: judge help {entry.topic}; --json writes JSON"
    assert max(map(len, ended.lines)) < 80
    assert f"judge {name}" in page(entry.topic).text


def test_the_help_is_one_screen_and_names_every_command(judge, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    shown = judge("--help").out
    assert shown.count("\n") <= 23
    assert max(map(len, shown.splitlines())) <= 80
    assert all(re.search(rf"\b{name}\b", shown) for name in COMMANDS)


def parse(line: str) -> str:
    """The name of a command line's command; fails where an option or a number is not valid."""
    program, name, *words = shlex.split(line, comments=True)
    assert program == "judge"
    with app.get_command(None, name).make_context(name, words) as parsed:
        assert parsed.args == []
    return name


def test_the_words_and_options_of_each_example_are_its_commands_own():
    for name, entry in COMMANDS.items():
        assert {parse(example) for example in entry.examples} == {name}


PIPED = re.compile(r"^(?:\$ )?(?:printf .* \| )?(judge [^&|\n]*)", re.MULTILINE)
SPOKEN = re.compile(r"`judge ([a-z]+)([^`]*)`")


@pytest.mark.parametrize("name", topics())
def test_the_command_lines_of_a_page_are_valid(name):
    """Those in blocks word for word; of those within a sentence, the command and its options."""
    text = page(name).text
    for block in re.findall(r"(?ms)^```(?:sh|console)\n(.*?)^```$", text):
        for line in PIPED.findall(block):
            parse(line)
    for command, words in SPOKEN.findall(re.sub(r"(?ms)^```.*?^```$", "", text)):
        known = {option for each in app.get_command(None, command).params for option in each.opts}
        assert set(re.findall(r"(?<!\S)--?[a-z][\w-]*", words)) <= known | {"--help"}, (command, words)


@pytest.mark.parametrize("example", QUIET)
def test_examples_that_need_nothing_succeed(example, judge):
    assert example in {each for entry in COMMANDS.values() for each in entry.examples}
    ended = judge(*shlex.split(example)[1:])
    assert (ended.status, ended.err) == (0, "")
    assert ended.out


# -- names that are no command's -----------------------------------------------------------------------------


@pytest.mark.parametrize(("typed", "meant"), [("submit", "run"), ("shwo", "show"), ("lst", "list")])
def test_a_mistyped_command_is_refused_with_the_one_that_was_meant(typed, meant, judge):
    ended = judge(typed)
    assert (ended.status, ended.out) == (2, "")
    assert ended.err == f"judge: There is no command {typed}. Did you mean judge {meant}?\n"


def test_the_name_of_a_file_is_told_how_to_judge_it(judge, submit):
    assert f"judge run {submit('x = 1')}" in judge("mine.py").err


def test_options_of_every_command_have_a_page_and_are_hidden_in_the_others(judge):
    shown = judge("help", "options").out
    assert f"--isolation {'|'.join(LEVELS)}" in shown
    assert all(f"`--{each}" in shown for each in (*Common.__struct_fields__, "debug"))
    assert "--isolation" not in judge("show", "--help").out


# -- completion in a shell -------------------------------------------------------------------------------


OFFERED = """
import json, sys
from click.shell_completion import ShellComplete
from judge.cli.app import app
for *args, incomplete in json.loads(sys.argv[1]):
    found = ShellComplete(app, {}, "judge", "_JUDGE_COMPLETE").get_completions(args, incomplete)
    print(json.dumps([item.value if item.type == "plain" else f"<{item.type}>" for item in found]))
"""


def offered(*asked: tuple[str, ...]) -> list[list[str]]:
    """What may stand where each last word is being typed; files are left to the shell: <file>.

    In a process of its own: completion leaves click's types changed.
    """
    command = [sys.executable, "-c", OFFERED, json.dumps(asked)]
    ended = subprocess.run(command, capture_output=True, text=True, timeout=60, check=True)
    return [json.loads(line) for line in ended.stdout.splitlines()]


def test_the_script_of_a_shell(process):
    ended = process(_JUDGE_COMPLETE="zsh_source")
    assert (ended.status, "_JUDGE_COMPLETE=zsh_complete" in ended.out) == (0, True)


def test_commands_and_options():
    first, options, levels = offered(
        ("",), ("run", "middle", "--j"), ("run", "middle", "mine.py", "--isolation", "s")
    )
    assert first == list(COMMANDS)
    assert "--junit" in options
    assert levels == ["strong"]


def test_katas_and_files(pack, monkeypatch):
    shipped = [path.parent.name for path in (ROOT / "problems").glob("*/problem.toml")]
    all_katas, begun, file = offered(("show", ""), ("run", "mi"), ("run", "middle", ""))
    assert all_katas == sorted([*shipped, "middle"])
    assert (begun, file) == (["middle", "<file>"], ["<file>"])
    monkeypatch.delenv("JUDGE_PROBLEMS")
    elsewhere = ("show", "--problems", str(pack / "problems"), "mi")
    assert offered(("show", "mi"), elsewhere) == [[], ["middle"]]


def test_every_command_is_named_for_two_hundred_words_with_one_slip(judge):
    chance = random.Random(5)
    asked = 0
    while asked < 200:
        meant = chance.choice(list(COMMANDS))
        at = chance.randrange(len(meant))
        before, letter, after = meant[:at], meant[at], meant[at + 1 :]
        other = chance.choice("abcdefghijklmnopqrstuvwxyz")
        typed = before + chance.choice(("", letter * 2, other, after[:1] + letter)) + after
        if len(typed) < 2 or typed in COMMANDS:
            continue
        asked += 1
        ended = judge(typed)
        assert ended.status == 2
        assert ended.err == f"judge: There is no command {typed}. Did you mean judge {meant}?\n", meant


@pytest.mark.parametrize(
    ("typed", "meant"), [("ryn", "run"), ("ery", "try"), ("lsit", "list"), ("sint", "hint")]
)
def test_of_two_commands_as_like_that_with_more_letters_in_place_is_meant(typed, meant):
    assert nearest(typed, COMMANDS) == meant
