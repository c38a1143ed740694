"""Trying cases on a submission, contained: which of them it gets wrong, in the way that it is known to fail.

Nothing is tried that breaks the bounds or the promise. A case that fails among others is called once more by
itself before it is believed: a function may keep something between its calls, or answer at random. A call
that was stopped, or ended otherwise than is looked for, is undecided: it neither fails nor passes.
"""

from __future__ import annotations

import time
from bisect import bisect_left
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from itertools import islice
from math import inf
from typing import NamedTuple

from msgspec import Struct
from msgspec.structs import replace

from judge.data.build import target_of, validate
from judge.diagnose.candidates import Simplicity, measure
from judge.errors import ProblemError
from judge.problem import Case, Group, Problem, Verdict
from judge.problem.declare import InvalidCase
from judge.problem.module import Module
from judge.run.printed import message_of, text_of
from judge.run.result import NO_ANSWER, Failure, short_answer
from judge.run.runner import VERDICTS, Runner
from judge.sandbox.boundary import Box, Limits, Reply, Stop, Usage
from judge.values import outline
from judge.values.answers import Exact, Target, within
from judge.values.check import Rejection
from judge.values.outline import Outline

_SHORT_SECONDS = 0.1  # of CPU time, after which a call that once ran out of time is not waited for
_SLOW_SECONDS = 4.0  # that the processes of a search may take where each is slow
_RUN_COSTS = 20  # calls that starting a process is worth
_RUNS_COST = 5  # processes that a program's run for each case is worth
_LOSS_COSTS = 5000  # calls that _SHORT_SECONDS of a call in vain are worth
_MOST_LOSSES = 6  # calls of a batch that may take their process with them
_QUICK_SECONDS = 0.005  # CPU time a case is worth when nothing points to slowness
_PATIENCE = 1.0  # more seconds than an answer takes, for the case that is shown where a call may never end
_WAITING = 1.0  # seconds in which a machine that has much else to do goes on with a call
_BATCH = 100  # cases of one process
_SLOW = 0.5  # of those limits: a first call or an import that takes more is slow
_NOT_A_LINE = "no line, or more than one"
LIMITED = (Verdict.TLE, Verdict.MLE, Verdict.OLE)  # what a call has used, not what it said


class SearchBudget:
    """What the search may cost, counted in calls, so that it comes to the same on every machine.

    `most` calls may be made; a process that is begun, and a call that is waited for in vain, count as so
    many. The seconds are for submissions whose every call takes long, and for machines that stand still:
    those of the CPU, the submission's own with the search's, and those of the clock.
    """

    def __init__(self, most: int = 60_000, *, cpu: float = 8.0, wall: float = 40.0) -> None:
        self.calls = 0
        self.cut_short = False  # whether the search wanted to go on when it was spent
        self._most = most
        self._cost = 0
        self._run_costs = _RUN_COSTS
        self._cpu_end = time.process_time() + cpu
        self._end = time.monotonic() + wall

    def slow(self, seconds: float) -> None:
        """From now on each process takes so long, whatever is called in it."""
        self._run_costs = _RUN_COSTS + round(self._most * seconds / _SLOW_SECONDS)

    def asked(self, calls: int, lost_seconds: float, usage: Usage, runs: int = 1) -> None:
        """Book so many processes: the calls made in them, the limit of the time that one used up."""
        self.calls += calls
        self._cost += calls + runs * self._run_costs + round(_LOSS_COSTS * lost_seconds / _SHORT_SECONDS)
        self._cpu_end -= usage.cpu_seconds

    def looked_at(self) -> None:
        """Book a case that was only looked at."""
        self._cost += 1

    @property
    def spent(self) -> bool:
        """Whether nothing more may be begun."""
        if self._cost >= self._most or time.process_time() >= self._cpu_end or time.monotonic() >= self._end:
            self.cut_short = True
        return self.cut_short


class FailingCase(Struct, frozen=True):
    """A case that the submission gets wrong, under a group's tolerance; the simpler one is the smaller.

    `failure_class` is in which way: what is wanted and given, roughly. What the function printed is in its
    `failure` where it was called alone.
    """

    case: Case
    group: Group
    failure_class: tuple[str, ...]
    failure: Failure

    @property
    def measure(self) -> Simplicity:
        """How simple the case is."""
        return measure(self.case)

    def __lt__(self, other: FailingCase) -> bool:
        return self.measure < other.measure


class TrialAnswer(NamedTuple):
    """What a trial says of a case: it passes, it fails, as `failing` says, or that is undecided."""

    ended: Verdict  # AC where it passes, JE where no call was made
    failing: FailingCase | None = None


_RIGHT = TrialAnswer(Verdict.AC)


class Trial(Struct):
    """One submission in its box, and the verdict to look for.

    `coarse` says that ints, words and lengths tell no two mistakes apart: there are many of them.
    """

    module: Module
    box: Box
    runner: Runner
    verdict: Verdict
    budget: SearchBudget
    reference: Callable[[], Box | None] = lambda: None
    coarse: bool = False
    _class: tuple[str, ...] | None = None  # in which way a case fails that counts; None: in any
    _alone: dict[tuple[str, str], FailingCase | None] = {}
    _wanted: dict[tuple[str, str], tuple[Exact, Target]] = {}
    _right: set[tuple[str, str]] = set()  # cases that were called right
    _used: Usage = Usage()  # by the last process
    _slow: Usage = Usage()  # what every process needs before its first answer, where that is much
    _patience: float = inf  # until it is known what an answer takes

    @property
    def problem(self) -> Problem:
        """Whose cases they are."""
        return self.runner.problem

    def look_for(self, failing: FailingCase | None) -> None:
        """From now on only cases that fail in this way count: another mistake would explain nothing.

        None: any way.
        """
        self._class = failing.failure_class if failing else None
        self._alone.clear()

    def valid(self, case: Case, group: Group) -> bool:
        """Whether the case keeps the bounds and the promise, and has an answer.

        One on which the problem's own code fails is passed over: no group would hold it.
        """
        with suppress(InvalidCase, ProblemError):
            return bool(self._answer(case, group))
        return False

    def alone(self, case: Case, group: Group) -> FailingCase | None:
        """How the case fails when it is called by itself, within short limits; remembered."""
        key = _key(case, group)
        if key not in self._alone:
            self._alone[key] = next(iter(self._failing([case], group)), None)
        return self._alone[key]

    def ask(self, case: Case, group: Group) -> TrialAnswer:
        """What the case comes to when it is called by itself, now and under the problem's own limits.

        What an answer takes here, every process may take from now on: it may be the import, or a first call
        that builds a table. Once that is known, a call that never ends is waited for a second; what is shown
        says how long.
        """
        (answer,) = self._run(self.box, [case], group, whole=True) or [TrialAnswer(Verdict.JE)]
        if answer.ended not in LIMITED:
            cpu, waiting = self._needed()
            if cpu or waiting:  # or the machine has stood still
                self._run(self.box, [case], group, whole=True)
                cpu, waiting = map(min, (cpu, waiting), self._needed())
            self._slow = Usage(cpu, cpu + waiting)
            self._patience = _PATIENCE
            self.budget.slow(self.slow_seconds)
        return answer

    def _needed(self) -> tuple[float, float]:
        """What the last process took of the CPU, and waited, each where that is much; else 0."""
        cpu, waiting = self._used.cpu_seconds, self._used.slept_seconds
        return cpu * (cpu > _SLOW * _SHORT_SECONDS), waiting * (waiting > _SLOW * _WAITING)

    def stopped_at(self, failing: FailingCase) -> int:
        """Which one of calls in a row did not come to its end, from 1; 0 where a message says it, or nothing.

        It is the last of the first calls with which the program ends as with all of them: one fewer, and it
        goes on.
        """
        *own, calls = failing.case

        def ends(count: int) -> bool:
            case = (*own, calls[:count])
            return self.valid(case, failing.group) and self.ask(case, failing.group).ended is self.verdict

        if self.verdict is Verdict.WA or ", in call " in failing.failure.message:
            return 0
        return bisect_left(range(len(calls)), True, key=ends)  # 0, too, where it ends in the constructor

    @property
    def slow_seconds(self) -> float:
        """What a process takes for a single call, where that is long; 0 for the usual."""
        return self._slow.wall_seconds

    def simplest(
        self, cases: Iterable[Case], group: Group, *, reference_agrees: bool = True
    ) -> FailingCase | None:
        """The simplest of the cases that fails, also by itself; invalid cases are passed over.

        Where `reference_agrees`, the problem's own reference solution must get it right: these cases were
        not built by a recipe that minds how well its answer is conditioned.
        """
        ordered = sorted({repr(case): case for case in cases}.values(), key=measure)
        # An exact answer takes longer than a call, so none is sought before its batch.
        valid = (case for case in ordered if self.valid(case, group))
        while not self.budget.spent and (batch := list(islice(valid, _BATCH))):
            unknown = [case for case in batch if _key(case, group) not in self._right]
            for failing in self._failing(unknown, group)[:_MOST_LOSSES]:
                agreed = not reference_agrees or self._reference_agrees(failing)
                if agreed and (confirmed := self.alone(failing.case, group)):
                    return confirmed
        return None

    def _reference_agrees(self, failing: FailingCase) -> bool:
        box = self.reference()
        return box is None or self._run(box, [failing.case], failing.group, whole=True) == [_RIGHT]

    def _failing(self, cases: Sequence[Case], group: Group) -> list[FailingCase]:
        """Those of the cases that fail as is looked for, in order; one alone is tried whatever it costs."""
        found: list[FailingCase] = []
        waiting = [cases] if cases else []
        losses = 0
        most = 1 if self.verdict in LIMITED else _MOST_LOSSES  # such a call costs much of the time there is
        while waiting and losses < most and (len(cases) == 1 or not self.budget.spent):
            part = waiting.pop()
            answers = self._run(self.box, part, group)
            if answers is None:  # a whole program that breaks down does not tell where
                waiting += [part[len(part) // 2 :], part[: len(part) // 2]]
                continue
            ended = zip(part, answers, strict=False)
            self._right.update(_key(case, group) for case, answer in ended if answer == _RIGHT)
            found += [each.failing for each in answers if each.failing]
            stopped = len(answers) < len(part)
            losses += stopped or (bool(answers) and answers[-1].ended in LIMITED)
            if stopped:
                waiting.append(part[max(1, len(answers)) :])
            if found and self.verdict is not Verdict.WA and not self.runner.calls:
                break
        return found

    def _answer(self, case: Case, group: Group) -> tuple[Exact, Target]:
        """The case's exact answer, and what others are held against; sought once. Raises as `validate`."""
        key = _key(case, group)
        if key not in self._wanted:
            exact = validate(self.problem, self.module, case)
            self._wanted[key] = exact, target_of(self.problem, exact, group.tolerance)
        return self._wanted[key]

    def _limits(self, cases: int, *, whole: bool) -> Limits:
        """What calls of so many cases may use: the same on every machine."""
        usual, slow = self.problem.limits, self._slow
        cpu, waiting = usual.cpu_seconds, 1e9
        if not whole or self.verdict in LIMITED:
            quick = _SHORT_SECONDS + _QUICK_SECONDS * (0 if self.verdict is Verdict.TLE else cases)
            cpu = min(cpu, 2 * slow.cpu_seconds + (self._patience if whole else quick))
            waiting = 2 * slow.waiting_seconds + _WAITING + cpu
        most = usual.wall_seconds, usual.memory_bytes, usual.output_bytes
        return Limits(cpu, *most, waiting, items=self.problem.answer.items)

    def _run(
        self, box: Box, cases: Sequence[Case], group: Group, *, whole: bool = False
    ) -> list[TrialAnswer] | None:
        """What came of each of the cases that were reached.

        None in place of all where a run of several cases broke down, and it is not known at which.
        """
        limits = self._limits(len(cases), whole=whole)
        replies = self.runner.ask(box, cases, limits)
        if replies.stop is Stop.WAITING and self.verdict not in LIMITED:  # the machine may have stood still
            replies = self.runner.ask(box, cases, limits)
        self._used = replies.usage + replies.imported
        cpu, waiting, wall = limits.cpu_seconds, limits.waiting_seconds, limits.wall_seconds
        lost = {Stop.CPU: cpu, Stop.WAITING: waiting, Stop.WALL: wall}
        made = max(1, len(replies.replies))
        runs = _RUNS_COST * made if self.problem.formatted and not self.runner.calls else 1
        self.budget.asked(made, lost.get(replies.stop, 0.0), replies.usage, runs)
        if replies.breakdown is not None:
            verdict, detail, _, got, _ = replies.breakdown
            return None if len(cases) > 1 else [self._stopped(cases[0], group, verdict, detail, got, "")]
        printed = text_of(replies.printed) if len(cases) == 1 else ""
        reached = zip(cases, replies.replies, strict=False)
        return [self._judged(case, group, reply, printed) for case, reply in reached]

    def _judged(self, case: Case, group: Group, reply: Reply, printed: str) -> TrialAnswer:
        given = reply.answer
        if reply.stop is not Stop.ANSWERED:
            return self._stopped(case, group, VERDICTS[reply.stop], reply.detail, NO_ANSWER, printed)
        exact, target = self._answer(case, group)
        outcome = self.runner.decide(given, target, lambda: (within(exact, group.name), group.tolerance))
        if not isinstance(outcome, Rejection):
            return _RIGHT
        right, got = outline.right(self.problem.answer, target), self.runner.outline(given)
        lengths = not self.coarse or self.problem.answer.measured  # whether these tell mistakes apart
        told = _failure_class(right, got, coarse=self.coarse, lengths=lengths)
        told += ("off" if outcome.where and lengths else "other",)
        failure = Failure(
            message_of(outcome.message, outcome.got, printed),
            expected=outcome.wanted,
            got=outcome.got,
            given=short_answer(self.runner.raw(given)),
            printed=printed,
        )
        return self._wrong(case, group, Verdict.WA, told, failure)

    def _stopped(
        self, case: Case, group: Group, verdict: Verdict, detail: str, got: str, printed: str
    ) -> TrialAnswer:
        told = {Verdict.RTE: (detail.partition(":")[0],), Verdict.WA: (_NOT_A_LINE,)}.get(verdict, ())
        wanted = self.runner.wanted(self._answer(case, group)[1])
        failure = Failure(detail, expected=wanted, got=got, printed=printed)
        return self._wrong(case, group, verdict, told, failure)

    def _wrong(
        self, case: Case, group: Group, verdict: Verdict, told: tuple[str, ...], failure: Failure
    ) -> TrialAnswer:
        if verdict is not self.verdict or self._class not in (None, told):
            return TrialAnswer(verdict)
        failure = replace(failure, group=group.name, input=self.problem.named(case))
        return TrialAnswer(verdict, FailingCase(case, group, told, failure))


def _key(case: Case, group: Group) -> tuple[str, str]:
    """What a case is remembered by; 1 and 1.0 are two."""
    return group.name, repr(case)


def _failure_class(right: Outline, given: Outline, *, coarse: bool, lengths: bool) -> tuple[str, ...]:
    """In which way an answer is wrong: what is wanted and what is given, without their numbers."""
    wanted, got = answer_class(right), answer_class(given)
    number = got.rpartition(" ")[2] if lengths else got
    if number.isdecimal() and got != wanted:  # of a wanted 1, 0 and 2 are the same mistake
        got = "another number"
    elif got == "zero":  # as wrong as any other
        got = "a number"
    elif got.startswith("word ") and got != wanted:  # so is every other word
        got = "another word"
    if not coarse:
        return wanted, got
    return tuple(
        "a word" if each.startswith("word ") else each.rstrip("-0123456789") for each in (wanted, got)
    )


def answer_class(answer: Outline) -> str:
    """What an answer is: an int itself, how many items, whether it is a number, a word, a text, none."""
    form, numbers = answer
    if form.startswith("return "):  # what calls in a row returned
        return "answers"
    if form.startswith(f"{outline.TEXT} "):  # each of which is a mistake's as well as any other
        return "a text"
    if form == "number":
        return "a number" if numbers[0] else "zero"
    if form in ("count", "type float"):
        return f"{numbers[0]:.0f}" if form == "count" else f"type float{numbers[:1]}"
    return " ".join(form.split()[:2]).rstrip(",)")
