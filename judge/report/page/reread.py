"""An answer's JSON form read from the text that a person was shown: all that is kept of a past run."""

from __future__ import annotations

import ast
from typing import Any

from judge.values import Raw, Type
from judge.values.lines import read_line

_LONGEST = 5000  # characters that are read


def reread(answer: Type, text: str | None) -> Raw:
    """The answer as it was given, by a function or in a program's line; None where the text is no answer."""
    if text is None or len(text) > _LONGEST:
        return None
    line = read_line(answer, text.strip())
    if not isinstance(line, str):
        return line[0]
    try:
        return _raw(ast.parse(text.strip(), mode="eval").body)
    except (SyntaxError, ValueError, MemoryError, RecursionError):
        return None


def _raw(node: ast.expr) -> Raw:
    """What a plain expression stands for; raises ValueError for any other."""
    if isinstance(node, ast.List | ast.Tuple):
        return [_raw(item) for item in node.elts]
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "Fraction":
        top, bottom = (ast.literal_eval(argument) for argument in node.args)
        return {"fraction": [_hexadecimal(top), _hexadecimal(bottom)]}
    value = ast.literal_eval(node)
    return {"word": value} if isinstance(value, str) else value


def _hexadecimal(value: Any) -> str:
    if type(value) is not int:
        raise ValueError("no part of a fraction")
    return f"{value:x}"
