"""A source on the same cases, again and again in one process, until that is long enough to be measured.

What a program in another language takes for a few hundred cases is less than the noise of its start, or
mostly the work of a compiler at run time. Its driver goes on to read cases until its input ends, so repeating
them is no more than a longer input; a program of a learner's gets them as more cases. A first pass, cold,
says something else than those that come after it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple, Protocol, cast

from judge.problem import Case
from judge.run.program import render_group
from judge.run.runner import Replies, Runner
from judge.sandbox.boundary import Box, Limits, ProgramResult, Reply, Stop, Usage

MOST_INPUT = 24 << 20  # bytes of standard input: to read so many takes long enough by itself
_MOST_CALLS = 20_000  # of Python in a turn
_MORE_OUTPUT = 256  # bytes for each answer of each pass, or twice what the first pass took
_MOST_OUTPUT = 256 << 20  # bytes beyond what a single pass may write


class Repeat(NamedTuple):
    """One process on so many passes over the cases; `usage` has the language's start in it.

    `answers` are the replies of one pass for each way in which it was answered: one where all passes answered
    alike. `trouble` is what kept the process from the end; "" where nothing did.
    """

    usage: Usage
    passes: int
    answers: tuple[Replies, ...] = ()
    trouble: str = ""


class Repeated(Protocol):
    """One source on its cases."""

    def run(self, passes: int, limits: Limits) -> Repeat:
        """Run it on so many passes over the cases; 0 for its start alone."""
        ...

    @property
    def most(self) -> int:
        """How many passes there may be."""
        ...

    @property
    def start(self) -> float:
        """The CPU seconds that its language's start is known to take."""
        ...


class _Whole(Protocol):
    @property
    def idle(self) -> Usage: ...
    def run_whole(self, stdin: bytes, limits: Limits) -> ProgramResult: ...


def course(runner: Runner, box: Box, cases: Sequence[Case]) -> Repeated:
    """The source in `box` on these cases."""
    repeats = runner.language and (runner.calls or not runner.problem.formatted)
    return _Foreign(runner, box, cases) if repeats else _Python(runner, box, cases)


class _Python:
    """Python's own, whose start is never in its usage; and what is a run for each case."""

    def __init__(self, runner: Runner, box: Box, cases: Sequence[Case]) -> None:
        self._runner, self._box, self._cases = runner, box, cases
        self._once: Sequence[Reply] = ()  # of a single pass

    @property
    def most(self) -> int:
        return max(1, _MOST_CALLS // max(1, len(self._cases)))

    @property
    def start(self) -> float:
        return 0.0

    def run(self, passes: int, limits: Limits) -> Repeat:
        if not passes:
            return Repeat(Usage(), 0)
        size = len(str([reply.answer for reply in self._once])) if passes > 1 else 0
        longer = _longer(limits, self._cases, passes, size)
        replies = self._runner.ask(self._box, list(self._cases) * passes, longer)
        once = replies._replace(replies=replies.replies[: len(self._cases)])
        self._once = once.replies
        return Repeat(replies.usage, passes, (once,), replies.trouble)


class _Foreign:
    """A function that a driver calls, or a program."""

    def __init__(self, runner: Runner, box: Box, cases: Sequence[Case]) -> None:
        self._runner, self._cases = runner, cases
        self._box = cast(_Whole, box)
        self._size = 0  # bytes that a pass wrote
        problem = runner.problem
        if runner.calls:
            from judge.sandbox import calls  # only a run needs what is of this platform

            self._head, self._body = b"", calls.text(problem.calls(cases))
        else:
            self._head, _, self._body = render_group(problem, cases).partition(b"\n")

    @property
    def most(self) -> int:
        return max(1, MOST_INPUT // max(1, len(self._body)))

    @property
    def start(self) -> float:
        return self._box.idle.cpu_seconds

    def run(self, passes: int, limits: Limits) -> Repeat:
        head = b"" if self._runner.calls else b"%d\n" % (len(self._cases) * passes)
        longer = _longer(limits, self._cases, passes, self._size)
        done = self._box.run_whole(head + self._body * passes, longer)
        if done.stop is not Stop.ANSWERED:
            return Repeat(done.usage, passes, trouble=done.detail or done.stop.value)
        if not passes:
            return Repeat(done.usage, 0)
        self._size = len(done.stdout) // passes
        once = done.stdout[: self._size]
        count = len(self._cases)
        if once.count(b"\n") == count and done.stdout == once * passes:  # as nearly always
            return Repeat(done.usage, passes, (self._read(once),))
        lines = done.stdout.splitlines(keepends=True)
        if len(lines) != count * passes:
            return Repeat(done.usage, passes, trouble="it answered no more")
        blocks = dict.fromkeys(b"".join(lines[at : at + count]) for at in range(0, len(lines), count))
        return Repeat(done.usage, passes, tuple(map(self._read, blocks)))

    def _read(self, block: bytes) -> Replies:
        if self._runner.calls:
            from judge.sandbox import calls

            found, _ = calls.replies(block, len(self._cases))
        else:
            text = block.decode("ascii", errors="replace")
            found = [Reply(Stop.ANSWERED, line) for line in text.splitlines()]
        return Replies(found, Usage())


def _longer(limits: Limits, cases: Sequence[Case], passes: int, size: int) -> Limits:
    """Limits with room for the answers of so many passes, of which one is known to write `size` bytes."""
    more = passes * max(len(cases) * _MORE_OUTPUT, 2 * size)
    return limits._replace(output_bytes=limits.output_bytes + min(more, _MOST_OUTPUT))


def passes_for(seconds: float, run: Callable[[int], float], most: int) -> tuple[int, float]:
    """How many passes take so many CPU seconds, at most `most`, and what they took.

    `run` gives the seconds of so many passes, without the start.
    """
    passes, took = 1, run(1)
    while took < seconds and passes < most:
        passes = min(most, more_passes(passes, took, seconds))
        took = run(passes)
    return passes, took


def more_passes(passes: int, took: float, seconds: float) -> int:
    """How many passes may well take so many seconds, where `passes` took fewer.

    What is too short to mean anything is taken for a sixtieth: nothing is ever divided by it.
    """
    return max(2 * passes, int(1.25 * passes * seconds / max(took, seconds / 60)) + 1)
