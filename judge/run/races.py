"""What a submission is raced on: a group with a time limit of its own by itself, all others together."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec.structs import replace

from judge.problem import Problem, Verdict
from judge.run.group import GroupRun
from judge.run.groups import Judging
from judge.run.settings import Reference
from judge.run.timing import Decision, Race, limits_of, race, time_limit


def race_all(judging: Judging, runs: Sequence[GroupRun], reference: Reference) -> Decision:
    """Race the submission on all groups, which are accepted, until one is too slow; it knows so itself.

    Raises:
        JudgeError: the reference does not come to the end of the cases.
    """
    alone = [[run] for run in runs if run.group.time_limit is not None]
    together = [run for run in runs if run.group.time_limit is None]
    decision = Decision()
    for part in ([together] if together else []) + alone:
        raced = measure(judging, part, reference)
        if raced.too_slow:
            too_slow(_slowest(judging, part), raced)
        decision = worse(decision, raced)
        if any(run.verdict is not Verdict.AC for run in part):
            break
    return decision


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
        return Decision()
    decision = race(raced.mine, raced.theirs, raced.limit, raced.goes_on, cautious=bool(raced.language))
    if any(run.verdict is not Verdict.AC for run in runs):
        decision = Decision(ratio=decision.ratio)
    return raced.told(decision)


def growing_of(problem: Problem, runs: Sequence[GroupRun]) -> list[GroupRun]:
    """The groups of the rule of growth, the smallest first."""
    by_name = {run.group.name: run for run in runs}
    names = problem.growth.groups if problem.growth else ()
    return [by_name[name] for name in names if name in by_name]


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
        whose = f" in {decision.reference}" if decision.reference else ""
        why = f" ({decision.why})" if decision.why else ""
        run.failed_whole(
            Verdict.TLE,
            f"it takes {decision.ratio.median:,.0f} times the CPU time of the reference solution{whose}; "
            f"the limit is {decision.ratio.limit:g} times{why}",
        )


def worse(first: Decision, second: Decision) -> Decision:
    """Of two races the one to be told: the one that is too slow, else the closer call, else the later one."""
    told = second
    if second.ratio is None or (first.too_slow, first.borderline) > (second.too_slow, second.borderline):
        told = first
    return replace(told, growth=second.growth, reference=second.reference, why=second.why)
