"""What the timing races: a submission and the reference solution, each in a box, on the same cases."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import takewhile
from typing import Any, NamedTuple

from judge.errors import JudgeError
from judge.reading import read_ordinary
from judge.run.budget import Budget
from judge.run.program import answer_lines, render_group
from judge.run.result import Mode
from judge.run.tally import VERDICTS, Tally
from judge.run.timing import Decision, race
from judge.sandbox import Box, BoxFactory, Limits, Stop, Usage
from judge.spec import Case, Problem, Verdict

MOST_CASES = 400  # in a turn; a sample of the groups' cases where there are more
_MORE_CPU_SECONDS = 1.0  # that a turn may take beyond twice what it took to judge all cases
_MORE_WALL_SECONDS = 4.0
_LONG_WAIT_SECONDS = 1.0  # of all its turns, before there is none after the first
_AGAIN = "when it was run again to be timed"


class Reference:
    """The solutions that set the time limit, each opened once in a box of its own and raced again and again.

    A context manager, its boxes end with it; one race at a time may use them.
    """

    def __init__(self, problem: Problem, box_factory: BoxFactory) -> None:
        self._problem = problem
        self._box_factory = box_factory
        self._boxes: dict[Mode, Box | None] = {}

    def __enter__(self) -> Reference:
        return self

    def __exit__(self, *exc: object) -> None:
        for box in self._boxes.values():
            if box is not None:
                box.__exit__(*exc)
        self._boxes.clear()

    def open(self, mode: Mode) -> Box | None:
        """The reference for submissions run in this way; None where the problem has none."""
        if mode not in self._boxes:
            source = self._source(mode)
            self._boxes[mode] = self._box_factory(*source) if source else None  # entered by its first use
        return self._boxes[mode]

    def _source(self, mode: Mode) -> tuple[bytes, str] | None:
        rule = self._problem.time
        name = None if rule is None else rule.function if mode is Mode.FUNCTION else rule.program
        if name is None:
            return None
        try:
            return read_ordinary(self._problem.solutions / "accepted" / name), name
        except OSError:  # an installed pack may come without solutions; `judge verify` tells of a wrong name
            return None


def measure(
    problem: Problem,
    mode: Mode,
    tallies: Sequence[Tally],
    submission: Box,
    reference: Box,
    budget: Budget,
) -> Decision:
    """Race the two on the cases of accepted groups, in one series of calls or one program a turn.

    The submission's answers are compared in every turn: one that answers otherwise than before, or not to
    the end, is no longer accepted, its tally says why, and there is no more racing. Nor is there for one
    that has kept the judge waiting.

    Raises:
        JudgeError: the reference does not come to the end of the cases.
    """
    assert problem.time is not None
    places = [(tally, index) for tally in tallies for index in range(len(tally.group.cases))]
    places = places[:: 1 + (len(places) - 1) // MOST_CASES]
    cases = [tally.group.cases[index] for tally, index in places]
    limits = _limits(problem, len(tallies))
    used = sum((tally.usage for tally in tallies), Usage())
    tighter = limits._replace(
        cpu_seconds=min(limits.cpu_seconds, 2 * used.cpu_seconds + _MORE_CPU_SECONDS),
        wall_seconds=min(limits.wall_seconds, 2 * used.wall_seconds + _MORE_WALL_SECONDS),
    )
    stdin = render_group(cases) if mode is Mode.PROGRAM else b""

    def turn(box: Box, within: Limits) -> _Turn:
        if mode is Mode.PROGRAM:
            return _program_turn(box, stdin, within)
        return _calls_turn(box, problem.entry, cases, within)

    taken = Usage()

    def mine() -> float | None:
        nonlocal taken
        done = turn(submission, budget.within(tighter))
        done = done._replace(detail=budget.told(done.stop, done.detail))
        taken += done.usage
        budget.spent(done.usage, done.stop)
        return done.usage.cpu_seconds if _as_before(done, mode, places) else None

    def theirs() -> float | None:
        done = turn(reference, limits)
        if done.stop is not Stop.ANSWERED:
            raise JudgeError(f"the reference solution cannot be timed: {done.detail}")
        return done.usage.cpu_seconds

    def goes_on() -> bool:
        # a busy machine lets it wait too, but hardly for more than twice as long as it works
        return taken.waiting_seconds <= _LONG_WAIT_SECONDS + 2 * taken.cpu_seconds

    decision = race(mine, theirs, problem.time.limit, goes_on)
    if any(tally.verdict is not Verdict.AC for tally in tallies):
        return Decision(decision.ratio)
    return decision


class _Turn(NamedTuple):
    """One run over all cases: its answers, or lines, as far as it came, and how it ended."""

    answers: Sequence[Any]
    stop: Stop
    detail: str
    usage: Usage


def _calls_turn(box: Box, entry: str, cases: Sequence[Case], limits: Limits) -> _Turn:
    replies, usage = box.call_many(entry, cases, limits)
    answers = [reply.answer for reply in takewhile(lambda reply: reply.stop is Stop.ANSWERED, replies)]
    stop, _, detail = replies[min(len(answers), len(replies) - 1)]
    return _Turn(answers, stop, detail, usage)


def _program_turn(box: Box, stdin: bytes, limits: Limits) -> _Turn:
    result = box.run_program(stdin, limits)
    lines = answer_lines(result.stdout, complete=result.stop is Stop.ANSWERED)
    return _Turn(lines, result.stop, result.detail, result.usage)


def _as_before(turn: _Turn, mode: Mode, places: Sequence[tuple[Tally, int]]) -> bool:
    """Whether all answers are accepted as when they were judged; the first that is not is recorded."""
    from judge.compare.check import Accepted, check
    from judge.compare.text import check_line

    compare: Callable[..., Any] = check_line if mode is Mode.PROGRAM else check
    for (tally, index), answer in zip(places, turn.answers, strict=False):
        kind, target = tally.problem.answer, tally.group.targets[index]
        outcome = compare(kind, answer, target, tally.exact(index))
        if not isinstance(outcome, Accepted):
            tally.unsteady(index, Verdict.WA, f"{outcome.message}, {_AGAIN}", outcome.got)
            return False
    if turn.stop is Stop.ANSWERED and len(turn.answers) == len(places):
        return True
    tally, index = places[min(len(turn.answers), len(places) - 1)]
    if turn.stop is Stop.ANSWERED:
        message = f"{len(turn.answers)} lines printed, {len(places)} wanted"
        tally.unsteady(index, Verdict.WA, f"{message}, {_AGAIN}")
    else:
        tally.unsteady(index, VERDICTS[turn.stop], f"{turn.detail}, {_AGAIN}")
    return False


def _limits(problem: Problem, groups: int) -> Limits:
    """The bounds of all groups together."""
    each = problem.limits
    return Limits(
        each.cpu_seconds * groups, each.wall_seconds * groups, each.memory_bytes, each.output_bytes * groups
    )
