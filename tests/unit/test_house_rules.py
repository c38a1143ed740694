"""What a newcomer may count on in every file of the package: its length, what it asks for and knows of."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
import tokenize
import tomllib
from collections import Counter
from graphlib import TopologicalSorter
from pathlib import Path

import pytest

import judge

PACKAGE = Path(judge.__file__).parent
FILES = {
    path.relative_to(PACKAGE).as_posix(): ast.parse(path.read_text(encoding="utf-8"))
    for path in PACKAGE.rglob("*.py")
    if not {"problems", "solutions"} & set(path.relative_to(PACKAGE).parts)
}
TOPIC = re.compile(
    r"(?<![a-z])(circles?|rays?|tangents?|tangency|tangencies|segments?)(?![a-z])(?!-line)", re.IGNORECASE
)
MOST_LINES = 400
MOST_PARAMETERS = 6
# A room knows only those that stand after it.
ROOMS = [
    *(
        "cli",
        "site",
        "batch",
        "judging",
        "report",
        "practice",
        "geometry",
        "packs",
        "holes",
        "verify",
        "mistakes",
        "repair",
        "diagnose",
    ),
    *("run", "data", "problem", "drawing", "manual", "languages", "values", "exact", "database"),
    *("cache", "files", "published", "errors"),
]


def nodes(tree: ast.AST, *kinds: type) -> list:
    return [node for node in ast.walk(tree) if isinstance(node, kinds)]


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


def test_no_file_is_long():
    assert len(FILES) > 200
    lengths = {name: len((PACKAGE / name).read_text(encoding="utf-8").splitlines()) for name in FILES}
    assert {name: length for name, length in lengths.items() if length > MOST_LINES} == {}


def test_no_function_asks_for_much():
    asked = {
        f"{name}:{each.name}": required(each)
        for name, tree in FILES.items()
        for each in nodes(tree, ast.FunctionDef, ast.AsyncFunctionDef)
        if not is_command(each)
    }
    assert len(asked) > 1000
    assert {name: given for name, given in asked.items() if len(given) > MOST_PARAMETERS} == {}


def modules(found: list[ast.AST]) -> set[str]:
    """What import statements may name: modules, and what may be a name in one."""
    names = {alias.name for node in found if isinstance(node, ast.Import) for alias in node.names}
    for node in found:
        if isinstance(node, ast.ImportFrom) and node.module:
            names |= {node.module, *(f"{node.module}.{alias.name}" for alias in node.names)}
    return names


def rooms(name: str) -> set[str]:
    """The rooms of the package that a file imports from, wherever in it."""
    return {each.split(".")[1] for each in modules(nodes(FILES[name], ast.AST)) if each.startswith("judge.")}


def inside(room: str) -> list[str]:
    return [name for name in FILES if name == f"{room}.py" or name.startswith(f"{room}/")]


@pytest.mark.parametrize("room", ROOMS)
def test_a_room_knows_only_those_below_it(room):
    above = set(ROOMS[: ROOMS.index(room)])
    found = {name: rooms(name) & above for name in inside(room)}
    assert found
    assert {name: known for name, known in found.items() if known} == {}


def dotted(name: str) -> str:
    return ".".join(("judge", *Path(name).with_suffix("").parts)).removesuffix(".__init__")


def for_types(tree: ast.AST) -> set[ast.AST]:
    """What a type checker alone imports."""
    guarded = [each for each in nodes(tree, ast.If) if ast.unparse(each.test) == "TYPE_CHECKING"]
    return {inner for each in guarded for node in each.body for inner in ast.walk(node)}


def test_no_modules_import_each_other():
    """Not even within functions; a circle is the error's second argument."""
    known = {dotted(name): tree for name, tree in FILES.items()}
    graph = {}
    for name, tree in known.items():
        found = modules(list(set(ast.walk(tree)) - for_types(tree))) & known.keys()
        graph[name] = {each for each in found if not any(other.startswith(f"{each}.") for other in found)}
    assert sum(map(len, graph.values())) > 1000
    TopologicalSorter({name: found - {name} for name, found in graph.items()}).prepare()


def test_a_public_name_is_one_class():
    """A package's validators stand beside it, and speak of the same things."""
    names = [
        each.name
        for name, tree in FILES.items()
        if not name.startswith("packs/validators/")
        for each in tree.body
        if isinstance(each, ast.ClassDef) and not each.name.startswith("_")
    ]
    assert [name for name, count in Counter(names).items() if count > 1] == []


def test_the_sandbox_knows_nothing_of_the_judge_but_its_errors():
    assert set().union(*map(rooms, inside("sandbox"))) & {*ROOMS, "schema"} == {"errors"}


def test_the_sandbox_imports_the_standard_library_alone():
    found = [each for name in inside("sandbox") for each in modules(nodes(FILES[name], ast.AST))]
    assert {each.split(".")[0] for each in found} - sys.stdlib_module_names <= {"judge"}


def test_only_problems_import_geometry():
    others = [name for name in FILES if name.split("/")[0] != "geometry"]
    assert {name for name in others if "geometry" in rooms(name)} == set()
    assert "geometry" in rooms("geometry/line.py")


def test_every_room_has_its_place():
    packages = {path.name for path in PACKAGE.iterdir() if (path / "__init__.py").exists()}
    assert packages <= {*ROOMS, "sandbox", "schema"}


def test_the_engine_has_no_word_of_its_topic():
    """SVG's own element apart, and what the package itself is called."""
    rooms = (
        "values",
        "exact",
        "data",
        "problem",
        "run",
        "judging",
        "diagnose",
        "repair",
        "mistakes",
        "holes",
        "verify",
    )
    told = {
        f"{path.relative_to(PACKAGE)}:{number}": row
        for room in rooms
        for path in (PACKAGE / room).rglob("*.py")
        for number, row in enumerate(path.read_text(encoding="utf-8").splitlines(), 1)
        if TOPIC.search(row)
    }
    assert told == {}


PURE = (
    *("exact", "values", "problem", "data", "geometry", "drawing", "diagnose", "repair", "mistakes"),
    "run",
)
PLATFORM = (
    *(
        "_posixsubprocess",
        "_ctypes",
        "_socket",
        "ctypes",
        "fcntl",
        "hypothesis",
        "mmap",
        "multiprocessing",
        "resource",
    ),
    *("signal", "socket", "sqlite3", "subprocess"),
)


def test_what_judges_needs_nothing_of_the_platform_before_a_box_is_opened():
    """In a browser's tab there are no processes, sockets and databases; Hypothesis is for a search alone."""
    modules = [
        f"judge.{name.removesuffix('.py').removesuffix('/__init__').replace('/', '.')}"
        for name in FILES
        if name.split("/")[0] in PURE
    ] + ["judge.report.tell", "judge.judging.session", "judge.judging.inprocess", "judge.site.tab"]
    script = (
        "import sys, importlib\n"
        f"for name in {PLATFORM!r}: sys.modules[name] = None\n"
        f"for name in {modules!r}: importlib.import_module(name)\n"
        "print('imported')"
    )
    ended = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=120)
    assert (ended.stdout, ended.stderr) == ("imported\n", "")


BUDGETS = tomllib.loads((PACKAGE.parent / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["judge"][
    "tokens"
]
NO_CODE = {
    *(tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT),
    tokenize.ENDMARKER,
}


def code_of(name: str) -> list[tokenize.TokenInfo]:
    """The tokens of a file, an f-string as one: since Python 3.12 it has parts."""
    found, inside = [], 0
    with (PACKAGE / name).open("rb") as file:
        for token in tokenize.tokenize(file.readline):
            if not inside:
                found.append(token)
            kind = tokenize.tok_name[token.type]
            inside += (kind == "FSTRING_START") - (kind == "FSTRING_END")
    return found


def tokens_of(name: str) -> int:
    """The tokens of a file's code."""
    told = {
        line
        for node in nodes(FILES[name], ast.Module, ast.ClassDef, ast.FunctionDef)
        if ast.get_docstring(node) is not None
        for line in range(node.body[0].lineno, node.body[0].end_lineno + 1)
    }
    return sum(
        token.type not in NO_CODE and not (token.type == tokenize.STRING and token.start[0] in told)
        for token in code_of(name)
    )


@pytest.mark.parametrize("room", BUDGETS)
def test_a_room_keeps_to_its_budget(room):
    used = sum(tokens_of(name) for name in FILES if name.startswith(f"{room}/"))
    assert 0.8 * BUDGETS[room] < used <= BUDGETS[room]
