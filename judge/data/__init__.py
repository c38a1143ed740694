"""Test data: cases drawn, proved, solved, pinned and cached."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from judge.problem import Case, Group, Problem, Tolerance
from judge.problem.model import EXAMPLES
from judge.values.answers import within

if TYPE_CHECKING:
    from judge.problem.module import Module
    from judge.values.answers import Exact, Target

Progress = Callable[[int, int], None]  # cases done, cases in all
Within = Callable[[str, int, Case], AbstractContextManager[None]]  # what a case of a group is solved in


class GroupData(Struct, frozen=True):
    """A group's cases and, for each, what an answer is held against.

    `attempts` are those that made the cases (see build.py); empty where these come from the cache.
    """

    group: Group
    cases: list[Case]
    targets: list[Target]
    attempts: tuple[int, ...] = ()


class ProblemData(Struct, eq=False):
    """All groups' data of one problem; `notes` are sentences for the person about how they came to be.

    `loaded` is the module, where it is.
    """

    problem: Problem
    groups: tuple[GroupData, ...]
    notes: tuple[str, ...] = ()
    loaded: Module | None = None

    def exact(self, case: Case, group: Group) -> tuple[Exact, Tolerance]:
        """The exact answer to a case of that group, and its tolerance. Raises ProblemError.

        Only a rejection's reason and an answer within a hair of the edge need it.
        """
        return within(self.module.solve(*case), group.name), group.tolerance

    @property
    def module(self) -> Module:
        """What problem.py defines; it is loaded on the first use. Raises ProblemError."""
        from judge.problem.module import load_module

        if self.loaded is None:
            self.loaded = load_module(self.problem)
        return self.loaded


def reseeded(group: Group, seed: int | None) -> Group:
    """The group as a run with its own seed has it; None stands for the declared one."""
    if seed is None or group.name == EXAMPLES:
        return group
    import hashlib  # only for who builds other cases

    own = hashlib.sha256(f"{seed}/{group.name}".encode()).hexdigest()[:16]
    return replace(group, seed=int(own, 16))
