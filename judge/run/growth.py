"""How CPU time grows with n, beside the reference solution's.

The logarithm of the ratio of both times is fitted against log n by least squares. Its slope is by how much
the submission's exponent exceeds the reference's: it says the same on any machine, in any language.
Groups that take the reference less than 10 ms say nothing. A pair for each size settles most submissions, two
where turns are short; in the grey zone around the limit nine pairs do, and both their medians and the least
times must be too steep. No submission is too steep by one round, nor by two of short turns: a machine that is
busy for a moment looks like that. What is clearly too steep is not run on its largest sizes: see `is_steep`.
What a submission took before its time was up is the least that it takes, so such a group may make the fit
steeper, never flatter, than the groups that came to an end. Of long turns the zone is a third as wide.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

from msgspec import Struct

from judge.run.result import Growth, GrowthPoint, exponent
from judge.run.timing import MOST_PAIRS, Decision, Run, TurnPair, decide, is_clear, quantile, turn

LEAST_SECONDS = 0.01  # of the reference, for a group to count
ROUNDS = 2  # that it takes to be too steep, and of short turns to be accepted
QUICK_SECONDS = 0.2  # turns that are so short
GREY = 0.15  # on either side of the limit
SHORT_SECONDS = 0.5  # turns of the steepest course; where they are shorter, to be too steep takes
ROUNDS_OF_SHORT = 5
_LEAST_CUT = 1.0  # CPU seconds that the first case of a larger size may take in any event
_MORE = 1.3  # times what would be clearly too steep by the turns so far: the next ones may differ


class Course(Struct):
    """One group to be run on: its size n, a turn each, and its limit as a multiple of the reference's time.

    `cases` is how many cases of that size a turn runs, `pairs` are the turns so far. Where a submission ran
    out of time, its turn gives the least that all cases take it, the limit is None and it has not `ended`.
    """

    name: str
    size: int
    submission: Run = lambda: None
    reference: Run = lambda: None
    limit: float | None = None
    cases: int = 1
    ended: bool = True
    pairs: list[TurnPair] = []

    @property
    def least(self) -> TurnPair:
        """The least time of each."""
        return TurnPair(
            min(pair.submission for pair in self.pairs), min(pair.reference for pair in self.pairs)
        )

    @property
    def median(self) -> float:
        """The ratio of the median pair."""
        return quantile(sorted(pair.ratio for pair in self.pairs), 0.5)

    @property
    def counts(self) -> bool:
        """Whether it takes the reference long enough."""
        return self.least.reference >= LEAST_SECONDS

    @property
    def unclear(self) -> bool:
        """Whether it is not clear by its own limit."""
        return self.limit is not None and not is_clear(self.pairs, self.limit)

    @property
    def point(self) -> GrowthPoint:
        """What a case took."""
        mine, theirs = self.least.submission / self.cases, self.least.reference / self.cases
        return GrowthPoint(self.name, self.size, mine, theirs, self.ended)


class Grown(Struct, frozen=True):
    """What the courses came to; `decisions` by name, `growth` is None where fewer than two of them count."""

    growth: Growth | None
    too_steep: bool
    decisions: dict[str, Decision]


class _Fit(NamedTuple):
    """By how much the exponent exceeds the reference's: by the median pairs, and by the least times."""

    courses: Sequence[Course]
    by_medians: float
    by_least: float


def grow(
    courses: Sequence[Course],
    slope: float,
    goes_on: Callable[[], bool] = lambda: True,
    *,
    cautious: bool = False,
) -> Grown:
    """Run the courses in rounds, the smallest first, until it is clear how the submission grows.

    `goes_on` is asked after each round whether there may be another; `cautious` is as in `timing.race`. A
    submission whose turn does not end well is not judged by its growth.
    """
    waiting = [course for course in courses if not course.pairs]
    for number in range(MOST_PAIRS):
        for course in waiting:
            pair = turn(course.submission, course.reference, swapped=number % 2 == 1)
            if pair is None:
                return Grown(None, False, {})
            course.pairs.append(pair)
        if not goes_on():
            break
        if not cautious or number >= ROUNDS:
            waiting = _unclear(courses, slope)
    decisions = {
        course.name: decide(course.pairs, course.limit, cautious=cautious)
        for course in courses
        if course.limit is not None
    }
    fit = _steepest(courses)
    if fit is None:
        return Grown(None, False, decisions)
    reference = exponent([(each.size, each.point.reference_seconds) for each in fit.courses])
    growth = Growth(
        reference + fit.by_medians,
        reference,
        slope,
        tuple(each.name for each in fit.courses),
        max(len(each.pairs) for each in fit.courses),
        borderline=slope - GREY < max(fit[1:]) and min(fit[1:]) < slope + GREY,
        points=tuple(each.point for each in courses if each.counts),
    )
    return Grown(growth, min(fit[1:]) > slope, decisions)


def _unclear(courses: Sequence[Course], slope: float) -> list[Course]:
    """The courses of which more pairs are needed."""
    fit = _steepest(courses)
    grey = False
    if fit is not None:
        largest = fit.courses[-1]
        long = largest.least.submission >= SHORT_SECONDS
        rounds, zone = (ROUNDS, GREY / 3) if long else (ROUNDS_OF_SHORT, GREY)  # long ones differ less
        if max(fit[1:]) > slope - zone:
            grey = min(fit[1:]) < slope + zone or len(largest.pairs) < rounds
    return [each for each in courses if each.unclear or (each.counts and (grey or _is_hasty(each)))]


def _is_hasty(course: Course) -> bool:
    return len(course.pairs) < ROUNDS and course.least.reference < QUICK_SECONDS


def is_steep(smaller: Course, larger: Course, slope: float) -> bool:
    """Whether a submission is clearly too steep by its least time, not short, on the larger size.

    It is so by the worst of its turns on the smaller size and by the slowest turn of the reference on the
    larger one, so that a machine that is busy for a moment rejects nobody.
    """
    own, theirs = larger.least.submission, max(pair.reference for pair in larger.pairs)
    if own < QUICK_SECONDS or not (smaller.counts and larger.counts):
        return False
    ratio = max(pair.ratio for pair in smaller.pairs)
    return exponent([(smaller.size, ratio), (larger.size, own / theirs)]) > slope + GREY


def steep_seconds(smaller: Course, size: int, theirs: float, slope: float) -> float:
    """The CPU time on a larger size that is enough to be clearly too steep, and some more.

    `theirs` is the reference's time there.
    """
    if theirs < LEAST_SECONDS or not smaller.counts:
        return math.inf
    steeper = math.pow(size / smaller.size, slope + GREY)
    return max(_LEAST_CUT, _MORE * max(pair.ratio for pair in smaller.pairs) * theirs * steeper)


def _steepest(courses: Sequence[Course]) -> _Fit | None:
    """All that count, or those that ended where these grow faster; None where they are of one size."""
    counting = [each for each in courses if each.counts]
    ended = [each for each in counting if each.ended]
    fits = [
        _Fit(
            some,
            exponent([(each.size, each.median) for each in some]),
            exponent([(each.size, each.least.ratio) for each in some]),
        )
        for some in (counting, ended)
        if len({each.size for each in some}) > 1
    ]
    return max(fits, key=lambda fit: fit.by_medians, default=None)
