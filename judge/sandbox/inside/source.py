"""Reading a source without running it: its fault, the names it binds, the modules it asks for.

Works on the compiler's own tree; the `ast` module takes longer to import than the tree to walk.
"""

from __future__ import annotations

import _ast
import os
import sys

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator
    from types import TracebackType
    from typing import Any

MOST_NAMES = 10_000
TEXT_LENGTH = 500

_NAME_OF: Any = type.__dict__["__name__"].__get__  # whatever a class of its own says of itself
TRACEBACK: Any = BaseException.__dict__["__traceback__"]
_FUNCTIONS = (_ast.FunctionDef, _ast.AsyncFunctionDef)
_HOLDING_STATEMENTS = ("body", "orelse", "finalbody", "handlers", "cases")
_OWN_SCOPE = (_ast.Lambda, _ast.ListComp, _ast.SetComp, _ast.DictComp, _ast.GeneratorExp)

# What a fork server imports before its children need it, when the source names it: what only defines things
# at import, for what a fork server has imported, it has run. The time is the judge's, not the submission's.
# Any other module of the interpreter can be imported too, at its own cost.
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


def inspect(source: bytes, name: str) -> dict[str, Any]:
    """What is wrong with the source, what it binds, what it imports, JSON-able.

    {"fault": [message, line, column, text] | None, "names": [[name, line], …], "modules": [module, …],
     "functions": [[name, line, least, most, empty], …], "inner": [[name, line, within], …]}, see `_functions`
    and `_inner`
    """
    try:
        tree: Any = compile(source, name, "exec", _ast.PyCF_ONLY_AST, dont_inherit=True)
        compile(source, name, "exec", dont_inherit=True)
    except SyntaxError as error:
        text = (error.text or "").strip("\n")[:TEXT_LENGTH]
        return _fault(f"{type(error).__name__}: {error.msg}", error.lineno or 0, error.offset or 0, text)
    except (ValueError, OverflowError) as error:
        return _fault(f"{type(error).__name__}: {error}", 0, 0, "")
    except (RecursionError, MemoryError):
        return _fault("too deeply nested or too large for the compiler", 0, 0, "")
    names = list(_bound(tree.body).items())[:MOST_NAMES]
    return {
        "fault": None,
        "names": names,
        "modules": sorted(_imported(tree))[:MOST_NAMES],
        "functions": _functions(tree.body)[:MOST_NAMES],
        "inner": _inner(tree)[:MOST_NAMES],
    }


def _fault(message: str, line: int, column: int, text: str) -> dict[str, Any]:
    return {"fault": [message, line, column, text], "names": [], "modules": [], "functions": [], "inner": []}


def _bound(body: list[Any]) -> dict[str, int]:
    """What the module's own statements bind, each name with the line of its first binding."""
    names: dict[str, int] = {}
    waiting = body[::-1]
    while waiting:
        node = waiting.pop()
        if isinstance(node, (*_FUNCTIONS, _ast.ClassDef)):
            names.setdefault(node.name, node.lineno)
        elif isinstance(node, (_ast.Import, _ast.ImportFrom)):
            for alias in node.names:
                names.setdefault(alias.asname or alias.name.partition(".")[0], node.lineno)
        elif isinstance(node, _ast.Name) and isinstance(node.ctx, _ast.Store):
            names.setdefault(node.id, node.lineno)
        elif not isinstance(node, _OWN_SCOPE):
            waiting += _children(node)[::-1]
    return names


def _functions(body: list[Any]) -> list[list[Any]]:
    """The functions that the module's own statements define for good: nothing binds their names again.

    Each with its line, how many arguments a call may have (the most is -1 where there is no end), and whether
    nothing is written in it yet. One that is decorated, or that wants arguments by name, may take anything.
    """
    found: dict[str, list[Any]] = {}
    for node in body:
        for name in _bound([node]):
            found.pop(name, None)
        if isinstance(node, _ast.FunctionDef) and not node.decorator_list:
            given = node.args
            if any(default is None for default in given.kw_defaults):
                continue
            most = len(given.posonlyargs) + len(given.args)
            least = most - len(given.defaults)
            found[node.name] = [node.name, node.lineno, least, -1 if given.vararg else most, _is_empty(node)]
    return list(found.values())


def _is_empty(function: _ast.FunctionDef) -> bool:
    """Whether its body is a docstring, `pass`, `...` and `raise NotImplementedError` and no more."""
    for node in function.body:
        if isinstance(node, _ast.Raise):
            raised = node.exc.func if isinstance(node.exc, _ast.Call) else node.exc
            if not (isinstance(raised, _ast.Name) and raised.id == "NotImplementedError"):
                return False
        elif not isinstance(node, _ast.Pass) and not (
            isinstance(node, _ast.Expr) and isinstance(node.value, _ast.Constant)
        ):
            return False
    return True


def _statements(tree: Any) -> Iterator[tuple[Any, str]]:
    """Every statement, with the class or the function in which it stands."""
    waiting = [(tree, "")]
    while waiting:
        node, within = waiting.pop()
        yield node, within
        if isinstance(node, _FUNCTIONS):
            within = f"function {node.name}"
        elif isinstance(node, _ast.ClassDef):
            within = f"class {node.name}"
        for field in _HOLDING_STATEMENTS:  # an expression holds none
            waiting += [(each, within) for each in reversed(getattr(node, field, ()))]


def _inner(tree: Any) -> list[list[Any]]:
    """The functions that stand in a class or in another function, in what each of them stands."""
    found = _statements(tree)
    return [[node.name, node.lineno, at] for node, at in found if at and isinstance(node, _FUNCTIONS)]


def _imported(tree: Any) -> set[str]:
    """Every module named by an import statement, wherever it stands."""
    modules: set[str] = set()
    for node, _ in _statements(tree):
        if isinstance(node, _ast.Import):
            modules.update(alias.name for alias in node.names)
        elif isinstance(node, _ast.ImportFrom) and node.module and not node.level:
            modules.add(node.module)
    return modules


def to_import(named: Iterable[str]) -> list[str]:
    """What to import ahead for a source that names these; an unlisted submodule counts as its top level."""
    chosen = (name if name in ALLOWED else name.partition(".")[0] for name in named)
    return [name for name in dict.fromkeys(chosen) if name in ALLOWED]


def _children(node: Any) -> list[Any]:
    found: list[Any] = []
    for field in node._fields:
        value = getattr(node, field, None)
        values = value if isinstance(value, list) else [value]
        found += [each for each in values if isinstance(each, _ast.AST)]
    return found


def sealed(source: bytes) -> list[int]:
    """The descriptor of a nameless file that holds the source and that nobody can change; none elsewhere."""
    if sys.platform != "linux":
        return []
    import fcntl

    number = os.memfd_create("source", os.MFD_CLOEXEC | os.MFD_ALLOW_SEALING)
    os.write(number, source)
    seals = fcntl.F_SEAL_SEAL | fcntl.F_SEAL_SHRINK | fcntl.F_SEAL_GROW | fcntl.F_SEAL_WRITE
    fcntl.fcntl(number, fcntl.F_ADD_SEALS, seals)
    return [number]


def described(error: BaseException, name: str) -> str:
    """An exception in one line, with its line in the file of that name, whatever its own text does."""
    try:
        text = " ".join(str(error)[: 4 * TEXT_LENGTH].split())[:TEXT_LENGTH]
    except BaseException:
        text = "(its text cannot be shown)"
    kind = _NAME_OF(type(error))
    what = f"{kind}: {text}" if text else kind
    line = own_line(TRACEBACK.__get__(error), name)
    return f"{what} (line {line})" if line else what


def own_line(step: TracebackType | None, name: str) -> int:
    """The innermost line of a traceback that is in the file of that name; 0 where none is."""
    line = 0
    while step is not None:
        if step.tb_frame.f_code.co_filename == name:
            line = step.tb_lineno
        step = step.tb_next
    return line
