"""Reference solutions in other languages: declared, read, shown and judged."""

from __future__ import annotations

import pytest
from native import need
from referenced import HEAD, SOURCES, referenced

from judge.errors import ProblemError, UsageError
from judge.kata.model import approaches, chosen_approach
from judge.languages import find
from judge.languages.model import language_called
from judge.mistakes.makers import read_makers
from judge.problem import Verdict
from judge.problem.solutions import Kind, parted, read_solutions
from judge.run.verify import verify_problem


def test_the_table_is_read_and_no_description_of_a_language_for_it(tmp_path, monkeypatch):
    monkeypatch.setattr("judge.languages.model.languages", lambda: pytest.fail("a language was read"))
    problem = referenced(tmp_path, "cpp", "js")
    assert dict(problem.time.references) == {"cpp": "reference.cpp", "javascript": "reference.js"}
    assert dict(referenced(tmp_path / "none").time.references) == {}


def test_python_is_none_of_the_other_languages(tmp_path):
    with pytest.raises(
        ProblemError, match=r"^middle/problem.toml:.* there is no language 'python'; there are"
    ):
        referenced(tmp_path, python="mean.py")


@pytest.mark.parametrize(
    ("source", "language", "head", "rest"),
    [
        ("// A.\n//\n// B c.\n\nint x;\n", "cpp", "A.\n\nB c.", "int x;"),
        ("\ufeff\n//A\nint x; // no\n", "go", "A", "int x; // no"),
        ("int x;\n// late\n", "java", "", "int x;\n// late"),
        ("#!/usr/bin/env node\n// A\nf();", "javascript", "A", "f();"),
        ("# A\n#\n#   indented\nx = 1\n", "pypy", "A\n\n  indented", "x = 1"),
        ("", "rust", "", ""),
    ],
)
def test_the_comments_that_a_source_begins_with(source, language, head, rest):
    assert parted(source.encode(), language_called(language)) == (head, rest)


def test_solutions_in_other_languages_say_their_name(tmp_path):
    problem = referenced(tmp_path, "cpp", "go")
    folder = problem.solutions / "accepted"
    (folder / "bare.go").write_text(SOURCES["go"])
    programs, faults = read_solutions(problem)
    found = {each.path.name: each for each in programs}
    cpp = found["reference.cpp"]
    assert (cpp.name, cpp.sentence, cpp.language.id) == ("Mean", "Half of the sum.", "cpp")
    assert found["mean.py"].language is None
    assert [str(each) for each in faults] == [
        "middle/accepted/bare.go: no comment begins it; begin it with the name of its idea"
    ]


def test_mistakes_are_made_from_python_alone(tmp_path):
    problem = referenced(tmp_path)
    (problem.solutions / "wrong" / "floor.cpp").write_text("// floor-division\n")
    (problem.solutions / "wrong" / "floor-division.pypy.py").write_text("# floor-division\n")
    assert {each.file for each in read_makers(problem).all} == {"wrong/floor-division.py"}
    assert len(read_solutions(problem, Kind.WRONG).programs) == 3


def test_approaches_of_all_languages_python_first(tmp_path):
    problem = referenced(tmp_path, "java", "cpp", "go")
    (problem.solutions / "accepted" / "whole.cpp").write_text("// Whole.\nint main() {}\n")  # no function
    models = approaches(problem)
    assert [each.call for each in models] == ["mean", "reference.cpp", "reference.go", "reference.java"]
    cpp = chosen_approach(problem, models, None, "c++")
    assert (cpp.path.name, cpp.tongue, cpp.name, cpp.idea) == ("reference.cpp", "C++", "reference", "Mean")
    assert cpp.program == SOURCES["cpp"]
    assert cpp.explanation.startswith("Half of the sum.")
    assert chosen_approach(problem, models, None).path.name == "mean.py"
    assert chosen_approach(problem, models, "reference.go").tongue == "Go"
    assert chosen_approach(problem, models, "reference", "java").tongue == "Java"
    with pytest.raises(UsageError, match=r"no solution in Rust; there are some in Python, C\+\+, Go, Java"):
        chosen_approach(problem, models, None, "rust")
    with pytest.raises(UsageError, match="there is no language cobol"):
        chosen_approach(problem, models, None, "cobol")


@pytest.mark.slow
def test_verify_judges_them_or_says_that_it_did_not(tmp_path, monkeypatch):
    need("cpp")
    problem = referenced(tmp_path, "cpp")
    (problem.solutions / "wrong" / "floor-division.cpp").write_text(
        "// floor-division\n#include <cmath>\n"
        "double middle(double a, double b) { return std::floor((a + b) / 2); }\n"
    )
    report = verify_problem(problem, update_pins=True)
    assert [str(each) for each in report.faults] == []
    verdicts = {each.file: each.verdict for each in report.solutions}
    assert verdicts["accepted/reference.cpp"] is Verdict.AC
    assert verdicts["wrong/floor-division.cpp"] is Verdict.WA
    monkeypatch.setattr(find, "missing", lambda language: ["g++"] if language.id == "cpp" else [])
    monkeypatch.setattr(find, "remedy", lambda language: "apt-get install g++")
    report = verify_problem(problem, update_pins=True)
    assert report.ok, report.faults
    for each in report.solutions:
        if each.file.endswith(".cpp"):
            assert (each.verdict, each.ok) == (None, True)
            assert each.unjudged == "not judged here: no g++ (apt-get install g++)"


@pytest.mark.slow
def test_verify_finds_a_reference_that_is_missing_or_in_another_language(tmp_path):
    problem = referenced(tmp_path, "cpp", go="gone.go", java="reference.cpp", rust="mean.py")
    (problem.solutions / "accepted" / "reference.cpp").write_text(f"{HEAD}{SOURCES['cpp']}")
    said = [str(each) for each in verify_problem(problem, update_pins=True).faults]
    assert any("[time] names 'gone.go', which is no accepted solution" in each for each in said)
    assert any("names 'reference.cpp' for java, which is in C++" in each for each in said)
    assert any("names 'mean.py' for rust, which is in Python" in each for each in said)
    assert all(each.startswith("middle/problem.toml:") for each in said)
