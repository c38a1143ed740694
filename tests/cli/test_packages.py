"""`judge run PACKAGE`: submissions judged on packages of another judge, as a person and a script see it."""

from __future__ import annotations

import json
import shutil

import pytest
from cli_support import MEAN
from foreign_packages import CHECKER, LEGACY, NEW, RAISES, RIGHT, WRONG, written, zipped
from jsonschema import Draft202012Validator

from judge.schema import schema_of

pytestmark = pytest.mark.slow

MANY_FILES = """
import os, sys
for n in range(99):
    os.mkdir(f"{sys.argv[3]}{n}")
    open(f"{sys.argv[3]}{n}/f", "w").close()
sys.exit(42)
"""
TWO = "import helper\nprint(helper.total(*map(int, input().split())))\n"
BUSY = "import time\nwhile time.process_time() < 0.3:\n    pass\n"
HOSTILE = """
import os, socket, sys
found = []
for path in ("/etc/shadow", "/root", "/home", HIDDEN):
    try:
        found.append(os.listdir(path) if os.path.isdir(path) else open(path).read())
    except OSError:
        pass
try:
    socket.create_connection(("127.0.0.1", 9), 1)
    found.append("network")
except OSError as fault:
    found += ["network"] if isinstance(fault, ConnectionRefusedError) else []
for path in (sys.argv[0], sys.argv[1], sys.argv[2], "/tmp/out", "/box/new"):
    try:
        open(path, "w").write("3")
        found.append(path)
    except OSError:
        pass
open(sys.argv[3] + "judgemessage.txt", "w").write(f"found {[each for each in found if each]}")
sys.exit(43)
"""


@pytest.fixture
def package(tmp_path):
    return lambda *tables: str(written(tmp_path / "sum", *tables))


def rows(ended):
    found = [json.loads(line) for line in ended.lines]
    validator = Draft202012Validator(schema_of("run"))
    for row in found:
        validator.validate(row)
    return found


def test_its_own_submissions_against_what_they_should_come_to(package, judge):
    own = {
        "submissions/wrong_answer/wrong.py": WRONG,
        "submissions/wrong_answer/right_all_the_same.py": RIGHT,
        "submissions/run_time_error/raises.py": RAISES,
        "submissions/accepted/old.py": "#!/usr/bin/env python2\nprint 3",
        "submissions/accepted/folder/main.py": TWO,
        "submissions/accepted/folder/helper.py": "def total(a, b):\n    return a + b\n",
    }
    ended = judge("run", package(LEGACY, own), "--all", "--json")
    assert ended.status == 3  # one is not run here
    assert "judged first" in ended.err
    found = {row["submission"].removeprefix("submissions/"): row for row in rows(ended)}
    assert {name: (row["verdict"], row["as_expected"]) for name, row in found.items()} == {
        "accepted/folder": ("AC", True),
        "accepted/old.py": ("JE", None),
        "accepted/right.py": ("AC", True),
        "run_time_error/raises.py": ("RTE", True),
        "wrong_answer/right_all_the_same.py": ("AC", False),
        "wrong_answer/wrong.py": ("WA", True),
    }
    wrong = found["wrong_answer/wrong.py"]
    assert (wrong["passed"], wrong["test_files"], wrong["failure"]["test"]) == (1, 2, "secret/1")
    assert wrong["limits"]["time_seconds"] >= 1
    assert wrong["limits"]["margin_seconds"] == 2 * wrong["limits"]["time_seconds"]


def test_the_limit_of_accepted_submissions_is_kept_until_the_package_changes(package, judge, submit):
    root, name = package(LEGACY), submit(RIGHT, "mine.py")
    first, again = judge("run", root, name), judge("run", root, name)
    assert (first.status, again.status) == (0, 0)
    assert "judged first" in first.err
    assert "judged first" not in again.err
    package({"data/secret/1.in": "5 -5", "data/secret/1.ans": "0"})
    assert "judged first" in judge("run", root, name).err


def test_a_package_without_an_accepted_submission_has_a_generous_limit(package, judge, submit):
    root = package(LEGACY, {"submissions/accepted/right.py": None})
    ended = judge("run", root, submit(RIGHT, "mine.py"), "--json")
    assert ended.status == 0, ended
    assert "the package has no accepted submission to set the time limit: it is 60 s" in ended.err
    assert rows(ended)[0]["limits"]["slowest_accepted_seconds"] is None
    package({"submissions/accepted/wrong.py": WRONG})
    again = judge("run", root, "mine.py", "--json")
    assert again.status == 0, again
    assert "judged first" in again.err
    assert "it accepts none of them to set the time limit: it is 60 s" in again.err


def test_a_wrong_one_is_shown_with_its_test_file(package, judge, submit):
    settings = {
        "problem.yaml": "validation: custom\nvalidator_flags: outer",
        "data/secret/testdata.yaml": "output_validator_flags: inner",
        "output_validators/check.py": CHECKER,
    }
    ended = judge("run", package(LEGACY, settings), submit(WRONG, "mine.py"))
    assert ended.status == 1
    shown = [" ".join(line.split()) for line in ended.lines]
    assert "secret/1" in shown
    for line in ("input -1 2", "answer 1", "output 3", "why the output validator rejects it"):
        assert line in shown
    assert "judge message flags ['outer', 'inner'], input ['-1', '2']" in shown
    assert shown[-1] == "WA wrong answer 1 of 2 test files"


def test_several_files_a_folder_and_one_that_is_none(package, judge, submit):
    root = package(NEW)
    files = [submit(RIGHT, "right.py"), submit(WRONG, "wrong.py"), submit("x", "notes.txt")]
    ended = judge("run", root, *files, "--json")
    assert ended.status == 3
    assert [row["verdict"] for row in rows(ended)] == ["AC", "WA", "JE"]
    shown = judge("run", root, files[0], files[1])
    assert shown.status == 1
    assert shown.lines[-1] == "1 of 2 accepted"
    alone = judge("run", root, files[2])
    assert (alone.status, alone.out) == (2, "")
    assert "no language that is known here" in alone.err


def test_an_archive_and_a_tag(tmp_path, judge):
    tagged = {**NEW, "submissions/odd/slow.py": f"# @EXPECTED_RESULTS@: WRONG-ANSWER\n{WRONG}"}
    path = zipped(tmp_path / "sum.zip", {f"sum/{name}": text for name, text in tagged.items()})
    ended = judge("run", str(path), "--all")
    assert (ended.status, ended.lines[-1]) == (0, "2 of 2 submissions as expected")
    assert "2 s of CPU time, margin 3 s" in ended.out


def test_a_close_call_is_told(package, judge, submit):
    limits = "limits: {time_limit: 0.1, time_multipliers: {time_limit_to_tle: 600}}"
    root = package(NEW, {"problem.yaml": f"problem_format_version: 2025-09\n{limits}"})
    ended = judge("run", root, submit(BUSY + RIGHT, "mine.py"), "--json")
    (row,) = rows(ended)
    assert (ended.status, row["verdict"]) == (1, "TLE")
    assert "another machine may say AC" in row["sensitive"]


def test_a_validator_is_trusted_with_nothing(package, judge, submit, tmp_path):
    (tmp_path / "private").write_text("private")
    source = HOSTILE.replace("HIDDEN", repr(str(tmp_path / "private")))
    ended = judge(
        "run", package(NEW, {"output_validator/check.py": source}), submit(RIGHT, "mine.py"), "--json"
    )
    (row,) = rows(ended)
    if row["isolation"] == "limits":
        pytest.skip("nothing is hidden there")
    assert (row["verdict"], row["failure"]["judge_message"]) == ("WA", "found []")
    assert (tmp_path / "sum/data/sample/1.ans").read_text() == "3\n"


@pytest.mark.parametrize(
    ("source", "why"),
    [
        ("raise SystemExit(0)", "neither 42 nor 43"),
        ("raise ValueError('own fault')", "own fault"),
        ("while True: pass", "of CPU time"),
        ("import os; os.kill(os.getpid(), 9)", "SIGKILL"),
        ("import sys; open(sys.argv[3] + 'score.txt', 'w').write('1'); sys.exit(42)", "score.txt"),
        (MANY_FILES, "more files than it may"),
    ],
)
def test_a_validator_that_says_neither_is_a_fault(package, judge, submit, source, why):
    settings = {
        "problem.yaml": "problem_format_version: 2025-09\nlimits: {time_limit: 2, validation_time: 1}",
        "output_validator/check.py": source,
    }
    ended = judge("run", package(NEW, settings), submit(RIGHT, "mine.py"), "--json")
    (row,) = rows(ended)
    assert (ended.status, row["verdict"]) == (3, "JE")
    assert why in row["failure"]["message"]


@pytest.mark.skipif(shutil.which("g++") is None, reason="no C++ compiler")
def test_a_validator_of_several_cpp_files(package, judge, submit):
    settings = {
        "problem.yaml": "validation: custom",
        "output_validators/check/main.cc": (
            '#include "read.h"\n#include <iostream>\n'
            "int main(int, char** words) {\n"
            "    long long own;\n    return std::cin >> own && own == read(words[2]) ? 42 : 43;\n}\n"
        ),
        "output_validators/check/read.cpp": (
            '#include "read.h"\n#include <fstream>\n'
            "long long read(const char* path) { long long n; std::ifstream(path) >> n; return n; }"
        ),
        "output_validators/check/read.h": "long long read(const char* path);\n",
    }
    files = [submit(RIGHT, "right.py"), submit(WRONG, "wrong.py")]
    ended = judge("run", package(LEGACY, settings), *files, "--json")
    assert [row["verdict"] for row in rows(ended)] == ["AC", "WA"]


@pytest.mark.parametrize(
    ("settings", "why"),
    [
        ({"output_validator/check.py": "def"}, "does not compile"),
        ({"output_validator/build": "#!/bin/sh", "output_validator/check.py": ""}, "a script of its own"),
        ({"output_validator/check.txt": ""}, "no language that is known"),
    ],
)
def test_a_validator_that_cannot_be_run_is_told_once(package, judge, submit, settings, why):
    ended = judge("run", package(NEW, settings), submit(RIGHT, "mine.py"))
    assert (ended.status, ended.out, ended.err.count("\n")) == (3, "", 1)
    assert why in ended.err


@pytest.mark.parametrize(
    ("words", "why"),
    [
        ((), "name files to judge, or its own submissions with --all"),
        (("mine.py", "--all"), "leave one out"),
        (("mine.py", "--seed", "1"), "--seed does not go with a package"),
        (("mine.py", "-j", "2"), "-j does not go with a package"),
        (("mine.py", "--format", "github"), "--format github does not go"),
        (("nobody.py",), "no such file"),
    ],
)
def test_what_cannot_be_asked_of_a_package(package, judge, submit, words, why):
    submit(RIGHT, "mine.py")
    ended = judge("run", package(NEW), *words)
    assert (ended.status, ended.out, ended.err.count("\n")) == (2, "", 1)
    assert why in ended.err


def test_a_package_that_is_not_there_or_not_first(package, judge, submit):
    root = package(NEW)
    submit(RIGHT, "mine.py")
    for words, why in (
        (("gone.zip", "mine.py"), "gone.zip: no such file; "),
        (("mine.py", root), "the package comes first: judge run "),
    ):
        ended = judge("run", *words)
        assert (ended.status, ended.out, ended.err.count("\n")) == (2, "", 1)
        assert why in ended.err


def test_other_kinds_of_packages_are_refused_in_a_line(package, judge, submit):
    ended = judge(
        "run", package(LEGACY, {"problem.yaml": "validation: custom interactive"}), submit(RIGHT, "m.py")
    )
    assert (ended.status, ended.out, ended.err.count("\n")) == (2, "", 1)
    assert "interactive problems are not judged: " in ended.err


def test_names_that_would_steer_the_terminal_are_written_out(package, judge, submit):
    root = package(NEW, {"data/secret/\x1b[31mred.in": "1 1\n\x1b[2J", "data/secret/\x1b[31mred.ans": "9\n"})
    ended = judge("run", root, submit(RIGHT, "mine.py"))
    assert "\x1b" not in ended.out
    assert r"secret/\x1b[31mred" in ended.out


def test_a_problems_name_is_that_problem(judge, submit, tmp_path):
    written(tmp_path / "middle", NEW)
    ended = judge("run", "middle", submit(MEAN, "mine.py"), "--json")
    assert json.loads(ended.out)["problem"] == "middle"
    assert rows(judge("run", "./middle", submit(RIGHT, "mine.py"), "--json"))[0]["package"] == "middle"


def test_a_file_with_the_function_is_run_as_a_program_where_that_is_asked(judge, submit):
    wrong = (
        "def middle(a, b):\n    return (a + b) / 2\nfor _ in range(int(input())):\n    print('no number')\n"
    )
    name = submit(wrong, "mine.py")
    called, ran = (
        json.loads(judge("run", "middle", name, "--json", "--no-name", "--no-shrink", *more).out)
        for more in ((), ("--mode", "program"))
    )
    assert (called["mode"], ran["mode"], ran["verdict"]) == ("function", "program", "WA")
    assert "defines no" not in ran["failure"]["message"]
