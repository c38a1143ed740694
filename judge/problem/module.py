"""Running a kata's problem.py: what it defines (judge.problem.declare), and its rows as test groups.

The file is the setter's own code and is trusted. Whatever it raises becomes a ProblemError with its line.

The group of the statement's examples comes first. Of 100 points those that no row names are shared evenly,
and the first groups take the remainder.
"""

from __future__ import annotations

import inspect
import sys
import traceback
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from types import ModuleType
from typing import TYPE_CHECKING, Any

import msgspec
from msgspec import Struct
from msgspec.structs import replace

from judge.errors import JudgeError, ProblemError
from judge.files import read_ordinary
from judge.problem.declare import Declared, Hooks, InvalidCase, group
from judge.problem.load import exact, tolerance_fault
from judge.problem.model import (
    EXAMPLES,
    FULL_SCORE,
    Case,
    Group,
    KataLevel,
    Problem,
)
from judge.problem.toml import read_text, told
from judge.values.answers import Tolerance

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
    hooks = getattr(module, "HOOKS", Hooks())
    if not isinstance(hooks, Hooks):
        what = f"HOOKS is {hooks!r}, which is no Hooks"
        raise _fault(problem, what, "make it of judge.problem.declare.Hooks, or remove it")
    rows = tuple(_rows(module, problem))
    return Module(_solver(module, problem), {str(row.row["name"]): row.draw for _, row in rows}, hooks, rows)


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
        raise _fault(problem, f"syntax error: {error.msg}", "repair this line", error.lineno or 1) from error
    except (Exception, SystemExit, GeneratorExit) as error:
        # Trusted, but anybody's: the person gets its line, --debug the traceback; an exit() in it would else
        # be the judge's, and its status that of an accepted submission.
        said = ": ".join(filter(None, (what, type(error).__name__, str(error))))
        raise ProblemError(said, where=_place(error, problem), remedy="repair it there") from error


def shortened(case: tuple[Any, ...]) -> str:
    """The case as a call's arguments, cut where it is long."""
    text = f"({', '.join(map(repr, case))})"
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 1]}…"


def _fault(problem: Problem, what: str, remedy: str, line: int | None = None) -> ProblemError:
    place = f"{problem.id}/problem.py"
    return ProblemError(what, where=place if line is None else f"{place}:{line}", remedy=remedy)


def _place(error: BaseException, problem: Problem) -> str:
    """The innermost line of the problem's own files that led to the error."""
    own = str(problem.folder)
    for frame in reversed(traceback.extract_tb(error.__traceback__)):
        if frame.filename.startswith(own):
            return f"{problem.id}{frame.filename[len(own) :]}:{frame.lineno}"
    return f"{problem.id}/problem.py"


def _solver(module: ModuleType, problem: Problem) -> Callable[..., Exact]:
    """The module's `solve`; what it raises is blamed on its line, and a float is refused.

    InvalidCase alone goes through. Raises ProblemError where there is no such function, or it takes other
    parameters than problem.toml names.
    """
    function: Any = getattr(module, "solve", None)
    line = getattr(getattr(function, "__code__", None), "co_firstlineno", None)
    try:
        inspect.signature(function).bind(*problem.parameters)
    except TypeError:
        what = "there is no function 'solve' of the parameters of problem.toml"
        remedy = f"define solve({', '.join(each.name for each in problem.parameters)})"
        raise _fault(problem, what, remedy, line) from None

    def solve(*case: Any) -> Exact:
        try:
            answer = function(*case)
        except InvalidCase:
            raise
        except (Exception, SystemExit, GeneratorExit):
            with blaming(problem, f"solve{shortened(case)} fails"):
                raise
        if isinstance(answer, float) or (isinstance(answer, tuple | list) and float in map(type, answer)):
            what = f"solve{shortened(case)} returns {answer!r}, and a float is not exact"
            raise _fault(problem, what, "return ints, Fractions or Real(x, unit)", line)
        return answer

    return solve


# -- rows --------------------------------------------------------------------------------------------------


def _rows(module: ModuleType, problem: Problem) -> Iterator[tuple[KataLevel | None, Declared]]:
    lists: dict[str, KataLevel | None] = {level.name: level for level in KataLevel}
    there = [name for name in (*lists, "GROUPS") if hasattr(module, name)]
    if there not in ([*lists], ["GROUPS"]):
        remedy = "define INTERVIEW = [group(…), …] and PRODUCTION = […], or GROUPS alone"
        raise _fault(problem, "problem.py declares no test groups", remedy)
    for name in there:
        rows = getattr(module, name)
        if not isinstance(rows, list | tuple) or not all(isinstance(row, Declared) for row in rows):
            remedy = f"define {name} = [group(name, about, draw), …]"
            raise _fault(problem, f"{name} is no list of group(…)", remedy)
        yield from ((lists.get(name), row) for row in rows)


def with_groups(problem: Problem, tolerance: Tolerance | None) -> Problem:
    """The problem with its groups; its problem.py is run for that. Raises ProblemError.

    `tolerance` is that of a group which has none of its own.
    """
    rows = load_module(problem).rows
    levels = list(dict.fromkeys(level for level, _ in rows))
    if len(levels) == 1 and levels[0] is not None:
        remedy = "declare groups of both, or all of them in GROUPS"
        raise _fault(problem, f"every group is in {levels[0].name}", remedy, rows[0][1].line)
    if not problem.examples:
        remedy = f"add a line >>> {problem.entry}(…) and the answer below it"
        raise ProblemError("there are no worked examples", where=f"{problem.id}/statement.md", remedy=remedy)
    about = "The worked examples of the statement."
    examples = replace(group(EXAMPLES, about, tuple, cases=len(problem.examples)), line=0)
    first = tolerance or next((row.row["tolerance"] for _, row in rows), None) or Tolerance()
    groups = {EXAMPLES: _checked(problem, examples, levels[0] if levels else None, first)}
    for level, row in rows:
        made = _checked(problem, row, level, tolerance)
        if made.name in groups:
            remedy = "the examples come by themselves" if made.name == EXAMPLES else "rename or remove one"
            raise _fault(problem, f"there are two groups {made.name!r}", remedy, made.line)
        groups[made.name] = made
    if problem.slope is not None and len({each.size for each in groups.values()} - {None}) < 2:
        raise _fault(problem, "growth needs groups of two different sizes", "add a group with size = …")
    left = FULL_SCORE - sum(each.points for each in groups.values())
    if left < 0:
        remedy = f"make them sum to {FULL_SCORE} at most: what is left is shared"
        raise _fault(problem, f"the groups' points sum to {FULL_SCORE - left}", remedy)
    free = [EXAMPLES, *(str(row.row["name"]) for _, row in rows if row.row["points"] is None)]
    share, rest = divmod(left, len(free))
    for at, name in enumerate(free):
        groups[name] = replace(groups[name], points=share + (at < rest))
    kills = _pinned_kills(problem)
    return replace(
        problem, groups=tuple(replace(each, kills=kills.get(name, ())) for name, each in groups.items())
    )


def _checked(problem: Problem, declared: Declared, level: KataLevel | None, usual: Any) -> Group:
    """The group of a row, without its share of the points; `usual` is the tolerance where it has none."""
    raw = {key: value for key, value in declared.row.items() if value is not None}
    own = "tolerance" in raw
    raw = {"points": 0, "tolerance": usual or Tolerance()} | raw | {"seed": problem.id, "line": declared.line}
    if isinstance(limits := raw.get("limits"), Mapping):
        usually, wall = problem.limits, {}
        if isinstance(cpu := limits.get("cpu_seconds"), int | float):
            wall = {"wall_seconds": usually.wall_seconds * cpu / usually.cpu_seconds}
        raw["limits"] = {**msgspec.to_builtins(usually), **wall, **limits}
    what = f"group {raw['name']!r}"

    def fault(what: str, remedy: str) -> ProblemError:
        return _fault(problem, what, remedy, declared.line)

    try:
        made = msgspec.convert(raw, Group, dec_hook=lambda kind, value: exact(kind, value, problem.folder))
    except msgspec.ValidationError as why:
        said, remedy, _ = told(why, raw, Group)
        raise fault(f"{what}: {said}", remedy) from None
    if not callable(declared.draw):
        raise fault(f"{what} draws from {declared.draw!r}", "give a function that takes a draw")
    if made.size is not None and made.neighbours:
        raise fault(f"the cases of {what} are big and cannot take turns", "remove turns")
    if made.time_limit is not None and problem.time is None:
        raise fault(f"{what} is timed beside a reference solution", "add a [time] table that names one")
    if own and (wrong := tolerance_fault(made.tolerance, problem.answer)):
        raise fault(wrong[0], wrong[1])
    if not own and usual is None:
        raise fault(f"{what} has no tolerance", "add tolerance = { … } to problem.toml")
    return replace(made, level=level)


class _Pin(Struct):
    kills: tuple[str, ...]


def _pinned_kills(problem: Problem) -> dict[str, tuple[str, ...]]:
    """The mistakes that each group catches, by pins.json; a file that is none is verify's to tell."""
    try:
        pins = msgspec.json.decode(read_ordinary(problem.folder / "pins.json"), type=dict[str, _Pin])
    except (OSError, ValueError, RecursionError):
        return {}
    return {name: pin.kills for name, pin in pins.items()}
