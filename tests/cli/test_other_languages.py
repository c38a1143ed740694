"""Submissions in other languages, from the stub to the verdict, as a person sees them."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path

import pytest
from cli_support import PACK
from jsonschema import Draft202012Validator
from sampling import daily

from judge.cli.app import app
from judge.languages import find
from judge.languages.model import language_called, languages
from judge.schema import schema_of

pytestmark = pytest.mark.slow

MEAN = {  # of two numbers, right
    "c": "bool middle(double a, double b, double *out) { *out = (a + b) / 2; return true; }",
    "cpp": "double middle(double a, double b) { return (a + b) / 2; }",
    "go": "package main\nfunc middle(a, b float64) (float64, bool) { return (a + b) / 2, true }",
    "java": "class Solution { static double middle(double a, double b) { return (a + b) / 2; } }",
    "javascript": "function middle(a, b) { return (a + b) / 2; }",
    "rust": "fn middle(a: f64, b: f64) -> f64 { (a + b) / 2.0 }",
    "pypy": "def middle(a, b):\n    return (a + b) / 2.0\n",
}


def need(name):
    language = language_called(name)
    if find.why_not(language):
        pytest.skip(f"{language.name} is not installed: {find.remedy(language)}")
    return language


@pytest.mark.parametrize("name", daily(MEAN, ("cpp",)))
def test_a_right_function_is_accepted(judge, submit, name):
    language = need(name)
    path = submit(MEAN[name], f"middle{language.suffixes[0]}")
    ended = judge("run", "--json", "middle", path)
    assert ended.status == 0, ended
    result = json.loads(ended.out)
    assert (result["verdict"], result["mode"]) == ("AC", "function")


@pytest.mark.parametrize("name", daily(MEAN, ("cpp",)))
def test_a_stub_compiles_and_is_told_as_one(judge, name):
    language = need(name)
    assert judge("start", "middle", "--language", name).status == 0
    ended = judge("run")
    assert ended.status == 1, ended
    path = Path(f"middle{language.suffixes[0]}")
    assert ended.lines[0] == f"RTE  Not written yet  {path}"
    lines = path.read_text(encoding="utf-8").splitlines()
    code = {number: each for number, each in enumerate(lines, 1) if language.comment not in each}
    line = next(number for number, each in code.items() if "middle(" in each)
    assert f"  Write the body of middle (line {line}), then save." in ended.lines
    dropped = "".join(f"{language.comment} {each}\n" for each in lines)
    path.write_text(dropped + MEAN[name], encoding="utf-8")
    assert "Not written yet" not in judge("run").out


def test_a_missing_compiler_costs_one_submission(judge, submit, monkeypatch, tmp_path):
    good = submit("def middle(a, b):\n    return (a + b) / 2\n", "good.py")
    other = submit(MEAN["go"], "other.go")
    bare = tmp_path / "bin"
    bare.mkdir()
    (bare / "dnf").write_text("#!/bin/sh\n")
    (bare / "dnf").chmod(0o755)
    monkeypatch.setenv("PATH", str(bare))
    find.toolchain.cache_clear()
    ended = judge("run", "middle", "--isolation", "limits", good, other)
    find.toolchain.cache_clear()
    assert ended.status == 3, ended
    assert "Go needs go, which is not installed; dnf install golang" in ended.out
    assert any("AC" in line and "good.py" in line for line in ended.lines), ended.out


def test_warnings_stand_beside_a_wrong_answer_alone(judge, submit):
    need("cpp")
    head = "double middle(double a, double b) {\n    int whole = (a + b) / 2;\n"
    warned = "the compiler warns: conversion from ‘double’ to ‘int’ may change value (line 2)"
    ended = judge("run", "middle", submit(f"{head}    return whole; }}", "wrong.cpp"))
    assert ended.out.startswith("WA")
    assert warned in ended.err
    assert warned in json.loads(judge("run", "middle", "wrong.cpp", "--json").out)["notes"]
    ended = judge("run", "middle", submit(f"{head}    return (a + b) / 2 + whole * 0; }}", "right.cpp"))
    assert ended.status == 0
    assert "warns" not in ended.err


OVERFLOW = """double middle(double a, double b) {{
    int most = 2147483647, some[2] = {{0, 0}};
    if (a != b) most += 1 + (int)(a == a) * 5;
    {more}
    return most;
}}
"""


@pytest.mark.parametrize("name", ["c", "cpp"])
def test_a_failing_case_is_run_once_more_with_checks(judge, submit, name):
    need(name)
    if not sanitized(name):
        pytest.skip("gcc has no library for its checks")
    bare = "bool middle(double a, double b, double *out) {" + OVERFLOW.partition("{{")[2].format(more="")
    source = (
        bare.replace("return most", "return *out = most, true") if name == "c" else OVERFLOW.format(more="")
    )
    file = submit(source, f"wrong.{name}")
    notes = json.loads(judge("run", "middle", file, "--json").out)["notes"]
    found = [each for each in notes if each.startswith("run with checks: signed integer overflow")]
    assert [each.rpartition(" ")[2] for each in found] == ["3)"]
    assert found[0] in judge("run", "middle", file).err


def test_the_library_says_what_it_is_asked_wrongly(judge, submit):
    need("cpp")
    if not sanitized("cpp"):
        pytest.skip("gcc has no library for its checks")
    source = "#include <vector>\n" + OVERFLOW.format(more="std::vector<int> v(3); most = v[(a == a) + 2];")
    notes = json.loads(judge("run", "middle", submit(source, "wrong.cpp"), "--json").out)["notes"]
    assert any(each.startswith("run with checks: vector: __n < this->size() fails") for each in notes), notes


def test_where_there_are_no_checks_nothing_is_told(judge, submit, monkeypatch, tmp_path):
    """A gcc without the library that the checks need."""
    language = need("cpp")
    folder = tmp_path / "own" / "cpp"
    shutil.copytree(language.folder, folder)
    text = (folder / "language.toml").read_text(encoding="utf-8")
    (folder / "language.toml").write_text(text.replace('"-fsanitize=undefined"', '"-ljudge-has-none"'))
    monkeypatch.setenv("JUDGE_LANGUAGES", str(folder.parent))
    languages.cache_clear()
    try:
        ended = judge("run", "middle", submit(OVERFLOW.format(more=""), "wrong.cpp"))
    finally:
        languages.cache_clear()
    assert ended.out.startswith("WA")
    assert "checks" not in ended.err


def sanitized(name):
    """Whether gcc has what its checks need."""
    language = need(name)
    tool = find.toolchain(language).filled(["{cc}" if name == "c" else "{cxx}"])[0]
    said = subprocess.run([tool, "-print-file-name=libubsan.a"], capture_output=True, text=True, check=True)
    return said.stdout.startswith("/")


# -- the race --------------------------------------------------------------------------------------------


GROWTH = Path(__file__).parents[1] / "fixtures" / "growth"
CPP = "// Mean.\ndouble middle(double a, double b) { return (a + b) / 2; }\n"
RULE = """[time]
limit = 20
function = "mean.py"
program = "program.py"

[time.references]
cpp = "reference.cpp"

[tolerance]"""


@pytest.fixture
def raced(judge, submit, tmp_path, monkeypatch):
    """Judge a file on `middle`, which has references in Python and C++; its result, and what was written."""
    need("cpp")
    shutil.copytree(PACK, tmp_path / "two")
    (tmp_path / "two" / "solutions" / "middle" / "accepted" / "reference.cpp").write_text(CPP)
    toml = tmp_path / "two" / "problems" / "middle" / "problem.toml"
    toml.write_text(toml.read_text().replace("[tolerance]", RULE, 1))
    monkeypatch.setenv("JUDGE_PROBLEMS", str(tmp_path / "two" / "problems"))

    def run(source, name):
        path = submit(source, name)
        result = json.loads(judge("run", "--json", "middle", path).out)
        Draft202012Validator(schema_of(app.get_command(None, "run"))).validate(result)
        return result, judge("run", "middle", path, "--all")

    return run


def test_it_is_raced_against_its_own_language(raced):
    result, ended = raced(CPP, "mine.cpp")
    assert result["verdict"] == "AC"
    assert result["time"]["reference"] == "C++"
    assert result["time"]["ratio"]["median"] > 0
    assert "× the C++ reference's time" in ended.out
    assert "held to" not in ended.err


QUADRATIC = """
#include <vector>
long long inversions(std::vector<long long> values) {
    long long found = 0;
    for (size_t i = 0; i < values.size(); ++i)
        for (size_t j = i + 1; j < values.size(); ++j) found += values[i] > values[j];
    return found;
}
"""


@pytest.mark.nightly
def test_the_growth_of_another_language(judge, submit, monkeypatch):
    need("cpp")
    monkeypatch.setenv("JUDGE_PROBLEMS", str(GROWTH / "problems"))
    result = json.loads(judge("run", "--json", "inversions", submit(QUADRATIC, "mine.cpp")).out)
    growth = result["time"]["growth"]
    assert result["verdict"] == "TLE", result
    assert growth["exponent"] > growth["reference"] + 0.4
    assert result["time"]["reference"] == "Python"


@pytest.mark.nightly
def test_the_solution_in_another_language_is_shown(judge, raced):
    assert judge("run", "-q", "middle", "mine.cpp").status == 2  # nothing there yet
    raced(CPP.replace("// Mean.", "// Mine."), "mine.cpp")
    ended = judge("solution", "middle", "--language", "c++")
    assert (ended.status, ended.err) == (0, "")
    assert "```cpp" in ended.out
    assert "double middle(double a, double b)" in ended.out
    assert "Also in Python." in ended.lines
    told = json.loads(judge("solution", "middle", "reference.cpp", "--json").out)
    Draft202012Validator(schema_of(app.get_command(None, "solution"))).validate(told)
    assert told["file"] == "reference.cpp"
    assert [each["language"] for each in told["approaches"]] == ["Python", "C++"]
    refused = judge("solution", "middle", "--language", "go")
    assert (refused.status, len(refused.err.splitlines())) == (2, 1)
    assert "middle has no solution in Go; there are some in Python, C++" in refused.err
