"""Reading a Python program without running it."""

from __future__ import annotations

import ast
import re
import warnings

LONGEST = 65_536  # bytes of a stranger's program; a tree takes six hundred times as many
_ENDLESS = re.compile(r"[^\x00-\x7f]{1000}")  # accents upon accents, which Python sorts in a name one by one


def tree_of_stranger(source: bytes) -> ast.Module:
    """The tree of what anybody may have written. Raises SyntaxError as `tree_of`, and for a longer one.

    What encoding the program says that it has is not believed: some make accents of plain letters.
    """
    if len(source) > LONGEST:
        raise SyntaxError("it is too long")
    try:
        text = source.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = source.decode("latin-1")
    if _ENDLESS.search(text):
        raise SyntaxError("a word in it is too long")
    return tree_of(text)


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
