"""How many modules of the judge stand on one another: what somebody who reads the top one has to know of."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import judge

PACKAGE = Path(judge.__file__).parent
MOST = 18


def named(path: Path) -> str:
    """A file's module."""
    parts = path.relative_to(PACKAGE.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


FILES = {named(path): path for path in PACKAGE.rglob("*.py")}


def at_top(node: ast.AST) -> Iterator[ast.AST]:
    """What stands outside functions, also under `if TYPE_CHECKING`: a reader follows that too."""
    for child in ast.iter_child_nodes(node):
        if not isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef):
            yield child
            yield from at_top(child)


def imported(name: str) -> set[str]:
    """The modules of the judge that a module imports when it is imported, with the packages they lie in."""
    found = set()
    for node in at_top(ast.parse(FILES[name].read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module:
            found |= {node.module, *(f"{node.module}.{alias.name}" for alias in node.names)}
    own = {".".join(name.split(".")[:end]) for end in range(1, name.count(".") + 1)}
    packages = {module[:end] for module in found for end in range(len(module)) if module[end] == "."}
    return {module for module in found | (packages - own) if module in FILES} - {name}


GRAPH = {name: imported(name) for name in FILES}


@cache
def reached(name: str) -> frozenset[str]:
    """Every module that a module leads to."""
    seen: set[str] = set()
    waiting = [name]
    while waiting:
        for module in GRAPH[waiting.pop()] - seen:
            seen.add(module)
            waiting.append(module)
    return frozenset(seen)


@cache
def chain(name: str) -> tuple[str, ...]:
    """The longest chain of imports from a module on; modules that import one another count as one."""
    ring = {module for module in reached(name) if name in reached(module)} | {name}
    below = {module for each in ring for module in GRAPH[each]} - ring
    return (name, *max((chain(module) for module in below), key=len, default=()))


def test_no_chain_of_imports_is_long():
    longest = max(map(chain, FILES), key=len)
    assert len(longest) > 5  # or nothing was read
    assert len(longest) <= MOST, " → ".join(longest)
