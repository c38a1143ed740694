"""A problem's data, from the cache or built."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Union

import msgspec
from msgspec import Struct
from msgspec.structs import replace

from judge.data.cache import DataCache
from judge.errors import ProblemError
from judge.problem import Case, Group, Problem, Tolerance
from judge.problem.model import EXAMPLES, tupled
from judge.values.answers import within

if TYPE_CHECKING:
    from judge.problem.module import Module
    from judge.values.answers import Exact, Target

Progress = Callable[[int, int], None]  # cases done, cases in all
_DEEPEST = 12  # lists in lists that are read as tuples at once


class GroupData(Struct, frozen=True):
    """A group's cases and, for each, what an answer is held against.

    `attempts` are those that made the cases (see build.py), and `choices` what each was drawn from, None
    where it was not drawn alone; both are empty where the cases come from the cache.
    """

    group: Group
    cases: list[Case]
    targets: list[Target]
    attempts: tuple[int, ...] = ()
    choices: tuple[tuple[int, ...] | None, ...] = ()


class ProblemData:
    """All groups' data of one problem; `notes` are sentences for the person about how they came to be."""

    def __init__(
        self,
        problem: Problem,
        groups: tuple[GroupData, ...],
        notes: tuple[str, ...] = (),
        module: Module | None = None,
    ) -> None:
        self.problem, self.groups, self.notes = problem, groups, notes
        self._module = module

    def exact(self, case: Case, group: Group) -> tuple[Exact, Tolerance]:
        """The exact answer to a case of that group, and its tolerance. Raises ProblemError.

        Only a rejection's reason and an answer within a hair of the edge need it.
        """
        return within(self.module.solve(*case), group.name), group.tolerance

    @property
    def module(self) -> Module:
        """What problem.py defines; it is loaded on the first use. Raises ProblemError."""
        from judge.problem.module import load_module

        if self._module is None:
            self._module = load_module(self.problem)
        return self._module


def reseeded(group: Group, seed: int | None) -> Group:
    """The group as a run with its own seed has it; None stands for the declared one."""
    if seed is None or group.name == EXAMPLES:
        return group
    import hashlib  # only for who builds other cases

    digest = hashlib.sha256(f"{seed}/{group.name}".encode()).digest()
    return replace(group, seed=int.from_bytes(digest[:8], "big"))


def _decoder(depth: int) -> msgspec.json.Decoder[Any]:
    """For a group's data, its cases and its targets, with tuples for the lists that those are made of."""
    value: Any = None | bool | int | float | str
    for _ in range(depth):
        value = Union[None, bool, int, float, str, tuple[value, ...]]  # noqa: UP007
    data: Any = tuple[list[tuple[value, ...]], list[value]]
    return msgspec.json.Decoder(data)


_DATA = _decoder(_DEEPEST)


def load_data(
    problem: Problem, *, seed: int | None = None, progress: Progress | None = None, cache: bool = True
) -> ProblemData:
    """Every group's cases and targets, in the order of the groups.

    With `seed`, each group's own seed is derived from it. `progress` hears how many cases are built.
    Without `cache` they are built afresh and not kept. Raises ProblemError.
    """
    store = DataCache(problem, seed) if cache else None
    if store is not None:
        kept = _from_plain(store.read(dict[str, msgspec.Raw]), problem, seed)
        if kept is not None:
            return kept
    # Only now: a warm start needs neither the exact numbers nor the builders.
    from judge.data.build import build
    from judge.problem.module import load_module

    module = load_module(problem)
    groups = tuple(build(problem, module, seed, progress))
    note = store.write(_as_plain(groups)) if store is not None else None
    return ProblemData(problem, groups, (note,) if note else (), module)


def _as_plain(groups: tuple[GroupData, ...]) -> dict[str, Any]:
    from judge.data.build import as_seeds

    return {
        data.group.name: [data.cases, data.targets] if data.group.size is None else as_seeds(data)
        for data in groups
    }


def _from_plain(plain: Any, problem: Problem, seed: int | None) -> ProblemData | None:
    """The data that `_as_plain` wrote, or None if this is anything else."""
    module = None
    groups = []
    try:
        for each in problem.groups:
            if each.size is not None and module is None:
                from judge.problem.module import load_module  # big cases are built again

                module = load_module(problem)
            groups.append(_group(plain[each.name], reseeded(each, seed), problem, module))
    except (
        KeyError,
        TypeError,
        ValueError,
        IndexError,
        AttributeError,
        ProblemError,
    ):  # whatever a foreign file can hold
        return None
    return ProblemData(problem, tuple(groups), module=module)


def _group(plain: Any, group: Group, problem: Problem, module: Module | None) -> GroupData:
    cases: Any
    if group.size is not None and module is not None:
        from judge.data.build import from_seeds

        plain = _plain(plain)
        cases, targets = (
            from_seeds(plain, problem, module, group),
            [tupled(each) for each in plain["targets"]],
        )
    else:
        cases, targets = _data(plain)
    if len(cases) != group.count or len(targets) != group.count:
        raise ValueError("not this group's data")
    return GroupData(group, cases, targets)


def _data(plain: Any) -> Any:
    """A group's cases and targets, in tuples."""
    if isinstance(plain, msgspec.Raw):
        try:
            return _DATA.decode(plain)
        except msgspec.ValidationError:  # more lists in lists
            plain = _plain(plain)
    cases, targets = plain
    return [tuple(map(tupled, each)) for each in cases], [tupled(each) for each in targets]


def _plain(plain: Any) -> Any:
    """What is still JSON as values; a file with an infinity has been read whole already."""
    return msgspec.json.decode(plain) if isinstance(plain, msgspec.Raw) else plain
