"""Reading a Python program without running it."""

from __future__ import annotations

import ast
import warnings

LONGEST = 65_536  # bytes of a stranger's program; a tree takes six hundred times as many


def tree_of_stranger(source: bytes) -> ast.Module:
    """The tree of what anybody may have written. Raises SyntaxError as `tree_of`, and for a longer one."""
    if len(source) > LONGEST:
        raise SyntaxError("it is too long")
    return tree_of(source)


def tree_of(source: str | bytes) -> ast.Module:
    """The program's tree; what the compiler would warn of is not for whoever runs the judge.

    Raises:
        SyntaxError: it is no Python, or nested too deeply for the compiler.
    """
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return ast.parse(source)
    except ValueError as fault:  # a NUL
        raise SyntaxError(str(fault)) from fault
    except (RecursionError, MemoryError) as fault:
        raise SyntaxError("it is nested too deeply") from fault
