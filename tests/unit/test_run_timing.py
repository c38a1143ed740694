"""The time limit as a multiple of the reference: when it is clear, when it is near, when it means little."""

from __future__ import annotations

import pytest

from judge.run.timing import MOST_PAIRS, TurnPair, busy, decide, disturbed, race, summary
from judge.sandbox import Usage

LIMIT = 10.0


class Runs:
    """A run that takes each of these times in turn, then the last again, and counts its turns."""

    def __init__(self, *values):
        self.left, self.turns = list(values), 0

    def __call__(self):
        self.turns += 1
        return self.left.pop(0) if len(self.left) > 1 else self.left[0]


@pytest.mark.parametrize(
    ("mine", "pairs", "too_slow", "borderline"),
    [
        ([0.2], 1, True, False),  # far above it
        ([0.01, 0.9], 1, False, False),  # a tenth of it
        ([0.095], 9, False, True),
        ([0.105], 9, True, True),
        ([0.05, 0.12], 9, False, True),  # any pair near the limit asks for all nine
        ([0.12, 0.2], 9, True, True),
        ([0.05, 0.3], 9, False, True),  # on both sides of it
        ([0.02, 0.09, 0.02], 9, False, False),  # one odd pair is no close call
    ],
)
def test_as_many_pairs_are_run_as_settle_it(mine, pairs, too_slow, borderline):
    decision = race(Runs(*mine), Runs(0.01), LIMIT)
    assert (decision.ratio.pairs, decision.too_slow, decision.borderline) == (pairs, too_slow, borderline)


@pytest.mark.parametrize("took", [(0.02, 0.01), (0.0004, 0.0004)])  # the second are too short for one
def test_a_submission_far_below_passes_with_a_few_pairs(took):
    decision = race(*map(Runs, took), LIMIT)
    assert (decision.too_slow, decision.borderline) == (False, False)
    assert 3 <= decision.ratio.pairs <= MOST_PAIRS


@pytest.mark.parametrize(
    ("mine", "near"), [([0.03], False), ([0.05], True), ([0.2], True), ([0.02, 0.05], True)]
)
def test_beside_others_only_what_is_far_below_is_decided(mine, near):
    decision = race(Runs(*mine), Runs(0.01), LIMIT, beside=True)
    assert (decision.near, decision.ratio is None, decision.too_slow) == (near, near, False)


@pytest.mark.parametrize(("factor", "too_slow"), [(0.5, False), (0.9, False), (1.1, True), (2.0, True)])
def test_there_may_be_only_one_pair(factor, too_slow):
    decision = race(Runs(0.01 * LIMIT * factor), Runs(0.01), LIMIT, lambda: False)
    assert (decision.ratio.pairs, decision.too_slow) == (1, too_slow)
    assert decision.ratio.median == pytest.approx(LIMIT * factor)


def test_one_short_turn_does_not_settle_what_is_too_slow():
    odd = race(Runs(0.034, 0.0003), Runs(0.0003), LIMIT)  # a moment of a busy machine, as it was seen
    assert (odd.too_slow, odd.borderline, odd.ratio.pairs) == (False, False, MOST_PAIRS)
    slow = race(Runs(0.034), Runs(0.0003), LIMIT)
    assert (slow.too_slow, slow.borderline, slow.ratio.pairs) == (True, False, 3)


def test_near_the_limit_both_the_least_times_and_the_median_must_exceed_it():
    slow_median = [TurnPair(0.099, 0.01), *[TurnPair(0.12, 0.01)] * 8]
    assert not decide(slow_median, LIMIT).too_slow  # one quick run shows that it can
    slow_least = [*[TurnPair(0.098, 0.01)] * 8, TurnPair(0.2, 0.0097)]
    assert not decide(slow_least, LIMIT).too_slow  # the median pair is within
    assert decide([TurnPair(0.105, 0.01)] * 9, LIMIT).too_slow


def test_the_two_take_turns_at_going_first():
    order = []

    def named(name):
        def run():
            order.append(name)
            return 0.01

        return run

    race(named("mine"), named("theirs"), 1.0)
    assert order[:6] == ["mine", "theirs", "theirs", "mine", "mine", "theirs"]


def test_a_run_that_does_not_end_well_leaves_no_ratio():
    assert race(lambda: None, Runs(0.01), LIMIT).ratio is None
    assert race(Runs(0.01), lambda: None, LIMIT).ratio is None
    assert race(Runs(0.01), lambda: 0.0, LIMIT).ratio is None


def test_what_makes_a_ratio_unreliable():
    assert summary([TurnPair(0.02, 0.01)] * 3, LIMIT).unreliable == ""
    assert summary([TurnPair(0.0002, 0.0001)] * 3, LIMIT).unreliable == "too short"
    wide = [TurnPair(0.01 * factor, 0.01) for factor in (1, 1, 2, 3, 3)]
    assert summary(wide, LIMIT).unreliable == "too noisy"


def test_the_summary_is_the_median_with_quartiles():
    ratio = summary([TurnPair(0.01 * factor, 0.01) for factor in (3.0, 2.8, 3.2, 2.9, 3.1)], LIMIT)
    assert (ratio.low, ratio.median, ratio.high) == pytest.approx((2.9, 3, 3.1))
    assert (ratio.pairs, ratio.unreliable, ratio.busy) == (5, "", "")
    short = summary([TurnPair(0.0001, 0.0001)], LIMIT)
    assert short.unreliable == "too short"


def test_a_machine_is_busy_where_the_reference_waits_for_a_processor():
    assert busy([Usage(0.003, 0.0034)] * 3) == ""  # as on a quiet one
    assert busy([Usage(0.0001, 0.0009)] * 3) == ""  # short turns are mostly the waking
    assert busy([Usage(0.3, 0.38)] * 3) == ""
    assert busy([Usage(0.3, 0.6)] * 3) == "busy machine, 50% waiting"
    assert busy([Usage(0.002, 0.0024), Usage(0.002, 0.009)]).startswith("busy machine")
    assert busy([Usage(0.8, 0.2)]) == ""  # with several threads
    assert busy([]) == ""


def test_what_disturbed_a_race_is_told_and_changes_no_verdict():
    slow = decide([TurnPair(0.3, 0.01)] * 3, LIMIT)
    told = disturbed(disturbed(slow, busy([Usage(0.1, 0.4)])), "beside another judge")
    assert told.ratio.busy == "beside another judge, busy machine, 75% waiting"
    assert (told.too_slow, told.ratio.median) == (slow.too_slow, slow.ratio.median)
    assert disturbed(slow, "") is slow
    assert slow.ratio.busy == ""
    assert disturbed(decide([], LIMIT), "anything").ratio is None
