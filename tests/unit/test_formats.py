"""Results at their places, as GitHub and editors read them: nothing of a submission begins a line of its own.

What they show of each verdict is in golden/transcripts: run/formats.txt.
"""

from __future__ import annotations

import re

import pytest
from msgspec.structs import replace

from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.report.formats import annotation, editor_lines
from judge.report.tell import FilePlace, annotated_place, fault_place
from judge.run.result import Failure, GroupResult, Result

KATA = replace(find_problem("count"), entry="solve")
COMMAND = re.compile(r"::(error|notice) ([^:]*)::(.*)")
SOURCE = b"import math\n\ndef solve(a):\n    return 1 / a\n"


def result(verdict: Verdict, message: str = "", **changes) -> Result:
    ran = verdict not in (Verdict.CE, Verdict.JE)
    groups = (GroupResult(name="grid", verdict=verdict, cases=2, passed=1),) if ran else ()
    failure = Failure(message, groups[0].name if groups else None, 7 if groups else None) if message else None
    name = changes.pop("name", "mine.py")
    return Result(
        problem="count", submission=name, verdict=verdict, groups=groups, failure=failure, **changes
    )


def parts(text: str) -> tuple[str, dict[str, str], list[str]]:
    """The command's name, its properties and the lines of its message, as GitHub reads them."""
    assert "\n" not in text
    assert "\r" not in text
    found = COMMAND.fullmatch(text)
    assert found, text
    properties = dict(each.split("=", 1) for each in found[2].split(","))
    return found[1], {name: plain(value) for name, value in properties.items()}, plain(found[3]).split("\n")


def plain(text: str) -> str:
    for code, character in (("%2C", ","), ("%3A", ":"), ("%0A", "\n"), ("%0D", "\r"), ("%25", "%")):
        text = text.replace(code, character)
    return text


@pytest.mark.parametrize("evil", ["a::error file=x::b", "100%, 5%0A", "x\n::stop-commands::y"])
def test_nothing_of_a_submission_becomes_a_command(evil):
    text = annotation(result(Verdict.RTE, evil, name=evil), SOURCE, KATA, {})
    _, properties, lines = parts(text)
    written_out = evil.replace("\n", r"\n").replace("\r", r"\r").replace("\x1b", r"\x1b")
    assert properties["file"] == written_out
    assert written_out in lines


def test_nothing_of_a_submission_begins_a_line_or_steers_the_terminal():
    found = result(Verdict.WA, "a\nother.py:1:1: error: b\x1b[2J", name="-x\n.py")
    (said,) = editor_lines(found, SOURCE, KATA)
    assert said.startswith("./-x\\n.py:3:1: error: ")
    assert said.isprintable()


def test_a_path_is_told_from_the_root_of_the_repository(tmp_path, monkeypatch):
    (tmp_path / "team").mkdir()
    monkeypatch.chdir(tmp_path / "team")
    for root, wanted in ((str(tmp_path), "team/mine.py"), ("/elsewhere", "mine.py"), ("", "mine.py")):
        text = annotation(result(Verdict.AC), SOURCE, KATA, {"GITHUB_WORKSPACE": root})
        assert parts(text)[1]["file"] == wanted


@pytest.mark.parametrize(
    ("verdict", "message", "place"),
    [
        (Verdict.CE, "SyntaxError: bad (line 2, column 9): f(line 3)", FilePlace(2, 9)),
        (Verdict.CE, "the file is not UTF-8: byte 0xff (line 4); save it as UTF-8", FilePlace(4)),
        (Verdict.CE, "source code string cannot contain null bytes", None),
        (
            Verdict.RTE,
            "ValueError: x (line 4); it was run as a program because it defines no f; is g (line 9) meant",
            FilePlace(4),
        ),
        (Verdict.WA, "the str 'a (line 4)'", None),
    ],
)
def test_the_place_of_a_fault(verdict, message, place):
    assert fault_place(result(verdict, message)) == place


@pytest.mark.parametrize(
    ("source", "line"),
    [
        (SOURCE, 3),
        (b"x = 1\nasync  def solve(a): pass", 2),
        (b"import f\n\nsolve = f.g\n", 3),
        (b"class A:\n    def solve(self): pass\n", 1),
        (b"\xff\xfe", 1),
    ],
)
def test_without_a_fault_it_is_the_entry_functions_line(source, line):
    assert annotated_place(result(Verdict.WA, "x"), source, "solve") == FilePlace(line)
