"""The two levels of a kata: what an interviewer asks, and what a program meets in use.

A test group says its level in problem.toml, or no group of the problem does: then there is one level, and
nobody speaks of it. How a submission is held while it runs is its isolation, which is something else.
"""

from __future__ import annotations

from collections.abc import Iterable
from enum import Enum


class KataLevel(Enum):
    """What a test group belongs to, the easier first; the value is its name in problem.toml and in JSON."""

    INTERVIEW = "interview"
    PRODUCTION = "production"

    @property
    def meaning(self) -> str:
        """What its test groups ask of a program."""
        if self is KataLevel.INTERVIEW:
            return "the kinds of cases there are, at sizes that a textbook has"
        return "sizes from tiny to huge, places far from the origin, the edges of bands, last digits, growth"


LEVELS = tuple(level.value for level in KataLevel)


def levels_among(found: Iterable[KataLevel | None]) -> tuple[KataLevel, ...]:
    """The levels there are among these, the easier first."""
    there = set(found)
    return tuple(level for level in KataLevel if level in there)
