"""How alike a submission and a hypothesis are over all cases: what best explains need not be what is there.

Evidence is relative: the least bad of the known mistakes wins where none fits. What a mistake does is known
case by case, though, so that a program that makes it fails nearly the same cases with the same answers. One
that fails many others, or passes many of them, does something else, and nothing is said of it.

Where chance decides which cases fail, as with rounding, far less agrees.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

from msgspec import Struct

_NEARLY_ALL = 0.9  # of all wrong answers of either, that are the same in both
_TRUE = (
    0.97  # of the hypothesis's wrong answers, that the submission gives; then it may fail other cases too …
)
_COVERED = 0.5  # … but no more than these of its own are unexplained
_HALF = 0.5  # of all wrong answers of either, where chance decides; or less, if all else …
_BY_CHANCE, _SURE = 0.2, 0.85  # … makes it sure: the share, and the score
BOTH = 0.92  # the same for two mistakes at once, by the program that makes both
IN_PART = 0.7  # where it does for one of two mistakes
NEEDED = 0.02  # by how much less than two mistakes each of them explains alone; less is a side of the one


class Overlap(Struct, frozen=True):
    """The cases of one group by what a submission and a known program answered."""

    same: frozenset[int]  # both wrong with the same answer
    kind: frozenset[int]  # both wrong with answers of one kind
    other: frozenset[int]  # both wrong in different ways
    ours: frozenset[int]  # only the submission is wrong
    theirs: Collection[int]  # only the known program is
    size: int
    open: int = 0  # cases in which either would fit
    ended: int = 0  # of `kind`, how often both end by an exception

    @property
    def failed(self) -> int:
        """How many the known program fails."""
        return len(self.same) + len(self.kind) + len(self.other) + len(self.theirs)

    def within(self, cases: Iterable[int]) -> Overlap:
        """The same of some cases."""
        only = frozenset(cases)
        same, kind, other, ours = (part & only for part in (self.same, self.kind, self.other, self.ours))
        return Overlap(
            same, kind, other, ours, only.intersection(self.theirs), len(only), 0, min(self.ended, len(kind))
        )


class Likeness(Struct, frozen=True):
    """The wrong answers of a submission and a hypothesis, by number: the same in both, and of each one all.

    `alike` are those of one kind as well, such as digits that are lost in different ways. Of the cases that a
    hypothesis leaves open it fails one half.
    """

    same: int
    alike: int
    ours: int
    theirs: float

    @staticmethod
    def of(overlaps: Iterable[Overlap | None]) -> Likeness:
        """Over all groups."""
        same, alike, ours, theirs = 0, 0, 0, 0.0
        for each in overlaps:
            if each is not None:
                same += len(each.same) + each.ended
                alike += len(each.same) + len(each.kind)
                ours += each.failed - len(each.theirs) + len(each.ours)
                theirs += each.failed + each.open / 2
        return Likeness(same, alike, ours, theirs)

    @property
    def share(self) -> float:
        """How much of what either fails both fail alike: 1 if they answer the same everywhere."""
        return self._of_either(self.same)

    def _of_either(self, both: int) -> float:
        failed = self.ours + self.theirs - both
        return both / failed if failed else 0.0

    def enough(self, chances: Sequence[bool], score: float) -> bool:
        """Whether it is enough for a name of that score; `chances` say of each one whether chance decides."""
        if all(chances):
            share = self._of_either(self.alike)
            return share >= _HALF or (share >= _BY_CHANCE and score >= _SURE)
        if any(chances):
            return self.share >= IN_PART
        if self.share >= _NEARLY_ALL:
            return True
        if len(chances) > 1:
            return False  # two can be made to fit too much
        return self.same >= _TRUE * self.theirs and self.same >= _COVERED * self.ours
