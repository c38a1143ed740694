"""Judging the groups of the rule of growth: each is timed by the way, and what grows too fast ends early.

The first turn of a race is the one in which a group is judged; the reference's turn follows at once. So an
accepted submission runs its largest size once, and one that is clearly too steep never does: the first case
of a larger size is cut as soon as that may be said. If it then cannot be, the case is run again, whole.
In other languages than Python a turn has many passes: all groups are judged before the first of them.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from math import inf

from msgspec.structs import replace

from judge.problem import Case, Verdict
from judge.run.group import GroupRun
from judge.run.groups import Judging
from judge.run.growth import SHORT_SECONDS, Course, grow, is_steep, steep_seconds
from judge.run.settings import Reference
from judge.run.timing import Decision, Race, TurnPair, decide, is_sure, limits_of, theirs_on
from judge.sandbox.boundary import Usage

RaceOf = Callable[..., Race | None]  # see `judge.run.execute.race_of`


def judge_growing(
    judging: Judging, runs: Sequence[GroupRun], reference: Reference, race_of: RaceOf
) -> Decision:
    """Judge these groups, the smallest first, and race on them, until it is clear how the submission grows.

    Raises:
        JudgeError: the reference does not come to the end of the cases.
    """
    growing = _Growing(judging, reference, race_of)
    if judging.runner.language:
        judging.run(runs)
    for place, run in enumerate(runs):
        if run.ended or judging.budget.over:
            break
        growing.judge(run)
        judging.end(run)
        if growing.decision is not None:
            for larger in runs[place + 1 :]:
                larger.give_up(Verdict.TLE, "it is too slow before")
            return growing.decision
    judging.give_up(runs)
    return growing.race([run for run in runs if not run.given_up])


class _Growing:
    """What is known so far of how a submission grows."""

    def __init__(self, judging: Judging, reference: Reference, race_of: RaceOf) -> None:
        runner = judging.runner
        time, growth = runner.problem.time, runner.problem.growth
        assert time is not None
        assert growth is not None
        self._judging, self._slope = judging, growth.slope
        self._race_of = partial(race_of, judging, reference=reference)
        self._rival = None if runner.language else reference.open(runner.reference(time))
        self._races: list[Race] = []  # on the groups that were accepted
        self._courses: list[Course] = []  # theirs
        self.decision: Decision | None = None  # that it is clearly too slow or too steep

    def judge(self, run: GroupRun) -> None:
        """Judge the group, and note what both took."""
        smaller, size = self._courses[-1] if self._courses else None, run.group.size or 1
        own, theirs, ahead, most = 0.0, Usage(), None, inf
        if smaller and self._rival:
            ahead = self._theirs(run, run.cases[:1])
            most = steep_seconds(smaller, size, ahead.cpu_seconds, self._slope)
        while not run.ended and not self._judging.budget.over:
            cases = run.rest[:1] if smaller and not run.reached else run.rest
            replies, cut = self._judging.part(run, cases, most)
            most = 2 * most if cut else inf
            if self._rival is None or run.verdict is not Verdict.AC:
                self._rival = None  # nothing hangs on the time any more
                continue
            used, ahead = ahead or self._theirs(run, cases), None
            # The limits hold for an import too; one that was cut tells nothing of the calls.
            called = not (cut and self._judging.runner.calls) or replies.imported != Usage()
            pair = TurnPair(replies.usage.cpu_seconds if called else 0.0, used.cpu_seconds)
            if smaller and self._is_steep(run, cases, pair, cut=cut):
                run.usage += replies.usage if cut else Usage()
                return
            if not cut:
                own, theirs = own + pair.submission, theirs + used
        race = self._race_of([run]) if self._rival else None
        if race and run.reached == len(run.cases):
            race.theirs_took.append(theirs)
            pairs = [TurnPair(own, theirs.cpu_seconds)] if theirs.cpu_seconds else []
            self._add(run, race, pairs)
            if pairs and is_sure(pairs[0], race.limit):
                self.decision = race.told(decide(pairs, race.limit))
                self.decision.record(run)

    def _is_steep(self, run: GroupRun, cases: Sequence[Case], pair: TurnPair, *, cut: bool) -> bool:
        """Whether the submission is too steep by what it took here; then the group says so."""
        long = cut or pair.submission >= SHORT_SECONDS  # and not run again

        def mine() -> float | None:
            if long:
                return pair.submission
            again = self._judging.ask(cases, limits_of(run.problem, [run]))
            return None if again.trouble else again.usage.cpu_seconds

        def theirs() -> float:
            return self._theirs(run, cases).cpu_seconds

        size = run.group.size or 1
        larger = Course(run.group.name, size, mine, theirs, None, len(cases), not cut, [pair])
        smaller = self._courses[-1]

        def steep() -> bool:
            return is_steep(smaller, larger, self._slope)

        growth = grow([smaller, larger], self._slope, steep).growth if steep() else None
        if growth is None or not steep():
            return False
        self.decision = Decision(growth=growth)
        run.failed_whole(Verdict.TLE, growth.too_steep)
        return True

    def _theirs(self, run: GroupRun, cases: Sequence[Case]) -> Usage:
        assert self._rival is not None
        return theirs_on(self._judging.runner, self._rival, cases, limits_of(run.problem, [run]))

    def _add(self, run: GroupRun, race: Race, pairs: list[TurnPair]) -> None:
        """Note the group's race, and its turns so far."""
        ended = run.verdict is Verdict.AC
        mine = race.mine if ended else partial(_at_least, run, race.cases)
        limit, size = race.limit if ended else None, run.group.size or 1
        self._races.append(race)
        self._courses.append(Course(run.group.name, size, mine, race.theirs, limit, race.cases, ended, pairs))

    def race(self, runs: Sequence[GroupRun]) -> Decision:
        """How the submission grows on all sizes, where it is accepted or out of CPU time on each."""
        if not all(run.verdict is Verdict.AC or run.out_of_cpu_time for run in runs):
            return Decision()
        for run in runs[len(self._races) :]:
            if race := self._race_of([run]):
                self._add(run, race, [])
        if not self._races:
            return Decision()

        def goes_on() -> bool:
            # of one that is too slow it only remains to say how it grows
            return all(each.ended for each in self._courses) and all(each.goes_on() for each in self._races)

        first = self._races[0]
        grown = grow(self._courses, self._slope, goes_on, cautious=bool(first.language))
        decision, growth = Decision(), grown.growth
        for run, race in zip(runs, self._races, strict=True):
            if run.group.name in grown.decisions and run.verdict is Verdict.AC:
                own = race.told(grown.decisions[run.group.name])
                own.record(run)
                decision = decision.worse(own)
        if growth is not None and grown.too_steep:
            for run in runs:  # it is the reason of what is too slow already
                if run.failure:
                    run.failure = replace(run.failure, message=f"{run.failure.message}; {growth}")
            if all(run.verdict is Verdict.AC for run in runs):
                runs[-1].failed_whole(Verdict.TLE, growth.too_steep)
        return replace(decision, growth=growth, reference=first.language, why=first.why)


def _at_least(run: GroupRun, cases: int) -> float:
    """What so many cases take that are like those which were begun before the time was up."""
    return run.usage.cpu_seconds * cases / (run.passed + 1)
