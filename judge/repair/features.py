"""What a program's syntax tree has, as far as a mistake's name may speak of it.

A name that speaks of `//`, a slope, a global or a root is said only of a program that has one. What is found
is what might do it: a feature is missing only where it cannot be there. Standard library only, and no import
of judge: this file is handed to the contained process.
"""

from __future__ import annotations

import ast
import sys

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Set

LIBRARY = "library"
_KNOWN = sys.stdlib_module_names | {"numpy", "__future__"}
_POWER, _CUT, _KEPT = "**", ".3f", "seen[x]"  # signs that are no names
_OBJECTS = (ast.List, ast.Dict, ast.Set, ast.ListComp, ast.DictComp, ast.SetComp, ast.Call)  # may be changed
_WHOLE = {ast.FloorDiv, "divmod", "floordiv", "floor_divide"}
_DIVISION = {ast.Div, "Fraction", "truediv", "polyfit", "tan", "atan"}
_ROOT = {_POWER, "sqrt", "hypot", "isqrt", "dist", "norm", "pow", "cbrt", "csqrt", "roots", "abs"}
_ROUNDERS = {"int", "round", "floor", "trunc", "ceil", "rint", "astype", "quantize", "divmod"}
_C_INTS = {f"c_{name}" for name in ("int", "int32", "int64", "long", "longlong")}
_FIXED = {"int32", "int64", "uint32", "uint64", "array", "asarray", *_C_INTS}
_SHORT = {"float32", "float16", "single", "half", "struct", "c_float", "pack", "array", "ctypes", "view"}
_DECIMAL = {"Decimal", "decimal", "getcontext", "localcontext", "mpf", "mp", "mpmath", "longdouble"}

# By the name that mistakes.toml has: kinds of nodes, names and types of literals, of which one is enough.
FEATURES: Mapping[str, Set[object]] = {
    "//": _WHOLE,
    "whole": {*_WHOLE, *_ROUNDERS, *_FIXED},
    "/": _DIVISION,
    "root": _ROOT,
    "state": {ast.Global, ast.Nonlocal, ast.ClassDef, "cache", "lru_cache", "globals", _KEPT},
    "round": {*_ROUNDERS, ast.FloorDiv, _CUT, "format", "around"},
    "float32": _SHORT,
    "fixed-width": {*_FIXED, ast.BitAnd, ast.Mod},
    "decimal": _DECIMAL,
    "comparison": {ast.Compare},
    "float": {*_DIVISION, *_ROOT, "float", float},
    "print": {"print", "write"},
}


def features(text: str) -> list[str]:
    """The features of a program; what is no Python shows none: a name that speaks of one is not said.

    Of one that imports what is neither Python's nor numpy only that is known: its work lies in a library.
    """
    try:
        tree = ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return []
    nodes = list(ast.walk(tree))
    if any(name not in _KNOWN for name in _imported(nodes)):
        return [LIBRARY]
    signs = {sign for node in nodes for sign in _signs(node)}
    signs |= {_KEPT for part in tree.body if _is_outside(part)}
    return [name for name, some in FEATURES.items() if not signs.isdisjoint(some)]


def _imported(nodes: list[ast.AST]) -> Iterator[str]:
    """The top of each module that is imported."""
    for node in nodes:
        if isinstance(node, ast.Import):
            yield from (each.name.partition(".")[0] for each in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield (node.module or "").partition(".")[0]


def _signs(node: ast.AST) -> Iterator[object]:
    """Its kind, a name that is read, imported or asked of something, the type of a literal; and as no
    program has it, a power that may be a root, digits that are cut, and what may be kept for later calls.
    """
    yield type(node)
    if isinstance(node, ast.Name):
        yield node.id
    elif isinstance(node, ast.Attribute):
        yield _KEPT if isinstance(node.ctx, ast.Store) else node.attr
    elif isinstance(node, ast.alias):
        yield from node.name.split(".")
    elif isinstance(node, ast.Constant):
        yield type(node.value)
    elif isinstance(node, ast.FormattedValue) and node.format_spec:
        yield _CUT
    elif isinstance(node, ast.BinOp):
        left, right = (getattr(side, "value", None) for side in (node.left, node.right))
        if isinstance(node.op, ast.Mod) and isinstance(left, str):
            yield _CUT
        elif isinstance(node.op, ast.Pow) and not isinstance(right, int):
            yield _POWER
    elif isinstance(node, ast.arguments) and any(map(_is_object, (*node.defaults, *node.kw_defaults))):
        yield _KEPT


def _is_outside(part: ast.stmt) -> bool:
    """Whether a statement of the top level makes an object that functions may change, or a decorator may."""
    if isinstance(part, ast.FunctionDef | ast.ClassDef):
        return bool(part.decorator_list)
    made = [node.value for node in ast.walk(part) if isinstance(node, ast.Assign | ast.AnnAssign)]
    return any(map(_is_object, made))


def _is_object(value: ast.expr | None) -> bool:
    return value is not None and any(isinstance(each, _OBJECTS) for each in ast.walk(value))
