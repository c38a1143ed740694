"""Time that can be trusted: CPU time as a multiple of a reference solution's, measured in the same run.

A machine's speed drifts, and from one machine to another it is anybody's guess; the ratio of two programs
that take turns is not. The first pairs settle most submissions. One that comes near the limit in any of them
runs again, turn by turn, and fails only where both the least times and the median pair exceed the limit.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Sequence
from typing import NamedTuple

from msgspec import Struct
from msgspec.structs import replace

from judge.run.result import Growth, Ratio
from judge.sandbox.boundary import Usage

CLEARLY_BELOW = 0.8  # of the limit, for a single pair
CLEARLY_ABOVE = 1.35
_NO_QUESTION = 0.1  # where one pair will do
_FAR_BELOW = 0.4  # where one pair of another language will do, if
_LONG_SECONDS = 0.006  # neither turn is so short that a moment of another speed shows
MOST_PAIRS = 9
_LEAST_PAIRS = 3
_PATIENCE_SECONDS = 0.03  # for the pairs of a submission that is nowhere near the limit
_TOO_SHORT_SECONDS = 0.0005  # a reference that takes less is mostly noise of the clock and the caches
_TOO_WIDE = 0.5  # a spread of more than half the median says little
_SURE_SECONDS = 0.05  # of a turn far above the limit, after which no second one is needed
_WAKING_SECONDS = 0.002  # between a turn's wall time and its CPU time where nothing else runs
_BUSY = 1 / 3  # of the wall time of the reference's turns, waited for a processor
BESIDE = "beside another judge"

Run = Callable[[], float | None]  # CPU seconds of one run, None where it did not end well


class Against(NamedTuple):
    """Whose time a submission in another language than Python is a multiple of.

    That of the reference in `language`; `why` says why that is another one than its own.
    """

    language: str
    why: str = ""


class Decision(Struct, frozen=True):
    """What the pairs came to; `ratio` is None where nothing could be paired.

    `imported` is the CPU time of the submission's import, which the pairs are without. `against` says whose
    time the pairs are of, where the submission is not in Python; `limit` is what the ratio was held to.
    `growth` is there where the problem has a rule of it.
    """

    ratio: Ratio | None
    too_slow: bool = False
    borderline: bool = False
    imported: float = 0.0
    against: Against | None = None
    limit: float = 0.0
    growth: Growth | None = None


class TurnPair(Struct, frozen=True):
    """One turn each, in CPU seconds."""

    submission: float
    reference: float

    @property
    def ratio(self) -> float:
        """How many times the reference's time the submission took."""
        return self.submission / self.reference


def race(
    submission: Run,
    reference: Run,
    limit: float,
    goes_on: Callable[[], bool] = lambda: True,
    *,
    cautious: bool = False,
) -> Decision:
    """Let the two take turns until the outcome is clear, and apply the limit (a multiple of the reference).

    A submission that comes near the limit in any pair gets nine whatever they take, one far above it whose
    turns are short three; any other as many, three at least, as fit a moment that a waiting person does not
    notice. `goes_on` is asked after each pair whether there may be another.
    A `cautious` race is one of long turns in another language: see `decide`.
    """
    pairs: list[TurnPair] = []
    start = time.monotonic()
    while len(pairs) < MOST_PAIRS:
        pair = turn(submission, reference, swapped=len(pairs) % 2 == 1)
        if pair is None:
            break
        pairs.append(pair)
        if not goes_on():
            break
        if not is_clear(pairs, limit):
            continue
        enough = len(pairs) >= _LEAST_PAIRS
        if pairs[0].ratio > limit:
            if enough or not (cautious or pair.submission < _SURE_SECONDS):
                break
        elif (
            (pair.ratio <= _NO_QUESTION * limit and pair.reference >= _TOO_SHORT_SECONDS)
            or (cautious and _one_will_do(pair, limit))
            or (enough and time.monotonic() - start > _PATIENCE_SECONDS)
        ):
            break
    return decide(pairs, limit, cautious=cautious)


def is_sure(pair: TurnPair, limit: float) -> bool:
    """Whether a single pair says that a submission is too slow: a long turn, a ratio far above the limit."""
    return pair.submission >= _SURE_SECONDS and pair.ratio > CLEARLY_ABOVE * limit


def decide(pairs: list[TurnPair], limit: float, *, cautious: bool = False) -> Decision:
    """The ratio of the pairs, and whether it exceeds the limit.

    Where the decision is `cautious`, quartiles that lie wider apart than what is clearly above and clearly
    below the limit, or on both sides of it, make it a close call and never too slow.
    """
    if not pairs:
        return Decision(None)
    ratio = summary(pairs)
    if is_clear(pairs, limit):
        return Decision(ratio, too_slow=ratio.median > limit)
    least = min(pair.submission for pair in pairs) / min(pair.reference for pair in pairs)
    too_slow = least > limit and ratio.median > limit
    wide = ratio.low <= limit or ratio.high > ratio.low * CLEARLY_ABOVE / CLEARLY_BELOW
    if cautious and too_slow and wide:
        return Decision(ratio, borderline=True)
    # One odd pair is no close call where the median and the least times agree that it is not.
    return Decision(ratio, too_slow, borderline=too_slow or max(least, ratio.median) > CLEARLY_BELOW * limit)


def summary(pairs: list[TurnPair]) -> Ratio:
    """The median paired ratio with its quartiles, and whether it deserves belief."""
    ratios = sorted(pair.ratio for pair in pairs)
    low, median, high = (quantile(ratios, part) for part in (0.25, 0.5, 0.75))
    unreliable = ""
    if min(pair.reference for pair in pairs) < _TOO_SHORT_SECONDS:
        unreliable = "too short"
    elif high - low > _TOO_WIDE * median:
        unreliable = "too noisy"
    return Ratio(median, low, high, len(pairs), unreliable=unreliable)


def disturbed(decision: Decision, what: str) -> Decision:
    """The decision, whose ratio says that this went on beside it; the verdict stays what it is."""
    ratio = decision.ratio
    if ratio is None or not what:
        return decision
    return replace(decision, ratio=replace(ratio, busy=", ".join(filter(None, (what, ratio.busy)))))


def busy(turns: Sequence[Usage]) -> str:
    """Whether the reference waited for a processor in these turns, and for how much of its time; "" if not.

    The reference neither sleeps nor reads, so what it takes beyond its CPU time and a moment to be woken in
    is the machine's doing. A submission might sleep, so it is not asked.
    """
    wall = math.fsum(turn.wall_seconds for turn in turns)
    waited = math.fsum(max(0.0, turn.waiting_seconds - _WAKING_SECONDS) for turn in turns)
    return f"busy machine, {waited / wall:.0%} waiting" if waited > _BUSY * wall else ""


def quantile(ordered: list[float], part: float) -> float:
    """The value below which `part` of the ordered values lie, linear between neighbours."""
    place = part * (len(ordered) - 1)
    below = int(place)
    above = min(below + 1, len(ordered) - 1)
    return ordered[below] + (place - below) * (ordered[above] - ordered[below])


def is_clear(pairs: list[TurnPair], limit: float) -> bool:
    """Whether every pair is clearly below the limit, or every one clearly above it."""
    ratios = [pair.ratio for pair in pairs]
    return max(ratios) <= CLEARLY_BELOW * limit or min(ratios) > CLEARLY_ABOVE * limit


def _one_will_do(pair: TurnPair, limit: float) -> bool:
    """Whether a single pair says enough: far below the limit, and of turns that are not short."""
    return pair.ratio <= _FAR_BELOW * limit and min(pair.submission, pair.reference) >= _LONG_SECONDS


def turn(submission: Run, reference: Run, *, swapped: bool) -> TurnPair | None:
    """One run each; who goes first changes, so that a drift favours nobody."""
    if swapped:
        theirs, mine = reference(), submission()
    else:
        mine, theirs = submission(), reference()
    if mine is None or not theirs:
        return None
    return TurnPair(mine, theirs)
