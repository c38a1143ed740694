"""Submissions in other languages, from the stub to the verdict, as a person sees them."""

from __future__ import annotations

import json
import shutil

import pytest
from sampling import daily

from judge.languages import find
from judge.languages.model import language_called

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
        pytest.skip(f"no {language.name} here: {find.remedy(language)}")
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
def test_a_stub_compiles_and_fails_with_its_own_words(judge, name):
    language = need(name)
    assert judge("init", "middle", "--language", name).status == 0
    ended = judge("run")
    assert ended.status == 1, ended
    assert ended.lines[0].startswith(f"RTE  middle{language.suffixes[0]}")
    assert "middle is still to be written" in ended.out


def test_a_wrong_function_is_shrunk_and_replayed(judge, submit):
    need("cpp")
    path = submit(
        "#include <cmath>\ndouble middle(double a, double b) { return std::floor((a + b) / 2); }", "m.cpp"
    )
    ended = judge("run", "middle", path)
    assert ended.status == 1
    assert "smallest case found" in ended.out
    again = next(line for line in ended.lines if "judge replay" in line).partition("judge replay ")[2]
    assert "WA" in judge("replay", *again.split()).out


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


@pytest.mark.nightly
def test_doctor_tries_languages_where_it_is_asked_to(judge, monkeypatch, tmp_path):
    need("c")
    for name in ("gcc", "bwrap"):
        if found := shutil.which(name):
            (tmp_path / name).symlink_to(found)
    (tmp_path / "g++").write_text("#!/bin/sh\n[ $1 = --version ] && echo g++ 0.1\n")
    (tmp_path / "apt-get").write_text("#!/bin/sh\n")
    for name in ("g++", "apt-get"):
        (tmp_path / name).chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path))
    find.toolchain.cache_clear()
    untried = {each["name"]: each["works"] for each in json.loads(judge("doctor", "--json").out)["languages"]}
    found = {
        each["name"]: each for each in json.loads(judge("doctor", "--json", "--languages").out)["languages"]
    }
    shown = judge("doctor", "--languages")
    find.toolchain.cache_clear()
    assert set(untried.values()) == {None}
    assert (found["C"]["works"], found["C"]["why_not"], found["C"]["remedy"]) == (True, None, None)
    assert found["C++"]["works"] is False
    assert found["C++"]["why_not"].startswith("the empty C++ program fails: ")
    assert found["C++"]["remedy"] == "repair it, or apt-get install g++"
    assert (found["Go"]["works"], found["Go"]["missing"]) == (None, "go")
    assert any(line.startswith("C  ") and ", works at " in line for line in shown.lines)
    place = next(i for i, line in enumerate(shown.lines) if line.startswith("C++ "))
    assert "fails     the empty C++ program fails" in shown.lines[place + 1]
    assert "remedy    repair it, or apt-get install g++" in shown.out
