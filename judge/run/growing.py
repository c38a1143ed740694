"""Judging the groups of the rule of growth: each is timed by the way, and what grows too fast ends early.

The first turn of a race is the one in which a group is judged; the reference's turn follows at once. So an
accepted submission runs its largest size once, and one that is clearly too steep never does: the first case
of a larger size is cut as soon as that may be said. If it then cannot be, the case is run again, whole.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, inf

from msgspec.structs import replace

from judge.problem import Case, Verdict
from judge.run.group import GroupRun
from judge.run.groups import Judging, TimedPart
from judge.run.growth import LEAST_SECONDS, SHORT_SECONDS, GrowthSample, grow, is_steep, steep_seconds
from judge.run.races import too_slow
from judge.run.settings import Reference
from judge.run.timing import Decision, TurnPair, decide, is_sure, limits_of, theirs_on, time_limit
from judge.sandbox.boundary import Usage


def judge_growing(judging: Judging, runs: Sequence[GroupRun], reference: Reference) -> Decision | None:
    """Judge these groups, the smallest first, until the submission is clearly too slow or too steep.

    What it comes to then; None where it is to be raced, or is not accepted for another reason.

    Raises:
        JudgeError: the reference does not come to the end of the cases.
    """
    growing = _Growing(judging, reference)
    for place, run in enumerate(runs):
        growing.judge(run)
        judging.end(run)
        if growing.decision is not None:
            for larger in runs[place + 1 :]:
                larger.give_up(Verdict.TLE, "it is too slow before")
        if growing.decision is not None or judging.budget.over:
            break
    judging.give_up(runs)
    return growing.decision


class _Growing:
    """What is known so far of how a submission grows."""

    def __init__(self, judging: Judging, reference: Reference) -> None:
        runner = judging.runner
        time, growth = runner.problem.time, runner.problem.growth
        assert time is not None
        assert growth is not None
        self._judging = judging
        self._rival = reference.open(runner.reference(time))
        self._slope = growth.slope
        self._smaller: GroupRun | None = None  # the last one that was accepted
        self._pairs: list[tuple[TurnPair, int]] = []  # its turns, and of how many cases
        self.decision: Decision | None = None

    def judge(self, run: GroupRun) -> None:
        """Judge the group, and note what both took."""
        own, theirs, ahead, first = 0.0, Usage(), None, None
        if self._smaller:
            ahead = self._theirs(run, run.cases[:1]) if self._rival else None
            first = self._first_seconds(self._smaller, run, ahead) if ahead else inf
        for piece in self._judging.timed(run, first):
            if self._rival is None or run.verdict is not Verdict.AC:
                self._rival = None  # nothing hangs on the time any more
                continue
            used, ahead = ahead or self._theirs(run, piece.cases), None
            if self._smaller and self._is_steep(self._smaller, run, piece, used):
                return
            if not piece.cut:
                own, theirs = own + piece.usage.cpu_seconds, theirs + used
        if self._rival is not None and run.reached == len(run.cases) and theirs.cpu_seconds:
            pair, limit = TurnPair(own, theirs.cpu_seconds), time_limit(run.problem, [run])
            run.first = pair, theirs
            self._smaller, self._pairs = run, [(pair, len(run.cases))]
            if is_sure(pair, limit):
                self.decision = replace(decide([pair], limit), limit=limit)
                too_slow(run, self.decision)

    def _first_seconds(self, smaller: GroupRun, run: GroupRun, theirs: Usage) -> float:
        """How long the first case may take at first: from then on the submission may be clearly too steep."""
        if self._pairs[0][0].submission >= SHORT_SECONDS and not self._sampled(smaller):
            return inf
        worst, _ = max(self._pairs, key=_ratio)
        return steep_seconds(_sizes(smaller, run), worst, theirs.cpu_seconds, self._slope)

    def _is_steep(self, smaller: GroupRun, run: GroupRun, piece: TimedPart, used: Usage) -> bool:
        """Whether the submission is too steep by what it took here; then the group says so."""
        cases, own, theirs = piece.cases, piece.usage.cpu_seconds, [used.cpu_seconds]

        def steep() -> bool:
            pairs = [pair for pair, _ in self._pairs]
            return is_steep(_sizes(smaller, run), pairs, own, theirs, self._slope)

        # All that is not long is run again.
        if not steep() or (len(self._pairs) == 1 and not self._sampled(smaller)):
            return False
        if own < SHORT_SECONDS:
            pair = self._pair(run, cases)
            if pair is None:
                return False
            own = min(own, pair.submission)
            theirs.append(pair.reference)
        else:
            theirs.append(self._theirs(run, cases).cpu_seconds)
        if not steep():
            return False
        worst, count = max(self._pairs, key=_ratio)
        turns = (smaller, count, worst, True), (run, len(cases), TurnPair(own, max(theirs)), not piece.cut)
        samples = [
            GrowthSample(each.group.name, each.group.size or 1, cases=count, ended=ended, first=first)
            for each, count, first, ended in turns
        ]
        if piece.cut:
            run.usage += piece.usage
        growth = grow(samples, self._slope, lambda: False).growth
        assert growth is not None
        self.decision = Decision(None, growth=growth)
        run.failed_whole(Verdict.TLE, growth.too_steep)
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
        again = self._judging.ask(cases, limits_of(run.problem, [run]))
        theirs = self._theirs(run, cases)
        return None if again.trouble else TurnPair(again.usage.cpu_seconds, theirs.cpu_seconds)

    def _theirs(self, run: GroupRun, cases: Sequence[Case]) -> Usage:
        assert self._rival is not None
        return theirs_on(self._judging.runner, self._rival, cases, limits_of(run.problem, [run]))


def _sizes(smaller: GroupRun, larger: GroupRun) -> tuple[int, int]:
    return smaller.group.size or 1, larger.group.size or 1


def _ratio(turn: tuple[TurnPair, int]) -> float:
    return turn[0].ratio
