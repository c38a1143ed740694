"""The places of a program's syntax tree, and a change of some of them.

Nothing is known of what the program is for. This file is handed to the contained process: standard library
only, and no import of judge.
"""

from __future__ import annotations

import ast
import copy
from typing import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence
    from typing import Any

SMALL = 0.02  # up to here a literal is a tolerance
_SKIPPED = ("decorator_list", "annotation", "returns", "type_params", "ctx", "op", "ops")
_PARTS = (ast.arguments, ast.arg, ast.alias, ast.keyword, ast.comprehension)
FUNCTIONS = (ast.FunctionDef, ast.Lambda)


class Slot(NamedTuple):
    """A child of a node: what may be put elsewhere there."""

    parent: Any
    field: str
    at: int = -1

    def get(self) -> Any:
        """What is there."""
        found = getattr(self.parent, self.field)
        return found if self.at < 0 else found[self.at]

    def put(self, node: Any) -> None:
        """Put that there."""
        if self.at < 0:
            setattr(self.parent, self.field, node)
        else:
            getattr(self.parent, self.field)[self.at] = node


class Edit(NamedTuple):
    """One change: its kind, its place, what tells it from others there, and the new nodes by slot."""

    kind: str
    line: int
    column: int
    what: str
    puts: Sequence[tuple[Slot, Any]]

    @property
    def lines(self) -> int:
        """How many lines it changes."""
        return len({getattr(slot.get(), "lineno", self.line) for slot, _ in self.puts})

    def apply(self) -> list[tuple[Slot, Any]]:
        """Change the tree; what undoes it."""
        before = [(slot, slot.get()) for slot, _ in self.puts]
        for slot, node in self.puts:
            slot.put(node)
        return before


def undo(before: Sequence[tuple[Slot, Any]]) -> None:
    """Put back what an edit has replaced."""
    for slot, node in reversed(before):
        slot.put(node)


class NodePlace(NamedTuple):
    """A node, its slot, and the function that it is in."""

    slot: Slot
    node: Any
    inside: Any


def places(tree: ast.AST) -> Iterator[NodePlace]:
    """Every statement and expression of the program's own."""
    waiting: list[tuple[ast.AST, Any]] = [(tree, None)]
    while waiting:
        node, inside = waiting.pop()
        inner = node if isinstance(node, FUNCTIONS) else inside
        for field, value in ast.iter_fields(node):
            if field in _SKIPPED:
                continue
            several = isinstance(value, list)
            for at, each in enumerate(value if several else (value,)):
                if isinstance(each, ast.AST):
                    if not isinstance(each, _PARTS) and not hasattr(each, "added"):
                        yield NodePlace(Slot(node, field, at if several else -1), each, inner)
                    waiting.append((each, inner))


def literal(node: Any) -> float | None:
    """The number that is written there, with its sign."""
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        inner = literal(node.operand)
        return None if inner is None else -inner
    if isinstance(node, ast.Constant) and type(node.value) in (int, float):
        value: Any = node.value
        return float(value) if abs(value) < 1e300 else None
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow):
        base, power = literal(node.left), literal(node.right)
        if base and power is not None and 1e-3 < abs(base) < 1e3 and abs(power) < 99:
            return float(base**power)
    return None


class Facts(NamedTuple):
    """What is known beside the tree.

    The entry, its parameters, when points coincide, and what names stand for by the line of their function.
    """

    entry: str
    parameters: Sequence[str]
    guards: Sequence[str]
    several: bool  # the answer is a list
    kinds: Mapping[tuple[int, str], str]
    first: bool = True  # no other edit has been made before


def is_small(node: Any) -> bool:
    """Whether it is a tolerance, as it is written."""
    value = literal(node)
    return value is not None and 0 < abs(value) <= SMALL


def called(node: Any) -> str:
    """The name of the function that it calls, without what it belongs to; empty where it calls none."""
    if not isinstance(node, ast.Call):
        return ""
    return node.func.id if isinstance(node.func, ast.Name) else str(getattr(node.func, "attr", ""))


def expression(text: str, **holes: Any) -> Any:
    """The expression, with nodes for names; what is written here is no place for another change."""

    class Filled(ast.NodeTransformer):
        def visit_Name(self, node: ast.Name) -> Any:
            return holes.get(node.id, node)

    tree = ast.parse(text, mode="eval")
    for node in ast.walk(tree):
        node.added = True  # type: ignore[attr-defined]
    return Filled().visit(tree.body)


def shrunk(tree: Any) -> Any:
    """The tree with every tolerance times `_FACTOR`."""

    class Smaller(ast.NodeTransformer):
        def visit(self, node: Any) -> Any:
            if isinstance(node, ast.expr) and is_small(node):
                return ast.copy_location(expression("x * _FACTOR", x=node), node)
            return self.generic_visit(node)

    return ast.fix_missing_locations(Smaller().visit(copy.deepcopy(tree)))


def counted(tree: Any) -> Any:
    """The tree with a call of `_turn_` in every loop and every function, which ends what goes on for ever."""
    for node in [*ast.walk(tree)]:
        if isinstance(node, ast.FunctionDef | ast.For | ast.While):
            turn = ast.Expr(expression("_turn_()"))
            turn.added = True  # type: ignore[attr-defined]
            for each in ast.walk(turn):
                ast.copy_location(each, node)
            node.body.insert(0, turn)
    return tree


def unrounded(tree: Any) -> list[tuple[int, Any]]:
    """Of each statement that may round its line, and the tree with its value worked out without rounding."""

    class Raised(ast.NodeTransformer):
        def visit_Name(self, node: Any) -> Any:
            return expression("_raised_(x)", x=node) if isinstance(node.ctx, ast.Load) else node

    found = []
    for at, each in enumerate(ast.walk(tree)):
        if isinstance(each, ast.Assign | ast.Return) and isinstance(
            each.value, ast.BinOp | ast.Call | ast.Tuple
        ):
            other = copy.deepcopy(tree)
            twin: Any = next(node for place, node in enumerate(ast.walk(other)) if place == at)
            twin.value = expression("_lowered_(x)", x=Raised().visit(twin.value))
            for node in ast.walk(twin.value):
                ast.copy_location(node, each)
            found.append((each.lineno, other))
    return found


def watched(tree: Any) -> tuple[Any, list[int]]:
    """The tree with every comparison told to `_told_`, and the line of each."""
    lines: list[int] = []

    class Told(ast.NodeTransformer):
        def visit_Compare(self, node: Any) -> Any:
            lines.append(node.lineno)
            text = f"_told_({len(lines) - 1}, x)"
            return ast.copy_location(expression(text, x=self.generic_visit(node)), node)

        def visit_Call(self, node: Any) -> Any:
            close = getattr(node.func, "attr", getattr(node.func, "id", "")) == "isclose"
            return self.visit_Compare(node) if close else self.generic_visit(node)

    return ast.fix_missing_locations(Told().visit(copy.deepcopy(tree))), lines
