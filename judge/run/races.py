"""What a submission is raced on: which groups together, which alone, and how it grows.

A group with a time limit of its own, or one of the rule of growth, is raced by itself; all others together.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING

from msgspec.structs import replace

from judge.problem import Problem, Verdict
from judge.run.group import GroupRun
from judge.run.groups import Judging
from judge.run.settings import Reference
from judge.run.timing import Against, Decision, Race, busy, disturbed, limits_of, race, time_limit

if TYPE_CHECKING:
    from judge.run.growth import Grown


def worth_racing(problem: Problem, runs: Sequence[GroupRun]) -> bool:
    """Whether the verdict may still hang on the time: accepted, or out of CPU time in a group that grows."""
    names = problem.growth.groups if problem.growth else ()

    def may_be(run: GroupRun) -> bool:
        if run.given_up:  # for the time that others took
            return run.verdict is Verdict.TLE
        return run.verdict is Verdict.AC or (run.group.name in names and run.out_of_cpu_time)

    return all(map(may_be, runs)) and not all(run.given_up for run in runs)


def race_all(judging: Judging, runs: Sequence[GroupRun], reference: Reference) -> Decision:
    """Race the submission on all groups that are `worth_racing`, until one is too slow; it knows so itself.

    Raises:
        JudgeError: the reference does not come to the end of the cases.
    """
    growing = growing_of(judging.runner.problem, runs)
    rest = [run for run in runs if run not in growing]
    alone = [[run] for run in rest if run.group.time_limit is not None]
    together = [run for run in rest if run.group.time_limit is None]
    decision, against = Decision(None), None
    parts = ([together] if together else []) + alone
    if any(run.verdict is not Verdict.AC for run in runs):
        parts = []  # it is too slow, and what is left to say is why
    for part in parts:
        raced = measure(judging, part, reference)
        if raced.too_slow:
            too_slow(_slowest(judging, part), raced)
        decision, against = _worse(decision, raced), raced.against
        if any(run.verdict is not Verdict.AC for run in part):
            return replace(decision, against=against)
    if not growing:
        return replace(decision, against=against)
    grown, against = _grown(judging, growing, reference)
    for run in growing:
        if run.group.name in grown.decisions and run.verdict is Verdict.AC:
            own = grown.decisions[run.group.name]
            too_slow(run, own)
            decision = _worse(decision, own)
    if grown.growth is not None and grown.too_steep:
        # The growth is the reason of what is too slow already; else of the largest group, where it will be.
        slow = [run for run in growing if run.verdict is not Verdict.AC]
        for run in slow:
            if run.failure is not None:
                run.failure = replace(run.failure, message=f"{run.failure.message}; {grown.growth}")
        if not slow:
            growing[-1].failed_whole(Verdict.TLE, grown.growth.too_steep)
    return replace(decision, growth=grown.growth, against=against)


def race_of(judging: Judging, runs: Sequence[GroupRun], reference: Reference) -> Race | None:
    """The two that take turns on the cases of these groups; None where there is nobody to race against.

    Raises:
        JudgeError: the reference does not compile, or not come to the end of the cases.
    """
    runner, problem = judging.runner, judging.runner.problem
    own_runs = problem.formatted and not runner.calls
    if problem.time is None or (runner.language and own_runs):  # each run is mostly its language's start
        return None
    limit = time_limit(problem, runs)
    if runner.language:
        from judge.run.foreign import LongRace, rival_of  # most submissions are in Python

        rival = rival_of(runner, problem.time, reference, limit)
        return None if rival is None else LongRace(judging, runs, rival)
    box = reference.open(runner.reference(problem.time))
    return None if box is None else Race(judging, runs, box, limit)


def measure(judging: Judging, runs: Sequence[GroupRun], reference: Reference) -> Decision:
    """Race a submission and the reference, if there is one, on the cases of accepted groups.

    There is no more racing for a submission that is no longer accepted, nor for one that has kept the judge
    waiting.

    Raises:
        JudgeError: the reference does not come to the end of the cases.
    """
    raced = race_of(judging, runs, reference)
    if raced is None:
        return Decision(None)
    cautious = raced.against is not None
    decision = race(raced.mine, raced.theirs, raced.limit, raced.goes_on, cautious=cautious)
    if any(run.verdict is not Verdict.AC for run in runs):
        decision = Decision(decision.ratio)
    decision = replace(decision, imported=raced.imported, against=raced.against, limit=raced.limit)
    return disturbed(decision, busy(raced.theirs_took))


def growing_of(problem: Problem, runs: Sequence[GroupRun]) -> list[GroupRun]:
    """The groups of the rule of growth that came to an end of their own, the smallest first."""
    if problem.growth is None:
        return []
    by_name = {run.group.name: run for run in runs if not run.given_up}
    return [by_name[name] for name in problem.growth.groups if name in by_name]


def _grown(
    judging: Judging, growing: Sequence[GroupRun], reference: Reference
) -> tuple[Grown, Against | None]:
    """How the submission grows beside the reference, and whose that is."""
    from judge.run.growth import Grown, GrowthSample, grow  # few problems have a rule of growth

    rule = judging.runner.problem.growth
    races = [each for run in growing if (each := race_of(judging, [run], reference))]
    if rule is None or not races:
        return Grown(None, False, {}), None
    samples = []
    for run, each in zip(growing, races, strict=True):
        ended = run.verdict is Verdict.AC
        if run.first is not None:
            each.theirs_took.append(run.first[1])
        samples.append(
            GrowthSample(
                run.group.name,
                run.group.size or 1,
                each.mine if ended else partial(_at_least, run, each.cases),
                each.theirs,
                each.limit if ended else None,
                each.cases,
                ended,
                run.first and run.first[0],
            )
        )

    def goes_on() -> bool:
        # of one that is too slow it only remains to say how it grows
        return all(sample.ended for sample in samples) and all(each.goes_on() for each in races)

    grown = grow(samples, rule.slope, goes_on, cautious=races[0].against is not None)
    for sample, each in zip(samples, races, strict=True):
        if sample.name in grown.decisions:
            decision = grown.decisions[sample.name]
            grown.decisions[sample.name] = disturbed(decision, busy(each.theirs_took))
    return grown, races[0].against


def _at_least(run: GroupRun, cases: int) -> float:
    """What so many cases take that are like those which were begun before the time was up."""
    return run.usage.cpu_seconds * cases / (run.passed + 1)


def _slowest(judging: Judging, runs: Sequence[GroupRun]) -> GroupRun:
    """The slowest of groups that were raced together; what ran in one process is run again, alone."""

    def took(run: GroupRun) -> float:
        if not run.shares:
            return run.usage.cpu_seconds
        return judging.ask(run.cases, limits_of(run.problem, [run])).usage.cpu_seconds

    return max(runs, key=took) if len(runs) > 1 else runs[0]


def too_slow(run: GroupRun, decision: Decision) -> None:
    """Record it in the group, if it was decided."""
    if decision.too_slow and decision.ratio:
        against = decision.against
        whose = f" in {against.language}" if against else ""
        why = f" ({against.why})" if against and against.why else ""
        run.failed_whole(
            Verdict.TLE,
            f"it takes {decision.ratio.median:,.0f} times the CPU time of the reference solution{whose}; "
            f"the limit is {decision.limit:g} times{why}",
        )


def _worse(first: Decision, second: Decision) -> Decision:
    """Of two races the one to be told: the one that is too slow, else the closer call, else the later one."""
    if second.ratio is None or (first.too_slow, first.borderline) > (second.too_slow, second.borderline):
        return first
    return second
