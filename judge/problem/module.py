"""Running a kata's problem.py: what it defines (judge.problem.declare).

The file is the setter's own code and is trusted. Whatever it raises becomes a ProblemError with its line.
"""

from __future__ import annotations

import inspect
import sys
import traceback
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from copy import deepcopy
from types import ModuleType
from typing import TYPE_CHECKING, Any

from msgspec import Struct

from judge.errors import JudgeError, ProblemError
from judge.problem.declare import Declared, Format, Hooks, InvalidCase
from judge.problem.model import Case, KataLevel, Problem, tupled
from judge.problem.toml import read_text
from judge.values import parameters
from judge.values.wire import cut

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
        format: what a program reads and writes; None where that is a line for each case.
        examples: the worked examples of a problem without entry.
    """

    solve: Callable[..., Exact]
    draws: Mapping[str, Callable[[Any], Case]] = {}
    hooks: Hooks = Hooks()
    rows: tuple[tuple[KataLevel | None, Declared], ...] = ()
    format: Format | None = None
    examples: tuple[Case, ...] = ()


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
    own = getattr(module, "FORMAT", None)
    for name, value, kind in (("HOOKS", hooks, Hooks), ("FORMAT", own or Format(str), Format)):
        if not isinstance(value, kind):
            remedy = f"make it of judge.problem.declare.{kind.__name__}, or remove it"
            raise problem.fault(f"{name} is {value!r}, which is no {kind.__name__}", remedy)
    rows = tuple(_rows(module, problem))
    draws = {str(row.row["name"]): _drawn(problem, row.draw) for _, row in rows}
    examples = () if problem.entry else _examples(module, problem, own)
    return Module(_solver(module, problem), draws, hooks, rows, own, examples)


def _drawn(problem: Problem, draw: Callable[[Any], Case]) -> Callable[[Any], Case]:
    """A group's draw, whose dicts are kept as pairs."""
    if not any(each.type.keyed for each in problem.parameters):
        return draw

    def case(source: Any) -> Case:
        found = draw(source)
        return problem.kept(found) if type(found) is tuple else found

    return case


def _examples(module: ModuleType, problem: Problem, own: Format | None) -> tuple[Case, ...]:
    """The worked examples of a problem without entry. Raises ProblemError."""
    if own is None:
        what = "there is no entry, and problem.py has no FORMAT"
        remedy = "name the function, entry = …, or give FORMAT to a kata of programs"
        raise problem.fault(what, remedy, file="problem.toml")
    examples = getattr(module, "EXAMPLES", ())
    if not isinstance(examples, list | tuple) or not examples:
        raise problem.fault("EXAMPLES is missing", "list a case or more: EXAMPLES = [(…), …]")
    return tuple(problem.kept(tupled(each)) for each in examples)


@contextmanager
def blaming(problem: Problem, what: str, line: int = 0) -> Iterator[None]:
    """Turn whatever the setter's code raises into a ProblemError that names its own line.

    `line` is where to look when the error's own message is all there is to know (a draw's own check).
    """
    try:
        yield
    except JudgeError as error:
        if error.where is not None:
            raise
        where = f"{problem.id}/problem.py:{line}" if line else _place(error, problem)
        raise ProblemError(f"{what}: {error.what}", where=where, remedy=error.remedy) from error
    except SyntaxError as error:
        raise problem.fault(f"syntax error: {error.msg}", "repair this line", error.lineno or 1) from error
    except (Exception, SystemExit, GeneratorExit) as error:
        # Trusted, but anybody's: the person gets its line, --debug the traceback; an exit() in it would else
        # be the judge's, and its status that of an accepted submission.
        said = ": ".join(filter(None, (what, type(error).__name__, str(error))))
        raise ProblemError(said, where=_place(error, problem), remedy="repair it there") from error


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
    if problem.methods:
        function = _by_class(module, problem)
    line = getattr(getattr(function, "__code__", None), "co_firstlineno", 0)
    try:
        inspect.signature(function).bind(*problem.parameters)
    except TypeError:
        what = "there is no function 'solve' of the parameters of problem.toml"
        remedy = f"define solve({', '.join(each.name for each in problem.parameters)})"
        raise problem.fault(what, remedy, line) from None

    taken = [each.type for each in problem.parameters]
    keyed = any(type_.keyed for type_ in taken) and not problem.methods

    def solve(*case: Any) -> Exact:
        if keyed:
            case = tuple(map(parameters.given, taken, case))
        try:
            answer = function(*case)
        except InvalidCase as broken:
            raise InvalidCase(str(broken).removesuffix(".")) from None
        except (Exception, SystemExit, GeneratorExit):
            with blaming(problem, f"solve{_shortened(case)} fails"):
                raise
        answers = [each.answer for each in answer] if problem.methods else answer
        answers = tuple(answers.values()) if isinstance(answers, dict) else answers
        if isinstance(answer, float) or (isinstance(answers, tuple | list) and float in map(type, answers)):
            what = f"solve{_shortened(case)} returns {answer!r}, and a float is not exact"
            raise problem.fault(what, "return ints, Fractions or Real(x, unit)", line)
        return answer

    return solve


def _by_class(module: ModuleType, problem: Problem) -> Callable[..., Exact]:
    """The exact answers of calls in a row on an object of the setter's own class. Raises ProblemError."""
    from judge.values.answers import Called
    from judge.values.calls import CallType

    made, calls = getattr(module, problem.entry, None), problem.parameters[-1].type
    assert isinstance(calls, CallType)
    names = ", ".join(calls.place)
    if not isinstance(made, type) or not all(callable(getattr(made, name, None)) for name in calls.place):
        raise problem.fault(f"there is no class {problem.entry!r} with {names}", "define it")
    for method in calls.methods:
        try:
            inspect.signature(getattr(made, method.name)).bind(None, *method.takes)
        except TypeError:
            takes = ", ".join(name for name, _ in method.takes) or "nothing"
            what = f"{problem.entry}.{method.name} takes other arguments than problem.toml names"
            code = getattr(getattr(made, method.name), "__code__", None)
            raise problem.fault(what, f"make it take {takes}", getattr(code, "co_firstlineno", 0)) from None
    try:
        inspect.signature(made).bind(*problem.parameters[:-1])
    except TypeError:
        what = f"{problem.entry}(…) takes other arguments than problem.toml names"
        raise problem.fault(what, "correct its __init__, or [parameters]") from None

    def solve(*case: Any) -> Exact:
        *own, row = problem.calls([case])[0]
        one = made(*own)
        return [
            Called(calls.place[name], _as_it_is(getattr(one, name)(*given)), (name, *given))
            for name, *given in row
        ]

    solve.__signature__ = inspect.signature(lambda *case: case)  # type: ignore[attr-defined]
    return solve


def _as_it_is(answer: Exact) -> Exact:
    """An answer that stays as it is, though the object changes what it has returned."""
    return deepcopy(answer) if isinstance(answer, list | dict) else answer


def _rows(module: ModuleType, problem: Problem) -> Iterator[tuple[KataLevel | None, Declared]]:
    """The rows of its lists, each with its level. Raises ProblemError."""
    lists: dict[str, KataLevel | None] = {level.name: level for level in KataLevel}
    there = [name for name in (*lists, "GROUPS") if hasattr(module, name)]
    if there not in ([*lists], ["GROUPS"]):
        remedy = "define INTERVIEW = [group(…), …] and PRODUCTION = […], or GROUPS alone"
        raise problem.fault("problem.py declares no test groups", remedy)
    for name in there:
        rows = getattr(module, name)
        if not isinstance(rows, list | tuple) or not all(isinstance(row, Declared) for row in rows):
            remedy = f"define {name} = [group(name, about, draw), …]"
            raise problem.fault(f"{name} is not a list of group(…)", remedy)
        yield from ((lists.get(name), row) for row in rows)


def _shortened(case: Case) -> str:
    """The case as a call's arguments, cut where it is long."""
    return cut(f"({', '.join(map(repr, case))})", _LONGEST)
