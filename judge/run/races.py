"""What a submission is raced on: which groups together, which alone, and how it grows.

A group with a time limit of its own, or one of the rule of growth, is raced by itself; all others together.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

from msgspec.structs import replace

from judge.problem import Problem, Verdict
from judge.run.budget import Budget
from judge.run.group import GroupRun
from judge.run.measure import Race, limits_of, time_limit
from judge.run.reference import Reference
from judge.run.result import Growth
from judge.run.runner import Runner
from judge.run.timing import Against, Decision, busy, disturbed, race
from judge.sandbox.boundary import Box

if TYPE_CHECKING:
    from judge.run.growth import Grown


class Timed(NamedTuple):
    """What the races came to; groups that are too slow know it themselves.

    `against` says whose time it is, where the submission is not in Python.
    """

    decision: Decision
    growth: Growth | None = None
    against: Against | None = None


def worth_racing(problem: Problem, runs: Sequence[GroupRun]) -> bool:
    """Whether the verdict may still hang on the time: accepted, or out of CPU time in a group that grows."""
    names = problem.growth.groups if problem.growth else ()
    return any(not run.given_up for run in runs) and all(
        run.verdict is Verdict.AC or _out_of_time(run, names) for run in runs
    )


def race_all(
    runner: Runner,
    runs: Sequence[GroupRun],
    submission: Box,
    reference: Reference,
    budget: Budget,
) -> Timed:
    """Race the submission on all groups that are `worth_racing`, until one is too slow.

    Raises:
        JudgeError: the reference does not come to the end of the cases.
    """
    problem = runner.problem
    growing = growing_of(problem, runs)
    alone = [run for run in runs if run.group.time_limit is not None and run not in growing]
    together = [run for run in runs if run not in growing and run not in alone]
    decision, against = Decision(None), None
    parts = ([together] if together else []) + [[run] for run in alone]
    if any(run.verdict is not Verdict.AC for run in runs):
        parts = []  # it is too slow, and what is left to say is why
    for part in parts:
        raced = measure(runner, part, submission, reference, budget)
        if raced.too_slow:
            too_slow(_slowest(runner, part, submission, budget), raced)
        against = raced.against
        decision = _worse(decision, raced)
        if any(run.verdict is not Verdict.AC for run in part):
            return Timed(decision, against=against)
    if not growing or problem.growth is None:
        return Timed(decision, against=against)
    grown, against = _grown(runner, growing, submission, reference, budget)
    for run in growing:
        if run.group.name in grown.decisions and run.verdict is Verdict.AC:
            raced = grown.decisions[run.group.name]
            too_slow(run, raced)
            decision = _worse(decision, raced)
    if grown.growth is not None and grown.too_steep:
        _too_steep(growing, grown.growth)
    return Timed(decision, grown.growth, against)


def duel_of(
    runner: Runner, runs: Sequence[GroupRun], submission: Box, reference: Reference, budget: Budget
) -> Race | None:
    """The two that take turns on the cases of these groups; None where there is nobody to race against.

    Raises:
        JudgeError: the reference does not compile, or not come to the end of the cases.
    """
    problem = runner.problem
    own_runs = problem.formatted and not runner.calls
    if problem.time is None or (runner.language and own_runs):  # each run is mostly its language's start
        return None
    limit = time_limit(problem, runs)
    if runner.language:
        from judge.run.foreign import LongRace, rival_of  # most submissions are in Python

        rival = rival_of(runner, problem.time, reference, limit)
        return None if rival is None else LongRace(runner, runs, submission, rival, budget)
    box = reference.open(runner.reference(problem.time))
    return None if box is None else Race(runner, runs, submission, box, limit, budget)


def measure(
    runner: Runner,
    runs: Sequence[GroupRun],
    submission: Box,
    reference: Reference,
    budget: Budget,
) -> Decision:
    """Race a submission and the reference, if there is one, on the cases of accepted groups.

    There is no more racing for a submission that is no longer accepted, nor for one that has kept the judge
    waiting.

    Raises:
        JudgeError: the reference does not come to the end of the cases.
    """
    duel = duel_of(runner, runs, submission, reference, budget)
    if duel is None:
        return Decision(None)
    against = duel.against
    decision = race(duel.mine, duel.theirs, duel.limit, duel.goes_on, cautious=against is not None)
    if any(run.verdict is not Verdict.AC for run in runs):
        decision = Decision(decision.ratio)
    decision = replace(decision, imported=duel.imported, against=against, limit=duel.limit)
    return disturbed(decision, busy(duel.theirs_took))


def growing_of(problem: Problem, runs: Sequence[GroupRun]) -> list[GroupRun]:
    """The groups of the rule of growth that came to an end of their own, the smallest first."""
    if problem.growth is None:
        return []
    by_name = {run.group.name: run for run in runs if not run.given_up}
    return [by_name[name] for name in problem.growth.groups if name in by_name]


def _out_of_time(run: GroupRun, names: Sequence[str]) -> bool:
    if run.given_up:  # for the time that others took
        return run.verdict is Verdict.TLE
    return run.group.name in names and run.out_of_cpu_time


def _grown(
    runner: Runner,
    growing: Sequence[GroupRun],
    submission: Box,
    reference: Reference,
    budget: Budget,
) -> tuple[Grown, Against | None]:
    from judge.run.growth import Grown, GrowthSample, grow  # few problems have a rule of growth

    rule = runner.problem.growth
    duels = [duel_of(runner, [run], submission, reference, budget) for run in growing]
    found = [each for each in duels if each is not None]
    if rule is None or not found:
        return Grown(None, False, {}), None
    courses = []
    for run, each in zip(growing, found, strict=True):
        ended = run.verdict is Verdict.AC
        first, used = run.first or (None, None)
        if used is not None:
            each.theirs_took.append(used)
        courses.append(
            GrowthSample(
                run.group.name,
                run.group.size or 1,
                each.mine if ended else partial(_at_least, run, each.cases),
                each.theirs,
                each.limit if ended else None,
                each.cases,
                ended,
                first,
            )
        )
    against = found[0].against
    cautious = against is not None

    def goes_on() -> bool:
        # of one that is too slow it only remains to say how it grows
        return all(course.ended for course in courses) and all(each.goes_on() for each in found)

    grown = grow(courses, rule.slope, goes_on, cautious=cautious)
    for course, each in zip(courses, found, strict=True):
        if course.name in grown.decisions:
            decision = grown.decisions[course.name]
            grown.decisions[course.name] = disturbed(decision, busy(each.theirs_took))
    return grown, against


def _at_least(run: GroupRun, cases: int) -> float:
    """What so many cases take that are like those which were begun before the time was up."""
    return run.usage.cpu_seconds * cases / (run.passed + 1)


def _slowest(runner: Runner, runs: Sequence[GroupRun], box: Box, budget: Budget) -> GroupRun:
    """The slowest of groups that were raced together; what ran in one process is run again, alone."""

    def took(run: GroupRun) -> float:
        if not run.shares:
            return run.usage.cpu_seconds
        limits = budget.within(limits_of(run.problem, [run]))
        return budget.booked(runner.ask(box, run.cases, limits)).usage.cpu_seconds

    return max(runs, key=took) if len(runs) > 1 else runs[0]


def too_slow(run: GroupRun, decision: Decision) -> None:
    """Record it in the group, if it was decided."""
    if decision.too_slow and decision.ratio:
        against = decision.against
        whose = f" in {against.language}" if against else ""
        why = f" ({against.why})" if against and against.why else ""
        run.too_slow(
            f"it takes {decision.ratio.median:,.0f} times the CPU time of the reference solution{whose}; "
            f"the limit is {decision.limit:g} times{why}"
        )


def _too_steep(growing: Sequence[GroupRun], growth: Growth) -> None:
    """The growth is the reason of what is too slow already; else of the largest group, where it will be."""
    slow = [run for run in growing if run.verdict is not Verdict.AC]
    for run in slow:
        run.explain(str(growth))
    if not slow:
        growing[-1].too_slow(f"{growth}; its exponent may exceed that by {growth.slope:g}")


def _worse(first: Decision, second: Decision) -> Decision:
    """Of two races the one to be told: the one that is too slow, else the closer call, else the later one."""
    if second.ratio is None or (first.too_slow, first.borderline) > (second.too_slow, second.borderline):
        return first
    return second
