"""Judging one submission: all its groups, what they come to and how long they take."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from contextlib import ExitStack
from typing import TYPE_CHECKING, NamedTuple

from msgspec.structs import replace

from judge.problem import Problem, Verdict
from judge.run.alone import Admitted
from judge.run.budget import Budget
from judge.run.group import GroupRun
from judge.run.groups import run_groups
from judge.run.races import Timed, growing_of, race_all, worth_racing
from judge.run.reference import Reference
from judge.run.result import Behaviour, Failure, GroupResult, LevelResult, Result, Timing, earned
from judge.run.runner import Runner
from judge.run.settings import Progress, Settings
from judge.run.timing import BESIDE, Decision, disturbed
from judge.run.unreadable import why_unreadable
from judge.sandbox import Box, Usage

if TYPE_CHECKING:
    from judge.data.model import ProblemData

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
    chosen = [group for group in data.groups if groups is None or group.group.name in groups]
    runner = opened(box, problem, source, program=settings.program)
    if isinstance(runner, Failure):
        return Judgement(uncompiled(problem, name, runner, box), None, {})
    runs = [GroupRun(data, group, runner) for group in chosen]
    judging = _Judging(runs, runner, on_progress, Budget(problem))
    # Those of the rule of growth are timed when they are judged; another language is raced with many passes.
    growing = growing_of(problem, runs) if settings.measured and problem.time and not runner.language else []
    with settings.lock.judging() as place:
        judging.groups(box, [run for run in runs if run not in growing])
        if any(run.verdict is not Verdict.AC for run in runs):  # nothing hangs on the time
            judging.groups(box, growing)
            growing = []
    timing, waited = Timed(Decision(None)), place.waited
    if growing or (settings.measured and worth_racing(problem, runs)):
        timing, place = _race(judging, runs, growing, box, settings)
        waited += place.waited
    result = _result(problem, name, runner, runs, timing, box.isolation)
    notes = [_WAITED] if waited >= _LONG_WAIT_SECONDS else []
    if result.verdict is not Verdict.AC:
        notes += box.inspect().warnings
    return Judgement(result.noting(*notes), runner, {run.group.name: run.answers for run in runs})


def opened(box: Box, problem: Problem, source: bytes, *, program: bool = False) -> Runner | Failure:
    """How to run the submission in `box`: its entry function is called if it has one, and no `program` asked
    for. Or why it does not compile.
    """
    inspection = box.inspect()
    if fault := why_unreadable(source, inspection.fault):
        return Failure(fault)
    defined = problem.entry and inspection.defines(problem.entry) and not program
    if defined or (problem.methods and not problem.formatted):
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
    problem: Problem, name: str, runner: Runner, runs: Sequence[GroupRun], timing: Timed, isolation: str
) -> Result:
    """What the groups come to together."""
    decision, growth, against = timing
    usage = sum((run.usage + run.imported for run in runs), Usage())
    rejected = [run for run in runs if run.verdict is not Verdict.AC]
    failing = next((run for run in rejected if not run.given_up), None)  # one that says why
    failing = failing or next(iter(rejected), None)
    groups = tuple(run.result() for run in runs)
    does = {run.group.name: run.answers for run in runs}
    failure = failing.failure and runner.explained(failing.failure, does) if failing else None
    return Result(
        problem=problem.id,
        submission=name,
        mode=runner.mode,
        verdict=failing.verdict if failing else Verdict.AC,
        failure=failure,
        time=Timing(
            cpu_seconds=usage.cpu_seconds,
            wall_seconds=usage.wall_seconds,
            import_seconds=decision.imported,
            ratio=decision.ratio and replace(decision.ratio, limit=decision.limit),
            borderline=_close(timing),
            growth=growth,
            reference=against.language if against else "",
            why=against.why if against else "",
        ),
        memory_bytes=usage.memory_bytes,
        isolation=isolation,
        levels=_levels(problem, groups),
        **earned(groups),
    )


def _levels(problem: Problem, groups: Sequence[GroupResult]) -> tuple[LevelResult, ...]:
    """How far they come on each of the problem's levels."""
    found = []
    for level in problem.levels:
        verdicts = [group.verdict for group in groups if group.level is level]
        accepted = verdicts.count(Verdict.AC)
        count = len(problem.of_level(level))
        found.append(LevelResult(level, accepted == count, count, len(verdicts), accepted))
    return tuple(found)


def _close(timing: Timed) -> bool:
    """Whether the time, or how it grows, was a close call."""
    return timing.decision.borderline or (timing.growth is not None and timing.growth.borderline)


def _race(
    judging: _Judging, runs: Sequence[GroupRun], growing: Sequence[GroupRun], box: Box, settings: Settings
) -> tuple[Timed, Admitted]:
    """Judge the groups that grow, and race whatever is worth it."""
    problem, runner, budget = judging.runner.problem, judging.runner, judging.budget
    with ExitStack() as stack:
        shared = settings.reference or stack.enter_context(Reference(problem, settings.box_factory))
        place = stack.enter_context(settings.lock.measuring())
        timing = judging.growing(box, growing, shared) if growing else None
        if timing is None:
            worth = worth_racing(problem, runs)
            timing = race_all(runner, runs, box, shared, budget) if worth else Timed(Decision(None))
        if not place.alone:
            timing = timing._replace(decision=disturbed(timing.decision, BESIDE))
        return timing, place


class _Judging:
    """The groups of one submission."""

    def __init__(
        self, runs: Sequence[GroupRun], runner: Runner, on_progress: Progress | None, budget: Budget
    ) -> None:
        self.budget = budget
        self.runner = runner
        self._on_progress = on_progress
        self._done = 0
        self._total = sum(len(run.cases) for run in runs)

    def groups(self, box: Box, runs: Sequence[GroupRun]) -> None:
        """Judge these of the groups in the box."""
        run_groups(self.runner, box, runs, self.budget, self._after_group)
        self._give_up(runs)

    def growing(self, box: Box, runs: Sequence[GroupRun], reference: Reference) -> Timed | None:
        """Judge those of the rule of growth; what they come to where that is clear."""
        from judge.run.growing import judge_growing  # few problems have one

        found = judge_growing(self.runner, runs, box, reference, self.budget, self._after_group)
        self._give_up(runs)
        return found

    def _give_up(self, runs: Sequence[GroupRun]) -> None:
        """Those that were not begun, since the budget is used up."""
        for run in runs:
            if not (run.ended or run.given_up):
                assert self.budget.over
                run.give_up(*self.budget.over)

    def _after_group(self, run: GroupRun) -> None:
        run.ended = True
        self._done += len(run.cases)
        if self._on_progress:
            self._on_progress(self._done, self._total)
        if run.verdict is Verdict.TLE or run.out_of_time:
            self.budget.ran_out_of_time(at_once=run.reached <= 1 < len(run.cases))
