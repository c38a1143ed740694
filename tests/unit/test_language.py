"""What a program's file is called is fixed in one place."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

import judge
from judge import languages as language

PACKAGE = Path(judge.__file__).parent
EXAMPLES = "cli/table.py"  # of commands, each with a file as a person has it
OWN = {  # the judge's own code and the problems' are Python whatever submissions are
    "cli/commands/hack.py": {"its solutions/ folder, with mistakes.py or wrong/, is not here"},
    "cli/classroom.py": {"it holds STUDENT/PROBLEM.py or PROBLEM/STUDENT.py; see 'judge help class'"},
    "data/cache.py": {"*.py", ".py"},
    "languages/draft.py": {".py"},
    "languages/drivers/pypy.py": {"judge_driver.pypy"},
    "mistakes/contained.py": {"mistakes.py"},
    "mistakes/verified.py": {"/mistakes.py", "mistake.py"},
    "packs/export/package.py": {
        *("input_validators/validate.py", "input_validator.py", "output_validator.py", "validate.py"),
    },
    "packs/foreign/programs.py": {"main.py", ".py2", ".py3"},
    "problem/solutions.py": {"mistakes.py"},
    "report/verified.py": {" of mistakes.py judged"},
    "sandbox/bundle.py": {".py"},
    "sandbox/inside/unseen.py": {"sandbox/boundary.py"},
    "sandbox/probe.py": {"look.py"},
    "values/grammar.py": {"[a-z]*.py", ".py"},
}


def texts(path: Path) -> set[str]:
    """The strings of a file that name a Python file, docstrings left out."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    told = {
        id(node.body[0].value)
        for node in ast.walk(tree)
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef)
        and node.body
        and isinstance(node.body[0], ast.Expr)
    }
    found = [node for node in ast.walk(tree) if isinstance(node, ast.Constant) and id(node) not in told]
    words = {node.value for node in found if isinstance(node.value, str)}
    return {word for word in words if ".py" in word.replace("problem.py", "") or word == "py"}


def test_no_other_file_knows_the_suffix():
    found = {path.relative_to(PACKAGE).as_posix(): texts(path) for path in PACKAGE.rglob("*.py")}
    assert found.pop("languages/__init__.py") == {".py"}
    assert found.pop(EXAMPLES)
    assert {name: words for name, words in found.items() if words} == OWN


@pytest.mark.parametrize(
    ("name", "wanted"),
    [
        ("a.py", True),
        ("../a.py", True),
        ("a.pyc", False),
        ("a.PY", False),
        (".py", False),
        (".#a.py", False),
        ("py", False),
    ],
)
def test_which_files_are_programs(name, wanted):
    assert language.is_program(name) is wanted


def test_the_name_of_a_program_is_made_of_a_stem():
    assert language.file_name("mine") == "mine.py"
