"""Reading a program of a problem's solutions without running it."""

from __future__ import annotations

import ast
import warnings


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
