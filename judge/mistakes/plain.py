"""A program as a person writes it: without what does nothing, and without names that are used once.

Comments, docstrings, names that are never read and statements below a return go. A name bound once, to
another name or for the next line alone, makes room for its value. What a wrapper does to arguments or answer
moves into the function.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Iterator
from contextlib import suppress
from copy import deepcopy
from itertools import pairwise
from typing import TypeVar

from judge.mistakes.transforms import ANSWER, INNER

_HARMLESS = ("abs", "copysign", "hypot", "len", "map", "max", "min")  # calls that cannot fail on valid input
_OFTEN = (ast.Lambda, ast.ListComp, ast.GeneratorExp, ast.SetComp, ast.DictComp)
_WIDTH = 79
_STYLE = (  # what Python writes otherwise than a person
    ("'", '"'),
    (r"^(.*\de-)0(\d.*)$", r"\1\2"),
    (r"^( *return|[\w, ]+ =) \((.*)\)$", r"\1 \2"),
    (r"^(.*\w\()\((.* for .*)\)\)$", r"\1\2)"),
)
_RETURNS = 3  # in which the change of an answer may be repeated
_Block = list[ast.stmt]
_Node = TypeVar("_Node", bound=ast.AST)


def as_written(source: str, entry: str) -> str:
    """The program, which answers alike. Without an `entry` nothing at its top level is left out."""
    tree, before = ast.parse(source), ""
    while (now := ast.dump(tree)) != before:
        before = now
        if entry:
            _move_wrapper(tree, entry)
            tree.body = list(_used(tree, entry))
        for block in _blocks(tree):
            block[:] = list(_needed(block))
        for function in tree.body:
            if isinstance(function, ast.FunctionDef):
                for block in _blocks(function):
                    _inline(function, block)
    return _text(tree)


def _text(tree: ast.Module) -> str:
    """The source: imports together, and two empty lines around a function."""
    parts = [ast.unparse(ast.fix_missing_locations(node)) for node in tree.body]
    plain = [isinstance(node, ast.Import | ast.ImportFrom | ast.Assign) for node in tree.body]
    gaps = ["\n" if a and b else "\n\n\n" for a, b in pairwise(plain)]
    whole = "".join(part + gap for part, gap in zip(parts, [*gaps, "\n"], strict=True))
    return "".join(map(_restyled, whole.splitlines(keepends=True)))


def _restyled(row: str) -> str:
    """The line with what a person writes otherwise than Python, as long as it says the same."""
    for pattern, instead in _STYLE:
        new = re.sub(pattern, instead, row)
        row = new if _said(new) == _said(row) else row
    return row


def _said(row: str) -> str:
    """What a line says, by itself or as the head of a block."""
    for whole in (row.strip(), f"{row.strip()} pass", f"if 0: pass\n{row.strip()} pass"):
        with suppress(SyntaxError):
            return ast.dump(ast.parse(whole))
    return row


def _blocks(root: ast.AST) -> Iterator[_Block]:
    """Every list of statements below."""
    for node in ast.walk(root):
        for name in ("body", "orelse", "finalbody"):
            block = getattr(node, name, None)
            if isinstance(block, list):
                yield block


def _names(root: ast.AST | Iterable[ast.AST], kind: type[ast.expr_context]) -> list[ast.Name]:
    """The names below that are read, or bound."""
    roots = [root] if isinstance(root, ast.AST) else root
    every = (node for each in roots for node in ast.walk(each))
    return [node for node in every if isinstance(node, ast.Name) and isinstance(node.ctx, kind)]


# -- what does nothing ---------------------------------------------------------------------------------------


def _needed(block: _Block) -> Iterator[ast.stmt]:
    """The statements of a block that do something there, at least one."""
    kept = []
    for each in block:
        text = isinstance(each, ast.Expr) and isinstance(each.value, ast.Constant)
        if not (text or isinstance(each, ast.Pass)):
            kept.append(each)
        if isinstance(each, ast.Return | ast.Raise | ast.Continue | ast.Break):
            break
    yield from kept or block[:1]


def _used(tree: ast.Module, entry: str) -> Iterator[ast.stmt]:
    """What stands at the top level and the `entry` leads to."""
    wanted, fresh = {entry}, {entry}
    while fresh:
        parts = [part for node in tree.body if wanted & _bound(node) for part in ast.walk(node)]
        used = {part.id for part in parts if isinstance(part, ast.Name)}
        wanted, fresh = wanted | used, used - wanted
    for node in tree.body:
        if isinstance(node, ast.ImportFrom):
            node.names = [each for each in node.names if (each.asname or each.name) in wanted]
        bound = _bound(node)
        if not wanted.isdisjoint(bound) or not (bound or isinstance(node, ast.ImportFrom)):
            yield node


def _bound(node: ast.stmt) -> set[str]:
    """The names that a statement outside of functions gives a meaning to."""
    if isinstance(node, ast.FunctionDef | ast.ClassDef):
        return {node.name}
    if isinstance(node, ast.Import | ast.ImportFrom):
        return {(each.asname or each.name).partition(".")[0] for each in node.names}
    return {each.id for each in _names(node, ast.Store)} if isinstance(node, ast.Assign) else set()


# -- what stands in another place ----------------------------------------------------------------------------


def _move_wrapper(tree: ast.Module, entry: str) -> None:
    """Let the function that the entry calls be the entry, with what is done before and after the call."""
    functions = {each.name: each for each in tree.body if isinstance(each, ast.FunctionDef)}
    outer, inner = functions[entry], functions.get(INNER)
    rows = [*map(ast.unparse, outer.body)]
    call = f"{ANSWER} = {INNER}({', '.join(each.arg for each in outer.args.args)})"
    if inner is None or call not in rows or rows[-1] != f"return {ANSWER}":
        return
    at = rows.index(call)
    after = [each.value for each in outer.body[at + 1 : -1] if isinstance(each, ast.Assign)]
    returns = [each for each in ast.walk(inner) if isinstance(each, ast.Return)]
    once = all([name.id for name in _names(each, ast.Load)].count(ANSWER) == 1 for each in after)
    if after and not (once and len(returns) <= _RETURNS and all(each.value for each in returns)):
        return
    for each in after:
        for done in returns:
            done.value = _with(each, ANSWER, done.value or ast.Constant(None))
    inner.name, inner.body = entry, [*outer.body[:at], *inner.body]
    tree.body.remove(outer)


def _with(root: _Node, name: str, value: ast.expr) -> _Node:
    """A copy of a node with a value in place of a name."""

    class With(ast.NodeTransformer):
        def visit_Name(self, node: ast.Name) -> ast.expr:
            return deepcopy(value) if node.id == name and isinstance(node.ctx, ast.Load) else node

    found: _Node = With().visit(deepcopy(root))
    return found


def _inline(function: ast.FunctionDef, block: _Block) -> None:
    """Put the values of names in their places: those bound once, to a name, for the next line or for none."""
    at = 0
    bound = [each.id for each in _names(function, ast.Store)] + [each.arg for each in function.args.args]
    parts = list(ast.walk(function))
    changed = {ast.unparse(each.target) for each in parts if isinstance(each, ast.AugAssign)}
    changed |= {name for each in parts if isinstance(each, ast.Global | ast.Nonlocal) for name in each.names}
    reads = _names(function, ast.Load)
    while at < len(block):
        each = block[at]
        at += 1
        pairs = _pairs(each) if isinstance(each, ast.Assign) and len(each.targets) == 1 else []
        for place, (name, value) in enumerate(pairs):
            if name in changed:
                continue
            own = [read for read in reads if read.id == name]
            new = _moved(name, value, own, bound, block[at:]) if own or _cannot_fail(value) else None
            if new is not None:
                at -= 1
                block[at:] = [*_assigned([*pairs[:place], *pairs[place + 1 :]]), *new]
                reads = _names(function, ast.Load)
                break


def _moved(
    name: str, value: ast.expr, reads: list[ast.Name], bound: list[str], below: _Block
) -> _Block | None:
    """The statements below with the value in place of the name; None where that cannot be."""
    if not reads:
        return below
    free = {read.id for read in _names(value, ast.Load)} - {own.id for own in _names(value, ast.Store)}
    if bound.count(name) != 1 or any(bound.count(other) > 1 for other in free):
        return None
    inside = [read for read in _names(below, ast.Load) if read.id == name]
    if len(inside) != len(reads) or not (isinstance(value, ast.Name) or _is_next(value, reads, below)):
        return None
    new = [_with(each, name, value) for each in below]
    return new if isinstance(value, ast.Name) or len(ast.unparse(new[0])) + 4 <= _WIDTH else None


def _is_next(value: ast.expr, reads: list[ast.Name], below: _Block) -> bool:
    """Whether the value is read once, by the plain statement that follows, and may be worked out there."""
    if len(reads) > 1 or not isinstance(below[0], ast.Assign | ast.Return):
        return False
    parts = [*ast.walk(below[0])]
    if any(isinstance(each, _OFTEN) for each in parts) or not any(each is reads[0] for each in parts):
        return False
    surely = not any(isinstance(each, ast.IfExp | ast.BoolOp) for each in parts)
    return _cannot_fail(value) or (surely and _cannot_fail(below[0]))


def _pairs(each: ast.Assign) -> list[tuple[str, ast.expr]]:
    """The names that an assignment binds, with the value of each; empty where that is not plain."""
    target, value = each.targets[0], each.value
    several = isinstance(target, ast.Tuple) and isinstance(value, ast.Tuple)
    names = target.elts if several and isinstance(target, ast.Tuple) else [target]
    values = value.elts if several and isinstance(value, ast.Tuple) else [value]
    plain = len(names) == len(values) and all(isinstance(name, ast.Name) for name in names)
    return [*zip(map(ast.unparse, names), values, strict=True)] if plain else []


def _assigned(pairs: list[tuple[str, ast.expr]]) -> Iterator[ast.stmt]:
    if pairs:
        names, values = zip(*pairs, strict=True)
        yield from ast.parse(f"{', '.join(names)} = {', '.join(map(ast.unparse, values))}").body


def _cannot_fail(value: ast.AST) -> bool:
    """Whether to work it out changes nothing, and does not fail as the root of a number below 0 does."""
    parts = list(ast.walk(value))
    calls = (each.func for each in parts if isinstance(each, ast.Call))
    plain = all(isinstance(each, ast.Name) and each.id in _HARMLESS for each in calls)
    return plain and not any(isinstance(each, ast.Div | ast.FloorDiv | ast.Mod | ast.Pow) for each in parts)
