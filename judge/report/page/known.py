"""What a page needs to know of a problem besides the runs."""

from __future__ import annotations

from collections.abc import Mapping

from msgspec import Struct

from judge.problem import Problem
from judge.run.matrix import Matrix


class KnownProblem(Struct, frozen=True):
    """What is known of a problem now: itself, its mistakes' advice by name, and its matrix if it was made."""

    problem: Problem
    advice: Mapping[str, str] = {}
    matrix: Matrix | None = None
