"""Time that can be trusted: CPU time as a multiple of a reference solution's, measured in the same run.

A machine's speed drifts, and from one machine to another it is anybody's guess; the ratio of two programs
that take turns is not. The first pairs settle most submissions. One that comes near the limit in any of them
runs again, turn by turn, and fails only where both the least times and the median pair exceed the limit.
"""

from __future__ import annotations

import marshal
import math
import time
from collections.abc import Callable, Sequence
from functools import partial

from msgspec import Struct
from msgspec.structs import replace

from judge.errors import JudgeError
from judge.problem import Case, Problem, Verdict
from judge.run.group import GroupRun
from judge.run.groups import Judging
from judge.run.result import Ratio, Timing
from judge.run.runner import VERDICTS, Replies, Runner
from judge.sandbox.boundary import Box, Limits, Stop, Usage
from judge.values.check import Accepted

CLEARLY_BELOW = 0.8  # of the limit, for a single pair
CLEARLY_ABOVE = 1.35
_NO_QUESTION = 0.1  # where one pair will do
_FAR_BELOW = 0.4  # where it may be beside others, and one pair of another language will do, if
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
MEASURED = ("import_seconds", "ratio", "growth", "reference", "why")  # by a race; the rest is of all groups
_MOST_CASES = 400  # in a turn; a sample of the groups' cases where there are more
_MORE_CPU_SECONDS = 1.0  # that a turn may take beyond twice what it took to judge all cases
_MORE_WALL_SECONDS = 4.0
_LONG_WAIT_SECONDS = 1.0  # of all its turns, before there is none after the first
_LONG_IMPORT_SECONDS = 3.0  # of CPU time in the imports of all its turns, the same
_AGAIN = "when it was run again to be timed"

Run = Callable[[], float | None]  # CPU seconds of one run, None where it did not end well


class Decision(Timing, frozen=True, kw_only=True):
    """What the pairs came to, and whether that is too slow; `ratio` is None where nothing could be paired.

    `near` says that it was measured beside others, and has to be alone.
    """

    too_slow: bool = False
    near: bool = False

    def record(self, run: GroupRun) -> None:
        """Record it in the group where it is too slow."""
        if self.too_slow and self.ratio:
            whose = f" in {self.reference}" if self.reference else ""
            why = f" ({self.why})" if self.why else ""
            run.failed_whole(
                Verdict.TLE,
                f"it takes {self.ratio.median:,.0f} times the CPU time of the reference solution{whose}; "
                f"the limit is {self.ratio.limit:g} times{why}",
            )

    def worse(self, second: Decision) -> Decision:
        """Of two races the one to be told: what is too slow, else the closer call, else the second one."""
        graver = (self.too_slow, self.borderline) > (second.too_slow, second.borderline)
        told = self if second.ratio is None or graver else second
        return replace(told, growth=second.growth, reference=second.reference, why=second.why)


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
    beside: bool = False,
) -> Decision:
    """Let the two take turns until the outcome is clear, and apply the limit (a multiple of the reference).

    A submission that comes near the limit in any pair gets nine whatever they take, one far above it whose
    turns are short three; any other as many, three at least, as fit a moment that a waiting person does not
    notice. `goes_on` is asked after each pair whether there may be another.
    A `cautious` race is one of long turns in another language: see `decide`. One `beside` others, who make
    CPU time longer, decides only of what stays far below the limit, and else says that it is `near`.
    """
    pairs: list[TurnPair] = []
    start = time.monotonic()
    while len(pairs) < MOST_PAIRS:
        pair = turn(submission, reference, swapped=len(pairs) % 2 == 1)
        if pair is None:
            break
        if beside and pair.ratio > _FAR_BELOW * limit:
            return Decision(near=True)
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
        return Decision()
    ratio = summary(pairs, limit)
    if is_clear(pairs, limit):
        return Decision(ratio=ratio, too_slow=ratio.median > limit)
    least = min(pair.submission for pair in pairs) / min(pair.reference for pair in pairs)
    too_slow = least > limit and ratio.median > limit
    wide = ratio.low <= limit or ratio.high > ratio.low * CLEARLY_ABOVE / CLEARLY_BELOW
    if cautious and too_slow and wide:
        return Decision(ratio=ratio, borderline=True)
    # One odd pair is no close call where the median and the least times agree that it is not.
    near = too_slow or max(least, ratio.median) > CLEARLY_BELOW * limit
    return Decision(ratio=ratio, too_slow=too_slow, borderline=near)


def summary(pairs: list[TurnPair], limit: float) -> Ratio:
    """The median paired ratio with its quartiles, held to the limit, and whether it deserves belief."""
    ratios = sorted(pair.ratio for pair in pairs)
    low, median, high = (quantile(ratios, part) for part in (0.25, 0.5, 0.75))
    unreliable = ""
    if min(pair.reference for pair in pairs) < _TOO_SHORT_SECONDS:
        unreliable = "too short"
    elif high - low > _TOO_WIDE * median:
        unreliable = "too noisy"
    return Ratio(median, low, high, len(pairs), limit, unreliable)


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


class Race:
    """A submission and the reference on the cases of some groups, turn by turn.

    A turn is some calls, or one program. What a module does when it is imported is the same for all
    cases: it is measured apart, and has no part in the ratio. The submission's answers are compared in every
    turn: one that answers otherwise than before, or not to the end, is no longer accepted, and its group says
    why.

    `limit` is a multiple of the reference's time; `language` and `why` are as in `Timing`. One in another
    language than Python needs caution with the start of a language.
    """

    language = why = ""

    def __init__(self, judging: Judging, runs: Sequence[GroupRun], rival: Box, limit: float) -> None:
        self.limit = limit
        self.imported = 0.0  # CPU seconds that the submission's import took, the least of all turns
        self.theirs_took: list[Usage] = []  # of the reference's turns, with its language's start
        self._judging = judging
        self._runner = runner = judging.runner
        self._rival = rival
        every = [(run, index) for run in runs for index in range(len(run.cases))]
        self._places = every[:: 1 + (len(every) - 1) // _MOST_CASES]
        self._cases = [run.cases[index] for run, index in self._places]
        self.cases = len(self._cases)  # that a turn of the reference runs
        self._limits = limits = limits_of(runner.problem, runs)
        used = sum((run.usage + run.imported for run in runs), Usage())
        self._tighter = limits._replace(
            cpu_seconds=min(limits.cpu_seconds, 2 * used.cpu_seconds + _MORE_CPU_SECONDS),
            wall_seconds=min(limits.wall_seconds, 2 * used.wall_seconds + _MORE_WALL_SECONDS),
        )
        self._taken = Usage()
        self._importing = 0.0  # CPU seconds of all turns' imports
        self._accepted: bytes | None = None  # the answers that were compared last

    def mine(self) -> float | None:
        """The submission's turn in CPU seconds; None where it is no longer accepted."""
        first = self._taken == Usage()
        replies = self._taking(self._judging.ask(self._cases, self._tighter))
        spent = replies.imported.cpu_seconds
        self.imported = spent if first else min(self.imported, spent)
        self._importing += spent
        return replies.usage.cpu_seconds if self._as_before(replies) else None

    def theirs(self) -> float | None:
        """The reference's turn. Raises JudgeError where it does not come to the end of the cases."""
        self.theirs_took.append(theirs_on(self._runner, self._rival, self._cases, self._limits))
        return self.theirs_took[-1].cpu_seconds

    def goes_on(self) -> bool:
        """Whether it has not kept the judge waiting, for nothing or for its imports."""
        if self._importing > _LONG_IMPORT_SECONDS:
            return False
        # a busy machine lets it wait too, but hardly for more than twice as long as it works
        return self._taken.waiting_seconds <= _LONG_WAIT_SECONDS + 2 * self._taken.cpu_seconds

    def told(self, decision: Decision) -> Decision:
        """What the turns came to, with what else is known of them."""
        decision = replace(decision, import_seconds=self.imported, reference=self.language, why=self.why)
        return disturbed(decision, busy(self.theirs_took))

    def _taking(self, replies: Replies) -> Replies:
        self._taken += replies.usage + replies.imported
        return replies

    def _as_before(self, replies: Replies) -> bool:
        """Whether all answers are accepted as when they were judged; the first that is not is recorded."""
        given = exactly(replies)
        if (given is None or given != self._accepted) and not self._right(replies):
            return False
        self._accepted = given
        return True

    def _right(self, replies: Replies) -> bool:
        for (run, index), reply in zip(self._places, replies.replies, strict=False):
            if reply.stop is not Stop.ANSWERED:
                run.unsteady(index, VERDICTS[reply.stop], f"{reply.detail}, {_AGAIN}")
                return False
            outcome = self._runner.decide(reply.answer, run.targets[index], partial(run.exact, index))
            if not isinstance(outcome, Accepted):
                run.unsteady(index, Verdict.WA, f"{outcome.message}, {_AGAIN}", outcome.got)
                return False
        if replies.breakdown is None and len(replies.replies) == len(self._places):
            return True
        run, index = self._places[min(len(replies.replies), len(self._places) - 1)]
        verdict = replies.breakdown.verdict if replies.breakdown else Verdict.WA
        run.unsteady(index, verdict, f"{replies.trouble or 'it answered no more'}, {_AGAIN}")
        return False


def exactly(replies: Replies) -> bytes | None:
    """The answers as bytes, for 1, 1.0 and True are equal and yet three answers; None if some are missing."""
    return None if replies.trouble else marshal.dumps([reply.answer for reply in replies.replies], 2)


def theirs_on(runner: Runner, rival: Box, cases: Sequence[Case], limits: Limits) -> Usage:
    """What the reference took. Raises JudgeError where it does not come to the end of the cases."""
    replies = runner.ask(rival, cases, limits)
    if replies.trouble:
        raise JudgeError(f"the reference solution cannot be timed: {replies.trouble}")
    return replies.usage


def limits_of(problem: Problem, runs: Sequence[GroupRun]) -> Limits:
    """The bounds of all groups together."""
    each = [problem.limits_of(run.group) for run in runs]
    return Limits(
        sum(limits.cpu_seconds for limits in each),
        sum(limits.wall_seconds for limits in each),
        problem.limits.memory_bytes,
        sum(limits.output_bytes for limits in each),
        items=problem.answer.items,
    )
