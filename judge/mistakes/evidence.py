"""How far one test group speaks for a mistake: the logarithm of a ratio of likelihoods.

Above the line stands the likelihood of the submission's wrong answers in the group if it makes the mistake of
a known program, below it that of a program that makes some mistake, known or not. One
program explains another in any of three ways:

    by answers   the same cases fail, mostly with the same answers
    by kinds     the same cases fail with answers of one kind, as where digits are lost
    by shares    about as many cases fail, whichever they are: chance decides where rounding does

A wrong answer that most mistakes lead to says less than a rare one, and so does a group in which most fail.
A group's cases are much alike, so that all of them together count as no more than a few independent ones, and
no group counts for more than a hundred to one.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence

from judge.mistakes.agreement import WrongAnswer, is_ended
from judge.mistakes.likeness import Overlap
from judge.mistakes.packed import PackedWrong
from judge.run.result import Answers
from judge.values.atoms import Type
from judge.values.outline import Outline, Usual

_INDEPENDENT = 6.0  # cases that a group is worth at most
_BOUND = math.log(100)
_WAYS = (math.log(0.45), math.log(0.25), math.log(0.25))  # by answers, by kinds, by shares; else none of them

# Where the known program is wrong, the submission gives by answers …
_SAME = 0.85
_KIND = 0.07
_OTHER = math.log(0.03)
_RIGHT = math.log(0.05)
# … by kinds …
_ALIKE = 0.8
_UNLIKE = math.log(0.1)
# … and by shares; where the known program is right, it is wrong with _STRAY.
_UNLIKE_BY_CHANCE = math.log(0.7)
_STRAY, _NO_STRAY = math.log(0.02), math.log(0.98)
_EITHER = math.log(0.5)

_CLEAN = math.log(0.95)  # a group that the known program passes is passed
_DIRTY = math.log(0.05)  # … and for the rest it may fail in any way
_SURVIVES = 0.05  # a group that the known program fails is passed, whatever the share
_UNHEARD_OF = 0.15  # a share of failures that no known program has
_ANY_SHARE = (0.02, 0.2, 0.5, 0.8, 0.99)
_ODDS = ((1.0, math.log(0.6)), (4.0, math.log(0.2)), (0.25, math.log(0.2)))  # of the share in another program
_MISTAKES = 20.0  # that can be made in a problem, at least, be they known or not
_FAILS = 0.3  # of the test groups, a mistake that is not known
_PRIOR = 0.3  # the weight of what is assumed of an answer before any known program has been asked


def log_sum(logarithms: Iterable[float]) -> float:
    """The logarithm of the sum of numbers that are given by their logarithms."""
    terms = list(logarithms)
    largest = max(terms)
    return largest + math.log(math.fsum(math.exp(term - largest) for term in terms))


def _overlap(ours: Answers, wrong: Mapping[int, WrongAnswer], theirs: Answers) -> Overlap:
    """Compare two programs on the cases where both are known."""
    if not wrong and ours.reached == theirs.reached:
        return Overlap(_NONE, _NONE, _NONE, _NONE, theirs.wrong, ours.reached)
    mine, yours = set(wrong), set(theirs.wrong)
    both = mine & yours
    size = min(ours.reached, theirs.reached)
    mine -= yours
    yours -= both
    if ours.reached != theirs.reached:
        mine = {case for case in mine if case < size}
        yours = {case for case in yours if case < size}
    size += sum(case >= size for case in both)
    if not both:
        return Overlap(_NONE, _NONE, _NONE, frozenset(mine), frozenset(yours), size)
    found: tuple[list[int], ...] = ([], [], [])
    others = theirs.wrong
    if isinstance(others, PackedWrong):
        for case in both:
            found[wrong[case].alike(others[case], others.kind(case))].append(case)
    else:
        for case in both:
            found[wrong[case].alike(others[case])].append(case)
    other, kind, same = map(frozenset, found)
    ended = sum(is_ended(ours.wrong[case]) and is_ended(others[case]) for case in kind)
    return Overlap(same, kind, other, frozenset(mine), frozenset(yours), size, 0, ended)


_NONE: frozenset[int] = frozenset()


class Evidence:
    """What one group says of every known program; `weights` are theirs, of which those of a mistake sum to 1.

    `chance` says for which of them chance may decide which cases fail; without it, for all. `ratios` holds
    the logarithm for each of them, and `shares` how much of the group it fails.
    """

    def __init__(
        self,
        ours: Answers,
        theirs: Sequence[Answers | None],
        weights: Sequence[float],
        rights: Sequence[Outline],
        answer: Type,
        usual: Usual,
        chance: Sequence[bool] = (),
    ) -> None:
        self._ours = ours
        self._chance = chance or [True] * len(theirs)
        self._passed: dict[float, float] = {}
        self._wrong = {
            case: WrongAnswer(given, rights[case], answer, usual) for case, given in ours.wrong.items()
        }
        self._failed = len(ours.wrong)
        self._size = max(1, ours.reached + sum(case >= ours.reached for case in ours.wrong))
        self._worth = min(1.0, _INDEPENDENT / self._size)
        self._overlaps = [_overlap(ours, self._wrong, each) if each else None for each in theirs]
        self._weigh_answers(weights)
        self._by_share: dict[float, float] = {}
        self.shares = [each.failed / max(1, each.size) if each else 0.0 for each in self._overlaps]
        self._unknown = self._of_unknown(weights)
        self.ratios = [
            self._ratio(each, each_chance) if each else 0.0
            for each, each_chance in zip(self._overlaps, self._chance, strict=True)
        ]

    @property
    def failed_share(self) -> float:
        """How much of the group the submission fails."""
        return self._failed / self._size

    def overlap(self, place: int) -> Overlap | None:
        """The cases by what the submission and one known program answered."""
        return self._overlaps[place]

    def both(self, one: int, other: int) -> Overlap | None:
        """The same of a program that fails wherever either of two known ones fails."""
        first, second = self._overlaps[one], self._overlaps[other]
        if not first or not second:
            return None
        return _joined(first, second, frozenset(first.theirs) | frozenset(second.theirs), 0)

    def midway(self, one: int, other: int) -> Overlap | None:
        """The same of a program that fails where both known ones fail, and may where one of them does."""
        first, second = self._overlaps[one], self._overlaps[other]
        if not first or not second:
            return None
        undecided = len(first.ours ^ second.ours) + len(frozenset(first.theirs) ^ frozenset(second.theirs))
        return _joined(first, second, frozenset(first.theirs) & frozenset(second.theirs), undecided)

    def beside(self, theirs: Answers | None) -> Overlap | None:
        """The same of a program that is not among the known ones; None where nothing is known of it."""
        return _overlap(self._ours, self._wrong, theirs) if theirs else None

    def union(self, one: int, other: int) -> float:
        """The ratio for a program that fails wherever either of two known ones fails."""
        first, second = self._overlaps[one], self._overlaps[other]
        if first and second and not (first.failed and second.failed):
            return self.ratios[one if first.failed else other]
        found = self.both(one, other)
        return self._ratio(found, self._chance[one] or self._chance[other]) if found else 0.0

    def between(self, one: int, other: int) -> float:
        """The ratio for a program that fails where both known ones fail, and may where one of them does."""
        found = self.midway(one, other)
        return self._ratio(found, self._chance[one]) if found else 0.0

    def against(self, theirs: Answers, chance: bool = True) -> float:
        """The ratio for a program that is not among the known ones."""
        return self._ratio(_overlap(self._ours, self._wrong, theirs), chance)

    def _weigh_answers(self, weights: Sequence[float]) -> None:
        """How much each of the submission's wrong answers counts, by how many mistakes lead to the like."""
        others = _PRIOR + 0.1 + _FAILS * max(0.0, _MISTAKES - math.fsum(weights))
        same, kind, wrong = (defaultdict[int, float](float) for _ in range(3))
        for each, weight in zip(self._overlaps, weights, strict=True):
            if each:
                for counter, cases in ((same, each.same), (kind, each.kind), (wrong, each.other)):
                    for case in cases:
                        counter[case] += weight
        self._same: dict[int, float] = {}
        self._kind: dict[int, float] = {}
        self._alike: dict[int, float] = {}
        for case in self._ours.wrong:
            total = same[case] + kind[case] + wrong[case] + others
            this = (same[case] + 0.3 * _PRIOR) / total
            like_this = (same[case] + kind[case] + 0.6 * _PRIOR) / total
            self._same[case] = math.log(_SAME / this)
            self._kind[case] = math.log(_KIND / like_this)
            self._alike[case] = math.log(_ALIKE / like_this)

    def _of_unknown(self, weights: Sequence[float]) -> float:
        """The likelihood of an unknown mistake: as much fails as in some known program, or any share."""
        total = max(_MISTAKES, math.fsum(weights))
        mass = {0.0: (1 - _FAILS) * (total - math.fsum(weights)) / total}
        for share, weight, each in zip(self.shares, weights, self._overlaps, strict=True):
            if each:
                mass[round(share, 2)] = mass.get(round(share, 2), 0.0) + weight / total
        if self._failed:
            del mass[0.0]
        heard_of = [
            math.log((1 - _UNHEARD_OF) * part) + self._of_share(share) for share, part in mass.items() if part
        ]
        unheard_of = _UNHEARD_OF + (1 - _UNHEARD_OF) * _FAILS * (total - math.fsum(weights)) / total
        any_share = math.log(unheard_of / len(_ANY_SHARE))
        return log_sum(heard_of + [any_share + self._of_share(share) for share in _ANY_SHARE])

    def _of_share(self, share: float) -> float:
        """The likelihood of how many cases fail, of a program that fails the share of them, give or take."""
        found = self._by_share.get(share)
        if found is None:
            found = self._by_share[share] = self._of_new_share(share)
        return found

    def _of_new_share(self, share: float) -> float:
        if not share:
            return _CLEAN
        if not self._failed:
            return math.log(0.5 * (1 - share) ** (self._worth * self._size) + _SURVIVES)
        least = 0.5 / self._size
        terms = []
        for factor, weight in _ODDS:
            odds = factor * share / max(1 - share, least)
            rate = min(max(odds / (1 + odds), least), 1 - least)
            passed = self._size - self._failed
            terms.append(weight + self._worth * (self._failed * math.log(rate) + passed * math.log(1 - rate)))
        return log_sum(terms)

    def _ratio(self, each: Overlap, chance: bool = True) -> float:
        share = (each.failed + each.open / 2) / max(1, each.size)
        if self._failed and not share:
            return _DIRTY
        if not self._failed:
            found = self._passed.get(share)
            if found is None:
                found = self._passed[share] = self._likely(each, share, chance)
            return found
        return self._likely(each, share, chance)

    def _likely(self, each: Overlap, share: float, chance: bool) -> float:
        likelihood = self._of_share(max(0.01, round(share, 2)) if share else 0.0)
        if share and self._failed:
            likelihood = self._of_overlap(each, likelihood, chance)
        known, unknown = likelihood, self._unknown
        return log_sum((known, unknown - _BOUND)) - log_sum((unknown, known - _BOUND))

    def _of_overlap(self, each: Overlap, of_share: float, chance: bool) -> float:
        both = len(each.same) + len(each.kind) + len(each.other)
        right = each.size - both - len(each.ours) - len(each.theirs)
        rest = len(each.ours) * _STRAY + right * _NO_STRAY + each.open * _EITHER
        by_answers = (
            math.fsum(self._same[case] for case in each.same)
            + math.fsum(self._kind[case] for case in each.kind)
            + len(each.other) * _OTHER
            + len(each.theirs) * _RIGHT
        )
        by_kinds = (
            math.fsum(self._alike[case] for cases in (each.same, each.kind) for case in cases)
            + (len(each.other) + len(each.theirs)) * _UNLIKE
        )
        ways = (
            self._worth * (by_answers + rest),
            self._worth * (by_kinds + rest),
            of_share + self._worth * len(each.other) * _UNLIKE_BY_CHANCE,
        )
        return log_sum(
            prior + way for prior, way in list(zip(_WAYS, ways, strict=True))[: 3 if chance else 2]
        )


def _joined(one: Overlap, other: Overlap, theirs: frozenset[int], undecided: int) -> Overlap:
    """Two known programs as one: where both are wrong, the one that is more like the submission counts."""
    same = one.same | other.same
    kind = (one.kind | other.kind) - same
    unlike = (one.other | other.other) - same - kind
    ours, size, ended = one.ours & other.ours, min(one.size, other.size), max(one.ended, other.ended)
    return Overlap(same, kind, unlike, ours, theirs, size, undecided, ended)
