"""The modules that a fork server imports before its children need them, when the source names them.

Only modules that do nothing at import but define things: what a fork server has imported, it has run. The
time they take is the judge's, not the submission's. Any other module of the interpreter can be imported
too, at its own cost.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable

_STANDARD = """
    __future__ abc argparse array ast atexit bisect builtins cProfile cmath codecs collections contextlib
    contextvars copy copyreg csv dataclasses datetime decimal dis doctest enum errno faulthandler fractions
    functools gc getopt graphlib hashlib heapq importlib inspect io itertools json keyword logging math
    numbers operator os pathlib pickle platform pprint profile queue random re reprlib resource secrets signal
    statistics string struct sys tempfile textwrap threading time timeit traceback types typing unicodedata
    unittest uuid warnings weakref zlib
"""
_INSTALLED = "gmpy2 mpmath networkx numpy scipy shapely sortedcontainers sympy typing_extensions"
_SUBMODULES = """
    collections.abc os.path numpy.linalg numpy.random numpy.polynomial numpy.typing scipy.linalg
    scipy.optimize scipy.spatial sympy.geometry
"""

ALLOWED = frozenset((_STANDARD + _INSTALLED + _SUBMODULES).split())


def to_import(named: Iterable[str]) -> list[str]:
    """What to import ahead for a source that names these; an unlisted submodule counts as its top level."""
    chosen = (name if name in ALLOWED else name.partition(".")[0] for name in named)
    return [name for name in dict.fromkeys(chosen) if name in ALLOWED]
