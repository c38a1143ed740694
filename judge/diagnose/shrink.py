"""From the first failing case to the simplest one that fails: what a person can work out on paper.

    1. The failing case is called alone. If it is right then, its message says so, and that is all. If that
       cannot be decided, nothing is said.
    2. The candidates (candidates.py): seeded cases of few digits, the simplest kinds first, in batches.
    3. Where they all pass: the failing group's own builder, shrunk by its parameters (search.py).
    4. What was found, or the failing case itself, is simplified, value by value (simplify.py).
    5. If that still has many digits, or several pieces of text and lists, all of it for a case that fails in
       any way.

Cases that no recipe built are judged under the tolerance of the problem's usual group, and only count if
the problem's reference solution, a program in doubles too, gets them right. All of it ends within a budget of
calls: what is found depends neither on how fast the machine is nor on what else it does.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from itertools import tee
from typing import NamedTuple

from msgspec.structs import replace

from judge.data import GroupData, ProblemData
from judge.diagnose.candidates import candidates, items_of, measure, sized, usual_group
from judge.diagnose.replay import LONGEST, encode
from judge.diagnose.simplify import rounded, simplified
from judge.diagnose.trial import LIMITED, FailingCase, SearchBudget, Trial, answer_class
from judge.problem import Case, Group, Problem, Verdict
from judge.problem.model import EXAMPLES
from judge.run.result import Failure, Result
from judge.run.runner import Runner
from judge.run.settings import Reference
from judge.sandbox.boundary import Box
from judge.sandbox.encode import in_call
from judge.values.atoms import IntType
from judge.values.outline import right
from judge.values.types import lasting

_SHRUNK = (Verdict.WA, Verdict.RTE, Verdict.TLE, Verdict.MLE)  # the verdicts that one call can earn
_SOUGHT = 40  # cases of a group, among which one is looked for that fails alone
_CLASSES = 6  # of right answers, above which a wanted 5 is like a wanted 3, and a Monday like a Friday
SIMPLE = 7  # the measure's digits up to which a failing case needs no shrinking by parameters
HARD = 24  # digits above which a simple case that fails in another way is shown instead
_PASSING = "called alone it is right: the program keeps something between calls, or answers at random"


def shrink(
    data: ProblemData,
    box: Box,
    runner: Runner,
    result: Result,
    *,
    reference: Reference | None = None,
    budget: SearchBudget | None = None,
) -> Failure | None:
    """The simplest case that the submission in `box` gets wrong, in the way that it failed in its `result`.

    None where the failure has no case of its own, is the sum of many calls, or is too long for a replay id.
    `reference` has the problem's reference solutions. The result depends on the submission alone, unless the
    budget's guard ends the search.

    Raises:
        ProblemError: the problem's own code fails on a case.
    """
    problem, verdict, failure = data.problem, result.verdict, result.failure
    if verdict not in _SHRUNK or failure is None:
        return None
    group_data = next((each for each in data.groups if each.group.name == failure.group), None)
    if group_data is None or group_data.group.size is not None:
        return None
    if failure.case is None and (verdict is not Verdict.WA or runner.calls):
        return None
    coarse = _has_many_answers(problem, data)
    trial = Trial(data.module, box, runner, verdict, budget or SearchBudget(), coarse=coarse)
    if reference is not None:
        trial.reference = partial(reference.open, runner.reference(problem.time) if problem.time else None)
    opening = data.groups[0]
    fails = opening.group.name == failure.group and failure.case == 1
    if failure.case is None or (verdict in LIMITED and not fails):  # what does an answer take?
        trial.ask(opening.cases[0], opening.group)
    if failure.case is None:  # a program's lines are too few or too many: is there a case for which they are?
        first = trial.simplest(group_data.cases[:_SOUGHT], group_data.group, reference_agrees=False)
        if first is None:
            return None
        case = first.case
    else:
        case = group_data.cases[failure.case - 1]
        first = trial.alone(case, group_data.group) if verdict in LIMITED else None
    if verdict not in LIMITED:
        asked = [trial.ask(case, group_data.group) for _ in range(2)]  # twice: it may answer at random
        if verdict is Verdict.WA and any(answer.ended is Verdict.AC for answer in asked):
            return replace(failure, input=problem.named(case), message=_PASSING)
        first = asked[0].failing if asked[1].failing else None
    if first is None:
        return None
    trial.look_for(first)
    return _Search(trial, group_data, first).run()


def _has_many_answers(problem: Problem, data: ProblemData) -> bool:
    """Whether the right answers are of more classes than a mistake could be looked for in.

    Lists that may have many lengths are, even where the data have few of them: the smallest case is shorter.
    So are ints that come from texts or lists.
    """
    counts = isinstance(lasting(problem.answer), IntType) and sized(problem)
    if counts or problem.answer.lengths > _CLASSES:
        return True
    targets = (target for group in data.groups for target in group.targets)
    return len({answer_class(right(problem.answer, target)) for target in targets}) > _CLASSES


class _Search(NamedTuple):
    """The stages of one search."""

    trial: Trial
    data: GroupData
    first: FailingCase

    def run(self) -> Failure | None:
        """The best of what the stages find; None where it is too long for an id."""
        trial, best = self.trial, self.first
        if not trial.problem.parameters:  # there is one case
            return self._told(best)
        under = usual = usual_group(trial.problem)
        levels, again = tee(self._levels())
        found = self._candidate(levels, usual)
        if found is not None:
            best = min(best, simplified(trial, found, usual))
        if best is self.first:
            if _is_long(best, SIMPLE):
                best = self._by_parameters()
            under = usual if usual.tolerance == self.data.group.tolerance else self.data.group
            best = min(best, simplified(trial, best, under))
        pieces = sized(trial.problem)  # which every mistake needs few of
        if _is_long(best, SIMPLE if pieces else HARD):
            trial.look_for(None)
            other = self._candidate(again, usual)
            if other is not None and other < best:
                best, under = simplified(trial, other, usual), usual
            elif pieces:
                best = simplified(trial, best, under)
        return self._told(rounded(trial, best, under))

    def _levels(self) -> Iterator[list[Case]]:
        """The cases of each level that are simpler than the first one that failed."""
        problem, size = self.trial.problem, self.first.measure
        for level in candidates(problem):
            cases = (case for each in level for case in each.cases(problem))
            yield [case for case in cases if measure(case) < size]

    def _candidate(self, levels: Iterator[list[Case]], group: Group) -> FailingCase | None:
        """The simplest failing case of the first level that has one."""
        while not self.trial.budget.spent and (cases := next(levels, None)) is not None:
            found = self.trial.simplest(cases, group)
            if found is not None:
                return found
        return None

    def _by_parameters(self) -> FailingCase:
        group = self.data.group
        if group.name == EXAMPLES or group.neighbours or self.trial.budget.spent:
            return self.first
        from judge.diagnose.search import shrunk  # Hypothesis: only now

        found = shrunk(self.trial, self.trial.module.draws[group.name], group)
        return self.first if found is None else min(self.first, found)

    def _told(self, found: FailingCase) -> Failure | None:
        """What is shown fails under the problem's own limits too; the search was less patient."""
        trial = self.trial
        best = trial.ask(found.case, found.group).failing or self.first
        replay = encode(trial.problem, best.group, best.case)
        if len(replay) > LONGEST:  # nobody would look at it, nor type it
            return None
        message, cut_short = best.failure.message, trial.budget.cut_short
        if trial.problem.methods and (place := trial.stopped_at(best)):
            name, *given = best.case[-1][place - 1]
            message += in_call(place, name, *given)
        if best.case == self.first.case and cut_short and trial.slow_seconds:
            message += f"; not made smaller: one call takes {trial.slow_seconds:.1g} s"
        return replace(best.failure, message=message, replay=replay, cut_short=cut_short)


def _is_long(failing: FailingCase, digits: int) -> bool:
    return failing.measure[0] - items_of(failing.case) > digits
