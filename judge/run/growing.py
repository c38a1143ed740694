"""Judging the groups of the rule of growth: each is timed by the way, and what grows too fast ends early.

The first turn of a race is the one in which a group is judged; the reference's turn follows at once. So an
accepted submission runs its largest size once, and one that is clearly too steep never does: the first case
of a larger size is cut as soon as that may be said. If it then cannot be, the case is run again, whole.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import ceil, inf

from msgspec.structs import replace

from judge.problem import Case, Verdict
from judge.run.budget import Budget
from judge.run.group import GroupRun
from judge.run.groups import TimedPart, run_timed
from judge.run.growth import LEAST_SECONDS, SHORT_SECONDS, GrowthSample, grow, is_steep, steep_seconds
from judge.run.measure import limits_of, theirs_on, time_limit
from judge.run.races import Timed, too_slow
from judge.run.reference import Reference
from judge.run.runner import Runner
from judge.run.timing import Decision, TurnPair, decide, is_sure
from judge.sandbox.boundary import Box, Usage


def judge_growing(
    runner: Runner,
    runs: Sequence[GroupRun],
    submission: Box,
    reference: Reference,
    budget: Budget,
    on_group: Callable[[GroupRun], None],
) -> Timed | None:
    """Judge these groups, the smallest first, until the submission is clearly too slow or too steep.

    What it comes to then; None where it is to be raced, or is not accepted for another reason.

    Raises:
        JudgeError: the reference does not come to the end of the cases.
    """
    judging = _Growing(runner, submission, reference, budget)
    for place, run in enumerate(runs):
        judging.judge(run)
        on_group(run)
        if judging.timed is not None:
            for larger in runs[place + 1 :]:
                larger.give_up(Verdict.TLE, "it is too slow before")
        if judging.timed is not None or budget.over:
            break
    return judging.timed


class _Growing:
    """What is known so far of how a submission grows."""

    def __init__(self, runner: Runner, submission: Box, reference: Reference, budget: Budget) -> None:
        rule = runner.problem.time
        self._runner = runner
        self._submission = submission
        self._rival = reference.open(runner.reference(rule)) if rule else None
        self._budget = budget
        self._smaller: GroupRun | None = None  # the last one that was accepted
        self._pairs: list[tuple[TurnPair, int]] = []  # its turns, and of how many cases
        self.timed: Timed | None = None

    def judge(self, run: GroupRun) -> None:
        """Judge the group, and note what both took."""
        own, theirs = 0.0, Usage()
        ahead = self._theirs(run, run.cases[:1]) if self._rival and self._smaller else None
        first = self._first_seconds(run, ahead) if self._smaller else None
        for piece in run_timed(self._runner, self._submission, run, self._budget, first):
            if self._rival is None or run.verdict is not Verdict.AC:
                self._rival = None  # nothing hangs on the time any more
                continue
            used, ahead = ahead or self._theirs(run, piece.cases), None
            if self._is_steep(run, piece, used):
                return
            if not piece.cut:
                own, theirs = own + piece.usage.cpu_seconds, theirs + used
        if self._rival is not None and run.reached == len(run.cases) and theirs.cpu_seconds:
            pair, limit = TurnPair(own, theirs.cpu_seconds), time_limit(run.problem, [run])
            run.first = pair, theirs
            self._smaller, self._pairs = run, [(pair, len(run.cases))]
            if is_sure(pair, limit):
                self.timed = Timed(replace(decide([pair], limit), limit=limit))
                too_slow(run, self.timed.decision)

    def _first_seconds(self, run: GroupRun, theirs: Usage | None) -> float:
        """How long the first case may take at first: from then on the submission may be clearly too steep."""
        problem, smaller = self._runner.problem, self._smaller
        if theirs is None or smaller is None or smaller.first is None or problem.growth is None:
            return inf
        if smaller.first[0].submission >= SHORT_SECONDS and not self._sampled(smaller):
            return inf
        sizes = smaller.group.size or 1, run.group.size or 1
        worst, _ = max(self._pairs, key=_ratio)
        return steep_seconds(sizes, worst, theirs.cpu_seconds, problem.growth.slope)

    def _is_steep(self, run: GroupRun, piece: TimedPart, used: Usage) -> bool:
        """Whether the submission is too steep by what it took here; then the group says so."""
        problem, smaller = self._runner.problem, self._smaller
        cases, own = piece.cases, piece.usage.cpu_seconds
        if smaller is None or smaller.first is None or problem.growth is None:
            return False
        sizes, slope = (smaller.group.size or 1, run.group.size or 1), problem.growth.slope
        theirs = [used.cpu_seconds]
        if not is_steep(sizes, [pair for pair, _ in self._pairs], own, theirs, slope):
            return False
        # All that is not long is run again.
        if len(self._pairs) == 1 and not self._sampled(smaller):
            return False
        if own < SHORT_SECONDS:
            pair = self._pair(run, cases)
            if pair is None:
                return False
            own = min(own, pair.submission)
            theirs.append(pair.reference)
        else:
            theirs.append(self._theirs(run, cases).cpu_seconds)
        if not is_steep(sizes, [pair for pair, _ in self._pairs], own, theirs, slope):
            return False
        worst, count = max(self._pairs, key=_ratio)
        turns = (smaller, count, worst, True), (run, len(cases), TurnPair(own, max(theirs)), not piece.cut)
        courses = [
            GrowthSample(each.group.name, size, _none, _none, cases=count, ended=ended, first=first)
            for size, (each, count, first, ended) in zip(sizes, turns, strict=True)
        ]
        if piece.cut:
            run.usage += piece.usage
        growth = grow(courses, slope, lambda: False).growth
        self.timed = Timed(Decision(None), growth)
        run.too_slow(f"{growth}; its exponent may exceed that by {slope:g}")
        return True

    def _sampled(self, smaller: GroupRun) -> bool:
        """Run of the smaller size again what takes the reference long enough; whether that ends well."""
        whole, cases = self._pairs[0][0], smaller.cases
        few = cases[: ceil(len(cases) * 2 * LEAST_SECONDS / whole.reference)]
        pair = self._pair(smaller, few)
        if pair is not None:
            self._pairs.append((pair, len(few)))
        return pair is not None

    def _pair(self, run: GroupRun, cases: Sequence[Case]) -> TurnPair | None:
        """One more turn each; None where the submission's does not end well."""
        within = self._budget.within(limits_of(run.problem, [run]))
        again = self._budget.booked(self._runner.ask(self._submission, cases, within))
        theirs = self._theirs(run, cases)
        return None if again.trouble else TurnPair(again.usage.cpu_seconds, theirs.cpu_seconds)

    def _theirs(self, run: GroupRun, cases: Sequence[Case]) -> Usage:
        assert self._rival is not None
        return theirs_on(self._runner, self._rival, cases, limits_of(run.problem, [run]))


def _ratio(turn: tuple[TurnPair, int]) -> float:
    return turn[0].ratio


def _none() -> None:
    """No further turn."""
