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
    from collections.abc import Callable, Iterator, Mapping

_ROUNDERS = frozenset({"int", "round", "floor", "trunc", "ceil", "rint", "astype", "quantize", "divmod"})
_ROOTS = frozenset({"sqrt", "hypot", "isqrt", "dist", "norm", "pow", "cbrt", "csqrt"})
_STATE = (ast.Global, ast.Nonlocal, ast.ClassDef)
_KEEPERS = frozenset(
    {"cache", "lru_cache", "setdefault", "append", "update", "add", "extend", "insert", "pop"}
)
_SHORT = frozenset(
    {"float32", "float16", "single", "half", "struct", "c_float", "pack", "array", "ctypes", "view"}
)
_FIXED = frozenset(
    {
        "int32",
        "int64",
        "uint32",
        "uint64",
        "c_int",
        "c_int32",
        "c_int64",
        "c_long",
        "c_longlong",
        "array",
        "asarray",
    }
)
_DECIMAL = frozenset(
    {"Decimal", "decimal", "getcontext", "localcontext", "mpf", "mp", "mpmath", "longdouble"}
)
LIBRARY = "library"
_KNOWN = sys.stdlib_module_names | {"numpy", "__future__"}
_MOST_VISITS = 20  # of a node, for the functions that it is in
_SLICED = (ast.Subscript, ast.Attribute)


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
    names = frozenset(_named_by(nodes))
    return [name for name, has in FEATURES.items() if has(nodes, names)]


def _imported(nodes: list[ast.AST]) -> Iterator[str]:
    """The top of each module that is imported."""
    for node in nodes:
        if isinstance(node, ast.Import):
            yield from (each.name.partition(".")[0] for each in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield (node.module or "").partition(".")[0]


def _named_by(nodes: list[ast.AST]) -> Iterator[str]:
    """Every name that is read, imported or asked of something."""
    for node in nodes:
        if isinstance(node, ast.Name):
            yield node.id
        elif isinstance(node, ast.Attribute):
            yield node.attr
        elif isinstance(node, ast.alias):
            yield from node.name.split(".")


def _has_operator(nodes: list[ast.AST], *kinds: type[ast.operator]) -> bool:
    return any(isinstance(node, ast.BinOp | ast.AugAssign) and isinstance(node.op, kinds) for node in nodes)


def _whole_division(nodes: list[ast.AST], names: frozenset[str]) -> bool:
    return _has_operator(nodes, ast.FloorDiv) or bool(names & {"divmod", "floordiv", "floor_divide"})


def _division(nodes: list[ast.AST], names: frozenset[str]) -> bool:
    return _has_operator(nodes, ast.Div) or bool(names & {"Fraction", "truediv", "polyfit", "tan", "atan"})


def _root(nodes: list[ast.AST], names: frozenset[str]) -> bool:
    fractions = any(
        isinstance(node, ast.BinOp)
        and isinstance(node.op, ast.Pow)
        and not (isinstance(node.right, ast.Constant) and isinstance(node.right.value, int))
        for node in nodes
    )
    return fractions or bool(names & (_ROOTS | {"roots", "abs"}))


def _state(nodes: list[ast.AST], names: frozenset[str]) -> bool:
    """A global, a default or a name outside that a function changes, an attribute of a function."""
    if any(isinstance(node, _STATE) for node in nodes) or names & {"cache", "lru_cache", "globals"}:
        return True
    left = _MOST_VISITS * len(nodes)
    for function in (node for node in nodes if isinstance(node, ast.FunctionDef | ast.Lambda)):
        arguments = function.args
        defaults = [*arguments.defaults, *(each for each in arguments.kw_defaults if each)]
        if any(isinstance(each, ast.List | ast.Dict | ast.Set | ast.Call) for each in defaults):
            return True
        own = {each.arg for each in (*arguments.posonlyargs, *arguments.args, *arguments.kwonlyargs)}
        inside = list(ast.walk(function))
        left -= len(inside)
        if left < 0:  # functions in functions, deeper than anybody writes: it may be there
            return True
        own |= {each.id for each in inside if isinstance(each, ast.Name) and isinstance(each.ctx, ast.Store)}
        if any(_changes_what_is_outside(each, own) for each in inside):
            return True
    return False


def _changes_what_is_outside(node: ast.AST, own: set[str]) -> bool:
    if isinstance(node, _SLICED) and isinstance(node.ctx, ast.Store | ast.Del):
        return isinstance(node.value, ast.Name) and node.value.id not in own
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr in _KEEPERS:
        return isinstance(node.func.value, ast.Name) and node.func.value.id not in own
    return False


def _formatting(nodes: list[ast.AST], names: frozenset[str]) -> bool:
    """A number turned into text and back, or rounded to digits."""
    if names & {"round", "quantize", "format", "rint", "around"} or _has_operator(nodes, ast.FloorDiv):
        return True
    return any(isinstance(node, ast.FormattedValue) and node.format_spec for node in nodes) or any(
        isinstance(node, ast.BinOp)
        and isinstance(node.op, ast.Mod)
        and isinstance(node.left, ast.Constant)
        and isinstance(node.left.value, str)
        for node in nodes
    )


def _strict(nodes: list[ast.AST], _names: frozenset[str]) -> bool:
    return any(isinstance(node, ast.Compare) for node in nodes)


FEATURES: Mapping[str, Callable[[list[ast.AST], frozenset[str]], bool]] = {
    "//": _whole_division,
    "whole": lambda nodes, names: (
        _whole_division(nodes, names) or bool(names & _ROUNDERS) or bool(names & _FIXED)
    ),
    "/": _division,
    "root": _root,
    "state": _state,
    "round": lambda nodes, names: _formatting(nodes, names) or bool(names & _ROUNDERS),
    "float32": lambda _nodes, names: bool(names & _SHORT),
    "fixed-width": lambda nodes, names: bool(names & _FIXED) or _has_operator(nodes, ast.BitAnd, ast.Mod),
    "decimal": lambda _nodes, names: bool(names & _DECIMAL),
    "comparison": _strict,
    "float": lambda nodes, names: (
        _division(nodes, names)
        or _root(nodes, names)
        or "float" in names
        or any(isinstance(node, ast.Constant) and isinstance(node.value, float) for node in nodes)
    ),
    "print": lambda _nodes, names: "print" in names or "write" in names,
}  # by the name that mistakes.toml has
