"""Mutants of a program: its text with one expression or statement replaced, so that the change is one line.

    for mutant in mutants(source): mutant.kind, mutant.line, mutant.was, mutant.becomes, mutant.source

A ladder is one tolerance with other values from the greatest down: where a value is accepted, smaller ones
most often are, and need not be asked.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from itertools import combinations, pairwise
from random import Random

from msgspec import Struct

_COMPARED: dict[type[ast.cmpop], tuple[type[ast.cmpop], ...]] = {
    ast.Lt: (ast.LtE, ast.Gt),
    ast.LtE: (ast.Lt, ast.GtE),
    ast.Gt: (ast.GtE, ast.Lt),
    ast.GtE: (ast.Gt, ast.LtE),
    ast.Eq: (ast.NotEq, ast.LtE, ast.GtE),
    ast.NotEq: (ast.Eq, ast.Lt, ast.Gt),
    ast.Is: (ast.IsNot,),
    ast.IsNot: (ast.Is,),
    ast.In: (ast.NotIn,),
    ast.NotIn: (ast.In,),
}
_OPERATORS: dict[type[ast.operator], tuple[type[ast.operator], ...]] = {
    ast.Add: (ast.Sub,),
    ast.Sub: (ast.Add,),
    ast.Mult: (ast.Div, ast.Add),
    ast.Div: (ast.Mult, ast.FloorDiv),
    ast.FloorDiv: (ast.Div, ast.Mult),
    ast.Mod: (ast.FloorDiv,),
    ast.Pow: (ast.Mult,),
    ast.LShift: (ast.RShift,),
    ast.RShift: (ast.LShift,),
}
_CALLED = {
    "min": "max",
    "max": "min",
    "floor": "ceil",
    "ceil": "floor",
    "sorted": "list",
    "any": "all",
    "all": "any",
}
_SIZES = ("max", "min", "hypot")
_RUNGS = tuple(float(f"{m}e-{k}") for k in range(2, 17) for m in ("5", "3", "2", "1.5", "1.2", "1"))
_PARTS = (1e-4, 1e-6, 1e-8, 1e-9, 1e-10, 1e-12, 1e-14, 1e-16)  # what is smaller is taken for 0, or for equal
_LEAST = (1e-9, 1e-12, 1e-15, 1e-20, 1e-30)
_LONGEST = 16  # characters of a text that is no message
_SMALL = 1e-4  # a constant below it is a tolerance
_LARGE = 100  # an int above it may say how fine something is
_MOST_NAMES = 500  # mutants that take another name
_ORDERED = (ast.Lt, ast.LtE, ast.Gt, ast.GtE)


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


def mutants(source: str, seed: int = 0) -> Iterator[Mutant]:
    """All of them, no two alike; of those with another name a sample. Raises SyntaxError."""
    maker, seen = _Maker(source), set()
    for node, kind, text, ladder in maker.changes(Random(seed)):
        made = ast.parse(text)
        key = node.lineno, node.col_offset, node.end_lineno, node.end_col_offset, ast.dump(made)
        if key not in seen and ast.unparse(made) != ast.unparse(node):
            seen.add(key)
            yield maker.mutant(node, kind, text, ladder)


_Change = tuple[ast.expr | ast.stmt, str, str, str]  # a node, the kind, its new text, the ladder


class _Maker:
    """The changes of one source, by the scope that each is in."""

    def __init__(self, source: str) -> None:
        self._source, self._bytes = source, source.encode()
        self._lines = source.splitlines()
        self._starts = [0]
        for line in self._bytes.splitlines(keepends=True):
            self._starts.append(self._starts[-1] + len(line))
        self._tree = ast.parse(source)

    def mutant(self, node: ast.expr | ast.stmt, kind: str, text: str, ladder: str) -> Mutant:
        """The source where `text` stands for the node."""
        last = node.end_lineno or node.lineno
        at = self._starts[node.lineno - 1] + node.col_offset
        end = self._starts[last - 1] + (node.end_col_offset or 0)
        source = (self._bytes[:at] + text.encode() + self._bytes[end:]).decode()
        after = node.lineno + text.count("\n")
        was = "\n".join(self._lines[node.lineno - 1 : last]).strip()
        becomes = "\n".join(source.splitlines()[node.lineno - 1 : after]).strip()
        return Mutant(kind, node.lineno, was, becomes, source, ladder)

    def changes(self, random: Random) -> Iterator[_Change]:
        """Every change, those that take another name last."""
        outer = _Scope(self._tree, {})
        scopes = [outer]
        scopes += [
            _Scope(node, outer.tolerances)
            for node in ast.walk(self._tree)
            if isinstance(node, ast.FunctionDef)
        ]
        swaps: list[_Change] = []
        for scope in scopes:
            for node in scope.nodes:
                if isinstance(node, ast.stmt):
                    yield from ((at, kind, text, "") for at, kind, text in _statement(node))
                    yield from _straightened(node)
                elif isinstance(node, ast.expr):
                    yield from scope.expression(node)
                    swaps += scope.renamed(node)
        random.shuffle(swaps)
        yield from swaps[:_MOST_NAMES]


def _statement(node: ast.stmt) -> Iterator[tuple[ast.expr | ast.stmt, str, str]]:
    match node:
        case ast.Expr(value=ast.Constant()) | ast.Import() | ast.ImportFrom():
            return
        case ast.Assign() | ast.AugAssign() | ast.Expr() | ast.Raise():
            yield node, "dropped statement", "pass"
        case ast.If(test=test) | ast.While(test=test):
            yield from ((test, "condition fixed", text) for text in ("False", "True"))
        case ast.Return(value=ast.expr()):
            yield node, "return None", "return None"


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
        self._values = [f"{name}{item}" for name in self._names for item in ("", "[0]", "[1]")]
        own = {
            target.id: small
            for node in self.nodes
            if isinstance(node, ast.Assign) and (small := _small(node.value))
            for target in node.targets
            if isinstance(target, ast.Name)
        }
        self.tolerances = outer | own

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

    def renamed(self, node: ast.expr) -> list[_Change]:
        """A name that is read, as each other one of the scope."""
        parent = self._parents[node]
        called = isinstance(parent, ast.Call) and parent.func is node
        if not isinstance(node, ast.Name) or not isinstance(node.ctx, ast.Load) or called:
            return []
        others = self._names if node.id in self._names else []
        return [(node, "another name", other, "") for other in others if other != node.id]

    def expression(self, node: ast.expr) -> Iterator[_Change]:
        """The changes of one expression that is read."""
        if not isinstance(getattr(node, "ctx", ast.Load()), ast.Load):
            return
        match node:
            case ast.Constant(value=str() as value):
                if not isinstance(self._parents[node], ast.Expr) and len(value) <= _LONGEST:
                    yield from ((node, "text", repr(other), "") for other in (value[1:], value[:-1], ""))
            case ast.Constant(value=bool() | bytes() | None) | ast.JoinedStr():
                return
            case ast.Constant(value=int() | float() as value):
                yield from self._constant(node, value)
            case ast.Name(id=name) if name in self.tolerances:
                yield from self._tolerance(node, self.tolerances[name])
            case ast.Compare():
                yield from ((node, kind, text, "") for kind, text in _compared(node))
                yield from _roomy(node)
            case ast.BoolOp(op=op, values=values):
                other = ast.Or() if isinstance(op, ast.And) else ast.And()
                yield node, "and/or", f"({ast.unparse(ast.BoolOp(other, values))})", ""
                for at in range(len(values)):
                    rest = [*values[:at], *values[at + 1 :]]
                    text = ast.unparse(ast.BoolOp(op, rest) if len(rest) > 1 else rest[0])
                    yield node, "dropped condition", f"({text})", ""
            case ast.BinOp():
                yield from ((node, kind, text, "") for kind, text in self._operated(node))
            case ast.UnaryOp(operand=operand):
                yield node, "dropped sign", f"({ast.unparse(operand)})", ""
            case ast.IfExp(body=body, orelse=orelse):
                yield from (
                    (node, "condition fixed", f"({ast.unparse(each)})", "") for each in (body, orelse)
                )
            case ast.Call():
                yield from ((node, kind, text, "") for kind, text in self._called(node))

    def _constant(self, node: ast.Constant, value: float) -> Iterator[_Change]:
        parent = self._parents[node]
        if isinstance(parent, ast.Subscript) and parent.slice is node:
            if value in (0, 1):
                yield node, "index", str(1 - int(value)), ""
        elif isinstance(value, float) and 0 < value < _SMALL:
            place = f"{node.lineno}:{node.col_offset}"
            yield from ((node, "tolerance", repr(rung), place) for rung in _RUNGS)
            yield node, "tolerance 0", "0.0", ""
        else:
            parts = [value // 16, value // 8, value // 4] if isinstance(value, int) and value > _LARGE else []
            half = value // 2 if isinstance(value, int) else value / 2
            for other in dict.fromkeys((value + 1, value - 1, 0, 2 * value, half, -value, *parts)):
                yield node, "constant", f"({other!r})", ""

    def _tolerance(self, node: ast.Name, value: float) -> Iterator[_Change]:
        """This use of it alone: larger and smaller, and of another size."""
        place = f"{node.lineno}:{node.col_offset}"
        for rung in _RUNGS:
            yield node, "tolerance", f"({rung / value:.6g} * {node.id})", place
        for other in self._values:
            yield node, "size of another quantity", f"({value!r} * abs({other}))", ""

    def _operated(self, node: ast.BinOp) -> Iterator[tuple[str, str]]:
        for other in _OPERATORS.get(type(node.op), ()):
            yield "operator", f"({ast.unparse(ast.BinOp(node.left, other(), node.right))})"
        for side in (node.left, node.right):
            yield "dropped operand", f"({ast.unparse(side)})"
        if isinstance(node.op, ast.Mult):
            for small, size in ((node.left, node.right), (node.right, node.left)):
                for value in ("1.0", *(f"abs({each})" for each in self._values)) if _small(small) else ():
                    yield "size of another quantity", f"{ast.unparse(small)} * {value}"
                    yield (
                        "size of another quantity",
                        f"{ast.unparse(small)} * ({ast.unparse(size)} + {value})",
                    )

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
            for value in ("1.0", *self._values) if last == "max" else ():
                yield "one more argument", f"{name}({listed}, abs({value}))"
        elif last == "copysign" and len(given) == 2:
            yield "dropped sign", f"({given[0]})"
            yield "sign of zero", f"({given[0]} * (({given[1]} > 0) - ({given[1]} < 0)))"


def _compared(node: ast.Compare) -> Iterator[tuple[str, str]]:
    for at, op in enumerate(node.ops):
        for other in _COMPARED.get(type(op), ()):
            ops = [*node.ops[:at], other(), *node.ops[at + 1 :]]
            yield "comparison", ast.unparse(ast.Compare(node.left, ops, node.comparators))
    if len(node.ops) == 2:
        middle, last = node.comparators
        yield "dropped condition", ast.unparse(ast.Compare(node.left, node.ops[:1], [middle]))
        yield "dropped condition", ast.unparse(ast.Compare(middle, node.ops[1:], [last]))
    elif isinstance(node.ops[0], _ORDERED):
        left, right = node.left, f"({ast.unparse(node.comparators[0])})"
        sign = {ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">="}[type(node.ops[0])]
        yield "squares compared", f"({ast.unparse(left)}) ** 2 {sign} {right} ** 2"
        bare = left.args[0] if isinstance(left, ast.Call) and ast.unparse(left.func) == "abs" else left
        if isinstance(bare, ast.BinOp) and isinstance(bare.op, ast.Sub):
            p, q = f"({ast.unparse(bare.left)})", f"({ast.unparse(bare.right)})"
            squares = f"{'' if bare is left else 'abs'}({p} ** 2 - {q} ** 2)"
            for bound in (right, f"{right} ** 2", f"1e-9 * {q} ** 2", f"1e-9 * ({p} ** 2 + {q} ** 2)"):
                yield "difference of squares", f"{squares} {sign} {bound}"


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
                place = f"{node.lineno}:{node.col_offset} {small} {large}"
                yield node, "small taken for 0", f"{ast.unparse(node)}; {more}", place


def _roomy(node: ast.Compare) -> Iterator[_Change]:
    """Numbers or points that are equal if they are close, be it to a length or to a part of their own."""
    signs: dict[type[ast.cmpop], str] = {ast.Eq: "<=", ast.NotEq: ">"}
    sides = node.left, *node.comparators
    sign, p, q = signs.get(type(node.ops[0]), ""), *map(ast.unparse, sides[:2])
    texts = [each for each in sides if isinstance(each, ast.Constant) and isinstance(each.value, str)]
    if not sign or len(sides) > 2 or texts:
        return
    forms = (
        ("abs(({p}) - ({q})) {sign} {room!r}", _LEAST),
        ("max([abs(u_ - v_) for u_, v_ in zip({p}, {q})]) {sign} {room!r}", _LEAST),
        ("abs(({p}) - ({q})) {sign} {room!r} * max(abs({p}), abs({q}))", _PARTS),
    )
    for number, (form, rooms) in enumerate(forms):
        for room in rooms:
            text = form.format(p=p, q=q, sign=sign, room=room)
            yield node, "room for equality", f"({text})", f"{node.lineno}:{node.col_offset} {number}"


def _small(node: ast.expr) -> float | None:
    """The first constant in an expression that is a tolerance, if one is."""
    found = (n.value for n in ast.walk(node) if isinstance(n, ast.Constant) and isinstance(n.value, float))
    return next((value for value in found if 0 < value < _SMALL), None)
