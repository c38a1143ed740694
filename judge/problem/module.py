"""Running a kata's problem.py: what it defines (judge.problem.declare), and its rows as test groups.

The file is the setter's own code and is trusted. Whatever it raises becomes a ProblemError with its line.

The group of the statement's examples comes first. Of 100 points those that no row names are shared evenly,
and the first groups take the remainder.
"""

from __future__ import annotations

import inspect
import sys
import traceback
from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from types import ModuleType
from typing import TYPE_CHECKING, Annotated, Any

import msgspec
from msgspec import Meta, Struct
from msgspec.structs import replace

from judge.errors import JudgeError, ProblemError
from judge.problem.declare import Declared, Hooks, InvalidCase
from judge.problem.load import made, tolerance_fault
from judge.problem.model import (
    EXAMPLES,
    FULL_SCORE,
    Case,
    Group,
    GrowthRule,
    KataLevel,
    Problem,
    ShownSkill,
    is_name,
)
from judge.problem.toml import read_text, told
from judge.reading import read_ordinary
from judge.values import Tolerance

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
    function = getattr(module, "solve", None)
    remedy = f"define solve({', '.join(each.name for each in problem.parameters)})"
    if not callable(function):
        raise _fault(problem, "problem.py defines no function 'solve'", remedy)
    code = getattr(function, "__code__", None)
    line = code.co_firstlineno if code is not None else 1
    try:
        inspect.signature(function).bind(*problem.parameters)
    except TypeError:
        what = f"solve does not take the {len(problem.parameters)} parameters of problem.toml"
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

_Seconds = Annotated[float, Meta(gt=0, le=1e6)]
_Text = Annotated[str, Meta(min_length=1)]


class _Limits(Struct, frozen=True, forbid_unknown_fields=True):
    cpu_seconds: _Seconds | None = None
    wall_seconds: _Seconds | None = None


class _Row(Struct, frozen=True, forbid_unknown_fields=True):
    """What `group(…)` is given."""

    name: str
    about: _Text
    cases: Annotated[int, Meta(ge=1, le=1_000_000)]
    points: Annotated[int, Meta(ge=0, le=FULL_SCORE)] | None
    skills: tuple[_Text, ...]
    tolerance: Tolerance | None
    limits: _Limits | None
    time_limit: Annotated[float, Meta(ge=1, le=1e6)] | None
    size: Annotated[int, Meta(ge=1, le=10**9)] | None
    turns: bool


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


def with_groups(problem: Problem, tolerance: Tolerance | None, slope: float | None) -> Problem:
    """The problem with its groups, their skills and the rule of growth; its problem.py is run for that.

    `tolerance` is that of a group which has none of its own, `slope` that of growth. Raises ProblemError.
    """
    rows = load_module(problem).rows
    levels = {level for level, _ in rows}
    points: dict[str, int | None] = {EXAMPLES: None}
    skills: defaultdict[str, list[str]] = defaultdict(list)
    groups = []
    for level, declared in rows:
        row = _checked(problem, declared, [*points])
        limits = problem.limits
        if row.limits is not None:
            cpu = row.limits.cpu_seconds or limits.cpu_seconds
            wall = row.limits.wall_seconds or limits.wall_seconds * cpu / limits.cpu_seconds
            limits = replace(limits, cpu_seconds=cpu, wall_seconds=wall)
        groups.append(
            Group(
                name=row.name,
                about=row.about,
                count=row.cases,
                points=0,
                tolerance=_tolerance(problem, declared, row.tolerance, tolerance),
                seed=problem.id,
                line=declared.line,
                size=row.size,
                time_limit=row.time_limit,
                limits=limits if row.limits else None,
                neighbours=row.turns,
                level=level,
            )
        )
        points[row.name] = row.points
        for skill in row.skills:
            skills[skill].append(row.name)
    if len(levels) == 1 and None not in levels:
        what = f"every group is in {' and '.join(level.name for level in levels if level)}"
        remedy = "declare groups of both, or all of them in GROUPS"
        raise _fault(problem, what, remedy, rows[0][1].line)
    if not problem.examples:
        remedy = f"add a line >>> {problem.entry}(…) and the answer below it"
        raise ProblemError("there are no worked examples", where=f"{problem.id}/statement.md", remedy=remedy)
    examples = Group(
        name=EXAMPLES,
        about="The worked examples of the statement.",
        count=len(problem.examples),
        points=0,
        tolerance=tolerance or next((group.tolerance for group in groups), Tolerance()),
        seed=problem.id,
        level=None if levels == {None} else KataLevel.INTERVIEW,
    )
    shares, kills = _shares(problem, points), _pinned_kills(problem)
    return replace(
        problem,
        groups=tuple(
            replace(each, points=shares[each.name], kills=kills.get(each.name, ()))
            for each in (examples, *groups)
        ),
        skills=tuple(ShownSkill(skill, tuple(names)) for skill, names in skills.items()),
        growth=None if slope is None else _growth(problem, groups, slope),
    )


def _checked(problem: Problem, declared: Declared, before: Sequence[str]) -> _Row:
    """A row, if it is sound; `before` are the names of the groups before it."""
    raw = declared.row
    name: Any = raw["name"]
    draw: Any = declared.draw
    what = f"group {name!r}"
    if not isinstance(name, str) or not is_name(name):
        what, remedy = f"{name!r} is no name for a group", "use small letters, digits and single hyphens"
    elif name in before:
        remedy = "the examples come by themselves" if name == EXAMPLES else "rename or remove one"
        what = f"there are two groups {name!r}"
    elif not callable(draw):
        what, remedy = f"{what} draws from {draw!r}", "give a function that takes a draw"
    else:
        try:
            row = msgspec.convert(raw, _Row, dec_hook=lambda kind, value: made(kind, value, problem.folder))
        except msgspec.ValidationError as why:
            said, remedy, _ = told(why, raw, _Row)
            raise _fault(problem, f"{what}: {said}", remedy, declared.line) from None
        if row.size is not None and row.turns:
            what, remedy = f"the cases of {name!r} are big and cannot take turns", "remove turns"
        elif row.time_limit is not None and problem.time is None:
            what, remedy = (
                f"{name!r} is timed beside a reference solution",
                "add a [time] table that names one",
            )
        elif len(set(row.skills)) < len(row.skills):
            what, remedy = f"{name!r} shows a skill twice", "remove one"
        else:
            return row
    raise _fault(problem, what, remedy, declared.line)


def _tolerance(problem: Problem, row: Declared, own: Tolerance | None, usual: Tolerance | None) -> Tolerance:
    """The tolerance of a row's group, whose own it may be."""
    found = own or usual
    if found is None:
        what = f"group {row.row['name']!r} has no tolerance"
        raise _fault(problem, what, "add tolerance = { … } to problem.toml", row.line)
    if own is not None and (fault := tolerance_fault(own, problem.answer)):
        raise _fault(problem, fault[0], fault[1], row.line)
    return found


def _shares(problem: Problem, given: Mapping[str, int | None]) -> dict[str, int]:
    """Each group's points."""
    left = FULL_SCORE - sum(points for points in given.values() if points is not None)
    if left < 0:
        remedy = f"make them sum to {FULL_SCORE} at most: what is left is shared"
        raise _fault(problem, f"the groups' points sum to {FULL_SCORE - left}", remedy)
    free = [name for name, points in given.items() if points is None]
    each, rest = divmod(left, len(free))
    shared = {name: each + (at < rest) for at, name in enumerate(free)}
    return {name: shared[name] if points is None else points for name, points in given.items()}


def _growth(problem: Problem, groups: Sequence[Group], slope: float) -> GrowthRule:
    """The rule of growth: over the groups whose cases are big, the smallest first."""
    sizes = {group.name: group.size for group in groups if group.size}
    if len(set(sizes.values())) < 2:
        raise _fault(problem, "growth needs groups of two different sizes", "add a group with size = …")
    return GrowthRule(tuple(sorted(sizes, key=sizes.__getitem__)), slope)


class _Pin(Struct):
    kills: tuple[str, ...]


def _pinned_kills(problem: Problem) -> dict[str, tuple[str, ...]]:
    """The mistakes that each group catches, by pins.json; a file that is none is verify's to tell."""
    try:
        pins = msgspec.json.decode(read_ordinary(problem.folder / "pins.json"), type=dict[str, _Pin])
    except (OSError, ValueError, RecursionError):
        return {}
    return {name: pin.kills for name, pin in pins.items()}
