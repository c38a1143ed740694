"""What a submission is raced on: which groups together, which alone, and how it grows.

A group with a time limit of its own, or one of the rule of growth, is raced by itself; all others together.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import NamedTuple

from judge.problem import Problem, Verdict
from judge.run.budget import Budget
from judge.run.group import GroupRun
from judge.run.growth import Course, Grown, grow
from judge.run.measure import Duel, measure, time_limit, track_of
from judge.run.reference import Reference
from judge.run.result import Growth
from judge.run.runner import Runner
from judge.run.timing import Decision
from judge.sandbox.boundary import Box


class Timed(NamedTuple):
    """What the races came to; groups that are too slow know it themselves."""

    decision: Decision
    growth: Growth | None = None


def worth_racing(problem: Problem, runs: Sequence[GroupRun]) -> bool:
    """Whether the verdict may still hang on the time: accepted, or out of CPU time in a group that grows."""
    names = problem.growth.groups if problem.growth else ()
    return any(not run.given_up for run in runs) and all(
        run.verdict is Verdict.AC or _out_of_time(run, names) for run in runs
    )


def race_all(
    problem: Problem,
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
    growing = _growing(problem, runs)
    alone = [run for run in runs if run.group.time_limit is not None and run not in growing]
    together = [run for run in runs if run not in growing and run not in alone]
    decision = Decision(None)
    parts = ([together] if together else []) + [[run] for run in alone]
    if any(run.verdict is not Verdict.AC for run in runs):
        parts = []  # it is too slow, and what is left to say is why
    for part in parts:
        raced = measure(problem, runner, part, submission, reference, budget)
        _too_slow(problem, part, raced)
        decision = _worse(decision, raced)
        if any(run.verdict is not Verdict.AC for run in part):
            return Timed(decision)
    if not growing or problem.growth is None:
        return Timed(decision)
    grown = _grown(problem, runner, growing, submission, reference, budget)
    for run in growing:
        if run.group.name in grown.decisions and run.verdict is Verdict.AC:
            raced = grown.decisions[run.group.name]
            _too_slow(problem, [run], raced)
            decision = _worse(decision, raced)
    if grown.growth is not None and grown.too_steep:
        _too_steep(growing, grown.growth)
    return Timed(decision, grown.growth)


def _growing(problem: Problem, runs: Sequence[GroupRun]) -> list[GroupRun]:
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
    problem: Problem,
    runner: Runner,
    growing: Sequence[GroupRun],
    submission: Box,
    reference: Reference,
    budget: Budget,
) -> Grown:
    rule = problem.growth
    rival = reference.open(runner.reference(problem.time)) if problem.time else None
    if rule is None or rival is None:
        return Grown(None, False, {})
    duels, courses = [], []
    for run in growing:
        track = track_of(reference, runner, [run])
        duel = Duel(runner, [run], submission, rival, track, budget)
        duels.append(duel)
        ended = run.verdict is Verdict.AC
        courses.append(
            Course(
                run.group.name,
                run.group.size or 1,
                duel.mine if ended else partial(float, run.usage.cpu_seconds),
                duel.theirs,
                time_limit(problem, [run]) if ended else None,
                len(track.cases),
            )
        )
    return grow(courses, rule.slope, lambda: all(duel.goes_on() for duel in duels))


def _too_slow(problem: Problem, runs: Sequence[GroupRun], decision: Decision) -> None:
    if decision.too_slow and decision.ratio and problem.time:
        slowest = max(runs, key=lambda run: run.usage.cpu_seconds)
        slowest.too_slow(
            f"it takes {decision.ratio.median:,.0f} times the CPU time of the reference solution; "
            f"the limit is {time_limit(problem, runs):g} times"
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
