"""How alike a submission and a hypothesis are over all cases: what best explains need not be what is there.

Evidence is relative: the least bad of the known mistakes wins where none fits. What a mistake does is known
case by case, though, so that a program that makes it fails nearly the same cases with the same answers. One
that fails many others, or passes many of them, does something else, and nothing is said of it.

Where chance decides which cases fail, as with rounding, far less agrees.
"""

from __future__ import annotations

from collections.abc import Iterable

from msgspec import Struct

from judge.mistakes.evidence import Overlap

_NEARLY_ALL = 0.9  # of all wrong answers of either, that are the same in both
_TRUE = (
    0.97  # of the hypothesis's wrong answers, that the submission gives; then it may fail other cases too …
)
_COVERED = 0.5  # … but no more than these of its own are unexplained
_BY_CHANCE = 0.2  # of all wrong answers of either, where chance decides
_IN_PART = 0.6  # where it does for one of two mistakes


class Likeness(Struct, frozen=True):
    """The wrong answers of a submission and a hypothesis, by number: the same in both, and of each one all.

    Of the cases that a hypothesis leaves open it fails one half.
    """

    same: int
    ours: int
    theirs: float

    @staticmethod
    def of(overlaps: Iterable[Overlap | None]) -> Likeness:
        """Over all groups."""
        same, ours, theirs = 0, 0, 0.0
        for each in overlaps:
            if each is not None:
                same += len(each.same) + each.ended
                ours += each.failed - len(each.theirs) + len(each.ours)
                theirs += each.failed + each.open / 2
        return Likeness(same, ours, theirs)

    @property
    def share(self) -> float:
        """How much of what either fails both fail alike: 1 if they answer the same everywhere."""
        failed = self.ours + self.theirs - self.same
        return self.same / failed if failed else 0.0

    def enough(self, chances: Iterable[bool]) -> bool:
        """Whether it is enough; `chances` say of each mistake whether chance decides where it shows."""
        by_chance = list(chances)
        if any(by_chance):
            return self.share >= (_BY_CHANCE if all(by_chance) else _IN_PART)
        if self.share >= _NEARLY_ALL:
            return True
        return self.same >= _TRUE * self.theirs and self.same >= _COVERED * self.ours
