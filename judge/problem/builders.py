"""Katas that declare their groups in problem.toml, as a Module: until the last of them is a page of Python.

solve(*case) -> (answer, broken)     the exact answer, and a sentence that says what of the promise the
                                     case breaks, or None; given the `[bands]` where it asks for them
BUILDERS = {"name": function}        function(draw, **parameters) -> case
TOPIC = Topic(...)                   optional (judge.problem.topic)
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from functools import partial
from types import ModuleType
from typing import TYPE_CHECKING, Any

from judge.errors import ProblemError, nearest
from judge.problem.declare import Hooks, InvalidCase
from judge.problem.model import EXAMPLES, Case, Group, Problem
from judge.problem.module import Module, blaming, shortened, solver
from judge.problem.tomlfile import group_place
from judge.problem.topic import Topic

if TYPE_CHECKING:
    from judge.values.tree import Exact


def module_of(module: ModuleType, problem: Problem) -> Module:
    """What such a problem.py defines. Raises ProblemError."""
    builders = getattr(module, "BUILDERS", None)
    if not isinstance(builders, Mapping) or not all(callable(each) for each in builders.values()):
        raise ProblemError(
            "problem.py defines no BUILDERS",
            where=f"{problem.id}/problem.py",
            remedy='define BUILDERS = {"name": function, …}',
        )
    topic = getattr(module, "TOPIC", None) or Topic()
    if not isinstance(topic, Topic):
        raise ProblemError(
            f"TOPIC is {topic!r}, which is no Topic",
            where=f"{problem.id}/problem.py",
            remedy="make it of judge.problem.topic.Topic, or remove it",
        )
    draws = {
        group.name: _bound(problem, builders, group) for group in problem.groups if group.builder != EXAMPLES
    }
    hooks = Hooks(topic.picture, topic.simpler, topic.explore, topic.puzzle)
    return Module(_solve(module, problem), draws, hooks, (), topic.special)


def _solve(module: ModuleType, problem: Problem) -> Callable[..., Exact]:
    function = solver(module, problem, bands=problem.bands)

    def solve(*case: Any) -> Exact:
        solved = function(*case)
        with blaming(problem, f"solve{shortened(case)} fails"):
            if type(solved) is not tuple or len(solved) != 2 or not _is_sentence(solved[1]):
                raise TypeError(f"{solved!r} given where (answer, broken promise or None) is meant")
        if solved[1]:
            raise InvalidCase(solved[1])
        return solved[0]

    return solve


def _is_sentence(broken: Any) -> bool:
    return broken is None or (isinstance(broken, str) and broken != "")


def _bound(
    problem: Problem, builders: Mapping[str, Callable[..., Case]], group: Group
) -> Callable[[Any], Case]:
    """The group's builder with its parameters filled in. Raises ProblemError."""
    builder = builders.get(group.builder)
    if builder is None:
        names = [*builders, EXAMPLES]
        meant = nearest(group.builder, names)
        raise ProblemError(
            f"group {group.name!r} wants the unknown builder {group.builder!r}",
            where=group_place(problem, group.name, "builder"),
            remedy=f"did you mean {meant!r}?" if meant else f"the builders are {', '.join(names)}",
        )
    bound = partial(builder, **group.parameters)
    _check_parameters(problem, group, builder)
    return bound


def _check_parameters(problem: Problem, group: Group, builder: Callable[..., Case]) -> None:
    signature = inspect.signature(builder)
    parameters = group.parameters
    try:
        signature.bind(None, **parameters)
    except TypeError as error:
        names = [name for name in list(signature.parameters)[1:] if name not in parameters]
        takes_any = any(each.kind is each.VAR_KEYWORD for each in signature.parameters.values())
        strange = [name for name in parameters if name not in signature.parameters and not takes_any]
        unknown = strange[0] if strange else None
        meant = nearest(unknown, names) if unknown is not None else None
        listed = ", ".join(list(signature.parameters)[1:]) or "none"
        why = f"it has none called {unknown!r}" if unknown is not None else error
        raise ProblemError(
            f"group {group.name!r}: the builder {group.builder!r} cannot take its parameters: {why}",
            where=group_place(problem, group.name, "parameters"),
            remedy=f"did you mean {meant!r}?" if meant else f"its parameters are {listed}",
        ) from None
