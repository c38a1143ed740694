"""Mistakes made before a right way begins, with its input, or after it has ended, with its answer.

They are lines of Python around a call of the right way, written once for all problems:

    those of this file      for whatever has parameters and an answer of fitting types; those that come from
                            the types alone are `offered` as names, and no group need reject them
    `edits` of a mistake    in mistakes.toml, for the problems with the parameters that they assign
"""

from __future__ import annotations

import ast
from collections.abc import Iterator

from msgspec import Struct

from judge.errors import ProblemError
from judge.mistakes.catalogue import FILE, Catalogue
from judge.problem import Problem
from judge.values.atoms import IntType, Type
from judge.values.letters import BoolType, TextType
from judge.values.types import DictType, ListType, lasting

HELPERS = '''\
def each(value, change):
    """The value with every number in it changed."""
    if isinstance(value, dict):
        return {key: each(item, change) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return type(value)([each(item, change) for item in value])
    if value is None or isinstance(value, (bool, str)):
        return value
    return change(value)


def single(x):
    """The nearest 32-bit float."""
    import struct

    try:
        return struct.unpack("f", struct.pack("f", x))[0]
    except OverflowError:
        return float("inf") if x > 0 else float("-inf")


def wrapped(x, bits):
    """A whole number as an integer of so many bits holds it."""
    return (int(x) + (1 << bits - 1)) % (1 << bits) - (1 << bits - 1)


KEPT = {}'''

_PLACES = (2, 3, 4, 6, 8, 9, 12)
_DIGITS = (6, 8)
_CUTS = (32, 64, 255)
_BY_TYPE: dict[type[Type], tuple[tuple[str, str], ...]] = {  # the first that fits
    BoolType: (("negated", "not answer"),),
    TextType: (
        ("other-case", "answer.swapcase()"),
        ("other-case", "answer.upper()"),
        ("other-case", "answer.lower()"),
        ("stripped", "answer.strip()"),
        ("reversed-text", "answer[::-1]"),
        ("first-letter-lost", "answer[1:]"),
        ("last-letter-lost", "answer[:-1]"),
    ),
    DictType: (("last-item-lost", "dict([*answer.items()][:-1])"),),
    ListType: (
        ("sorted-answer", "sorted(answer)"),
        ("each-once", "[item for at, item in enumerate(answer) if item not in answer[:at]]"),
        ("last-item-lost", "answer[:-1]"),
    ),
    IntType: (("one-too-many", "answer + 1"), ("one-too-few", "answer - 1")),
}
ANSWER = "answer"
INNER = "inner"  # what a right way is called below such a line
KEPT_BETWEEN_CALLS = "kept-between-calls"


class Transform(Struct, frozen=True):
    """A mistake by its name, and the line that makes it, before the right way is called or `after` it.

    `text` is said of it instead of what mistakes.toml says. One that is `offered` may be no mistake here.
    """

    name: str
    line: str
    after: bool = False
    text: str = ""
    offered: bool = False


def transforms(problem: Problem, catalogue: Catalogue) -> tuple[Transform, ...]:
    """Those that make sense for a problem's parameters and answer. Raises ProblemError."""
    usual = (*_before(problem), *_after(problem), *_kept(problem), *_of_pack(problem, catalogue))
    return (*usual, *_of_types(problem))


def _before(problem: Problem) -> Iterator[Transform]:
    every = "".join(f"{each.name}, " for each in problem.parameters)

    def changed(name: str, change: str) -> Transform:
        return Transform(name, f"{every.rstrip(' ')} = each(({every.rstrip(' ')}), {change})")

    yield changed("whole-numbers", "int")
    yield changed("whole-numbers", "round")
    for places in _PLACES:
        yield changed("rounded-input", f"lambda x: round(x, {places})")
    yield changed("single-precision", "single")
    yield changed("float-coordinates", "lambda x: int(float(x))")
    for each in problem.parameters:
        if each.type.width == 2:
            yield Transform("swapped-coordinates", f"{each.name} = {each.name}[::-1]")


def _after(problem: Problem) -> Iterator[Transform]:
    answer = problem.answer
    if answer.measured:
        for places in _PLACES:
            yield _answered("rounded-output", f"each(answer, lambda x: round(x, {places}))")
        for digits in _DIGITS:
            yield _answered("rounded-output", f'each(answer, lambda x: float(f"{{x:.{digits}g}}"))')
        yield _answered("single-precision", "each(answer, single)")
        yield _answered("whole-numbers", "each(answer, int)")
    if answer.lengths > 1:
        several = "answer if answer is None else"
        is_dict = isinstance(lasting(answer), DictType)
        if not is_dict:
            yield _answered("reversed-order", f"{several} answer[::-1]")
        yield _answered("none-for-empty", "answer or None")
        if answer.width is None and not is_dict:
            yield _answered("swapped-coordinates", f"{several} [item[::-1] for item in answer]")


def _of_types(problem: Problem) -> Iterator[Transform]:
    """What people do to a value of such a type."""
    answer = lasting(problem.answer)
    ways = next((ways for type_, ways in _BY_TYPE.items() if isinstance(answer, type_)), ())
    for name, expression in ways:
        line = f"answer = answer if answer is None else {expression}"
        yield Transform(name, line, after=True, offered=True)
    for each in problem.parameters:
        if isinstance(each.type, TextType):
            for most in _CUTS:
                if most < each.type.high:
                    text = f"Only the first {most} letters of {each.name} are looked at. Read all of it."
                    yield Transform(
                        "cut-after-n", f"{each.name} = {each.name}[:{most}]", text=text, offered=True
                    )


def _answered(name: str, expression: str) -> Transform:
    return Transform(name, f"answer = {expression}", after=True)


def _kept(problem: Problem) -> Iterator[Transform]:
    """Answers that are kept for the next call under too few of the arguments: all but one, the first of them,
    or the last.
    """
    names = [each.name for each in problem.parameters]
    keys = [[*names[:i], *names[i + 1 :]] for i in range(len(names))]
    keys += [part for i in range(1, len(names)) for part in (names[:i], names[i:])]
    for key in sorted(set(map(tuple, keys))):
        left = [name for name in names if name not in key]
        line = f"answer = KEPT.setdefault(repr([{', '.join(key)}]), answer)"
        text = (
            f"An answer is kept for later calls, whatever {' and '.join(left)} "
            f"{'are' if left[1:] else 'is'} by then. Make all arguments the key, or keep nothing."
        )
        yield Transform(KEPT_BETWEEN_CALLS, line, after=True, text=text)


def _of_pack(problem: Problem, catalogue: Catalogue) -> Iterator[Transform]:
    """The edits of mistakes.toml that assign nothing but parameters of this problem, or its answer."""
    known = {ANSWER, *(each.name for each in problem.parameters)}
    for name, words in catalogue.items():
        for line, text in words.edits.items():
            try:
                nodes = list(ast.walk(ast.parse(line)))
            except SyntaxError as fault:
                where = f"{problem.solutions.parent.name}/{FILE}"
                what = f"the edit {line!r} of [{name}] is not Python: {fault.msg}"
                raise ProblemError(what, where=where, remedy="repair this line") from None
            assigned = {
                node.id for node in nodes if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)
            }
            if assigned and assigned <= known:
                yield Transform(name, line, ANSWER in assigned, text)
