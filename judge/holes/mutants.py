"""Mutants of a program: its text with one expression or statement replaced, so that the change is one line.

    for mutant in mutants(source): mutant.kind, mutant.line, mutant.was, mutant.becomes, mutant.source

A ladder is one tolerance with other values from the greatest down: where a value is accepted, smaller ones
most often are, and need not be asked.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import partial
from itertools import accumulate, chain, combinations, pairwise
from random import Random
from typing import Any, NamedTuple

from msgspec import Struct

_OTHERS = {  # what an operator becomes
    "Lt": "LtE Gt", "LtE": "Lt GtE", "Gt": "GtE Lt", "GtE": "Gt LtE", "Eq": "NotEq LtE GtE",
    "NotEq": "Eq Lt Gt", "Is": "IsNot", "IsNot": "Is", "In": "NotIn", "NotIn": "In", "Add": "Sub",
    "Sub": "Add", "Mult": "Div Add", "Div": "Mult FloorDiv", "FloorDiv": "Div Mult", "Mod": "FloorDiv",
    "Pow": "Mult", "LShift": "RShift", "RShift": "LShift",
}  # fmt: skip
_CALLED = {
    "min": "max", "max": "min", "floor": "ceil", "ceil": "floor", "sorted": "list", "any": "all", "all": "any"
}  # fmt: skip
_SIZES = ("max", "min", "hypot")
_RUNGS = tuple(float(f"{m}e-{k}") for k in range(2, 17) for m in ("5", "3", "2", "1.5", "1.2", "1"))
_PARTS = (1e-4, 1e-6, 1e-8, 1e-9, 1e-10, 1e-12, 1e-14, 1e-16)  # what is smaller is taken for 0, or for equal
_LEAST = (1e-9, 1e-12, 1e-15, 1e-20, 1e-30)
_LONGEST = 16  # characters of a text that is no message
_SMALL = 1e-4  # a constant below it is a tolerance
_LARGE = 100  # an int above it may say how fine something is
_MOST_NAMES = 500  # mutants that take another name
_NAME = "another name"
_SIZE = "size of another quantity"
_ORDERED: dict[type[ast.cmpop], str] = {ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">="}
_EQUAL: dict[type[ast.cmpop], str] = {ast.Eq: "<=", ast.NotEq: ">"}


class Mutant(Struct, frozen=True):
    """A changed program, and the line before and after; `ladder` is what it is a rung of.

    Where the program is as it was and its numbers are others, `numbers` says which.
    """

    kind: str
    line: int
    was: str
    becomes: str
    source: str
    ladder: str = ""
    numbers: tuple[str, int] = ("", 0)


class _Change(NamedTuple):
    """A node, and the text in its place; of what in this place it is a rung, if it is one."""

    node: ast.expr | ast.stmt
    kind: str
    text: str
    ladder: str = ""


def mutants(source: str, seed: int = 0) -> Iterator[Mutant]:
    """All of them, no two alike; of those with another name a sample. Raises SyntaxError."""
    tree = ast.parse(source)
    outer = _Scope(tree, {})
    functions = [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)]
    scopes = [outer, *(_Scope(node, outer.tolerances) for node in functions)]
    changes = [each for scope in scopes for node in scope.nodes for each in scope.changes(node)]
    swaps, seen = [each for each in changes if each.kind == _NAME], set()
    Random(seed).shuffle(swaps)
    for each in chain((each for each in changes if each.kind != _NAME), swaps[:_MOST_NAMES]):
        node, made = each.node, ast.parse(each.text)
        key = node.lineno, node.col_offset, node.end_lineno, node.end_col_offset, ast.dump(made)
        if key not in seen and ast.unparse(made) != ast.unparse(node):
            seen.add(key)
            yield _mutant(source, each)


def _mutant(source: str, change: _Change) -> Mutant:
    """The source where the text stands for the node."""
    node, text = change.node, change.text
    first, last = node.lineno - 1, node.end_lineno or node.lineno
    whole = source.encode()
    starts = [0, *accumulate(map(len, whole.splitlines(keepends=True)))]
    at, end = starts[first] + node.col_offset, starts[last - 1] + (node.end_col_offset or 0)
    changed = (whole[:at] + text.encode() + whole[end:]).decode()
    ends = (source, last), (changed, first + 1 + text.count("\n"))
    was, becomes = ("\n".join(each.splitlines()[first:end]).strip() for each, end in ends)
    ladder = change.ladder and f"{node.lineno}:{node.col_offset} {change.ladder}"
    return Mutant(change.kind, node.lineno, was, becomes, changed, ladder)


class _Scope:
    """A function, or what stands outside of all: its nodes, names and tolerances."""

    def __init__(self, root: ast.Module | ast.FunctionDef, outer: dict[str, float]) -> None:
        self.nodes: list[ast.expr | ast.stmt] = []
        self._parents: dict[ast.AST, ast.AST] = {}
        for child in root.body:
            self._collect(child, root)
        stored = {n.id for n in self.nodes if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)}
        given = {each.arg for each in root.args.args} if isinstance(root, ast.FunctionDef) else set()
        self._names = sorted(stored | given)
        self._values = [f"abs({name}{item})" for name in self._names for item in ("", "[0]", "[1]")]
        self.tolerances = outer | {
            target.id: small
            for node in self.nodes
            if isinstance(node, ast.Assign) and (small := _small(node.value))
            for target in node.targets
            if isinstance(target, ast.Name)
        }

    def _collect(self, node: ast.AST, parent: ast.AST) -> None:
        self._parents[node] = parent
        if isinstance(node, ast.expr | ast.stmt) and not isinstance(node, ast.FunctionDef | ast.ClassDef):
            self.nodes.append(node)
        # A function is a scope of its own; what stands in a text has no place of its own; nobody evaluates
        # an annotation.
        if isinstance(node, ast.FunctionDef | ast.JoinedStr):
            return
        note = getattr(node, "annotation", None)
        for child in ast.iter_child_nodes(node):
            if child is not note:
                self._collect(child, node)

    def changes(self, node: ast.expr | ast.stmt) -> Iterator[_Change]:
        """The changes of a statement, or of an expression that is read."""
        put, parent = partial(_Change, node), self._parents[node]
        if not isinstance(getattr(node, "ctx", ast.Load()), ast.Load):
            return
        match node:
            case ast.Expr(value=ast.Constant()):
                return
            case ast.Assign() | ast.AugAssign() | ast.Expr() | ast.Raise():
                yield put("dropped statement", "pass")
                yield from _straightened(node)
            case ast.If(test=test) | ast.While(test=test):
                yield from (_Change(test, "condition fixed", text) for text in ("False", "True"))
            case ast.Return(value=ast.expr()):
                yield put("return None", "return None")
            case ast.Constant(value=str() as value):
                if not isinstance(parent, ast.Expr) and len(value) <= _LONGEST:
                    yield from (put("text", repr(other)) for other in (value[1:], value[:-1], ""))
            case ast.Constant(value=int() | float() as value) if not isinstance(value, bool):
                yield from _constant(node, value, isinstance(parent, ast.Subscript) and parent.slice is node)
            case ast.Name(id=name):
                if name in self._names and not (isinstance(parent, ast.Call) and parent.func is node):
                    yield from (put(_NAME, other) for other in self._names if other != name)
                if small := self.tolerances.get(name):  # this use of it alone
                    forms = (f"({rung / small:.6g} * {name})" for rung in _RUNGS)
                    yield from (put("tolerance", form, "of a name") for form in forms)
                    yield from (put(_SIZE, f"({small!r} * {other})") for other in self._values)
            case ast.Compare():
                yield from _compared(node)
            case ast.BoolOp(op=op, values=values):
                other = ast.Or() if isinstance(op, ast.And) else ast.And()
                yield put("and/or", f"({ast.unparse(ast.BoolOp(other, values))})")
                for at in range(len(values)):
                    rest = [*values[:at], *values[at + 1 :]]
                    text = ast.unparse(ast.BoolOp(op, rest) if len(rest) > 1 else rest[0])
                    yield put("dropped condition", f"({text})")
            case ast.BinOp(left=left, op=op, right=right):
                for sign in _others(op):
                    yield put("operator", f"({ast.unparse(ast.BinOp(left, sign, right))})")
                yield from (put("dropped operand", f"({ast.unparse(side)})") for side in (left, right))
                for tiny, size in ((left, right), (right, left)) if isinstance(op, ast.Mult) else ():
                    for value in ("1.0", *self._values) if _small(tiny) else ():
                        yield put(_SIZE, f"{ast.unparse(tiny)} * {value}")
                        yield put(_SIZE, f"{ast.unparse(tiny)} * ({ast.unparse(size)} + {value})")
            case ast.UnaryOp(operand=operand):
                yield put("dropped sign", f"({ast.unparse(operand)})")
            case ast.IfExp(body=body, orelse=orelse):
                yield from (put("condition fixed", f"({ast.unparse(each)})") for each in (body, orelse))
            case ast.Call():
                yield from (put(kind, text) for kind, text in self._called(node))

    def _called(self, node: ast.Call) -> Iterator[tuple[str, str]]:
        name, given = ast.unparse(node.func), [ast.unparse(each) for each in node.args]
        last, listed = name.rpartition(".")[2], ", ".join(given)
        if any(isinstance(each, ast.Starred) for each in node.args):
            return
        if last in _CALLED and not node.keywords:
            yield "function", f"{name.removesuffix(last)}{_CALLED[last]}({listed})"
        if len(given) == 1 and not node.keywords:
            yield "dropped call", f"({given[0]})"
        if last in _SIZES and len(given) > 1:
            for kept in (k for count in range(1, len(given)) for k in combinations(given, count)):
                text = f"{name}({', '.join(kept)})" if len(kept) > 1 else f"abs({kept[0]})"
                yield "subset of arguments", text
            yield "sum of arguments", f"({' + '.join(given)})"
            for value in ("abs(1.0)", *self._values) if last == "max" else ():
                yield "one more argument", f"{name}({listed}, {value})"
        elif last == "copysign" and len(given) == 2:
            yield "dropped sign", f"({given[0]})"
            yield "sign of zero", f"({given[0]} * (({given[1]} > 0) - ({given[1]} < 0)))"


def _others(op: ast.AST) -> list[Any]:
    return [getattr(ast, name)() for name in _OTHERS.get(type(op).__name__, "").split()]


def _constant(node: ast.Constant, value: float, index: bool) -> Iterator[_Change]:
    put = partial(_Change, node)
    if index:
        if value in (0, 1):
            yield put("index", str(1 - int(value)))
    elif isinstance(value, float) and 0 < value < _SMALL:
        yield from (put("tolerance", repr(rung), "of a number") for rung in _RUNGS)
        yield put("tolerance 0", "0.0")
    else:
        parts = [value // 16, value // 8, value // 4] if isinstance(value, int) and value > _LARGE else []
        half = value // 2 if isinstance(value, int) else value / 2
        for other in dict.fromkeys((value + 1, value - 1, 0, 2 * value, half, -value, *parts)):
            yield put("constant", f"({other!r})")


def _compared(node: ast.Compare) -> Iterator[_Change]:
    put, sides = partial(_Change, node), [node.left, *node.comparators]
    for at, op in enumerate(node.ops):
        for other in _others(op):
            ops = [*node.ops[:at], other, *node.ops[at + 1 :]]
            yield put("comparison", ast.unparse(ast.Compare(node.left, ops, node.comparators)))
    for at, op in enumerate(node.ops) if len(node.ops) == 2 else ():
        yield put("dropped condition", ast.unparse(ast.Compare(sides[at], [op], [sides[at + 1]])))
    if len(node.ops) > 1:
        return
    (p, q), kind = (f"({ast.unparse(each)})" for each in sides), type(node.ops[0])
    if sign := _ORDERED.get(kind):
        yield put("squares compared", f"{p} ** 2 {sign} {q} ** 2")
        left = node.left
        bare = left.args[0] if isinstance(left, ast.Call) and ast.unparse(left.func) == "abs" else left
        if isinstance(bare, ast.BinOp) and isinstance(bare.op, ast.Sub):
            a, b = f"({ast.unparse(bare.left)})", f"({ast.unparse(bare.right)})"
            squares = f"{'' if bare is left else 'abs'}({a} ** 2 - {b} ** 2)"
            for bound in (q, f"{q} ** 2", f"1e-9 * {b} ** 2", f"1e-9 * ({a} ** 2 + {b} ** 2)"):
                yield put("difference of squares", f"{squares} {sign} {bound}")
    texts = [each for each in sides if isinstance(each, ast.Constant) and isinstance(each.value, str)]
    if (sign := _EQUAL.get(kind)) and not texts:  # equal if they are close, to a length or to a part of it
        forms = (
            (f"abs({p} - {q})", _LEAST, ""),
            (f"max([abs(u_ - v_) for u_, v_ in zip({p}, {q})])", _LEAST, ""),
            (f"abs({p} - {q})", _PARTS, f" * max(abs{p}, abs{q})"),
        )
        for gap, rooms, size in forms:
            for room in rooms:
                yield put("room for equality", f"({gap} {sign} {room!r}{size})", gap + size)


def _straightened(node: ast.stmt) -> Iterator[_Change]:
    """Of two numbers that one statement computes alike, one is 0 where it is small beside the other."""
    if not isinstance(node, ast.Assign) or not isinstance(node.value, ast.Tuple):
        return
    names = node.targets[0].elts if isinstance(node.targets[0], ast.Tuple) else []
    for (first, p), (last, q) in pairwise(zip(names, node.value.elts, strict=False)):
        forms = [[type(part) for part in ast.walk(each) if isinstance(part, ast.expr)] for each in (p, q)]
        alike = forms[0] == forms[1] and ast.BinOp in forms[0]
        both = ast.unparse(first), ast.unparse(last)
        for small, large in (both, both[::-1]) if alike else ():
            for part in _PARTS:
                more = f"{small} *= abs({small}) > {part!r} * abs({large})"
                text = f"{ast.unparse(node)}; {more}"
                yield _Change(node, "small taken for 0", text, f"{small} beside {large}")


def _small(node: ast.expr) -> float | None:
    """The first constant in an expression that is a tolerance, if one is."""
    found = (n.value for n in ast.walk(node) if isinstance(n, ast.Constant) and isinstance(n.value, float))
    return next((value for value in found if 0 < value < _SMALL), None)
