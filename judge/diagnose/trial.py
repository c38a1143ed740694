"""Trying cases on a submission, contained: which of them it gets wrong, in the way that it is known to fail.

Nothing is tried that breaks the bounds or the promise. A case that fails among others is called once more by
itself before it is believed: a function may keep something between its calls, or answer at random. A call
that was stopped, or ended otherwise than is looked for, is undecided: it neither fails nor passes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from enum import Enum
from itertools import islice
from typing import Any

from msgspec import Struct
from msgspec.structs import replace

from judge.data.build import target_of, validate
from judge.diagnose.budget import SHORT_SECONDS, SearchBudget
from judge.diagnose.simplicity import Simplicity, measure
from judge.errors import ProblemError
from judge.problem import Case, Group, Tolerance, Verdict
from judge.problem.declare import InvalidCase
from judge.problem.module import Module
from judge.run.printed import message_of, text_of
from judge.run.replies import VERDICTS, Breakdown
from judge.run.runner import Runner
from judge.sandbox.boundary import Box, Limits, Stop, Usage
from judge.values import outline
from judge.values.answers import Exact, Target, within
from judge.values.check import Rejection
from judge.values.outline import Outline
from judge.values.wire import Raw

MOST_LOSSES = 6  # calls of a batch that may take their process with them
_QUICK_SECONDS = 0.005  # CPU time a case is worth when nothing points to slowness
_PATIENCE = 1.0  # more seconds than an answer takes, for the case that is shown where a call may never end
_WAITING = 1.0  # seconds in which a machine that has much else to do goes on with a call
_BATCH = 100  # cases of one process
_SLOW = 0.5  # of those limits: a first call or an import that takes more is slow
_BUSY = 5  # times its CPU time, which a machine that has much else to do lets a process wait
_NOT_A_LINE = "no line, or more than one"
LIMITED = (Verdict.TLE, Verdict.MLE, Verdict.OLE)  # what a call has used, not what it said


class Finding(Struct, frozen=True):
    """A case that the submission gets wrong, under a group's tolerance."""

    case: Case
    group: Group
    measure: Simplicity
    verdict: Verdict
    expected: str
    got: str
    message: str
    kind: tuple[str, ...]  # in which way it fails: what is wanted and given, roughly
    given: Raw = None  # the answer itself, None where there is none
    printed: str = ""  # what the function printed, where it was called alone


class Outcome(Enum):
    """What a trial says of a case that is not known to fail."""

    PASSES = "passes"
    UNDECIDED = "undecided"


class Trial:
    """One submission in its box, and the verdict to look for."""

    def __init__(
        self,
        module: Module,
        box: Box,
        runner: Runner,
        verdict: Verdict,
        budget: SearchBudget,
        judge_box: Callable[[], Box | None] = lambda: None,
        *,
        coarse: bool = False,
    ) -> None:
        """`coarse` says that ints, words and lengths tell no two mistakes apart: there are many of them."""
        self.problem = runner.problem
        self.module = module
        self.verdict = verdict
        self.budget = budget
        self._box = box
        self._runner = runner
        self._judge_box = judge_box
        self._coarse = coarse
        self._known: dict[tuple[str, str], Finding | None] = {}
        self._answers: dict[str, Exact | InvalidCase] = {}
        self._targets: dict[tuple[str, str], Target] = {}
        self._right = set[tuple[str, str]]()  # cases that were called right, by group
        self._kind: tuple[str, ...] | None = None
        self._used = Usage()  # by the last process
        self._slow = Usage()  # what every process needs before its first answer, where that is much
        self._patience = runner.problem.limits.cpu_seconds  # until it is known what an answer takes

    def look_for(self, finding: Finding | None) -> None:
        """From now on only cases that fail in this way count: another mistake would explain nothing.

        None: any way.
        """
        self._kind = finding.kind if finding else None
        self._known.clear()

    def measure(self, case: Case) -> Simplicity:
        """How simple the case is."""
        return measure(case)

    def valid(self, case: Case, group: Group) -> bool:
        """Whether the case keeps the bounds and the promise, and has an answer.

        One on which the problem's own code fails is passed over: no group would hold it.
        """
        try:
            self._target(case, group)
        except (InvalidCase, ProblemError):
            return False
        return True

    def alone(self, case: Case, group: Group) -> Finding | None:
        """How the case fails when it is called by itself, within short limits; remembered."""
        key = (group.name, repr(case))
        if key not in self._known:
            self._known[key] = next(iter(self._try([case], group)), None)
        return self._known[key]

    def ask(self, case: Case, group: Group) -> Finding | Outcome:
        """What the case comes to when it is called by itself, now and under the problem's own limits.

        What an answer takes here, every process may take from now on: it may be the import, or a first call
        that builds a table. Once that is known, a call that never ends is waited for a second; what is shown
        says how long.
        """
        (ended,) = self._asked(self._box, [case], [self._target(case, group)], group, whole=True) or [None]
        if ended is None or ended.verdict not in LIMITED:
            cpu, waiting = self._used.cpu_seconds, self._used.waiting_seconds
            sleeps = waiting > max(_SLOW * _WAITING, _BUSY * cpu)
            cpu, waiting = cpu * (cpu > _SLOW * SHORT_SECONDS), waiting * sleeps
            self._slow = Usage(cpu, cpu + waiting)
            self._patience = _PATIENCE
            self.budget.slow(self.slow_seconds)
        if ended is None:
            return Outcome.PASSES
        return ended if self._counts(ended) else Outcome.UNDECIDED

    @property
    def slow_seconds(self) -> float:
        """What a process takes for a single call, where that is long; 0 for the usual."""
        return self._slow.wall_seconds

    def simplest(self, cases: Iterable[Case], group: Group, *, fair: bool = True) -> Finding | None:
        """The simplest of the cases that fails, also by itself; invalid cases are passed over.

        Where `fair` is asked for, the problem's own reference solution must get it right: these cases were
        not built by a recipe that minds how well its answer is conditioned.
        """
        ordered = sorted({repr(case): case for case in cases}.values(), key=self.measure)
        # An exact answer takes longer than a call, so none is sought before its batch.
        valid = (case for case in ordered if self.valid(case, group))
        while not self.budget.spent and (batch := list(islice(valid, _BATCH))):
            unknown = [case for case in batch if (group.name, repr(case)) not in self._right]
            for finding in self._try(unknown, group)[:MOST_LOSSES]:
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
        ended = self._asked(box, [finding.case], [target], finding.group, whole=True)
        return bool(ended) and ended == [None]

    def _try(self, cases: Sequence[Case], group: Group, *, whole: bool = False) -> list[Finding]:
        """Those of the cases that fail with the verdict looked for, in order.

        A single one is tried whatever the budget says.
        """
        targets = [self._target(case, group) for case in cases]
        failing: list[Finding] = []
        waiting = [(0, len(cases))] if cases else []
        losses = 0
        most = 1 if self.verdict in LIMITED else MOST_LOSSES  # such a call costs much of the time there is
        while waiting and losses < most and (len(cases) == 1 or not self.budget.spent):
            first, end = waiting.pop()
            ended = self._asked(self._box, cases[first:end], targets[first:end], group, whole=whole)
            if ended is None:  # a whole program that breaks down does not tell where
                middle = (first + end) // 2
                waiting += [(middle, end), (first, middle)]
                continue
            failing += [each for each in ended if each is not None and self._counts(each)]
            passed = zip(cases[first:end], ended, strict=False)
            self._right.update((group.name, repr(case)) for case, each in passed if each is None)
            stopped = len(ended) < end - first
            losses += stopped or bool(ended and ended[-1] and ended[-1].verdict in LIMITED)
            if stopped:
                waiting.append((first + max(1, len(ended)), end))
            if failing and self._verdict_of_a_run:
                break
        return failing

    def _counts(self, finding: Finding) -> bool:
        return finding.verdict is self.verdict and self._kind in (None, finding.kind)

    @property
    def _verdict_of_a_run(self) -> bool:
        return self.verdict is not Verdict.WA and not self._runner.tells_where

    def _answer(self, case: Case) -> Exact:
        """The case's exact answer, sought once: the search comes back to it. Raises as `validate`."""
        key = repr(case)
        if key not in self._answers:
            try:
                self._answers[key] = validate(self.problem, self.module, case)
            except InvalidCase as fault:
                self._answers[key] = fault
        if isinstance(self._answers[key], InvalidCase):
            raise self._answers[key]
        return self._answers[key]

    def _target(self, case: Case, group: Group) -> Target:
        key = (group.name, repr(case))
        if key not in self._targets:
            self._targets[key] = target_of(self.problem, self._answer(case), group.tolerance)
        return self._targets[key]

    def _limits(self, cases: int, *, whole: bool) -> Limits:
        """What calls of so many cases may use: the same on every machine."""
        usual, slow = self.problem.limits, self._slow
        cpu, waiting = usual.cpu_seconds, 1e9
        if not whole or self.verdict in LIMITED:
            quick = SHORT_SECONDS + _QUICK_SECONDS * (0 if self.verdict is Verdict.TLE else cases)
            cpu = min(cpu, 2 * slow.cpu_seconds + (self._patience if whole else quick))
            waiting = 2 * slow.waiting_seconds + _WAITING + cpu
        return Limits(
            cpu,
            usual.wall_seconds,
            usual.memory_bytes,
            usual.output_bytes,
            waiting,
            items=self.problem.answer.items,
        )

    def _asked(
        self, box: Box, cases: Sequence[Case], targets: Sequence[Target], group: Group, *, whole: bool
    ) -> list[Finding | None] | None:
        """How each of the cases that were reached came out: None where it is right.

        None in place of all where a run of several cases broke down, and it is not known at which.
        """
        limits = self._limits(len(cases), whole=whole)
        replies = self._runner.answers(box, cases, limits)
        self._used = replies.usage
        lost = {
            Stop.CPU: limits.cpu_seconds,
            Stop.WAITING: limits.waiting_seconds,
            Stop.WALL: limits.wall_seconds,
        }
        self.budget.asked(max(1, len(replies.replies)), lost.get(replies.stop, 0.0), replies.usage)
        if replies.breakdown is not None:
            if len(cases) > 1:
                return None
            return [self._broken_down(replies.breakdown, cases[0], targets[0], group)]
        ended: list[Finding | None] = []
        for case, target, reply in zip(cases, targets, replies.replies, strict=False):
            if reply.stop is not Stop.ANSWERED:
                ended.append(self._stopped(case, target, group, VERDICTS[reply.stop], reply.detail))
                continue
            outcome = self._runner.decide(reply.answer, target, self._exact(case, group))
            if isinstance(outcome, Rejection):
                ended.append(self._rejected(case, target, group, outcome, reply.answer))
            else:
                ended.append(None)
        printed = text_of(replies.printed) if len(cases) == 1 and any(ended) else ""
        return [_having_printed(each, printed) for each in ended] if printed else ended

    def _broken_down(self, breakdown: Breakdown, case: Case, target: Target, group: Group) -> Finding:
        """What a run on a single case that broke down says of it."""
        verdict, detail, got = breakdown.verdict, breakdown.detail, breakdown.got
        found = self._stopped(case, target, group, verdict, detail, got)
        return replace(found, kind=(_NOT_A_LINE,)) if verdict is Verdict.WA else found

    def _exact(self, case: Case, group: Group) -> Callable[[], tuple[Exact, Tolerance]]:
        return lambda: (within(self._answer(case), group.name), group.tolerance)

    def _rejected(self, case: Case, target: Target, group: Group, outcome: Rejection, answer: Any) -> Finding:
        way = _way(
            outline.right(self.problem.answer, target),
            self._runner.outline(answer),
            outcome,
            coarse=self._coarse,
        )
        texts = outcome.wanted, outcome.got, outcome.message
        return Finding(case, group, self.measure(case), Verdict.WA, *texts, way, self._runner.raw(answer))

    def _stopped(
        self,
        case: Case,
        target: Target,
        group: Group,
        verdict: Verdict,
        detail: str,
        got: str = "no answer",
    ) -> Finding:
        way = (detail.partition(":")[0],) if verdict is Verdict.RTE else ()
        wanted = self._runner.wanted(target)
        return Finding(case, group, self.measure(case), verdict, wanted, got, detail, way)


def _having_printed(finding: Finding | None, printed: str) -> Finding | None:
    if finding is None:
        return None
    message = message_of(finding.message, finding.got, printed)
    return replace(finding, printed=printed, message=message)


def _way(right: Outline, given: Outline, outcome: Rejection, *, coarse: bool) -> tuple[str, ...]:
    """In which way an answer is wrong: what is wanted and what is given, without their numbers."""
    wanted, got = sort_of(right), sort_of(given)
    if got.rpartition(" ")[2].isdecimal() and got != wanted:  # of a wanted 1, 0 and 2 are the same mistake
        got = "another number"
    elif got == "zero":  # as wrong as any other
        got = "a number"
    elif got.startswith("word ") and got != wanted:  # so is every other word
        got = "another word"
    if coarse:
        wanted, got = _roughly(wanted), _roughly(got)
    return wanted, got, "off" if outcome.where else "other"


def _roughly(sort: str) -> str:
    return "a word" if sort.startswith("word ") else sort.rstrip("-0123456789")


def sort_of(outline: Outline) -> str:
    """What an answer is: an int itself, how many items, whether it is a number, a word, none."""
    form, numbers = outline
    if form == "number":
        return "a number" if numbers[0] else "zero"
    if form in ("count", "type float"):
        return f"{numbers[0]:.0f}" if form == "count" else f"type float{numbers[:1]}"
    return " ".join(form.split()[:2])
