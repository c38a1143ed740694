"""Judging one submission: all its groups, what they come to and how long they take.

A group with a time limit of its own is raced on by itself, all others together.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from contextlib import ExitStack
from typing import TYPE_CHECKING, NamedTuple

from judge.problem import Problem, Verdict
from judge.problem.model import KataLevel
from judge.run.group import GroupRun
from judge.run.groups import Judging
from judge.run.result import Behaviour, Failure, GroupResult, LevelResult, Result, Timing, earned
from judge.run.runner import Runner
from judge.run.settings import Progress, Reference, Settings
from judge.run.timing import BESIDE, MEASURED, Decision, Race, disturbed, limits_of, race
from judge.sandbox import Box, Usage

if TYPE_CHECKING:
    from judge.data import ProblemData

_LONG_WAIT_SECONDS = 2.0
_WAITED = "Waited: another judge of yours was timing"  # without the seconds, so that it is said once


class Judgement(NamedTuple):
    """A result, how the submission was run (None for one that does not compile), and what it answered."""

    result: Result
    runner: Runner | None
    behaviour: Behaviour


def judge_submission(
    data: ProblemData,
    source: bytes,
    name: str,
    settings: Settings | None = None,
    *,
    box: Box | None = None,
    groups: Collection[str] | None = None,
    on_progress: Progress | None = None,
) -> Judgement:
    """Judge one submission on a problem's data.

    Args:
        source: the bytes of its file.
        name: the file's name, for tracebacks and the result.
        settings: how.
        box: one that is open already and holds the submission; without it one is opened and ended.
        groups: the names of the groups to run; all where it is None.
        on_progress: called after each group.

    Raises:
        ProblemError: the reference fails on a case.
        JudgeError: nothing can be run on this machine.
    """
    settings = settings or Settings()
    if box is None:
        with settings.box_factory(source, name) as box:
            return judge_submission(
                data, source, name, settings, box=box, groups=groups, on_progress=on_progress
            )
    problem = data.problem
    runner = opened(box, problem, source, program=settings.program)
    if isinstance(runner, Failure):
        return Judgement(uncompiled(problem, name, runner, box), None, {})
    runs = [
        GroupRun(data, group, runner) for group in data.groups if groups is None or group.group.name in groups
    ]

    def after_group(_: GroupRun) -> None:
        if on_progress:
            cases = sum(len(run.cases) for run in runs)
            on_progress(sum(len(run.cases) for run in runs if run.ended), cases)

    judging = Judging(runner, box, on_group=after_group)
    measured = bool(settings.measured and problem.time)
    names = problem.growth.groups if measured and problem.growth else ()  # the smallest first
    growing = [run for name in names for run in runs if run.group.name == name]  # timed when they are judged
    rest = [run for run in runs if run not in growing]
    with ExitStack() as stack:
        reference = settings.reference or stack.enter_context(Reference(problem, settings.box_factory))
        with settings.lock.judging() as place:
            judging.run(rest)
            decision = race_all(judging, rest, reference, beside=True) if measured else Decision()
            measured = measured and _accepted(rest)
            if not measured:  # nothing hangs on the time
                judging.run(growing)
        waited = place.waited
        if measured and (decision.near or growing):
            with settings.lock.measuring() as place:
                if decision.near:
                    decision = race_all(judging, rest, reference)
                if not _accepted(rest):
                    judging.run(growing)
                elif growing:
                    from judge.run.growing import judge_growing  # few problems have a rule of growth

                    decision = decision.worse(judge_growing(judging, growing, reference, race_of))
            waited += place.waited
    if not place.alone:
        decision = disturbed(decision, BESIDE)
    does = {run.group.name: run.answers for run in runs}
    result = _result(name, runner, runs, does, decision, box.isolation)
    notes = [_WAITED] if waited >= _LONG_WAIT_SECONDS else []
    if result.verdict is not Verdict.AC:
        notes += box.inspect().warnings
    return Judgement(result.noting(*notes), runner, does)


def opened(box: Box, problem: Problem, source: bytes, *, program: bool = False) -> Runner | Failure:
    """How to run the submission in `box`: its entry function is called if it has one, and no `program` asked
    for. Or why it does not compile.
    """
    inspection = box.inspect()
    defined = problem.entry and inspection.defines(problem.entry)
    if not defined:
        from judge.run.unreadable import why_unreadable  # most submissions can be read

        if fault := why_unreadable(source, inspection.fault):
            return Failure(fault)
    if (defined and not program) or (problem.methods and not problem.formatted):
        return Runner(problem, inspection.language)
    if problem.formatted:
        from judge.run.formatted import FormatRunner  # few problems have a format of their own

        return FormatRunner(problem, inspection.language)
    from judge.run.program import ProgramRunner  # most submissions are functions

    return ProgramRunner(problem, inspection.language, program, source)


def uncompiled(problem: Problem, name: str, failure: Failure, box: Box) -> Result:
    """The result of a submission that does not compile."""
    return Result(
        problem=problem.id, submission=name, verdict=Verdict.CE, failure=failure, isolation=box.isolation
    )


def _result(
    name: str,
    runner: Runner,
    runs: Sequence[GroupRun],
    does: Behaviour,
    decision: Decision,
    isolation: str,
) -> Result:
    """What the groups come to together."""
    problem, growth = runner.problem, decision.growth
    usage = sum((run.usage + run.imported for run in runs), Usage())
    rejected = [run for run in runs if run.verdict is not Verdict.AC]
    # the first one that says why, if there is one
    failing = next((run for run in rejected if not run.given_up), next(iter(rejected), None))
    groups = tuple(run.result() for run in runs)
    return Result(
        problem=problem.id,
        submission=name,
        mode=runner.mode,
        verdict=failing.verdict if failing else Verdict.AC,
        failure=failing.failure and runner.explained(failing.failure, does) if failing else None,
        time=Timing(
            cpu_seconds=usage.cpu_seconds,
            wall_seconds=usage.wall_seconds,
            borderline=decision.borderline or (growth is not None and growth.borderline),
            **{each: getattr(decision, each) for each in MEASURED},
        ),
        memory_bytes=usage.memory_bytes,
        isolation=isolation,
        levels=tuple(_level(problem, level, groups) for level in problem.levels),
        **earned(groups),
    )


def _level(problem: Problem, level: KataLevel, groups: Sequence[GroupResult]) -> LevelResult:
    """How far the groups come on that level."""
    verdicts = [group.verdict for group in groups if group.level is level]
    accepted, count = verdicts.count(Verdict.AC), len(problem.of_level(level))
    return LevelResult(level, accepted == count, count, len(verdicts), accepted)


def _accepted(runs: Sequence[GroupRun]) -> bool:
    return all(run.verdict is Verdict.AC for run in runs)


def race_all(
    judging: Judging, runs: Sequence[GroupRun], reference: Reference, *, beside: bool = False
) -> Decision:
    """Race the submission on all groups, as long as they are accepted; one that is too slow knows so itself.

    `beside` is as in `timing.race`.

    Raises:
        JudgeError: the reference does not come to the end of the cases.
    """
    alone = [[run] for run in runs if run.group.time_limit is not None]
    together = [run for run in runs if run.group.time_limit is None]
    decision = Decision()
    for part in filter(None, [together, *alone]):
        if not _accepted(runs):
            break
        raced = measure(judging, part, reference, beside=beside)
        if raced.near:
            return raced
        if raced.too_slow:
            raced.record(_slowest(judging, part))
        decision = decision.worse(raced)
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
    own = runs[0].group.time_limit if len(runs) == 1 else None
    limit = problem.time.limit if own is None else own
    if runner.language:
        from judge.run.foreign import LongRace, rival_of  # most submissions are in Python

        rival = rival_of(runner, problem.time, reference, limit)
        return None if rival is None else LongRace(judging, runs, rival)
    box = reference.open(runner.reference(problem.time))
    return None if box is None else Race(judging, runs, box, limit)


def measure(judging: Judging, runs: Sequence[GroupRun], reference: Reference, *, beside: bool) -> Decision:
    """Race a submission and the reference, if there is one, on the cases of accepted groups.

    There is no more racing for a submission that is no longer accepted, nor for one that has kept the judge
    waiting.

    Raises:
        JudgeError: the reference does not come to the end of the cases.
    """
    raced = race_of(judging, runs, reference)
    if raced is None:
        return Decision()
    decision = race(
        raced.mine, raced.theirs, raced.limit, raced.goes_on, cautious=bool(raced.language), beside=beside
    )
    if not _accepted(runs):
        decision = Decision(ratio=decision.ratio)
    return raced.told(decision)


def _slowest(judging: Judging, runs: Sequence[GroupRun]) -> GroupRun:
    """The slowest of groups that were raced together; what ran in one process is run again, alone."""

    def took(run: GroupRun) -> float:
        if not run.shares:
            return run.usage.cpu_seconds
        return judging.ask(run.cases, limits_of(run.problem, [run])).usage.cpu_seconds

    return max(runs, key=took) if len(runs) > 1 else runs[0]
