"""The small changes that the types of a program's places allow.

This file is handed to the contained process: standard library only, and no import of judge but of what
stands beside it.
"""

from __future__ import annotations

import ast
import copy
from itertools import combinations

from judge.repair.expressions import TOLERANCES, Expressions
from judge.repair.trees import Edit, Facts, NodePlace, Slot, expression, is_small, literal, places

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# Every kind of edit, the likeliest first; a list from the contained process holds their places in this one.
KINDS = (
    *("parameter-order", "room", "near", "tolerance-none", "tolerance-smaller", "tolerance-scaled", "size"),
    *("guard-exact", "clamp", "compare-equal", "compare-turned", "condition", "guard-left-out", "form"),
    *("copied", "order", "whole-division", "root", "abs", "square", "without-round", "without-int"),
    *("without-float", "without-sorted", "without-abs", "without-set", "without"),
    *("coordinates", "turned", "sign"),
    *("statement-left-out", "slice", "bound", "early", "measure", "brackets", "dropped", "operator"),
    *("constant", "arguments", "name", "missing"),
)
MOST_EDITS = 2_000
_MOST_NODES = 4_000  # of a program that is changed


def listed(tree: ast.AST, facts: Facts) -> list[Edit]:
    """All edits of the program, in an order that depends on nothing but its text."""
    found = _Edits([*places(tree)], facts).made
    order = {kind: at for at, kind in enumerate(KINDS)}
    return sorted(found, key=lambda edit: (order[edit.kind], *edit[1:4]))[:MOST_EDITS]


class _Edits(Expressions):
    def __init__(self, everything: list[NodePlace], facts: Facts) -> None:
        super().__init__(facts)
        self._all = everything
        self._slots = {id(node): slot for slot, node, _ in everything}
        self._small_names = {
            node.targets[0].id
            for _, node, _ in everything
            if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name) and is_small(node.value)
        }
        self.functions = {
            node.name: len(node.args.args)
            for _, node, inside in everything
            if isinstance(node, ast.FunctionDef) and inside is None
        }
        if len(everything) > _MOST_NODES:
            return
        for each in everything:
            if getattr(each.inside, "name", "") == "__init__" and isinstance(each.node, ast.Name):
                continue  # a value that is kept: who changes it there changes all that is made of it
            if isinstance(each.node, ast.stmt):
                self._statement(each)
            elif not isinstance(getattr(each.node, "ctx", None), ast.Store | ast.Del):
                self.of_expression(each)
        self._tolerances()
        self._twins()

    def _twins(self) -> None:
        """One change at all places of a function where a name divides, or where a fraction is lost."""
        found: dict[tuple[Any, ...], list[Any]] = {}
        for _, node, inside in self._all:
            whole = isinstance(node, ast.BinOp) and isinstance(node.op, ast.FloorDiv)
            halved = isinstance(node, ast.BinOp) and isinstance(node.op, ast.Div)
            if whole or (halved and isinstance(node.right, ast.Name)):
                found.setdefault((id(inside), "" if whole else node.right.id), []).append(node)
        for (_, name), some in found.items():
            puts = [
                (Slot(node, "right"), expression("2 * (x)", x=node.right))
                if name
                else (self._slots[id(node)], ast.BinOp(node.left, ast.Div(), node.right))
                for node in some
            ]
            if len(puts) > 1:
                self.add("measure" if name else "whole-division", some[0], "all", *puts)

    # -- statements ------------------------------------------------------------------------------------

    def _statement(self, place: NodePlace) -> None:
        slot, node, inside = place
        own = getattr(inside, "name", "") == self.facts.entry
        if isinstance(node, ast.FunctionDef) and node.name == self.facts.entry:
            self._parameters(node)
        if isinstance(node, ast.If):
            if own and any(isinstance(each, ast.Return) for each in node.body):
                for text in self.facts.guards:
                    self.put("guard-exact", Slot(node, "test"), node, text)
            self.put("condition", Slot(node, "test"), node, "not (x)", x=node.test)
        if (
            inside is not None
            and slot.at >= 0
            and isinstance(node, ast.If | ast.AugAssign | ast.Expr | ast.Assign)
        ):
            kind = "guard-left-out" if isinstance(node, ast.If) else "statement-left-out"
            rest = node.orelse[0] if isinstance(node, ast.If) and len(node.orelse) == 1 else ast.Pass()
            self.add(kind, node, "", (slot, ast.copy_location(copy.copy(rest), node)))
        if isinstance(node, ast.Return) and own:
            value, at = node.value or ast.copy_location(ast.Constant(None), node), Slot(node, "value")
            if self.facts.several:
                self.put("order", at, node, "(x)[::-1]", x=value)
                self.put("form", at, node, "list(x or [])", x=value)
            for text in ("[]", "None"):
                self.put("form", at, node, text)
        if isinstance(node, ast.Assign | ast.Return | ast.AugAssign) and inside is not None:
            self._exchanged(node, inside)
        if isinstance(node, ast.Break):
            self.add("early", node, "", (slot, ast.Pass()))
            self.add("early", node, "next", (slot, ast.Continue()))
        elif isinstance(node, ast.Return):
            self._early(slot, node)

    def _early(self, slot: Slot, node: ast.Return) -> None:
        """A return in a loop is none, or comes once the loop is over."""
        loop = slot.parent
        while isinstance(loop, ast.If):
            loop = self._slots[id(loop)].parent
        if isinstance(loop, ast.For | ast.While):
            after = ast.If(ast.Constant(True), [loop, node], [])
            self.add("early", node, "none", (slot, ast.Pass()))
            self.add("early", node, "after", (slot, ast.Pass()), (self._slots[id(loop)], after))

    def _parameters(self, node: Any) -> None:
        given, wanted = [each.arg for each in node.args.args], [*self.facts.parameters]
        if given != wanted and sorted(given) == sorted(wanted):
            other = copy.deepcopy(node.args)
            for each, name in zip(other.args, wanted, strict=True):
                each.arg = name
            self.add("parameter-order", node, "", (Slot(node, "args"), other))

    def _exchanged(self, statement: Any, inside: Any) -> None:
        """Two names of numbers, each in place of the other in one statement."""
        uses: dict[str, list[Slot]] = {}
        for slot, node, _ in places(statement):
            loaded = isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load)
            if loaded and self.stands_for(inside, node, "number"):
                uses.setdefault(node.id, []).append(slot)
        for one, other in combinations(sorted(uses), 2):
            puts = [(slot, ast.Name(other, ast.Load())) for slot in uses[one]]
            puts += [(slot, ast.Name(one, ast.Load())) for slot in uses[other]]
            self.add("name", statement, f"{one} {other}", *puts)

    def _tolerances(self) -> None:
        """Each alone, those that are equal, and all of them."""
        small = [
            (slot, node)
            for slot, node, _ in self._all
            if (is_small(node) and not isinstance(slot.parent, ast.UnaryOp))
            or (
                isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load) and node.id in self._small_names
            )
        ]
        alike: dict[Any, list[tuple[Slot, Any]]] = {}
        for slot, node in small:
            alike.setdefault(node.id if isinstance(node, ast.Name) else literal(node), []).append(
                (slot, node)
            )
        sets = [[each] for each in small] + [each for each in alike.values() if len(each) > 1]
        for each in [*sets, small] if len(alike) > 1 else sets:
            first = min((node for _, node in each), key=lambda node: (node.lineno, node.col_offset))
            for kind, text in TOLERANCES:
                puts = []
                for slot, node in each:
                    sign = "-" if isinstance(node, ast.UnaryOp) else ""
                    puts.append((slot, expression(sign + text)))
                self.add(kind, first, f"{text} {len(each)}", *puts)
