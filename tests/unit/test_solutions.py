"""The one reader of a problem's solutions, in all languages: what is a program, what is said of the rest."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from judge.errors import ProblemError
from judge.languages import find
from judge.problem.load import load_problem
from judge.problem.solutions import read_solutions
from judge.verify.gate import Options, verify_problem

PACK = Path(__file__).parents[1] / "fixtures" / "pack"

TOLD = '''"""floor-division.

Both halves are cut off. Use `/`.

    - one
    - two
"""
'''


@pytest.fixture
def problem(tmp_path):
    """A problem without solutions."""
    shutil.copytree(PACK / "problems" / "middle", tmp_path / "problems" / "middle")
    return load_problem(tmp_path / "problems" / "middle")


@pytest.fixture
def add(problem):
    """Write a file of its solutions."""

    def write(name, content=TOLD):
        path = problem.solutions / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    return write


def test_what_a_program_tells_of_itself(problem, add):
    add("wrong/floor-division.py")
    (program,) = read_solutions(problem).programs
    assert (program.name, program.usual) == ("floor-division", True)
    assert program.text == "Both halves are cut off. Use `/`.\n\n    - one\n    - two"
    assert program.advice == "Both halves are cut off. Use `/`. - one - two"
    assert program.sentence == "Both halves are cut off."
    assert program.source == TOLD.encode()


def test_what_is_hidden_is_passed_over(problem, add):
    for name in (".#fast.py", "._fast.py", ".DS_Store", "__pycache__/fast.pyc", "__init__.py"):
        add(f"accepted/{name}", b"\x00")
    (problem.solutions / ".git").mkdir()
    assert read_solutions(problem) == ((), ())


def test_a_link_to_nothing_and_a_folder_that_is_a_file_are_told(problem, add):
    add("accepted", "")
    add("wrong/fine.py")
    (problem.solutions / "wrong" / "gone.py").symlink_to("nowhere.py")
    programs, faults = read_solutions(problem)
    assert [program.file for program in programs] == ["wrong/fine.py"]
    assert [str(fault).partition(": ")[0] for fault in faults] == ["middle/accepted", "middle/wrong/gone.py"]
    assert all("cannot be read: " in str(fault) for fault in faults)


# -- in other languages --------------------------------------------------------------------------------------

SOURCES = {
    "cpp": "double middle(double a, double b) { return (a + b) / 2; }",
    "go": "package main\n\nfunc middle(a, b float64) (float64, bool) { return (a + b) / 2, true }",
    "java": "class Solution { static double middle(double a, double b) { return (a + b) / 2; } }",
}
HEAD = "// Mean.\n//\n// Half of the sum. It does not overflow here.\n"


def referenced(folder, *suffixes, limit=50, **more):
    """The problem; `more` are entries of `[time.references]` beside those of these suffixes."""
    shutil.copytree(PACK, folder, dirs_exist_ok=True)
    toml = folder / "problems" / "middle" / "problem.toml"
    names = {each: f"reference.{each}" for each in suffixes} | more
    rule = [f'[time]\nlimit = {limit}\nfunction = "mean.py"\nprogram = "program.py"\n']
    if names:
        rule += ["[time.references]", *(f'{key} = "{name}"' for key, name in names.items()), ""]
    toml.write_text(toml.read_text().replace("[tolerance]", "\n".join([*rule, "[tolerance]"]), 1))
    for each in suffixes:
        path = folder / "solutions" / "middle" / "accepted" / f"reference.{each}"
        path.write_text(f"{HEAD}{SOURCES[each]}\n")
    return load_problem(folder / "problems" / "middle")


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ({"python": "mean.py"}, "there is no language 'python'; there are c, cpp, go"),
        (
            {"go": "../a.go"},
            "time.references = {'go': '../a.go'}; use the name of a file of the accepted solutions",
        ),
    ],
)
def test_what_the_table_may_not_say_is_one_line(tmp_path, more, said):
    with pytest.raises(ProblemError, match=r"^middle/problem.toml:\d+: [^\n]*$") as raised:
        referenced(tmp_path, **more)
    assert said in str(raised.value)


@pytest.mark.slow
def test_verify_says_what_it_did_not_judge(tmp_path, monkeypatch):
    problem = referenced(tmp_path, "cpp")
    (problem.solutions / "wrong" / "floor-division.cpp").write_text(
        "// floor-division\ndouble middle(double a, double b) { return a; }\n"
    )
    monkeypatch.setattr(find, "missing", lambda language: ["g++"] if language.id == "cpp" else [])
    report = verify_problem(problem, Options(pin=True))
    assert not report.faults
    for each in report.solutions:
        if each.file.endswith(".cpp"):
            assert (each.verdict, each.ok) == (None, True)
            assert each.unjudged.startswith("not judged here: no g++")
