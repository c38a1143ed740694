"""What a newcomer may count on in every file of the package: its length, and what its functions ask for."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

import judge

PACKAGE = Path(judge.__file__).parent
FILES = {
    path.relative_to(PACKAGE).as_posix(): ast.parse(path.read_text(encoding="utf-8"))
    for path in PACKAGE.rglob("*.py")
    if path.relative_to(PACKAGE).parts[0] not in {"problems", "solutions"}
}
MOST_LINES = 400
MOST_PARAMETERS = 6


def required(function: ast.FunctionDef | ast.AsyncFunctionDef) -> list[str]:
    """The parameters that every caller has to give."""
    given = function.args
    plain = [*given.posonlyargs, *given.args]
    plain = plain[: len(plain) - len(given.defaults)]
    named = [each for each, value in zip(given.kwonlyargs, given.kw_defaults, strict=True) if value is None]
    return [each.arg for each in (*plain, *named) if each.arg not in ("self", "cls")]


def is_command(function: ast.FunctionDef | ast.AsyncFunctionDef) -> bool:
    """Whether it is called by the command line alone, which has a parameter for each option."""
    return any("click" in ast.unparse(each) for each in function.decorator_list)


def functions(tree: ast.AST):
    return [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)]


def test_no_file_is_long():
    assert len(FILES) > 200
    lengths = {name: len((PACKAGE / name).read_text(encoding="utf-8").splitlines()) for name in FILES}
    assert {name: length for name, length in lengths.items() if length > MOST_LINES} == {}


def test_no_function_asks_for_much():
    asked = {
        f"{name}:{each.name}": required(each)
        for name, tree in FILES.items()
        for each in functions(tree)
        if not is_command(each)
    }
    assert len(asked) > 1000
    assert {name: given for name, given in asked.items() if len(given) > MOST_PARAMETERS} == {}


@pytest.mark.parametrize(("kind", "most"), [("Mode", 2)])
def test_few_places_ask_which_kind_it_is(kind, most):
    asked = [
        f"{name}:{node.lineno}"
        for name, tree in FILES.items()
        for node in ast.walk(tree)
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id == kind
    ]
    assert 0 < len(asked) <= most, asked


def test_nobody_prints_but_who_talks_to_a_person():
    """Nor what runs in a container, where standard output is the submission's."""
    prints = {
        name
        for name, tree in FILES.items()
        for node in ast.walk(tree)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "print"
    }
    assert {name for name in prints if name.split("/")[0] not in {"cli", "report"}} == set()


def public_kinds(tree: ast.Module):
    """The classes and the names of types that a module makes."""
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            yield node.name
        elif isinstance(node, ast.Assign):
            yield from (each.id for each in node.targets if isinstance(each, ast.Name))


WORDS = [
    *(
        "Figure",
        "Given",
        "Target",
        "Parameter",
        "Exact",
        "Measure",
        "Budget",
        "Limits",
        "Level",
        "Box",
        "Mark",
    ),
    *("Place", "Job", "Terms", "Result"),
]


@pytest.mark.parametrize("name", WORDS)
def test_a_name_stands_for_one_thing(name):
    makers = [file for file, tree in FILES.items() if name in public_kinds(tree)]
    assert len(makers) == 1
