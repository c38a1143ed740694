"""A case that a person wrote: as Python arguments, as a call, or as the line that a program reads.

    0, 0, 1, (-1, 1), (1, 1)                 by place
    cx=0, cy=0, r=1, A=(-1, 1), B=(1, 1)     by name
    line_count(0, 0, 1, (-1, 1), (1, 1))     the call itself, as in the statement's examples
    0 0 1 -1 1 1 1                           the line

Numbers may be sums, products, quotients and powers: 2**0.5, 1e8 + 1e-7. Nothing else is worked out. Where a
text is wanted, 'aab' in quotation marks is read as Python, and aab without them as a program reads it.
"""

from __future__ import annotations

import ast
import math
import operator
import re
import warnings
from collections.abc import Callable, Mapping
from typing import Any

from judge.data.build import shape_fault
from judge.errors import UsageError, nearest
from judge.problem import Case, Problem
from judge.values import parameters, wire
from judge.values.letters import texts_of

_LONGEST = 20_000  # characters of a case
_SHORT = 80  # characters of an example
_MOST_BITS = 4_000  # of an int that a power makes
_DEEPEST = 20  # of brackets in brackets
_NOT_FINITE = re.compile(r"[-+]?(nan|inf(inity)?)")
_BASED = re.compile(r"[-+]?0([xX][0-9a-fA-F]+|[oO][0-7]+|[bB][01]+)")
_COMMA = re.compile(r"[-+]?\d+,\d+")
_ROOT = re.compile(r"\b(?:math\.)?sqrt\(([^()]*)\)")
_OPERATORS: Mapping[type[ast.AST], Callable[..., Any]] = {
    ast.UAdd: operator.pos,
    ast.USub: operator.neg,
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: operator.pow,
}


def read_case(problem: Problem, text: str) -> Case:
    """The case that the text holds, one argument for each parameter; whether it is sound is not looked at.

    Raises UsageError where it is written in no such way; it says what is wrong and how a case is written.
    """
    if not problem.parameters and "(" not in text:
        what = f"{problem.entry}() of {problem.id} takes nothing, so there is no case"
        raise UsageError(what, remedy=f"'judge run {problem.id} FILE' judges it")
    text = text.strip()
    if not text:
        raise UsageError(f'Give a case: judge try {problem.id} "{example_of(problem)}"')
    if len(text) > _LONGEST:
        raise _unreadable(problem, f"a case of {len(text):,} characters is too long")
    if any(texts_of(parameter.type) for parameter in problem.parameters):
        return _with_texts(problem, text)
    _refuse_odd_numbers(text)
    return _python(problem, text) if any(sign in text for sign in ",=([{") else _line(problem, text.split())


def _with_texts(problem: Problem, text: str) -> Case:
    """Python or the line, whichever makes a case; a text may hold all that tells them apart otherwise."""
    why: UsageError | None = None
    for read in (_python, lambda problem, text: _line(problem, wire.tokens(text))):
        try:
            case = read(problem, text)
        except UsageError as error:
            why = why or error
        else:
            fault = shape_fault(problem, case)
            if fault is None:
                return case
            why = why or _unreadable(problem, fault)
    if why is not None:
        raise why
    return _python(problem, text)


def line_of(problem: Problem, case: Case) -> str:
    """The line that a program reads for a case."""
    pairs = zip(problem.parameters, case, strict=True)
    return " ".join(word for parameter, value in pairs for word in parameters.tokens(parameter.type, value))


def call_of(problem: Problem) -> str:
    """How a case is written: `cx, cy, r, A, B`."""
    return ", ".join(parameter.name for parameter in problem.parameters)


def example_of(problem: Problem) -> str:
    """The statement's first example as arguments, `0, 0, 1, (-1, 1), (1, 1)`; their names if it is long."""
    values = [*problem.named(problem.examples[0].case).values()] if problem.examples else []
    if values and problem.methods:
        values[-1] = values[-1][:2]  # of the calls
    text = ", ".join(map(repr, values))
    return text if 0 < len(text) <= _SHORT else call_of(problem)


def _refuse_odd_numbers(text: str) -> None:
    """UsageError for a number as other languages write it, with what to write instead."""
    words, numbers = text.split(), re.findall(r"[^\s,()\[\]]+", text)
    for place, number in enumerate(numbers, 1):
        if _NOT_FINITE.fullmatch(number.lower()):
            raise UsageError(f"{number}, number {place} of {len(numbers)}: not a finite number")
    for word in words:
        if _COMMA.fullmatch(word) and words[1:]:
            raise UsageError(f"{word}: write {word.replace(',', '.')}")
        if _BASED.fullmatch(word):
            raise UsageError(f"{word}: write {int(word, 0)}")
    if root := _ROOT.search(text):
        inner = root[1] if root[1].strip().isalnum() else f"({root[1]})"
        raise UsageError(f"{root[0]}: write {inner.strip()}**0.5")


# -- the line of a program ----------------------------------------------------------------------------------


def _line(problem: Problem, words: list[str]) -> Case:
    left = iter(words)
    case = []
    for each in problem.parameters:
        try:
            case.append(parameters.from_tokens(each.type, left))
        except StopIteration:
            _count_numbers(problem, len(words))
            raise _unreadable(problem, f"the numbers end before {each.name} is complete") from None
        except (ValueError, OverflowError):
            bad = words[len(words) - len(list(left)) - 1]
            kind = "point. Write (3, 4)" if "point" in str(each.type) else f"value of {each.name}"
            raise UsageError(f"{_quoted(bad)} is not a {kind}") from None
    if (surplus := next(left, None)) is not None:
        _count_numbers(problem, len(words))
        raise _unreadable(problem, f"{_quoted(surplus)} is left over after {problem.parameters[-1].name}")
    return tuple(case)


def _count_numbers(problem: Problem, given: int) -> None:
    """UsageError where a case's numbers are so many, and it has others; it names them."""
    widths = [parameter.type.width for parameter in problem.parameters]
    if not set(widths) <= {1, 2}:
        return
    pairs = zip(problem.parameters, widths, strict=True)
    names = [each.name if width == 1 else "{0}x {0}y".format(each.name.lower()) for each, width in pairs]
    needed = len(" ".join(names).split())
    if given != needed:
        numbers = f"{given} number{'s' * (given > 1)}, {needed} {'are' if needed > 1 else 'is'} needed"
        raise _unreadable(problem, f"{numbers}: {' '.join(names)}")


# -- Python -------------------------------------------------------------------------------------------------


def _python(problem: Problem, text: str) -> Case:
    call = _call(problem, text)
    names = [parameter.name for parameter in problem.parameters]
    given = len(call.args)
    if given == 1 < len(names) and isinstance(call.args[0], ast.List | ast.Dict | ast.Set):
        raise UsageError(f"A case is not JSON. Write: {example_of(problem)}")
    if given < len(names) and not call.keywords and all(isinstance(each, ast.Constant) for each in call.args):
        _count_numbers(problem, given)
    if given > len(names) or (given < len(names) and not call.keywords):
        what = f"{len(names)} argument{'s' * (len(names) > 1)} expected ({call_of(problem)}), {given} given"
        raise _unreadable(problem, what)
    found: dict[str, Any] = {}
    keywords = [(each.arg or "**", each.value) for each in call.keywords]
    for name, node in [*zip(names, call.args, strict=False), *keywords]:
        if name not in names:
            near = nearest(name, names)
            hint = f"; did you mean {near}?" if near else ""
            raise _unreadable(problem, f"there is no parameter {name}{hint}")
        if name in found:
            raise _unreadable(problem, f"{name} is given twice")
        try:
            found[name] = _value(node)
        except OverflowError:  # of which Python says (34, 'Numerical result out of range')
            raise _unreadable(problem, f"{name}: a number is too large") from None
        except (ValueError, TypeError, ArithmeticError, RecursionError) as fault:
            raise _unreadable(problem, f"{name}: {fault}") from None
    if lacking := [name for name in names if name not in found]:
        raise _unreadable(problem, f"{' and '.join(lacking[:3])} {'are' if lacking[1:] else 'is'} missing")
    return problem.kept(tuple([found[name] for name in names]))


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


def _value(node: ast.expr, depth: int = 0) -> Any:
    """What an expression of plain values comes to. Raises ValueError, TypeError or ArithmeticError."""
    if depth > _DEEPEST:
        raise ValueError("nested too deeply")
    match node:
        case ast.Constant(value) if value is None or type(value) in (bool, int, float, str):
            return value
        case ast.Tuple(parts) | ast.List(parts):
            return tuple([_value(each, depth + 1) for each in parts])
        case ast.Dict(keys, parts) if None not in keys:
            return {
                _value(key, depth + 1): _value(part, depth + 1)
                for key, part in zip(keys, parts, strict=True)
                if key
            }
        case ast.UnaryOp(sign, inner) if type(sign) in _OPERATORS:
            return _OPERATORS[type(sign)](_number(inner, depth))
        case ast.BinOp(first, sign, second) if type(sign) in _OPERATORS:
            left, right = _number(first, depth), _number(second, depth)
            whole = isinstance(left, int) and isinstance(right, int)
            if whole and isinstance(sign, ast.Pow) and int(left).bit_length() * abs(right) > _MOST_BITS:
                raise ValueError("a power is too large")
            found = _OPERATORS[type(sign)](left, right)
            if isinstance(found, complex) or (isinstance(found, float) and not math.isfinite(found)):
                raise ValueError("a number is not finite or not real")
            return found
    raise ValueError(f"{_quoted(ast.unparse(node))} is not a plain value")


def _number(node: ast.expr, depth: int) -> int | float:
    found = _value(node, depth + 1)
    if isinstance(found, bool) or not isinstance(found, int | float):
        raise TypeError(f"{_quoted(ast.unparse(node))} is not a number")
    return found


def _quoted(text: str) -> str:
    return repr(text if len(text) <= 40 else f"{text[:40]}…")


def _unreadable(problem: Problem, what: str) -> UsageError:
    return UsageError(what, remedy=f'write a case of {problem.id} as "{example_of(problem)}"')
