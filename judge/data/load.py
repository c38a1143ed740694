"""A problem's data: from the cache, one file a problem, or built.

    data/<id>-<place>-own          {"<group>": [[case, …], [target, …]], …}
    data/<id>-<place>-seeded       the same of the last run with a seed

`place` stands for the problem's folder. Of a group with a size the file holds what its cases are built from.
"""

from __future__ import annotations

import os
from typing import Any, Union

from judge.cache import DISK, Store, digest
from judge.data.model import GroupData, ProblemData, Progress, reseeded
from judge.errors import ProblemError
from judge.problem import Problem
from judge.problem.load import problem_key
from judge.problem.model import tupled

FORMAT = 4  # raise it when the form of the file changes
_DEEPEST = 12  # lists in lists that are read as tuples


def _form() -> Any:
    """The type of the file, with tuples for the lists that cases and targets are made of."""
    value: Any = None | bool | int | float | str
    for _ in range(_DEEPEST):
        value = Union[None, bool, int, float, str, tuple[value, ...]]  # noqa: UP007
    return dict[str, tuple[list[tuple[value, ...]], list[value]] | dict[str, Any]]


_FORM = _form()


def load_data(
    problem: Problem,
    *,
    seed: int | None = None,
    progress: Progress | None = None,
    store: Store | None = DISK,
) -> ProblemData:
    """Every group's cases and targets, in the order of the groups.

    With `seed`, each group's own seed is derived from it. `progress` hears how many cases are built.
    Without a `store` they are built afresh and not kept. Raises ProblemError.
    """
    place = data_name("data", problem, seed), data_key(problem, seed)
    kept = _data(store.read(*place, _FORM), problem, seed) if store else None
    if kept is not None:
        return kept
    # Only now: a warm start needs neither the exact numbers nor the builders.
    from judge.data.build import build
    from judge.data.rebuilt import as_seeds
    from judge.problem.module import load_module

    module = load_module(problem)
    groups = tuple(build(problem, module, seed, progress))
    note = None
    if store and problem.key and problem_key(problem.folder) == problem.key:  # its files are still these
        plain = {
            data.group.name: [data.cases, data.targets] if data.group.size is None else as_seeds(data)
            for data in groups
        }
        note = store.write(*place, plain)
    return ProblemData(problem, groups, (note,) if note else (), module)


def is_kept(problem: Problem, seed: int | None) -> bool:
    """Whether the data are in the cache."""
    name, key = data_name("data", problem, seed), data_key(problem, seed)
    return DISK.read(name, key, dict[str, Any]) is not None


def data_name(folder: str, problem: Problem, seed: int | None) -> str:
    """The name in that folder of the store of what is kept for this problem, in this place, for a seed."""
    place = digest(os.fsencode(problem.folder))[:8]
    return f"{folder}/{problem.id}-{place}-{'own' if seed is None else 'seeded'}"


def data_key(problem: Problem, seed: int | None) -> str:
    """The key of all that the data are made from."""
    return f"{FORMAT}/{seed}/{problem.key}"


def _data(plain: Any, problem: Problem, seed: int | None) -> ProblemData | None:
    """The data that were written, or None if this is anything else."""
    module = None
    groups = []
    try:
        for each in problem.groups:
            group, kept = reseeded(each, seed), plain[each.name]
            if each.size is None:
                cases, targets = kept
            else:  # big cases are built again
                from judge.data.rebuilt import from_seeds
                from judge.problem.module import load_module

                module = module or load_module(problem)
                cases, targets = from_seeds(kept, problem, module, group), list(map(tupled, kept["targets"]))
            if len(cases) != group.count or len(targets) != group.count:
                return None
            groups.append(GroupData(group, cases, targets))
    except (KeyError, TypeError, ValueError, IndexError, AttributeError, ProblemError):
        return None  # whatever a foreign file can hold
    return ProblemData(problem, tuple(groups), module=module)
