"""Trying cases on a submission, contained: which of them it gets wrong, in the way that it is known to fail.

Nothing is tried that breaks the bounds or the promise. A case that fails among others is called once more by
itself before it is believed: a function may keep something between its calls, or answer at random.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Sequence

from msgspec import Struct
from msgspec.structs import astuple

from judge.data.module import ProblemModule, blaming
from judge.data.validate import Validator
from judge.diagnose.simplicity import Measure, measure
from judge.errors import ProblemError
from judge.problem import Case, Group, Problem, Tolerance, Verdict
from judge.run.program import answer_lines, render_group
from judge.run.result import Mode
from judge.run.tally import VERDICTS
from judge.sandbox import Box, Limits, Stop
from judge.values import Exact, Outline, Raw, Rejection, Target

Clock = Callable[[], float]

MOST_LOSSES = 6  # calls of a batch that may take their process with them
SHORT_SECONDS = 0.2  # of CPU time, after which a call that once ran out of time is not waited for
_QUICK_SECONDS = 0.02  # wall time a case is worth when nothing points to slowness
LIMITED = (Verdict.TLE, Verdict.MLE, Verdict.OLE)  # what a call has used, not what it said


class Finding(Struct, frozen=True):
    """A case that the submission gets wrong, under a group's tolerance."""

    case: Case
    group: Group
    measure: Measure
    verdict: Verdict
    expected: str
    got: str
    message: str
    kind: tuple[str, ...]  # in which way it fails: what is wanted and given, roughly
    given: Raw = None  # the answer itself, None where there is none


class Budget:
    """What the search may cost: seconds by a clock, and calls."""

    def __init__(self, seconds: float, clock: Clock = time.monotonic, most_calls: int = 50_000) -> None:
        self._clock = clock
        self._end = clock() + seconds
        self._most_calls = most_calls
        self.calls = 0

    @property
    def spent(self) -> bool:
        """Whether nothing more may be begun."""
        return self.calls >= self._most_calls or self._clock() >= self._end

    @property
    def left(self) -> float:
        """The seconds that remain."""
        return max(0.0, self._end - self._clock())


class Trial:
    """One submission in its box, and the verdict to look for."""

    def __init__(
        self,
        problem: Problem,
        module: ProblemModule,
        box: Box,
        mode: Mode,
        verdict: Verdict,
        budget: Budget,
        judge_box: Callable[[], Box | None] = lambda: None,
        *,
        coarse: bool = False,
    ) -> None:
        """`coarse` says that ints and lengths tell no two mistakes apart, as where there are many of them."""
        self.problem = problem
        self.module = module
        self.verdict = verdict
        self.budget = budget
        self._box = box
        self._mode = mode
        self._validator = Validator(problem, module.promise)
        self._judge_box = judge_box
        self._coarse = coarse
        self._known: dict[tuple[str, str], Finding | None] = {}
        self._targets: dict[tuple[str, str], Target] = {}
        self._kind: tuple[str, ...] | None = None

    def look_for(self, finding: Finding) -> None:
        """From now on only cases that fail in this way count: another mistake would explain nothing."""
        self._kind = finding.kind

    def valid(self, case: Case, group: Group) -> bool:
        """Whether the case keeps the bounds and the promise, and has an answer.

        One on which the problem's own code fails is passed over: no group would hold it.
        """
        try:
            with blaming(self.problem, "the promise fails on a case"):
                if self._validator.fault(case) is not None:
                    return False
            self._target(case, group)
        except ProblemError:
            return False
        return True

    def alone(self, case: Case, group: Group) -> Finding | None:
        """How the case fails when it is called by itself, within short limits; remembered."""
        key = (group.name, repr(case))
        if key not in self._known:
            self._known[key] = next(iter(self._try([case], group)), None)
        return self._known[key]

    def again(self, case: Case, group: Group) -> Finding | None:
        """How the case fails when it is called by itself, now and under the problem's own limits.

        A call that never ends is waited for as long as the budget lasts; what is shown says how long.
        """
        return next(iter(self._try([case], group, whole=True)), None)

    def simplest(self, cases: Iterable[Case], group: Group, *, fair: bool = True) -> Finding | None:
        """The simplest of the cases that fails, also by itself; invalid cases are passed over.

        Where `fair` is asked for, the problem's own reference solution must get it right: these cases were
        not built by a recipe that minds how well its answer is conditioned.
        """
        fresh = {repr(case): case for case in cases if self.valid(case, group)}
        ordered = sorted(fresh.values(), key=measure)
        found = sorted(self._try(ordered, group), key=lambda finding: finding.measure)
        for finding in found[:MOST_LOSSES]:
            if fair and not self._fair(finding):
                continue
            confirmed = self.alone(finding.case, group)
            if confirmed is not None:
                return confirmed
        return None

    def _fair(self, finding: Finding) -> bool:
        box = self._judge_box()
        if box is None:
            return True
        target = self._target(finding.case, finding.group)
        ended = self._asked(box, [finding.case], [target], finding.group, self._limits(1, whole=True))
        return bool(ended) and ended[0] is None

    def _try(self, cases: Sequence[Case], group: Group, *, whole: bool = False) -> list[Finding]:
        """Those of the cases that fail with the verdict looked for."""
        targets = [self._target(case, group) for case in cases]
        failing: list[Finding] = []
        done = losses = 0
        most = 1 if self.verdict in LIMITED else MOST_LOSSES  # such a call costs much of the time there is
        while done < len(cases) and losses < most and (whole or not self.budget.spent):
            limits = self._limits(len(cases) - done, whole=whole)
            # A whole program that crashes does not tell where, so that its cases are tried one by one.
            one_by_one = self._verdict_of_a_run
            batch = cases[done : done + 1] if one_by_one else cases[done:]
            ended = self._asked(self._box, batch, targets[done:], group, limits)
            failing += [each for each in ended if each is not None and self._counts(each)]
            done += max(1, len(ended))
            losses += len(ended) < len(batch) or bool(ended and ended[-1] and ended[-1].verdict in LIMITED)
            self.budget.calls += max(1, len(ended))
        return failing

    def _counts(self, finding: Finding) -> bool:
        return finding.verdict is self.verdict and self._kind in (None, finding.kind)

    @property
    def _verdict_of_a_run(self) -> bool:
        return self._mode is Mode.PROGRAM and self.verdict is not Verdict.WA

    def _target(self, case: Case, group: Group) -> Target:
        key = (group.name, repr(case))
        if key not in self._targets:
            with blaming(self.problem, "the reference fails on a case"):
                self._targets[key] = self.problem.answer.target(self.module.reference(*case), group.tolerance)
        return self._targets[key]

    def _limits(self, cases: int, *, whole: bool) -> Limits:
        """What calls of so many cases may use; no more of a person's time than is left, unless `whole`."""
        cpu, wall, memory, output = astuple(self.problem.limits)
        if whole and self.verdict in LIMITED:
            patience = max(SHORT_SECONDS, round(self.budget.left, 1))
            cpu, wall = min(cpu, patience), min(wall, patience)
        elif not whole:
            short = SHORT_SECONDS + _QUICK_SECONDS * (0 if self.verdict is Verdict.TLE else cases)
            cpu = min(cpu, short)
            wall = min(wall, max(SHORT_SECONDS, min(2 * short, round(self.budget.left, 1))))
        return Limits(cpu, wall, memory, output, items=self.problem.answer.items)

    def _asked(
        self, box: Box, cases: Sequence[Case], targets: Sequence[Target], group: Group, limits: Limits
    ) -> list[Finding | None]:
        """How each of the cases that were reached came out; None where it is right."""
        ask = self._calls if self._mode is Mode.FUNCTION else self._program
        return ask(box, cases, targets, group, limits)

    def _calls(
        self, box: Box, cases: Sequence[Case], targets: Sequence[Target], group: Group, limits: Limits
    ) -> list[Finding | None]:
        ended: list[Finding | None] = []
        answer = self.problem.answer
        replies = box.call_many(self.problem.entry, self.problem.calls(cases), limits).replies
        for case, target, reply in zip(cases, targets, replies, strict=False):
            if reply.stop is not Stop.ANSWERED:
                wanted = answer.wanted(target)
                ended.append(self._stopped(case, group, VERDICTS[reply.stop], wanted, reply.detail))
                continue
            outcome = answer.check(reply.answer, target, self._exact(case, group))
            if isinstance(outcome, Rejection):
                way = _way(answer.right(target), answer.outline(reply.answer), outcome, coarse=self._coarse)
                ended.append(self._rejected(case, group, outcome, way, reply.answer))
            else:
                ended.append(None)
        return ended

    def _program(
        self, box: Box, cases: Sequence[Case], targets: Sequence[Target], group: Group, limits: Limits
    ) -> list[Finding | None]:
        answer = self.problem.answer
        result = box.run_program(render_group(self.problem, cases), limits)
        if result.stop is not Stop.ANSWERED:
            wanted, verdict = answer.line(targets[0]), VERDICTS[result.stop]
            return [self._stopped(case, group, verdict, wanted, result.detail) for case in cases[:1]]
        lines = answer_lines(result.stdout, complete=True)
        if len(cases) == 1:
            lines = [
                " ".join(lines)
            ]  # too many lines, or none, are read as one that says too much or nothing
        if len(lines) != len(cases):
            return []  # which case is to blame is not known
        ended: list[Finding | None] = []
        for case, target, line in zip(cases, targets, lines, strict=False):
            outcome = answer.check_line(line, target, self._exact(case, group))
            if isinstance(outcome, Rejection):
                way = _way(answer.right(target), answer.line_outline(line), outcome, coarse=self._coarse)
                read = answer.read_line(line)
                given = None if isinstance(read, str) else read[0]
                ended.append(self._rejected(case, group, outcome, way, given))
            else:
                ended.append(None)
        return ended

    def _exact(self, case: Case, group: Group) -> Callable[[], tuple[Exact, Tolerance]]:
        return lambda: (self.module.reference(*case), group.tolerance)

    def _rejected(
        self, case: Case, group: Group, outcome: Rejection, way: tuple[str, ...], given: Raw
    ) -> Finding:
        texts = outcome.wanted, outcome.got, outcome.message
        return Finding(case, group, measure(case), Verdict.WA, *texts, way, given)

    def _stopped(self, case: Case, group: Group, verdict: Verdict, wanted: str, detail: str) -> Finding:
        way = (detail.partition(":")[0],) if verdict is Verdict.RTE else ()
        return Finding(case, group, measure(case), verdict, wanted, "no answer", detail, way)


def _way(right: Outline, given: Outline, outcome: Rejection, *, coarse: bool) -> tuple[str, ...]:
    """In which way an answer is wrong: what is wanted and what is given, without their numbers."""
    wanted, got = sort_of(right), sort_of(given)
    if (
        got.rpartition(" ")[2].isdecimal() and got != wanted
    ):  # of a wanted 1 both 0 and 2 are the same mistake
        got = "another number"
    elif got == "zero":  # as wrong as any other
        got = "a number"
    if coarse:
        wanted, got = wanted.rstrip("-0123456789"), got.rstrip("-0123456789")
    return wanted, got, "off" if outcome.where else "other"


def sort_of(outline: Outline) -> str:
    """What an answer is: an int itself, how many items, whether it is a number, a word, none."""
    form, numbers = outline
    if form == "number":
        return "a number" if numbers[0] else "zero"
    if form in ("count", "type float"):
        return f"{numbers[0]:.0f}" if form == "count" else f"type float{numbers[:1]}"
    return " ".join(form.split()[:2])
