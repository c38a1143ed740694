"""The modules that a fork server imports before its children need them, when the source names them.

Only modules that do nothing at import but define things: what a fork server has imported, it has run. The
time they take is the judge's, not the submission's. Any other module of the interpreter can be imported
too, at its own cost.
"""

from __future__ import annotations

from collections.abc import Iterable

_STANDARD = """
    __future__ abc array bisect cmath collections contextlib copy dataclasses decimal enum fractions functools
    heapq io itertools json math numbers operator os random re statistics string struct sys textwrap threading
    time traceback types typing
"""
_INSTALLED = "gmpy2 mpmath networkx numpy scipy shapely sortedcontainers sympy"
_SUBMODULES = """
    collections.abc os.path numpy.linalg numpy.random numpy.polynomial numpy.typing scipy.linalg
    scipy.optimize scipy.spatial sympy.geometry
"""

ALLOWED = frozenset((_STANDARD + _INSTALLED + _SUBMODULES).split())


def to_import(named: Iterable[str]) -> list[str]:
    """What to import ahead for a source that names these; an unlisted submodule counts as its top level."""
    chosen = (name if name in ALLOWED else name.partition(".")[0] for name in named)
    return [name for name in dict.fromkeys(chosen) if name in ALLOWED]
