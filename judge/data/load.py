"""A problem's data, from the cache or built."""

from __future__ import annotations

from typing import Any

from judge.data.cache import DataCache
from judge.data.model import GroupData, ProblemData, Progress, reseeded
from judge.problem import Group, Problem


def load_data(
    problem: Problem, *, seed: int | None = None, progress: Progress | None = None, cache: bool = True
) -> ProblemData:
    """Every group's cases and targets, in the order of the groups.

    With `seed`, each group's own seed is derived from it. `progress` is told of cases while they are built.
    Without `cache` they are built afresh and not kept. Raises ProblemError.
    """
    store = DataCache(problem, seed) if cache else None
    if store is not None:
        kept = _from_plain(store.read(), problem, seed)
        if kept is not None:
            return ProblemData(problem, kept)
    # Only now: a warm start needs neither the exact numbers nor the builders.
    from judge.data.build import build
    from judge.data.module import load_module

    module = load_module(problem)
    groups = tuple(build(problem, module, seed, progress))
    note = store.write(_as_plain(groups)) if store is not None else None
    return ProblemData(problem, groups, (note,) if note else (), module)


def _as_plain(groups: tuple[GroupData, ...]) -> dict[str, Any]:
    return {data.group.name: [data.cases, data.targets] for data in groups}


def _from_plain(plain: Any, problem: Problem, seed: int | None) -> tuple[GroupData, ...] | None:
    """The groups that `_as_plain` wrote, or None if this is anything else."""
    try:
        return tuple(_group(plain[each.name], reseeded(each, seed)) for each in problem.groups)
    except (KeyError, TypeError, ValueError, IndexError):  # whatever a foreign file can hold
        return None


def _group(plain: Any, group: Group) -> GroupData:
    cases, targets = plain
    if len(cases) != group.count or len(targets) != group.count:
        raise ValueError("not this group's data")
    frozen = [_frozen(each) if type(each) is list else each for each in targets]
    return GroupData(group, [_tupled(each) for each in cases], frozen)


def _frozen(plain: list[Any]) -> tuple[Any, ...]:
    """`_tupled` of a target, most of which are five doubles each."""
    if plain and type(plain[0]) is float:
        return tuple(plain)
    return tuple([_frozen(each) if type(each) is list else each for each in plain])


def _tupled(plain: list[Any]) -> tuple[Any, ...]:
    """JSON has no tuples: they come back as lists."""
    return tuple([_tupled(each) if type(each) is list else each for each in plain])
