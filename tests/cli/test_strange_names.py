"""Files whose names would be taken for something else: a command to CI, an option, the next line."""

from __future__ import annotations

import json
import os
import re
import sys

import pytest
from cli_support import FLOOR, MEAN
from sampling import daily

from judge.report.screen import Screen
from judge.report.words import shown_command, shown_name

pytestmark = pytest.mark.slow

STRANGE = [
    "::error::x.py",
    "a##[error]x.py",
    "--help.py",
    "\n::error::b.py",
    "a\r ::error::b.py",
    "a\x1b[2Jb.py",
    "a\u2028::error::b.py",
    "\u202egnp.py",
    "it's $(id).py",
    os.fsdecode(b"\xff::error.py"),
]
strange = pytest.mark.parametrize(
    "name", daily(STRANGE, ("--help.py", "\n::error::b.py", "a\x1b[2Jb.py", "\u202egnp.py"))
)


def harmless(text: str) -> bool:
    """Whether GitHub's runner reads no command in it: it trims a line, and finds the old form anywhere."""
    return not any(row.strip().startswith("::") for row in re.split(r"[\r\n]", text)) and "##[" not in text


@strange
def test_no_line_of_the_output_begins_with_a_name_that_is_a_command(name, judge, submit, monkeypatch):
    submit(FLOOR, name)
    for columns, *words in (
        ("", "run", "middle", "--no-name", "--", name),
        ("30", "run", "middle", "--no-name", "--no-shrink", "--", name),
        ("30", "run", "middle", "--fresh", "1s", "--no-name", "--no-shrink", "--", name),
        ("", "history"),
        ("", "start", "middle", "--no-watch", "--", f"new{name}"),
        ("", "export", "middle", "--format", "files", "--out", f"{name}.d"),
    ):
        monkeypatch.setenv("COLUMNS", columns)
        ended = judge(*words)
        assert ended.status in (0, 1), ended
        assert ended.out
        assert harmless(ended.out), words
        assert harmless(ended.err), words


@strange
def test_in_a_table_of_several_it_is_a_row_and_scripts_get_it_as_it_was_given(name, judge, submit):
    submit(MEAN, name)
    submit(FLOOR, f"b{name}")
    ended = judge("run", "middle", ".", "--no-shrink", "--no-name")
    assert harmless(ended.out)
    assert ended.lines[-1] == "1 of 2 accepted"
    rows = [row for row in ended.lines if re.match("(AC|WA) ", row)]
    assert len(rows) == 2, "a row each, whatever line breaks the names have"
    told = judge("run", "middle", "--json", "--", name).lines[0]
    assert told.isprintable()
    assert json.loads(told)["submission"] == name
    (row,) = judge("run", "middle", "--format", "github", "--", name).lines
    assert row.startswith("::notice file=")
    assert row.count("::") == 2


@pytest.mark.parametrize(
    ("name", "shown"),
    [
        ("mine.py", "mine.py"),
        ("été.py", "été.py"),
        ("./-x.py", "./-x.py"),
        ("-x.py", "./-x.py"),
        ("::error::x.py", "./::error::x.py"),
        ("~x.py", "./~x.py"),
        ("a\nb.py", r"a\nb.py"),
        ("\nb.py", r"./\nb.py"),
    ],
)
def test_names(name, shown):
    assert shown_name(name) == shown


@pytest.mark.parametrize(
    ("name", "command"),
    [
        ("mine.py", "judge try x:y mine.py"),
        ("my file.py", "judge try x:y 'my file.py'"),
        ("-x.py", "judge try x:y ./-x.py"),
        ("a\nb'\\.py", r"judge try x:y $'a\x0ab\x27\x5c.py'"),
        ("é\n.py", r"judge try x:y $'\xc3\xa9\x0a.py'"),
    ],
)
def test_commands(name, command):
    assert shown_command("judge", "try", "x:y", file=name) == command


@pytest.mark.parametrize(
    "text", ["::error::x", "a\n  ::stop-commands::x\nb", "\t::x", "a ##[error]b", "##[group]"]
)
def test_whatever_is_written_is_no_command(text, capsys):
    Screen.of(sys.stdout).write(text)
    written = capsys.readouterr().out
    assert harmless(written)
    assert written.replace(r"\x3a", ":").replace(r"\x23", "#") == text
