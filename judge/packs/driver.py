"""A Python function made a program: what is appended to its file, and what keeps it from a package."""

from __future__ import annotations

import ast
import symtable
import sys
from collections.abc import Collection

from judge.packs.schemas import form_of
from judge.problem import Problem
from judge.problem.solutions import tree_of

_DRIVER = """

def _judge_export_main():  # added by `judge export`: it makes a program of the function
    import json
    import re
    import sys
    from decimal import Context
    from itertools import chain

    def read(form, tokens):
        if form[0] == "tuple":
            return tuple([read(part, tokens) for part in form[1]])
        token = next(tokens)
        if form[0] == "dict":
            return dict(read(["list", ["tuple", form[1:3]]], chain([token], tokens)))
        if form[0] == "list":
            return [read(form[1], tokens) for _ in range(int(token))]
        if form[0] == "optional":
            return None if token == "none" else read(form[1], chain([token], tokens))
        return token if form[0] in ("word", "text") and token[0] != '"' else json.loads(token)

    def text(form, value):
        if isinstance(value, bool):
            return str(value).lower()
        if form[0] == "text" and not re.fullmatch('(?!")(?!none$)[!-~]+', str(value)):
            return json.dumps(str(value))
        if type(value).__name__ == "Fraction":
            return str(Context(prec=60).divide(value.numerator, value.denominator))
        return str(value)

    def written(form, value):
        if value is None:
            return ["none"]
        if form[0] == "optional":
            return written(form[1], value)
        if form[0] == "dict":
            form, value = ["list", ["tuple", form[1:3]]], value.items()
        if form[0] == "list":
            items = [written(form[1], each) for each in value]
            return [str(len(items))] + [token for item in items for token in item]
        if form[0] == "tuple":
            last = len(form[1]) - 1
            parts = [written(form[1][min(at, last)], each) for at, each in enumerate(value)]
            return [token for part in parts for token in part]
        return [text(form, value)]

    lines = sys.stdin.read().split("\\n")
    answers = []
    for line in lines[1 : int(lines[0]) + 1]:
        tokens = iter(re.findall(r'"(?:[^"\\\\]|\\\\.)*"|\\S+', line))
        given = [read(form, tokens) for form in PARAMETERS]
        answers.append(" ".join(written(ANSWER, ENTRY(*given))))
    print("\\n".join(answers))


if __name__ == "__main__":
    _judge_export_main()
"""
_NEWER = {  # names that Python has had only since 3.10, in modules or as methods
    *("pairwise", "batched", "cbrt", "exp2", "sumprod", "fma", "bit_count", "Self"),
    *("StrEnum", "TaskGroup", "ExceptionGroup"),
}


def as_program(problem: Problem, source: str) -> str:
    """The program that calls the entry function of `source` for each case that it reads."""
    parameters = [form_of(parameter.type) for parameter in problem.parameters]
    driver = _DRIVER.replace("PARAMETERS", repr(parameters)).replace("ENTRY", problem.entry)
    return source.rstrip() + "\n" + driver.replace("ANSWER", repr(form_of(problem.answer)))


def defines(source: str, entry: str) -> bool:
    """Whether a file binds the entry at its top level. Raises SyntaxError."""
    top = symtable.symtable(source, "", "exec")
    return entry in top.get_identifiers() and top.lookup(entry).is_assigned()


def why_not_alone(source: str, declared: Collection[str] = ()) -> str:
    """Why a program does not run wherever a package does: Python 3.9 or newer, its own library; or empty.

    `declared` are the names of judge.problem.declare that the package stands in for.
    """
    stood = {f"judge.problem.declare.{name}" for name in declared}
    for node in ast.walk(tree_of(source)):
        roots = {name: name.partition(".")[0] for name in _imported(node) if name not in stood}
        foreign = [name for name, root in roots.items() if root not in sys.stdlib_module_names]
        if foreign:
            return f"it imports {foreign[0]}"
        if _is_newer(node):
            return "it needs a newer Python than PyPy's 3.9"
    return ""


def _imported(node: ast.AST) -> list[str]:
    if isinstance(node, ast.Import):
        return [alias.name for alias in node.names]
    if isinstance(node, ast.ImportFrom) and node.module and not node.level:
        inner = node.module == "judge.problem.declare"
        return [f"{node.module}.{alias.name}" if inner else node.module for alias in node.names]
    return []


def _is_newer(node: ast.AST) -> bool:
    if isinstance(node, ast.Call):
        called = getattr(node.func, "id", "")
        return called == "zip" and any(keyword.arg == "strict" for keyword in node.keywords)
    name = node.attr if isinstance(node, ast.Attribute) else getattr(node, "name", "")
    return isinstance(node, ast.Match | ast.TryStar) or (
        isinstance(node, ast.Attribute | ast.alias) and name in _NEWER
    )
