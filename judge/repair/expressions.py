"""The small changes that expressions allow, by their types.

This file is handed to the contained process: standard library only, and no import of judge but of what
stands beside it.
"""

from __future__ import annotations

import ast
import copy
from functools import reduce

from judge.repair.trees import (
    SMALL,
    Edit,
    Facts,
    NodePlace,
    Slot,
    called,
    expression,
    is_small,
    literal,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any

WIDTHS = (  # how wide a tolerance may be, by the size of the figure and the length of what is measured along
    *("1e-10", "1e-10*_size_", "1e-10*_size_*_size_", "1e-10*_size_/_way_", "1e-10*_size_*_way_"),
    *("1e-10*_size_*_size_*_way_*_way_", "2e-15*_size_*_size_", "2e-15*_size_*_size_*_way_*_way_"),
    "2e-15*_size_*_size_/(_way_*_way_)",
)
TOLERANCES = (  # what may stand in place of one
    *(("tolerance-none", "0.0"), ("tolerance-smaller", "1e-12"), ("tolerance-smaller", WIDTHS[0])),
    *(("tolerance-scaled", width) for width in WIDTHS[1:]),
)
SWAPPED: Mapping[type, type] = {
    ast.Lt: ast.LtE,
    ast.LtE: ast.Lt,
    ast.Gt: ast.GtE,
    ast.GtE: ast.Gt,
    ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq,
}
TURNED: Mapping[type, type] = {ast.Lt: ast.Gt, ast.LtE: ast.GtE, ast.Gt: ast.Lt, ast.GtE: ast.LtE}
SIGNS = {ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">="}
_OTHERS: Mapping[type, type] = {
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Div,
    ast.FloorDiv: ast.Div,
    ast.BitXor: ast.Pow,
}
UNWRAPPED = {
    **{name: f"without-{name}" for name in ("round", "int", "float", "sorted", "abs", "set")},
    **dict.fromkeys(("fabs",), "without-abs"),
    **dict.fromkeys(("floor", "ceil", "trunc", "isqrt"), "without-int"),
    **dict.fromkeys(("list", "tuple", "max", "min", "reversed", "sqrt", "Decimal", "str"), "without"),
}
_TWINS = (  # functions that are taken for one another
    *(("max", "min"), ("max", "sum"), ("maximum", "minimum"), ("any", "all")),
    *(("sin", "cos"), ("floor", "ceil")),
)
_MEASURES = ("(x)/_way_", "(x)*_way_", "(x)**0.5", "(x)*(x)", "2*(x)", "(x)/2")


def _times(left: Any, right: Any) -> ast.BinOp:
    return ast.BinOp(left, ast.Mult(), right)


class Expressions:
    """Collects the edits in `made`."""

    def __init__(self, facts: Facts) -> None:
        self.made: list[Edit] = []
        self.facts = facts
        self.functions: dict[str, int] = {}  # of the top level, with how many parameters they have
        self._ways = {
            ast.Compare: self._compare,
            ast.BoolOp: self._logic,
            ast.BinOp: self._operation,
            ast.UnaryOp: self._signed,
            ast.Call: self._call,
            ast.Constant: self._constant,
            ast.Name: self._name,
            ast.List: self._row,
            ast.Tuple: self._row,
            ast.Subscript: self._part,
            ast.Attribute: self._field,
        }

    def add(self, kind: str, node: Any, what: str, *puts: tuple[Slot, Any]) -> None:
        """Collect an edit at the node."""
        line, column = getattr(node, "lineno", 1), getattr(node, "col_offset", 0)
        for _, new in puts:
            for each in ast.walk(new) if isinstance(new, ast.AST) else ():
                if not hasattr(each, "lineno") or hasattr(each, "added"):
                    ast.copy_location(each, node)
        self.made.append(Edit(kind, line, column, what, puts))

    def put(self, kind: str, slot: Slot, node: Any, text: str, **holes: Any) -> None:
        """Collect the edit that puts that expression in place of the node."""
        self.add(kind, node, text, (slot, expression(text, **holes)))

    def stands_for(self, inside: Any, node: Any, *kinds: str) -> bool:
        """Whether the name stands for a value of these kinds in the function."""
        return self.facts.kinds.get((getattr(inside, "lineno", 0), node.id)) in kinds

    def of_expression(self, place: NodePlace) -> None:
        """Collect what may be changed at an expression."""
        if way := self._ways.get(type(place.node)):
            way(place)
        self._value(place)

    def _signed(self, place: NodePlace) -> None:
        self.add("sign", place.node, "without", (place.slot, place.node.operand))

    def _compare(self, place: NodePlace) -> None:
        slot, node, _ = place
        for at, operator in enumerate(node.ops):
            for kind, table in (("compare-equal", SWAPPED), ("compare-turned", TURNED)):
                if type(operator) in table:
                    ops = [*node.ops[:at], table[type(operator)](), *node.ops[at + 1 :]]
                    self.add(kind, node, f"{at}", (slot, ast.Compare(node.left, ops, node.comparators)))
        if len(node.ops) == 1:
            sides = {"a": node.left, "b": node.comparators[0]}
            if isinstance(node.ops[0], ast.Eq | ast.NotEq):
                sign = "<=" if isinstance(node.ops[0], ast.Eq) else ">"
                for width in WIDTHS:
                    self.put("near", slot, node, f"abs((a) - (b)) {sign} {width}", **sides)
            elif type(node.ops[0]) in TURNED:
                sign = SIGNS[type(node.ops[0])]
                for width in WIDTHS:
                    for by in "+-":
                        self.put("room", slot, node, f"(a) {sign} (b) {by} {width}", **sides)
        elif len(node.ops) == 2 and all(type(each) in TURNED for each in node.ops):
            parts = {"a": node.left, "b": node.comparators[0], "c": node.comparators[1]}
            up = isinstance(node.ops[0], ast.Lt | ast.LtE)
            sign = "<=" if up else ">="
            for width in WIDTHS:
                for one, other in ("-+", "+-"):
                    text = f"(a) {one} {width} {sign} (b) {sign} (c) {other} {width}"
                    self.put("room", slot, node, text, **parts)
            self.put("compare-equal", slot, node, f"(a) {sign} (b) {sign} (c)", **parts)
            for pair in ("ab", "bc"):
                text = f"({pair[0]}) {SIGNS[type(node.ops[pair == 'bc'])]} ({pair[1]})"
                self.put("condition", slot, node, text, **parts)
        for text in ("True", "False"):
            self.put("condition", slot, node, text)

    def _logic(self, place: NodePlace) -> None:
        slot, node, _ = place
        for at in range(len(node.values)):
            rest = node.values[:at] + node.values[at + 1 :]
            self.add(
                "condition", node, f"{at}", (slot, rest[0] if len(rest) == 1 else ast.BoolOp(node.op, rest))
            )
        other = ast.Or() if isinstance(node.op, ast.And) else ast.And()
        self.add("condition", node, "other", (slot, ast.BoolOp(other, node.values)))

    def _operation(self, place: NodePlace) -> None:
        slot, node, _ = place
        sides = (node.left, node.right)
        if other := _OTHERS.get(type(node.op)):
            kind = "whole-division" if isinstance(node.op, ast.FloorDiv) else "operator"
            kind = "sign" if isinstance(node.op, ast.Add | ast.Sub) else kind
            self.add(kind, node, "", (slot, ast.BinOp(node.left, other(), node.right)))
        if isinstance(node.op, ast.Sub):
            self.put("turned", slot, node, "(b) - (a)", a=node.left, b=node.right)
            if not any(isinstance(each, ast.Subscript | ast.Constant) for each in sides):
                leg = "max(0.0, ((a) - (b)) * ((a) + (b))) ** 0.5"
                self.put("measure", slot, node, leg, a=node.left, b=node.right)
        for at, each in enumerate(sides):
            self.add("dropped", node, f"{at}", (slot, each))
        if isinstance(node.op, ast.Mult | ast.Pow) and 2 in map(literal, sides):
            x = sides[literal(node.left) == 2]
            self.put("measure", slot, node, "(x) * (x)" if isinstance(node.op, ast.Mult) else "2 * (x)", x=x)
        self._brackets(place)
        if isinstance(node.op, ast.Mult) and any(map(is_small, sides)):
            for width in WIDTHS:
                self.put("tolerance-scaled", slot, node, width)

    def _brackets(self, place: NodePlace) -> None:
        """A sum within a product that is written beside it, or the other way round: a·(b + c) and a·b + c.

        Or a factor that is written beside a divisor: a / 2·b.
        """
        slot, node, _ = place
        (left, right), sums = (node.left, node.right), ast.Add | ast.Sub
        if isinstance(node.op, sums) and isinstance(left, ast.BinOp) and isinstance(left.op, ast.Mult):
            factors = [left.right]
            while isinstance(left.left, ast.BinOp) and isinstance(left.left.op, ast.Mult):
                left = left.left
                factors.append(left.right)
            factors = [left.left, *factors[::-1]]
            for at in range(1, len(factors)):
                before, after = (reduce(_times, some) for some in (factors[:at], factors[at:]))
                inner = ast.BinOp(after, node.op, right)
                self.add("brackets", node, f"{at}", (slot, _times(before, inner)))
        if isinstance(node.op, sums) and isinstance(right, ast.BinOp) and isinstance(right.op, ast.Div):
            top = ast.BinOp(node.left, node.op, right.left)
            self.add("brackets", node, "over", (slot, ast.BinOp(top, ast.Div(), right.right)))
        if isinstance(node.op, ast.Mult) and isinstance(left, ast.BinOp) and isinstance(left.op, ast.Div):
            self.put("brackets", slot, node, "a / (b * c)", a=left.left, b=left.right, c=right)
        others = ast.Mult | ast.Div | ast.Pow
        if isinstance(node.op, others) and isinstance(left, ast.BinOp) and isinstance(left.op, sums):
            inner = ast.BinOp(left.right, node.op, right)
            self.add("brackets", node, "", (slot, ast.BinOp(left.left, left.op, inner)))

    def _field(self, place: NodePlace) -> None:
        """Another one of the fields that its function takes of values."""
        slot, node, inside = place
        if inside is None or (isinstance(slot.parent, ast.Call) and slot.field == "func"):
            return
        fields = {
            each.attr
            for each in ast.walk(inside)
            if isinstance(each, ast.Attribute) and isinstance(each.ctx, ast.Load)
        }
        for other in sorted(fields - {node.attr}):
            self.add("name", node, other, (slot, ast.Attribute(node.value, other, ast.Load())))

    def _call(self, place: NodePlace) -> None:
        slot, node, _ = place
        name, args = called(node), node.args
        for twin in [each for pair in _TWINS if name in pair for each in pair if each != name]:
            func = copy.copy(node.func)
            setattr(func, "id" if isinstance(func, ast.Name) else "attr", twin)
            self.add("operator", node, twin, (Slot(node, "func"), func))
        if name in ("max", "min") and isinstance(node.func, ast.Attribute) and args and not node.keywords:
            axis = ast.keyword("axis", expression("0"))  # of arrays one for all, in place of one for each
            self.add("name", node, "axis", (slot, ast.Call(node.func, args, [axis])))
        if name in UNWRAPPED:
            if isinstance(node.func, ast.Attribute) and not args:
                self.add(UNWRAPPED[name], node, "of", (slot, node.func.value))
            for at, each in enumerate(args[: 2 if name in ("min", "max") else 1]):
                self.add(UNWRAPPED[name], node, f"{at}", (slot, each))
                if len(args) == 2 and called(each) in ("min", "max") and len(each.args) == 2:
                    for inner, kept in enumerate(each.args):
                        self.add("clamp", node, f"{at}{inner}", (slot, kept))
        if name in ("max", "hypot", "min") and len(args) > 1:
            self.put("size", slot, node, "_size_")
        if name == "max" and len(args) == 2:
            self.put("measure", slot, node, "((a) * (a) + (b) * (b)) ** 0.5", a=args[0], b=args[1])
        for at, each in enumerate(args if name in ("max", "min") else ()):
            if isinstance(each, ast.BinOp | ast.Name):
                self.put("abs", Slot(node, "args", at), each, "abs(x)", x=each)
        if name == "sqrt" and args:
            root = ast.Call(node.func, [expression("max(0.0, x)", x=args[0])], [])
            self.add("root", node, "", (slot, root))
            if isinstance(args[0], ast.BinOp) and isinstance(args[0].op, ast.Sub):
                sides = {"a": args[0].left, "b": args[0].right}
                self.put("measure", Slot(node, "args", 0), args[0], "(a) * (a) - (b) * (b)", **sides)
        if name == "isclose" and len(args) >= 2:
            for width in ("0.0", *WIDTHS):
                kind = "tolerance-none" if width == "0.0" else "tolerance-scaled"
                self.put(kind, slot, node, f"abs((a) - (b)) <= {width}", a=args[0], b=args[1])
        for key in node.keywords:
            if key.arg in ("reverse", "key"):
                kept = [each for each in node.keywords if each is not key]
                self.add("order", node, key.arg, (slot, ast.Call(node.func, args, kept)))
        if name == "range":
            self._bounds(node, *(Slot(node, "args", at) for at in range(len(args[:2]))))
        elif name not in ("max", "min", "hypot", "isclose"):
            for at in range(len(args) - 1):
                other = [*args[:at], args[at + 1], args[at], *args[at + 2 :]]
                self.add("arguments", node, f"{at}", (slot, ast.Call(node.func, other, node.keywords)))

    def _constant(self, place: NodePlace) -> None:
        slot, node, _ = place
        value = node.value
        if value is None or type(value) is bool:
            self.put("constant", slot, node, "[]" if value is None else repr(not value))
        elif type(value) is int and abs(value) < 10**6:
            for other in sorted({value + 1, value - 1, -value, value * 2, value // 2} - {value}):
                self.put("constant", slot, node, repr(other))
        elif type(value) is float and abs(value) > SMALL:
            for near in sorted({-value, value * 2, value / 2} - {value}):
                self.put("constant", slot, node, repr(near))

    def _name(self, place: NodePlace) -> None:
        slot, node, inside = place
        for other, count in self.functions.items():
            if other != node.id and count == self.functions.get(node.id):
                self.put("operator", slot, node, other)
        if inside is None or (isinstance(slot.parent, ast.Call) and slot.field != "args"):
            return
        kind = self.facts.kinds.get((inside.lineno, node.id))
        for other in self._others(inside, kind, node.id) if kind else ():
            self.put("name", slot, node, other)
        if node.id.lower().rstrip("012") in ("r", "radius", "rad"):
            for text in ("(x) * (x)", "(x) / 2"):
                self.put("square", slot, node, text, x=node)

    def _others(self, inside: Any, kind: str, *but: str) -> list[str]:
        """The names of the function that stand for a value of that kind."""
        wanted = getattr(inside, "lineno", 0), kind
        kinds = sorted(self.facts.kinds.items())
        return [name for (line, name), each in kinds if (line, each) == wanted and name not in but]

    def _part(self, place: NodePlace) -> None:
        slot, node, inside = place
        part = node.slice
        if literal(part) in (0, -1):
            for text in ("min(x)", "max(x)"):
                self.put("name", slot, node, text, x=node.value)
        if isinstance(part, ast.Slice):
            self.add("slice", node, "", (slot, node.value))
            self._bounds(node, Slot(part, "lower"), Slot(part, "upper"))
        elif isinstance(part, ast.BinOp) or (
            isinstance(part, ast.Name) and inside is not None and self.stands_for(inside, part, "number")
        ):
            self._bounds(node, Slot(node, "slice"))

    def _bounds(self, node: Any, *slots: Slot) -> None:
        """A bound or a place in a list, one more and one less."""
        for slot in slots:
            value = slot.get()
            if value is not None and literal(value) is None:
                for by in "+-":
                    self.put("bound", slot, node, f"(x) {by} 1", x=value)

    def _row(self, place: NodePlace) -> None:
        slot, node, _ = place
        row, items = isinstance(node, ast.List), node.elts
        if len(items) == 2:
            other = type(node)(items[::-1], ast.Load())
            self.add("order" if row else "coordinates", node, "", (slot, other))
        if row and len(items) > 1:
            for at in (0, len(items) - 1):
                self.add("dropped", node, f"{at}", (slot, ast.List([items[at]], ast.Load())))

    def _value(self, place: NodePlace) -> None:
        """A value that is compared, returned, stored or divided."""
        slot, node, inside = place
        parent = slot.parent
        stored = isinstance(parent, ast.Return) or (isinstance(parent, ast.Assign) and slot.field == "value")
        stored = stored or (isinstance(parent, ast.BinOp) and isinstance(parent.op, ast.Div))
        stored = stored or (isinstance(parent, ast.IfExp) and slot.field != "test")
        if isinstance(parent, ast.Call) and slot.field == "args" and called(parent)[:1].isupper():
            self.put("sign", slot, node, "-(x)", x=node)  # a part of what is made
        if not isinstance(node, ast.BinOp | ast.Call | ast.Name):
            return
        if stored or isinstance(parent, ast.Compare | ast.Tuple | ast.List):
            self.put("sign", slot, node, "-(x)", x=node)
            self.put("abs", slot, node, "abs(x)", x=node)
        elif isinstance(parent, ast.BinOp) and isinstance(parent.op, ast.Add | ast.Sub):
            self.put("abs", slot, node, "abs(x)", x=node)
        if (stored or isinstance(parent, ast.Tuple)) and not isinstance(node, ast.Name):
            for text in _MEASURES if stored else _MEASURES[-2:]:
                self.put("measure", slot, node, text, x=node)
        if type(node) is ast.Name and stored and self.stands_for(inside, node, "ndarray", "list"):
            self.put("copied", slot, node, "(x).copy()", x=node)
        self._missing(place, stored=stored)

    def _missing(self, place: NodePlace, *, stored: bool) -> None:
        """A term is added to a value, or it is taken from another one."""
        slot, node, inside = place
        parent = slot.parent
        first = isinstance(parent, ast.BinOp) and slot.field == "left"
        first = first and isinstance(parent.op, ast.Div | ast.Sub)
        if inside is None or not self.facts.first or not (stored or first or isinstance(parent, ast.Tuple)):
            return
        self.put("missing", slot, node, "1 - (x)", x=node)
        for other in self._others(inside, "number", node.id) if isinstance(node, ast.Name) else ():
            for text in (f"_x_ + {other}", f"_x_ - {other}", f"{other} - _x_")[: 2 + first]:
                self.put("missing", slot, node, text, _x_=node)
