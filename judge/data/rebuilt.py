"""Big cases, kept as what they are built from: the attempt that made each, and a hash of the inputs.

Case i of a group is the builder's answer to the seed text `seed/group/i/attempt` (see build.py).
"""

from __future__ import annotations

import hashlib
import marshal
from collections.abc import Sequence
from typing import Any

from judge.data.build import case_seed
from judge.data.draw import SeededDraw
from judge.data.model import GroupData
from judge.problem import Case, Group, Problem
from judge.problem.module import Module, blaming

_FORM = 2  # of marshal: every version of Python writes it alike, bit by bit


def as_seeds(data: GroupData) -> dict[str, Any]:
    """What the cases of a group that was just built are built from, as JSON; the targets are kept as ever."""
    return {"attempts": data.attempts, "inputs": _hash(data.cases), "targets": data.targets}


def from_seeds(plain: dict[str, Any], problem: Problem, module: Module, group: Group) -> list[Case]:
    """The cases that `as_seeds` wrote.

    Raises:
        ValueError: they are other ones now, or this is none of its objects.
        ProblemError: the builder fails.
    """
    builder = module.draws[group.name]
    with blaming(problem, f"group {group.name!r}: the builder fails"):
        cases = [
            builder(SeededDraw(case_seed(group, at, attempt))) for at, attempt in enumerate(plain["attempts"])
        ]
    if _hash(cases) != plain["inputs"]:
        raise ValueError("the builder makes other cases")
    return cases


def _hash(cases: Sequence[Case]) -> str:
    total = hashlib.sha256()
    for case in cases:
        total.update(marshal.dumps(case, _FORM))  # 1 and 1.0 are two inputs
    return total.hexdigest()
