"""What a program's syntax tree tells of it: whether it writes something, whether a library works for it.

Standard library only, and no import of judge: this file is handed to the contained process.
"""

from __future__ import annotations

import ast
import sys

LIBRARY, PRINT = "library", "print"
_KNOWN = sys.stdlib_module_names | {"numpy", "__future__"}


def features(text: str) -> list[str]:
    """`PRINT` where it writes something; only `LIBRARY` where it imports what is not Python's nor numpy.

    What is no Python shows none.
    """
    try:
        nodes = [*ast.walk(ast.parse(text))]
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return []
    names = [each.name for node in nodes if isinstance(node, ast.Import) for each in node.names]
    names += [node.module or "" for node in nodes if isinstance(node, ast.ImportFrom)]
    if not {name.partition(".")[0] for name in names} <= _KNOWN:
        return [LIBRARY]
    writes = any(getattr(each, "id", getattr(each, "attr", "")) in ("print", "write") for each in nodes)
    return [PRINT] if writes else []
