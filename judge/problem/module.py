"""Running a kata's problem.py and taking what it defines (judge.problem.declare).

The file is the setter's own code and is trusted. Whatever it raises becomes a ProblemError with its line.
"""

from __future__ import annotations

import inspect
import sys
import traceback
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from types import ModuleType
from typing import TYPE_CHECKING, Any

from msgspec import Struct

from judge.errors import JudgeError, ProblemError
from judge.problem.declare import Declared, Hooks, InvalidCase
from judge.problem.model import Case, KataLevel, Problem
from judge.problem.text import read_text

if TYPE_CHECKING:
    from judge.values.answers import Exact

_LONGEST = 100  # characters of a case that a fault shows


class Module(Struct, frozen=True):
    """What a problem.py defines.

    Attributes:
        solve: the exact answer to a case; raises InvalidCase where the case breaks the statement's promise,
            ProblemError where the function itself fails.
        draws: how a case of each group is drawn, by the group's name; the examples are not drawn.
        hooks: what is known of its topic.
        rows: the groups as problem.py declares them, each with its level.
    """

    solve: Callable[..., Exact]
    draws: Mapping[str, Callable[[Any], Case]] = {}
    hooks: Hooks = Hooks()
    rows: tuple[tuple[KataLevel | None, Declared], ...] = ()


def load_module(problem: Problem) -> Module:
    """Run the problem's problem.py and take what it must define. Raises ProblemError."""
    path = problem.folder / "problem.py"
    source = read_text(path)
    # A name of its own, for two packs may hold one problem; no .pyc, for the folder may be read-only.
    module = ModuleType(f"judge_problem_{problem.id.replace('-', '_')}_{abs(hash(path)):x}")
    module.__file__ = str(path)
    with blaming(problem, "problem.py cannot be loaded"):
        code = compile(source, str(path), "exec", dont_inherit=True)
        sys.modules[module.__name__] = module  # dataclasses look their own module up
        exec(code, module.__dict__)
    rows = tuple(_rows(module, problem))
    return Module(
        _solve(module, problem), {row.name: row.draw for _, row in rows}, _hooks(module, problem), rows
    )


@contextmanager
def blaming(problem: Problem, what: str, place: Callable[[], str] | None = None) -> Iterator[None]:
    """Turn whatever the setter's code raises into a ProblemError that names its own line.

    `place` says where to look when the error's own message is all there is to know (a draw's own check).
    """
    try:
        yield
    except JudgeError as error:
        if error.where is not None:
            raise
        where = place() if place is not None else _place(error, problem)
        raise ProblemError(f"{what}: {error.what}", where=where, remedy=error.remedy) from error
    except SyntaxError as error:
        where = f"{problem.id}/problem.py:{error.lineno or 1}"
        raise ProblemError(f"syntax error: {error.msg}", where=where, remedy="repair this line") from error
    except (Exception, SystemExit, GeneratorExit) as error:
        # Trusted, but anybody's: the person gets its line, --debug the traceback; an exit() in it would else
        # be the judge's, and its status that of an accepted submission.
        name = type(error).__name__
        raise ProblemError(
            f"{what}: {name}: {error}" if str(error) else f"{what}: {name}",
            where=_place(error, problem),
            remedy="repair it there",
        ) from error


def _place(error: BaseException, problem: Problem) -> str:
    """The innermost line of the problem's own files that led to the error."""
    own = str(problem.folder)
    for frame in reversed(traceback.extract_tb(error.__traceback__)):
        if frame.filename.startswith(own):
            return f"{problem.id}{frame.filename[len(own) :]}:{frame.lineno}"
    return f"{problem.id}/problem.py"


def _solver(module: ModuleType, problem: Problem) -> Callable[..., Any]:
    """The module's `solve`; what it raises is blamed on its line.

    InvalidCase alone goes through. Raises ProblemError where there is no such function, or it takes other
    parameters than problem.toml names.
    """
    function = getattr(module, "solve", None)
    names = ", ".join([each.name for each in problem.parameters])
    if not callable(function):
        raise ProblemError(
            "problem.py defines no function 'solve'",
            where=f"{problem.id}/problem.py",
            remedy=f"define solve({names})",
        )
    signature = inspect.signature(function)
    try:
        signature.bind(*problem.parameters)
    except TypeError:
        raise ProblemError(
            f"solve does not take the {len(problem.parameters)} parameters of problem.toml",
            where=f"{problem.id}/problem.py:{_line(function)}",
            remedy=f"define solve({names})",
        ) from None

    def solve(*case: Any) -> Any:
        try:
            return function(*case)
        except InvalidCase:
            raise
        except (Exception, SystemExit, GeneratorExit):
            with blaming(problem, f"solve{shortened(case)} fails"):
                raise

    return solve


def _solve(module: ModuleType, problem: Problem) -> Callable[..., Exact]:
    solve = _solver(module, problem)

    def exact(*case: Any) -> Exact:
        answer = solve(*case)
        if isinstance(answer, float) or (isinstance(answer, tuple | list) and float in map(type, answer)):
            raise ProblemError(
                f"solve{shortened(case)} returns {answer!r}, and a float is not exact",
                where=f"{problem.id}/problem.py:{_line(module.solve)}",
                remedy="return ints, Fractions or Real(x, unit)",
            )
        return answer

    return exact


def shortened(case: tuple[Any, ...]) -> str:
    """The case as a call's arguments, cut where it is long."""
    text = f"({', '.join(map(repr, case))})"
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 1]}…"


def _rows(module: ModuleType, problem: Problem) -> Iterator[tuple[KataLevel | None, Declared]]:
    lists: dict[str, KataLevel | None] = {level.name: level for level in KataLevel}
    there = [name for name in lists if hasattr(module, name)]
    if hasattr(module, "GROUPS") and not there:
        lists, there = {"GROUPS": None}, ["GROUPS"]
    if len(there) < len(lists) or hasattr(module, "GROUPS") != (there == ["GROUPS"]):
        raise ProblemError(
            "problem.py declares no test groups",
            where=f"{problem.id}/problem.py",
            remedy="define INTERVIEW = [group(…), …] and PRODUCTION = […], or GROUPS alone",
        )
    for name in there:
        rows = getattr(module, name)
        if not isinstance(rows, list | tuple) or not all(isinstance(row, Declared) for row in rows):
            raise ProblemError(
                f"{name} is no list of group(…)",
                where=f"{problem.id}/problem.py",
                remedy=f"define {name} = [group(name, about, draw), …]",
            )
        yield from ((lists[name], row) for row in rows)


def _hooks(module: ModuleType, problem: Problem) -> Hooks:
    hooks = getattr(module, "HOOKS", Hooks())
    if not isinstance(hooks, Hooks):
        raise ProblemError(
            f"HOOKS is {hooks!r}, which is no Hooks",
            where=f"{problem.id}/problem.py",
            remedy="make it of judge.problem.declare.Hooks, or remove it",
        )
    return hooks


def _line(function: Callable[..., Any]) -> int:
    code = getattr(function, "__code__", None)
    return code.co_firstlineno if code is not None else 1
