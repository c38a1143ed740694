"""Small wrong changes of a program, one at a time: what the test data should notice.

    operators    + ↔ -, * ↔ /, // → /, % → *, ** → *, and ↔ or, min ↔ max
    signs        -x → x, abs(x) → x, not x → x
    comparisons  < ↔ <=, > ↔ >=, and every comparison by its opposite
    constants    an int by one up and down; a float doubled and halved, one below 1e-3 times and by 10,000
    names        a name read in a function → another one bound there that differs in one letter

No tool for mutation testing judges by anything but a test suite's exit status; here a mutant is a submission.
"""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass

_OPERATORS = {
    ast.Add: (ast.Sub,), ast.Sub: (ast.Add,), ast.Mult: (ast.Div,), ast.Div: (ast.Mult,),
    ast.FloorDiv: (ast.Div,), ast.Mod: (ast.Mult,), ast.Pow: (ast.Mult,),
}  # fmt: skip
_COMPARISONS = {
    ast.Lt: (ast.LtE, ast.GtE), ast.LtE: (ast.Lt, ast.Gt),
    ast.Gt: (ast.GtE, ast.LtE), ast.GtE: (ast.Gt, ast.Lt),
    ast.Eq: (ast.NotEq,), ast.NotEq: (ast.Eq,), ast.In: (ast.NotIn,), ast.NotIn: (ast.In,),
    ast.Is: (ast.IsNot,), ast.IsNot: (ast.Is,),
}  # fmt: skip
_CALLS = {"min": "max", "max": "min"}
_TINY = 1e-3
_FAR = 1e4  # a threshold is meant to lie anywhere within five powers of ten: a small step says nothing


@dataclass(frozen=True, slots=True)
class Mutant:
    """A change of the one line of a program (as `ast.unparse` writes it) that differs.

    `number` counts the mutants of one file that agree in what the line was and becomes, from 1.
    """

    was: str
    becomes: str
    number: int
    source: str  # the whole program with it


def mutants(source: str) -> list[Mutant]:
    """Every mutant of a program, in the order of its text."""
    tree = ast.parse(source)
    lines = ast.unparse(tree).splitlines()
    places, names = _places(tree), _names_around(tree)
    seen: Counter[tuple[str, str]] = Counter()
    found = []
    for node in ast.walk(tree):
        for changed in _changes(node, names.get(id(node), frozenset())):
            after = _unparsed_with(tree, places[id(node)], node, changed)
            different = [(one, other) for one, other in zip(lines, after, strict=True) if one != other]
            if different:
                ((was, becomes),) = different
                key = was.strip(), becomes.strip()
                seen[key] += 1
                found.append(Mutant(*key, seen[key], "\n".join(after) + "\n"))
    return found


Place = tuple[ast.AST, str, int | None]  # whose child a node is, by which field, and which of several


def _places(tree: ast.Module) -> dict[int, Place]:
    """Where every node is, by its id."""
    found: dict[int, Place] = {}
    for node in ast.walk(tree):
        for name, value in ast.iter_fields(node):
            several = isinstance(value, list)
            for at, child in enumerate(value if several else [value]):
                found[id(child)] = (node, name, at if several else None)
    return found


def _unparsed_with(tree: ast.Module, place: Place, node: ast.AST, other: ast.AST) -> list[str]:
    """The lines of the tree where another node stands in the place of this one, for as long as that takes."""
    _put(place, other)
    after = ast.unparse(tree).splitlines()
    _put(place, node)
    return after


def _put(place: Place, node: ast.AST) -> None:
    parent, name, at = place
    if at is None:
        setattr(parent, name, node)
    else:
        getattr(parent, name)[at] = node


def _changes(node: ast.AST, names: frozenset[str]) -> Iterator[ast.expr]:
    """What an expression may become."""
    match node:
        case ast.BinOp():
            for operator in _OPERATORS.get(type(node.op), ()):
                yield ast.BinOp(node.left, operator(), node.right)
        case ast.BoolOp():
            yield ast.BoolOp(ast.Or() if isinstance(node.op, ast.And) else ast.And(), node.values)
        case ast.UnaryOp(op=ast.USub() | ast.Not()):
            yield node.operand
        case ast.Compare():
            yield from _comparisons(node)
        case ast.Call(func=ast.Name(id="abs"), args=[argument]):
            yield argument
        case ast.Call(func=ast.Name(id=name)) if name in _CALLS:
            yield ast.Call(ast.Name(_CALLS[name], ast.Load()), node.args, node.keywords)
        case ast.Constant(value=value) if type(value) in (int, float):
            yield from (ast.Constant(other) for other in _numbers(value))
        case ast.Name(ctx=ast.Load()):
            other = _twin(node.id, names)
            if other is not None:
                yield ast.Name(other, ast.Load())


def _comparisons(node: ast.Compare) -> Iterator[ast.Compare]:
    for index, operator in enumerate(node.ops):
        for other in _COMPARISONS[type(operator)]:
            yield ast.Compare(
                node.left, [*node.ops[:index], other(), *node.ops[index + 1 :]], node.comparators
            )


def _numbers(value: float) -> tuple[float, ...]:
    if isinstance(value, int):
        return value + 1, value - 1
    if value == 0:
        return (1.0,)
    return (value * _FAR, value / _FAR) if abs(value) < _TINY else (value * 2, value / 2)


def _twin(name: str, names: frozenset[str]) -> str | None:
    """The first name of the same length that differs in one letter: ax for ay, dx for dy."""
    alike = [
        other
        for other in sorted(names)
        if len(other) == len(name) > 1 and sum(a != b for a, b in zip(name, other, strict=True)) == 1
    ]
    return alike[0] if alike else None


def _names_around(tree: ast.Module) -> dict[int, frozenset[str]]:
    """The names bound in the innermost function around each name that is read, by its id."""
    found: dict[int, frozenset[str]] = {}
    functions = [list(ast.walk(node)) for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)]
    for inside in sorted(functions, key=len, reverse=True):
        names = [each for each in inside if isinstance(each, ast.Name)]
        bound = {each.id for each in names if isinstance(each.ctx, ast.Store)}
        bound |= {argument.arg for argument in inside[0].args.args}
        found |= dict.fromkeys(map(id, names), frozenset(bound))
    return found
