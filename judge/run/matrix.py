"""The kill matrix: which group rejects which wrong program.

Pure computing on what judging the wrong programs came to; nothing is run here.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction

from msgspec import Struct

from judge.problem import Group
from judge.run.result import Behaviour


class Kill(Struct, frozen=True):
    """What one group does to one wrong program: `rejected` of its `cases`, numbered from 1."""

    group: str
    rejected: tuple[int, ...]
    cases: int

    @property
    def share(self) -> Fraction:
        """The part of the group's cases that the program gets wrong."""
        return Fraction(len(self.rejected), self.cases)


class Row(Struct, frozen=True):
    """A wrong program: its mistake, the groups whose `kills` name that, and every group's effect in order."""

    file: str  # as wrong/absolute-epsilon.py
    mistake: str
    aimed: tuple[str, ...]
    kills: tuple[Kill, ...]

    @property
    def killing(self) -> tuple[Kill, ...]:
        """The groups that reject it."""
        return tuple(kill for kill in self.kills if kill.rejected)

    @property
    def own(self) -> Kill | None:
        """Of the groups that name its mistake and reject it, the one that does so in the largest share."""
        named = [kill for kill in self.killing if kill.group in self.aimed]
        return max(named, key=lambda kill: kill.share, default=None)


class Matrix(Struct, frozen=True):
    """All wrong programs of a problem against all its groups."""

    groups: tuple[str, ...]
    rows: tuple[Row, ...]


def kill_matrix(
    groups: Sequence[Group], sizes: Mapping[str, int], programs: Iterable[tuple[str, str, Behaviour]]
) -> Matrix:
    """The matrix of wrong programs, each given as its file, its mistake and what it answers.

    `sizes` are how many cases the groups have. A case counts as it went within its group: a program that
    keeps state may pass it when called alone. What was never run, since the program had been given up,
    rejects nothing.
    """
    rows = tuple(_row(groups, sizes, *program) for program in programs)
    return Matrix(tuple(group.name for group in groups), rows)


def _row(groups: Sequence[Group], sizes: Mapping[str, int], file: str, mistake: str, does: Behaviour) -> Row:
    return Row(
        file,
        mistake,
        tuple(group.name for group in groups if mistake in group.kills),
        tuple(
            Kill(name, tuple(index + 1 for index in sorted(answers.wrong)), sizes[name])
            for name, answers in does.items()
        ),
    )
