"""From the first failing case to the simplest one that fails: what a person can work out on paper.

    1. The failing case is called alone. If it is right then, its message says so, and that is all. If that
       cannot be decided, nothing is said.
    2. The ladder (simple.py): seeded cases of few digits, the simplest kinds first, in batches.
    3. Where they all pass: the failing group's own builder, shrunk by its parameters (search.py).
    4. What was found, or the failing case itself, is polished, value by value (polish.py).
    5. If that still has many digits, the ladder again, for a case that fails in any way.

Cases that no recipe built are judged under the tolerance of the problem's plainest group, and only count if
the problem's reference solution, a program in doubles too, gets them right. All of it ends within a budget of
calls: what is found depends neither on how fast the machine is nor on what else it does.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from typing import Any

from msgspec.structs import replace

from judge.data.build import choices_of
from judge.data.draw import Draw, seeded
from judge.data.model import GroupData, ProblemData
from judge.diagnose.budget import SearchBudget
from judge.diagnose.polish import polished, rounded
from judge.diagnose.replay import LONGEST, encode
from judge.diagnose.simple import Step, ladder
from judge.diagnose.simplicity import items_of
from judge.diagnose.trial import LIMITED, Finding, Outcome, Trial, sort_of
from judge.problem import Case, Group, Problem, Verdict
from judge.problem.model import EXAMPLES
from judge.run.group import named_input
from judge.run.reference import Reference
from judge.run.result import Failure, Result, short_answer
from judge.run.runner import Runner
from judge.sandbox.boundary import Box
from judge.values.outline import right

_SHRUNK = (Verdict.WA, Verdict.RTE, Verdict.TLE, Verdict.MLE)  # the verdicts that one call can earn
_SOUGHT = 40  # cases of a group, among which one is looked for that fails alone
_SORTS = 6  # of right answers, above which a wanted 5 is like a wanted 3, and a Monday like a Friday
SIMPLE = 7  # the measure's digits up to which a failing case needs no shrinking by parameters
HARD = 24  # digits above which a simple case that fails in another way is shown instead
Choices = Callable[[Group, Callable[[Draw], Any], int, Case], tuple[int, ...] | None]
_PASSING = "called alone it is right: the program keeps something between calls, or answers at random"


def shrink(
    data: ProblemData,
    box: Box,
    runner: Runner,
    result: Result,
    *,
    reference: Reference | None = None,
    budget: SearchBudget | None = None,
    choices: Choices | None = None,
) -> Failure | None:
    """The simplest case that the submission in `box` gets wrong, in the way that it failed in its `result`.

    None where the failure has no case of its own, is the sum of many calls, or is too long for a replay id.
    `reference` has the problem's reference solutions. `choices` tells what case `number` (from 0)
    of a group was built from; without it they are sought as those of pinned data. The result depends on the
    submission alone, unless the budget's guard ends the search.

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
    budget = budget or SearchBudget()
    coarse = _has_many_answers(problem, data)
    rule = problem.time
    name = runner.reference(rule) if rule else None

    def judge_box() -> Box | None:
        return reference.open(name) if reference else None

    trial = Trial(data.module, box, runner, verdict, budget, judge_box, coarse=coarse)
    opening = data.groups[0]
    fails = opening.group.name == failure.group and failure.case == 1
    if failure.case is None or (verdict in LIMITED and not fails):  # what does an answer take?
        trial.ask(opening.cases[0], opening.group)
    if failure.case is None:  # a program's lines are too few or too many: is there a case for which they are?
        first = trial.simplest(group_data.cases[:_SOUGHT], group_data.group, fair=False)
        if first is None:
            return None
        case = first.case
    else:
        case = group_data.cases[failure.case - 1]
        first = trial.alone(case, group_data.group) if verdict in LIMITED else None
    if verdict not in LIMITED:
        asked = [trial.ask(case, group_data.group) for _ in range(2)]  # twice: it may answer at random
        if verdict is Verdict.WA and Outcome.PASSES in asked:
            return replace(failure, input=named_input(problem, case), message=_PASSING)
        first, again = (each if isinstance(each, Finding) else None for each in asked)
        first = first if again else None
    if first is None:
        return None
    trial.look_for(first)
    number = group_data.cases.index(case)
    return _Search(problem, trial, group_data, first, number, choices or choices_of).run()


def _has_many_answers(problem: Problem, data: ProblemData) -> bool:
    """Whether the right answers are of more sorts than a mistake could be looked for in.

    Lists that may have many lengths are, even where the data have few of them: the smallest case is shorter.
    """
    if problem.answer.lengths > _SORTS:
        return True
    sorts = {sort_of(right(problem.answer, target)) for group in data.groups for target in group.targets}
    return len(sorts) > _SORTS


class _Search:
    """The stages of one search."""

    def __init__(
        self,
        problem: Problem,
        trial: Trial,
        data: GroupData,
        first: Finding,
        number: int,
        choices_of: Choices,
    ) -> None:
        self._problem = problem
        self._trial = trial
        self._group = data.group
        self._first = first
        self._number = number
        self._choices_of = choices_of
        self._simple: list[list[Case]] = []  # of each step of the ladder, once it was climbed

    def run(self) -> Failure | None:
        """The best of what the stages find; None where it is too long for an id."""
        best = self._first
        if not self._problem.parameters:  # there is one case
            return self._told(self._confirmed(best))
        under = plain = plainest(self._problem)
        found = self._climbed(plain)
        if found is not None:
            best = min(best, polished(self._trial, found, plain), key=_measure)
        if best is self._first:
            if best.measure[0] - items_of(best.case) > SIMPLE:
                best = self._by_parameters()
            under = plain if plain.tolerance == self._group.tolerance else self._group
            best = min(best, polished(self._trial, best, under), key=_measure)
        if best.measure[0] - items_of(best.case) > HARD:
            self._trial.look_for(None)
            other = self._climbed(plain)
            if other is not None:
                best, under = polished(self._trial, other, plain), plain
        best = rounded(self._trial, best, under)
        return self._told(self._confirmed(best))

    def _climbed(self, group: Group) -> Finding | None:
        """The simplest failing case of the first step that has one."""
        for place, step in enumerate(ladder(self._problem)):
            if self._trial.budget.spent:
                break
            if place == len(self._simple):
                self._simple.append(self._cases(step))
            found = self._trial.simplest(self._simple[place], group)
            if found is not None:
                return found
        return None

    def _cases(self, step: Step) -> list[Case]:
        """The cases of a step that are simpler than the first one that failed."""
        drawn = (
            rung.case(Draw(seeded(f"{rung}/{number}")), self._problem)
            for rung, count in step
            for number in range(count)
        )
        return [case for case in drawn if self._trial.measure(case) < self._first.measure]

    def _by_parameters(self) -> Finding:
        if self._group.name == EXAMPLES or self._trial.budget.spent:
            return self._first
        builder = self._trial.module.draws[self._group.name]
        choices = self._choices_of(self._group, builder, self._number, self._first.case)
        if choices is None:
            return self._first
        from judge.diagnose.search import shrunk  # Hypothesis: only now

        found = shrunk(self._trial, builder, self._group, choices)
        if found is None or self._first.measure <= found.measure:
            return self._first
        return found

    def _confirmed(self, best: Finding) -> Finding:
        """What is shown fails under the problem's own limits too; the search was less patient."""
        found = self._trial.ask(best.case, best.group)
        return found if isinstance(found, Finding) else self._first

    def _told(self, best: Finding) -> Failure | None:
        replay = encode(self._problem, best.group, best.case)
        if len(replay) > LONGEST:  # nobody would look at it, nor type it
            return None
        trial, message = self._trial, best.message
        if best.case == self._first.case and trial.budget.cut_short and trial.slow_seconds:
            message += f"; not made smaller: one call takes {trial.slow_seconds:.1g} s"
        return Failure(
            message,
            group=best.group.name,
            case=None,
            input=named_input(self._problem, best.case),
            expected=best.expected,
            got=best.got,
            given=short_answer(best.given),
            printed=best.printed,
            replay=replay,
            cut_short=trial.budget.cut_short,
        )


def plainest(problem: Problem) -> Group:
    """The group whose tolerance is the problem's usual one: its grid, or the first of that tolerance."""
    usual, _ = Counter(group.tolerance for group in problem.groups).most_common(1)[0]
    groups = [group for group in problem.groups if group.tolerance == usual]
    return next((group for group in groups if group.name == "grid"), groups[0])


def _measure(finding: Finding) -> tuple[object, ...]:
    return finding.measure
