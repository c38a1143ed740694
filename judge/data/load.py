"""A problem's data: from the cache, one file a problem, or built.

    data/<id>-<place>-own          {"<group>": [[case, …], [target, …]], …}
    data/<id>-<place>-seeded       the same of the last run with a seed

`place` stands for the problem's folder.
"""

from __future__ import annotations

import os
from typing import Any, Union

from judge.cache import DISK, Store, digest
from judge.data import GroupData, ProblemData, Progress, Within, reseeded
from judge.problem import Problem
from judge.problem.load import problem_key
from judge.problem.model import tupled

FORMAT = 6  # raise it when the form of the file changes

_value: Any = None | bool | int | float | str
for _ in range(12):  # lists in lists, which are read as the tuples that cases and targets are made of
    _value = Union[None, bool, int, float, str, tuple[_value, ...]]  # noqa: UP007
_FORM: Any = dict[str, tuple[list[tuple[_value, ...]], list[_value]]]


def load_data(
    problem: Problem,
    *,
    seed: int | None = None,
    progress: Progress | None = None,
    store: Store | None = DISK,
    within: Within | None = None,
) -> ProblemData:
    """Every group's cases and targets, in the order of the groups.

    With `seed`, each group's own seed is derived from it. `progress` hears how many cases are built, and each
    of them is solved `within` what is given.
    Without a `store` they are built afresh and not kept. Raises ProblemError.
    """
    place = kept_place("data", problem, seed)
    # The form has no place for several right answers: they are read without one.
    plain = store and (store.read(*place, _FORM) or tupled(store.read(*place, dict[str, Any])))
    kept = _data(plain, problem, seed) if plain else None
    if kept is not None:
        return kept
    # Only now: a warm start needs neither the exact numbers nor the builders.
    from judge.data.build import build

    data = ProblemData(problem, ())
    data.groups = tuple(build(problem, data.module, seed, progress, within))
    if store and problem.key and problem_key(problem.folder) == problem.key:  # its files are still these
        plain = {each.group.name: [each.cases, each.targets] for each in data.groups}
        data.notes = tuple(filter(None, [store.write(*place, plain)]))
    return data


def kept_place(folder: str, problem: Problem, seed: int | None) -> tuple[str, str]:
    """The name in that folder of the store of what is kept for this problem, in this place, for a seed.

    After it the key of all that the data are made from.
    """
    place = digest(os.fsencode(problem.folder))[:8]
    name = f"{folder}/{problem.id}-{place}-{'own' if seed is None else 'seeded'}"
    return name, f"{FORMAT}/{seed}/{problem.key}"


def _data(plain: Any, problem: Problem, seed: int | None) -> ProblemData | None:
    """The data that were written, or None if this is anything else."""
    data = ProblemData(problem, ())
    try:
        for each in problem.groups:
            cases, targets = plain[each.name]
            if len(cases) != each.count or len(targets) != each.count:
                return None
            data.groups += (GroupData(reseeded(each, seed), list(cases), list(targets)),)
    except (KeyError, TypeError, ValueError):
        return None  # whatever a foreign file can hold
    return data
