"""Loading `problems/<id>/problem.py`: the exact reference, the promise and the builders.

    reference(*case) -> Answer           the exact answer (judge.compare.answers)
    promise(*case) -> str | None         how the case breaks the statement's promise, or None
    BUILDERS = {"name": function}        function(draw, **parameters) -> case
    IMAGES = mirror_images               optional: cases that follow from one (judge.data.images), for stress

It is the setter's own code and is trusted. A problem.py that needs the bands of its problem.toml takes them
from `judge.spec.load.bands_beside(__file__)`. Whatever it raises becomes a ProblemError with its line.
"""

from __future__ import annotations

import inspect
import sys
import traceback
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from types import ModuleType
from typing import TYPE_CHECKING, Any, cast

from msgspec import Struct

from judge.errors import JudgeError, ProblemError
from judge.spec import Case, Problem
from judge.spec.tomlfile import read_text

if TYPE_CHECKING:
    from judge.compare.answers import Answer
    from judge.data.images import Images

Builder = Callable[..., Case]


class ProblemModule(Struct, frozen=True):
    """What a problem.py defines."""

    reference: Callable[..., Answer]
    promise: Callable[..., str | None]
    builders: Mapping[str, Builder]
    images: Images | None = None


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
    loaded = ProblemModule(
        reference=_function(module, "reference", problem),
        promise=_function(module, "promise", problem),
        builders=_builders(module, problem),
        images=_function(module, "IMAGES", problem) if hasattr(module, "IMAGES") else None,
    )
    _check_arity(loaded.reference, "reference", problem)
    _check_arity(loaded.promise, "promise", problem)
    return loaded


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


def _function(module: ModuleType, name: str, problem: Problem) -> Callable[..., Any]:
    function = getattr(module, name, None)
    if not callable(function):
        raise ProblemError(
            f"problem.py defines no function {name!r}",
            where=f"{problem.id}/problem.py",
            remedy=f"define {name}({', '.join(each.name for each in problem.parameters)})",
        )
    return cast("Callable[..., Any]", function)


def _builders(module: ModuleType, problem: Problem) -> Mapping[str, Builder]:
    builders = getattr(module, "BUILDERS", None)
    if not isinstance(builders, Mapping) or not all(callable(each) for each in builders.values()):
        raise ProblemError(
            "problem.py defines no BUILDERS",
            where=f"{problem.id}/problem.py",
            remedy='define BUILDERS = {"name": function, …}',
        )
    return builders


def _check_arity(function: Callable[..., Any], name: str, problem: Problem) -> None:
    wanted = len(problem.parameters)
    try:
        inspect.signature(function).bind(*[None] * wanted)
    except TypeError:
        raise ProblemError(
            f"{name} does not take the {wanted} parameters of problem.toml",
            where=f"{problem.id}/problem.py:{_line(function)}",
            remedy=f"define {name}({', '.join(each.name for each in problem.parameters)})",
        ) from None


def _line(function: Callable[..., Any]) -> int:
    code = getattr(function, "__code__", None)
    return code.co_firstlineno if code is not None else 1
