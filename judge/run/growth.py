"""How CPU time grows with n, beside the reference solution's.

The logarithm of the ratio of both times is fitted against log n by least squares. Its slope is by how much
the submission's exponent exceeds the reference's: it says the same on any machine, in any language.
Groups that take the reference less than 10 ms say nothing. A pair for each size settles most submissions, two
where turns are short; in the grey zone around the limit nine pairs do, and both their medians and the least
times must be too steep. No submission is too steep by one round, nor by two of short turns: a machine that is
busy for a moment looks like that. What is clearly too steep is not run on its largest sizes: see `is_steep`.
What a submission took before its time was up is the least that it takes, so such a group may make the fit
steeper, never flatter, than the groups that came to an end.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from msgspec import Struct
from msgspec.structs import replace

from judge.run.result import Growth, GrowthPoint
from judge.run.timing import MOST_PAIRS, Decision, Run, TurnPair, decide, is_clear, quantile, turn

LEAST_SECONDS = 0.01  # of the reference, for a group to count
ROUNDS = 2  # that it takes to be too steep, and of short turns to be accepted
QUICK_SECONDS = 0.2  # turns that are so short
GREY = 0.15  # on either side of the limit
SHORT_SECONDS = 0.5  # turns of the steepest course; where they are shorter, to be too steep takes
ROUNDS_OF_SHORT = 5
_LEAST_CUT = 1.0  # CPU seconds that the first case of a larger size may take in any event
_MORE = 1.3  # times what would be clearly too steep by the turns so far: the next ones may differ
_SHORTEST = 1e-4  # seconds: what takes less cannot be told from nothing


class GrowthSample(Struct, frozen=True):
    """One group to be run on: its size n, a turn each, and its limit as a multiple of the reference's time.

    `cases` is how many cases of that size a turn runs, `first` the pair of when it was judged, if known.
    Where a submission ran out of time, its turn gives the least that all cases take it, the limit is None and
    it has not `ended`.
    """

    name: str
    size: int
    submission: Run = lambda: None
    reference: Run = lambda: None
    limit: float | None = None
    cases: int = 1
    ended: bool = True
    first: TurnPair | None = None


class Grown(Struct, frozen=True):
    """What the courses came to; `decisions` by name, `growth` is None where fewer than two of them count."""

    growth: Growth | None
    too_steep: bool
    decisions: dict[str, Decision]


def grow(
    courses: Sequence[GrowthSample],
    slope: float,
    goes_on: Callable[[], bool] = lambda: True,
    *,
    cautious: bool = False,
) -> Grown:
    """Run the courses in rounds, the smallest first, until it is clear how the submission grows.

    `goes_on` is asked after each round whether there may be another; `cautious` is as in `timing.race`. A
    submission whose turn does not end well is not judged by its growth.
    """
    pairs = {course.name: [course.first] if course.first else [] for course in courses}
    waiting = [course for course in courses if course.first is None]
    for number in range(MOST_PAIRS):
        for course in waiting:
            pair = turn(course.submission, course.reference, swapped=number % 2 == 1)
            if pair is None:
                return Grown(None, False, {})
            pairs[course.name].append(pair)
        if not goes_on():
            break
        if not cautious or number >= ROUNDS:
            waiting = _unclear(courses, pairs, slope)
    decisions = {
        each.name: replace(decide(pairs[each.name], each.limit, cautious=cautious), limit=each.limit)
        for each in courses
        if each.limit is not None
    }
    counting = _counting(courses, pairs)
    if not _differ(counting):
        return Grown(None, False, decisions)
    steepest, by_medians, by_least = _steepest(counting, pairs)
    reference = exponent([(each.size, _least(pairs[each.name]).reference / each.cases) for each in steepest])
    growth = Growth(
        reference + by_medians,
        reference,
        slope,
        tuple(each.name for each in steepest),
        max(len(pairs[each.name]) for each in steepest),
        borderline=slope - GREY < max(by_medians, by_least) and min(by_medians, by_least) < slope + GREY,
        points=tuple(_point(each, _least(pairs[each.name])) for each in counting),
    )
    return Grown(growth, by_medians > slope and by_least > slope, decisions)


def _unclear(
    courses: Sequence[GrowthSample], pairs: dict[str, list[TurnPair]], slope: float
) -> list[GrowthSample]:
    """The courses of which more pairs are needed."""
    counting = _counting(courses, pairs)
    grey = False
    if _differ(counting):
        steepest, by_medians, by_least = _steepest(counting, pairs)
        largest = pairs[max(steepest, key=lambda each: each.size).name]
        hasty = len(largest) < (ROUNDS if _least(largest).submission >= SHORT_SECONDS else ROUNDS_OF_SHORT)
        near = min(by_medians, by_least) < slope + GREY
        grey = max(by_medians, by_least) > slope - GREY and (near or hasty)
    return [
        each
        for each in courses
        if (each in counting and (grey or _is_hasty(pairs[each.name])))
        or (each.limit is not None and not is_clear(pairs[each.name], each.limit))
    ]


def _is_hasty(pairs: Sequence[TurnPair]) -> bool:
    return len(pairs) < ROUNDS and _least(pairs).reference < QUICK_SECONDS


def is_steep(
    sizes: tuple[int, int], pairs: Sequence[TurnPair], own: float, theirs: Sequence[float], slope: float
) -> bool:
    """Whether a submission is clearly too steep by its `own` least time, not short, on the larger size.

    It is so by the worst of its `pairs` on the smaller size and by the slowest turn of the reference on the
    larger one, so that a machine that is busy for a moment rejects nobody.
    """
    if own < QUICK_SECONDS or min(*theirs, *(pair.reference for pair in pairs)) < LEAST_SECONDS:
        return False
    ratios = max(pair.ratio for pair in pairs), own / max(theirs)
    return exponent([*zip(sizes, ratios, strict=True)]) > slope + GREY


def steep_seconds(sizes: tuple[int, int], pair: TurnPair, theirs: float, slope: float) -> float:
    """The CPU time on the larger size that is enough to be clearly too steep, and some more.

    `pair` is that of the smaller size, `theirs` the reference's time on the larger one.
    """
    if min(theirs, pair.reference) < LEAST_SECONDS:
        return math.inf
    steeper = math.pow(sizes[1] / sizes[0], slope + GREY)
    return max(_LEAST_CUT, _MORE * pair.ratio * theirs * steeper)


def _counting(courses: Sequence[GrowthSample], pairs: dict[str, list[TurnPair]]) -> list[GrowthSample]:
    """Those that take the reference long enough."""
    return [each for each in courses if _least(pairs[each.name]).reference >= LEAST_SECONDS]


def _differ(courses: Sequence[GrowthSample]) -> bool:
    """Whether they are of two sizes at least."""
    return len({each.size for each in courses}) > 1


def _point(course: GrowthSample, least: TurnPair) -> GrowthPoint:
    mine, theirs = least.submission / course.cases, least.reference / course.cases
    return GrowthPoint(course.name, course.size, mine, theirs, course.ended)


def _steepest(
    counting: Sequence[GrowthSample], pairs: dict[str, list[TurnPair]]
) -> tuple[Sequence[GrowthSample], float, float]:
    """All courses, or those that ended where these grow faster; by how much their exponent exceeds."""
    ended = [each for each in counting if each.ended]
    every = (counting, *_slopes(counting, pairs))
    if len(ended) == len(counting) or not _differ(ended):
        return every
    return max(every, (ended, *_slopes(ended, pairs)), key=lambda fit: fit[1])


def _slopes(courses: Sequence[GrowthSample], pairs: dict[str, list[TurnPair]]) -> tuple[float, float]:
    """By how much the exponent exceeds the reference's: by the median pairs, and by the least times."""
    medians = [
        (each.size, quantile(sorted(pair.ratio for pair in pairs[each.name]), 0.5)) for each in courses
    ]
    least = [(each.size, _least(pairs[each.name]).ratio) for each in courses]
    return exponent(medians), exponent(least)


def _least(pairs: Sequence[TurnPair]) -> TurnPair:
    """The least time of each."""
    return TurnPair(min(pair.submission for pair in pairs), min(pair.reference for pair in pairs))


def exponent(points: Sequence[tuple[int, float]]) -> float:
    """The e of the law y = c·nᵉ that fits the points (n, y) best; of n at least two must differ."""
    xs = [math.log(size) for size, _ in points]
    ys = [math.log(max(value, _SHORTEST)) for _, value in points]
    x_mean, y_mean = math.fsum(xs) / len(xs), math.fsum(ys) / len(ys)
    over = math.fsum((x - x_mean) * (y - y_mean) for x, y in zip(xs, ys, strict=True))
    return over / math.fsum((x - x_mean) ** 2 for x in xs)
