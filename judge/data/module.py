"""Loading `problems/<id>/problem.py`: the exact answers, the builders and the topic.

    solve(*case) -> (answer, broken)     the exact answer (judge.values.tree), and a sentence that says what
                                         of the statement's promise the case breaks, or None; it raises
                                         nothing for such a case
    BUILDERS = {"name": function}        function(draw, **parameters) -> case
    TOPIC = Topic(...)                   optional: what is known of its topic (judge.problem.topic)

`solve` is given the `[bands]` of problem.toml where it asks for them: `def solve(a, b, *, bands)`.

The file is the setter's own code and is trusted. Whatever it raises becomes a ProblemError with its line.
"""

from __future__ import annotations

import inspect
import sys
import traceback
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from types import ModuleType
from typing import TYPE_CHECKING, Any, NamedTuple

from msgspec import Struct

from judge.errors import JudgeError, ProblemError
from judge.problem import Case, Problem
from judge.problem.text import read_text
from judge.problem.topic import Topic

if TYPE_CHECKING:
    from judge.values import Exact

Builder = Callable[..., Case]

_LONGEST = 100  # characters of a case that a fault shows


class Solved(NamedTuple):
    """A case's exact answer, and what of the promise the case breaks; None where it keeps the promise."""

    answer: Exact
    broken: str | None


class ProblemModule(Struct, frozen=True):
    """What a problem.py defines; `solve` takes a case's arguments alone, and raises ProblemError."""

    solve: Callable[..., Solved]
    builders: Mapping[str, Builder]
    topic: Topic = Topic()


def load_module(problem: Problem) -> ProblemModule:
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
    return ProblemModule(_solve(module, problem), _builders(module, problem), _topic(module, problem))


@contextmanager
def blaming(problem: Problem, what: str, place: Callable[[], str] | None = None) -> Iterator[None]:
    """Turn whatever the setter's code raises into a ProblemError that names its own line.

    `place` says where to look when the error's own message is all there is to know (a builder's own check).
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


def _solve(module: ModuleType, problem: Problem) -> Callable[..., Solved]:
    """The module's `solve`, given the bands if it takes them, its result looked at."""
    function = getattr(module, "solve", None)
    names = ", ".join(each.name for each in problem.parameters)
    if not callable(function):
        raise ProblemError(
            "problem.py defines no function 'solve'",
            where=f"{problem.id}/problem.py",
            remedy=f"define solve({names}) -> (answer, broken promise or None)",
        )
    signature = inspect.signature(function)
    bands = {"bands": problem.bands} if "bands" in signature.parameters else {}
    try:
        signature.bind(*[None] * len(problem.parameters), **bands)
    except TypeError:
        raise ProblemError(
            f"solve does not take the {len(problem.parameters)} parameters of problem.toml",
            where=f"{problem.id}/problem.py:{_line(function)}",
            remedy=f"define solve({names}{', *, bands' if bands else ''})",
        ) from None

    def solve(*case: Any) -> Solved:
        try:
            solved = function(*case, **bands)
            if type(solved) is not tuple or len(solved) != 2 or not _is_sentence(solved[1]):
                raise TypeError(f"{solved!r} given where (answer, broken promise or None) is meant")
        except (Exception, SystemExit, GeneratorExit):
            with blaming(problem, f"solve{_shortened(case)} fails"):
                raise
        return Solved(*solved)

    return solve


def _shortened(case: tuple[Any, ...]) -> str:
    text = f"({', '.join(map(repr, case))})"
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 1]}…"


def _is_sentence(broken: Any) -> bool:
    return broken is None or (isinstance(broken, str) and broken != "")


def _builders(module: ModuleType, problem: Problem) -> Mapping[str, Builder]:
    builders = getattr(module, "BUILDERS", None)
    if not isinstance(builders, Mapping) or not all(callable(each) for each in builders.values()):
        raise ProblemError(
            "problem.py defines no BUILDERS",
            where=f"{problem.id}/problem.py",
            remedy='define BUILDERS = {"name": function, …}',
        )
    return builders


def _topic(module: ModuleType, problem: Problem) -> Topic:
    topic = getattr(module, "TOPIC", None)
    if topic is None:
        return Topic()
    if not isinstance(topic, Topic):
        raise ProblemError(
            f"TOPIC is {topic!r}, which is no Topic",
            where=f"{problem.id}/problem.py",
            remedy="make it of judge.problem.topic.Topic, or remove it",
        )
    return topic


def _line(function: Callable[..., Any]) -> int:
    code = getattr(function, "__code__", None)
    return code.co_firstlineno if code is not None else 1
