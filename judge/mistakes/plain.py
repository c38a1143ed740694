"""A program as a person writes it: without what does nothing, and without names that are used once.

Comments, docstrings, names that are never read and statements below a return go. A name bound once, to
another name or for one use, makes room for its value. What a wrapper does to arguments or answer moves into
the function. A chain of numbers that is compared with each of them becomes ifs.

No value is worked out at another place where that could fail, and no line grows beyond a terminal.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Iterator
from contextlib import suppress
from copy import deepcopy
from itertools import pairwise

from judge.mistakes.transforms import ANSWER

_HARMLESS = ("abs", "copysign", "hypot", "len", "map", "max", "min")  # calls that cannot fail on valid input
_DEFERRED = (ast.Lambda, ast.FunctionDef, ast.While, ast.For)  # what is inside is worked out later, or often
_NUMBER = re.compile(r"-?\d")
_WIDTH = 79
_STYLE = (  # what Python writes otherwise than a person
    ("'", '"'),
    (r"^(.*\de-)0(\d.*)$", r"\1\2"),
    (r"^( *return|[\w, ]+ =) \((.*)\)$", r"\1 \2"),
    (r"^(.*\w\()\((.* for .*)\)\)$", r"\1\2)"),
)
_RETURNS = 3  # in which the change of an answer may be repeated
_Block = list[ast.stmt]


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
                    _chain_to_ifs(function, block)
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
    outer = functions[entry]
    at, inner = next(
        (
            (at, functions[each.value.func.id])
            for at, each in enumerate(outer.body)
            if isinstance(each, ast.Assign)
            and ast.unparse(each.targets[0]) == ANSWER
            and isinstance(each.value, ast.Call)
            and isinstance(each.value.func, ast.Name)
            and each.value.func.id in functions
            and [*map(ast.unparse, each.value.args)] == [arg.arg for arg in outer.args.args]
        ),
        (0, outer),
    )
    names = [[each.arg for each in function.args.args] for function in (outer, inner)]
    returns = [each for each in ast.walk(inner) if isinstance(each, ast.Return)]
    after = [each for each in outer.body[at + 1 : -1] if isinstance(each, ast.Assign)]
    once = all([name.id for name in _names(each, ast.Load)].count(ANSWER) == 1 for each in after)
    plain = after == outer.body[at + 1 : -1] and ast.unparse(outer.body[-1]) == f"return {ANSWER}"
    few = not after or (len(returns) <= _RETURNS and all(each.value for each in returns))
    if inner is outer or names[0] != names[1] or not (plain and once and few):
        return
    for each in after:
        for done in returns:
            done.value = _with(deepcopy(each.value), ANSWER, done.value or ast.Constant(None))
    inner.name, inner.body = entry, [*outer.body[:at], *inner.body]
    tree.body.remove(outer)


def _with(root: ast.expr, name: str, value: ast.expr) -> ast.expr:
    """The expression with a value in place of a name."""

    class With(ast.NodeTransformer):
        def visit_Name(self, node: ast.Name) -> ast.expr:
            return deepcopy(value) if node.id == name and isinstance(node.ctx, ast.Load) else node

    found: ast.expr = With().visit(root)
    return found


def _chain_to_ifs(function: ast.FunctionDef, block: _Block) -> None:
    """`x = 1 if a else 0 if b else -1`, `if x == 1: return`, `if x == 0:` with a and b in place of x."""
    for at, each in enumerate(block):
        if not (isinstance(each, ast.Assign) and isinstance(each.value, ast.IfExp)):
            continue
        tail: ast.expr = each.value
        tests: dict[str, ast.expr] = {}
        while isinstance(tail, ast.IfExp):
            tests[ast.unparse(tail.body)] = tail.test
            tail = tail.orelse
        last, name = ast.unparse(tail), ast.unparse(each.targets[0])
        asked: list[tuple[ast.If, str]] = []
        for below in block[at + 1 :]:
            words = ast.unparse(below.test).split(" == ") if isinstance(below, ast.If) else []
            if isinstance(below, ast.If) and words[0] == name and _NUMBER.fullmatch(words[-1]):
                asked.append((below, words[1]))
        reads = [read for read in _names(function, ast.Load) if read.id == name]
        whole = len(asked) == len(reads) and all(map(_NUMBER.fullmatch, (*tests, last)))
        ended = all(isinstance(below.body[-1], ast.Return) for below, _ in asked[:-1])
        order = [value for _, value in asked if value in tests]
        if not (
            asked and whole and ended and block[at + 1] is asked[0][0] and order == [*tests][: len(order)]
        ):
            continue
        if any(value == last for _, value in asked):
            continue
        never = {id(below): below.orelse for below, value in asked if value not in tests}
        for below, value in asked:
            below.test = tests.get(value, below.test)
        block[at:] = [kept for below in block[at + 1 :] for kept in never.get(id(below), [below])]
        return


def _inline(function: ast.FunctionDef, block: _Block) -> None:
    """Put the values of names in their places: those bound once, to a name, for one use or for none."""
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
    free = {read.id for read in _names(value, ast.Load)} - {own.id for own in _names(value, ast.Store)}
    if reads and (bound.count(name) != 1 or any(bound.count(other) > 1 for other in free)):
        return None
    inside = [[read for read in _names(each, ast.Load) if read.id == name] for each in below if reads]
    if sum(map(len, inside)) != len(reads) or (reads and not _moves(value, reads, below)):
        return None
    new = [*below]
    for at, own in enumerate(inside):
        if own:
            new[at] = _replaced(below[at], name, value)
            if max(map(len, ast.unparse(new[at]).splitlines())) + 4 > _WIDTH:
                return None
    return new


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


def _moves(value: ast.expr, reads: list[ast.Name], below: _Block) -> bool:
    """Whether the value may stand where it is read, which is below and neither later nor often."""
    if isinstance(value, ast.IfExp | ast.Lambda | ast.NamedExpr):
        return False
    if isinstance(value, ast.Name):
        return True
    deferred = {id(read) for each in below for node in ast.walk(each) for read in _deferred(node)}
    if len(reads) > 1 or id(reads[0]) in deferred:
        return False
    if isinstance(value, ast.ListComp | ast.GeneratorExp):  # never one within another
        inner = [node for each in below for node in ast.walk(each) if isinstance(node, ast.ListComp)]
        if any(read is reads[0] for node in inner for read in ast.walk(node)):
            return False
    surely = any(node is reads[0] for node in _surely(below[0]))
    return _cannot_fail(value) or (surely and _cannot_fail(below[0]))


def _surely(node: ast.AST) -> Iterator[ast.AST]:
    """What is worked out whenever a statement of one line, or the question of an if, is."""
    yield node
    if isinstance(node, ast.If | ast.IfExp):
        yield from _surely(node.test)
    elif isinstance(node, ast.BoolOp):
        yield from _surely(node.values[0])
    elif not hasattr(node, "body"):
        for each in ast.iter_child_nodes(node):
            yield from _surely(each)


def _deferred(node: ast.AST) -> Iterator[ast.AST]:
    """What is below a node and is worked out later than it, or more often."""
    if isinstance(node, _DEFERRED):
        yield from ast.walk(node)
    elif isinstance(node, ast.ListComp | ast.GeneratorExp | ast.SetComp | ast.DictComp):
        first = {id(each) for each in ast.walk(node.generators[0].iter)}
        yield from (each for each in ast.walk(node) if id(each) not in first)


def _cannot_fail(value: ast.AST) -> bool:
    """Whether to work it out changes nothing, and does not fail as the root of a number below 0 does."""
    parts = list(ast.walk(value))
    calls = (each.func for each in parts if isinstance(each, ast.Call))
    plain = all(isinstance(each, ast.Name) and each.id in _HARMLESS for each in calls)
    return plain and not any(isinstance(each, ast.Div | ast.FloorDiv | ast.Mod | ast.Pow) for each in parts)


def _replaced(node: ast.stmt, name: str, value: ast.expr) -> ast.stmt:
    found: ast.stmt = _with(deepcopy(node), name, value)  # type: ignore[arg-type, assignment]
    return found
