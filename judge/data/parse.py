"""A case that a person wrote: as Python arguments, as a call, or as the line that a program reads.

    0, 0, 1, (-1, 1), (1, 1)                 by place
    cx=0, cy=0, r=1, A=(-1, 1), B=(1, 1)     by name
    line_count(0, 0, 1, (-1, 1), (1, 1))     the call itself, as in the statement's examples
    0 0 1 -1 1 1 1                           the line

Numbers may be sums, products, quotients and powers: 2**0.5, 1e8 + 1e-7. Nothing else is worked out.
"""

from __future__ import annotations

import ast
import math
import operator
import warnings
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from judge.errors import UsageError, nearest
from judge.problem import Case, Parameter, Problem
from judge.problem.model import tupled
from judge.values import parameters

_LONGEST = 20_000  # characters of a case
_SHORT = 80  # characters of an example
_MOST_BITS = 4_000  # of an int that a power makes
_DEEPEST = 20  # of brackets in brackets
_OPERATORS: Mapping[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: operator.pow,
}


def read_case(problem: Problem, text: str) -> Case:
    """The case that the text holds, one argument for each parameter; whether it is sound is not looked at.

    Raises:
        UsageError: it is written in no such way; it says what is wrong and how a case is written.
    """
    if not problem.parameters and "(" not in text:
        remedy = f"'judge run {problem.id} FILE' judges it"
        what = f"{problem.entry}() of {problem.id} takes nothing, so there is no case"
        raise UsageError(what, remedy=remedy)
    text = text.strip()
    if not text:
        raise UsageError(f'Give a case: judge try {problem.id} "{example_of(problem)}"')
    if len(text) > _LONGEST:
        raise _unreadable(problem, f"a case of {len(text):,} characters is too long")
    return _python(problem, text) if any(sign in text for sign in ",=([") else _line(problem, text)


def line_of(problem: Problem, case: Case) -> str:
    """The line that a program reads for a case."""
    pairs = zip(problem.parameters, case, strict=True)
    return " ".join(word for parameter, value in pairs for word in parameters.tokens(parameter.type, value))


def call_of(problem: Problem) -> str:
    """How a case is written: `cx, cy, r, A, B`."""
    return ", ".join(parameter.name for parameter in problem.parameters)


def example_of(problem: Problem) -> str:
    """The statement's first example as arguments, `0, 0, 1, (-1, 1), (1, 1)`; their names if it is long."""
    values = problem.named(problem.examples[0].case).values() if problem.examples else ()
    text = ", ".join(map(repr, values))
    return text if 0 < len(text) <= _SHORT else call_of(problem)


# -- the line of a program ----------------------------------------------------------------------------------


def _line(problem: Problem, text: str) -> Case:
    words = text.split()
    taken = iter(words)
    case = tuple([_from_words(problem, parameter, taken) for parameter in problem.parameters])
    surplus = list(taken)
    if surplus:
        raise _unreadable(problem, f"{_quoted(surplus[0])} is left over after {problem.parameters[-1].name}")
    return case


def _from_words(problem: Problem, parameter: Parameter, words: Iterator[str]) -> Any:
    seen: list[str] = []

    def watched() -> Iterator[str]:
        for word in words:
            seen.append(word)
            yield word

    try:
        return parameters.from_tokens(parameter.type, watched())
    except (StopIteration, RuntimeError):  # the latter where a generator of ours has met the end
        raise _unreadable(problem, f"the numbers end before {parameter.name} is complete") from None
    except (ValueError, OverflowError):
        kind = "point. Write (3, 4)" if "point" in str(parameter.type) else f"value of {parameter.name}"
        raise UsageError(f"{_quoted(seen[-1] if seen else '')} is not a {kind}") from None


# -- Python -------------------------------------------------------------------------------------------------


def _python(problem: Problem, text: str) -> Case:
    call = _call(problem, text)
    names = [parameter.name for parameter in problem.parameters]
    given = len(call.args)
    if given > len(names) or (given < len(names) and not call.keywords):
        what = f"{len(names)} argument{'s' * (len(names) > 1)} expected ({call_of(problem)}), {given} given"
        raise _unreadable(problem, what)
    found: dict[str, Any] = {}
    for name, node in zip(names, call.args, strict=False):
        found[name] = _argument(problem, name, node)
    for keyword in call.keywords:
        if keyword.arg is None or keyword.arg not in names:
            meant = nearest(keyword.arg or "", names)
            hint = f"; did you mean {meant}?" if meant else ""
            raise _unreadable(problem, f"there is no parameter {keyword.arg or '**'}{hint}")
        if keyword.arg in found:
            raise _unreadable(problem, f"{keyword.arg} is given twice")
        found[keyword.arg] = _argument(problem, keyword.arg, keyword.value)
    lacking = [name for name in names if name not in found]
    if lacking:
        raise _unreadable(problem, f"{' and '.join(lacking[:3])} {'are' if lacking[1:] else 'is'} missing")
    return tuple([found[name] for name in names])


def _call(problem: Problem, text: str) -> ast.Call:
    """The call that the text is, or the one with these arguments."""
    why = "not arguments"
    for source in (text, f"_({text})"):
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # of what is odd in a person's text; it is judged below
                node = ast.parse(source, mode="eval").body
        except (SyntaxError, ValueError, RecursionError, MemoryError) as fault:
            why = str(getattr(fault, "msg", fault)).split("; ")[0].lower() or "nested too deeply"
            continue
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            if node.func.id in ("_", problem.entry):
                return node
            raise _unreadable(problem, f"{node.func.id} is not {problem.entry}")
    raise _unreadable(problem, f"this is not Python ({why})")


def _argument(problem: Problem, name: str, node: ast.expr) -> Any:
    try:
        return tupled(_value(node, 0))
    except OverflowError:  # of which Python says (34, 'Numerical result out of range')
        raise _unreadable(problem, f"{name}: a number is too large") from None
    except (ValueError, TypeError, ArithmeticError, RecursionError) as fault:
        raise _unreadable(problem, f"{name}: {fault}") from None


def _value(node: ast.expr, depth: int) -> Any:
    """What an expression of plain values comes to. Raises ValueError, TypeError or ArithmeticError."""
    if depth > _DEEPEST:
        raise ValueError("nested too deeply")
    if isinstance(node, ast.Constant) and (node.value is None or type(node.value) in (int, float, str)):
        return node.value
    if isinstance(node, ast.Tuple | ast.List):
        return [_value(each, depth + 1) for each in node.elts]
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub | ast.UAdd):
        number = _number(node.operand, depth)
        return -number if isinstance(node.op, ast.USub) else number
    if isinstance(node, ast.BinOp) and type(node.op) in _OPERATORS:
        left, right = _number(node.left, depth), _number(node.right, depth)
        if isinstance(node.op, ast.Pow):
            _check_power(left, right)
        found = _OPERATORS[type(node.op)](left, right)
        if not isinstance(found, int | float) or (isinstance(found, float) and not math.isfinite(found)):
            raise ValueError("a number is not finite or not real")
        return found
    raise ValueError(f"{_quoted(ast.unparse(node))} is not a plain value")


def _number(node: ast.expr, depth: int) -> int | float:
    found = _value(node, depth + 1)
    if not isinstance(found, int | float):
        raise TypeError(f"{_quoted(ast.unparse(node))} is not a number")
    return found


def _check_power(left: float, right: float) -> None:
    if isinstance(left, int) and isinstance(right, int) and abs(left).bit_length() * abs(right) > _MOST_BITS:
        raise ValueError("a power is too large")


def _quoted(text: str) -> str:
    return repr(text if len(text) <= 40 else f"{text[:40]}…")


def _unreadable(problem: Problem, what: str) -> UsageError:
    return UsageError(what, remedy=f'write a case of {problem.id} as "{example_of(problem)}"')
