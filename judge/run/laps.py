"""A source on the same cases, again and again in one process, until that is long enough to be measured.

What a program in another language takes for a few hundred cases is less than the noise of its start, or
mostly the work of a compiler at run time. Its driver goes on to read cases until its input ends, so repeating
them is no more than a longer input; a program of a learner's gets them as more cases. A first pass, cold,
says something else than those that come after it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, NamedTuple, cast

from judge.problem import Case
from judge.run.program import render_group
from judge.run.runner import Replies, Runner
from judge.sandbox.boundary import Box, Limits, Reply, Stop, Usage

if TYPE_CHECKING:
    from judge.sandbox.native import NativeBox

MOST_INPUT = 24 << 20  # bytes of standard input: to read so many takes long enough by itself
_MOST_CALLS = 20_000  # of Python in a turn
_MORE_OUTPUT = 256  # bytes for each answer of each pass, or twice what the first pass took
_MOST_OUTPUT = 256 << 20  # bytes beyond what a single pass may write


class Repeat(NamedTuple):
    """One process on some passes over the cases; `usage` has the language's start in it.

    `answers` are the replies of one pass for each way in which it was answered: one where all passes answered
    alike. `trouble` is what kept the process from the end; "" where nothing did.
    """

    usage: Usage
    answers: tuple[Replies, ...] = ()
    trouble: str = ""


class Repeated:
    """One source on its cases: Python's own, whose start is never in its usage, and what is a run a case."""

    def __init__(self, runner: Runner, box: Box, cases: Sequence[Case]) -> None:
        self._runner, self._box, self._cases = runner, box, cases
        self._size = 0  # bytes that a pass wrote
        self.most = max(1, _MOST_CALLS // max(1, len(cases)))  # passes that there may be

    @property
    def start(self) -> float:
        """The CPU seconds that its language's start is known to take."""
        return 0.0

    def run(self, passes: int, limits: Limits) -> Repeat:
        """Run it on so many passes over the cases; 0 for its start alone."""
        if not passes:
            return Repeat(Usage())
        replies = self._runner.ask(self._box, list(self._cases) * passes, self._longer(limits, passes))
        once = replies._replace(replies=replies.replies[: len(self._cases)])
        self._size = len(str([reply.answer for reply in once.replies]))
        return Repeat(replies.usage, (once,), replies.trouble)

    def _longer(self, limits: Limits, passes: int) -> Limits:
        """Limits with room for the answers of so many passes."""
        more = passes * max(len(self._cases) * _MORE_OUTPUT, 2 * self._size)
        return limits._replace(output_bytes=limits.output_bytes + min(more, _MOST_OUTPUT))


def course(runner: Runner, box: Box, cases: Sequence[Case]) -> Repeated:
    """The source in `box` on these cases."""
    repeats = runner.language and (runner.calls or not runner.problem.formatted)
    return (_Foreign if repeats else Repeated)(runner, box, cases)


class _Foreign(Repeated):
    """A function that a driver calls, or a program."""

    def __init__(self, runner: Runner, box: Box, cases: Sequence[Case]) -> None:
        super().__init__(runner, box, cases)
        self._native = cast("NativeBox", box)
        if runner.calls:
            from judge.sandbox import calls  # only a run needs what is of this platform

            self._body = calls.text(runner.problem.calls(cases))
        else:
            _, _, self._body = render_group(runner.problem, cases).partition(b"\n")
        self.most = max(1, MOST_INPUT // max(1, len(self._body)))

    @property
    def start(self) -> float:
        """See `Repeated.start`."""
        return self._native.idle.cpu_seconds

    def run(self, passes: int, limits: Limits) -> Repeat:
        """See `Repeated.run`."""
        head = b"" if self._runner.calls else b"%d\n" % (len(self._cases) * passes)
        done = self._native.run_whole(head + self._body * passes, self._longer(limits, passes))
        if done.stop is not Stop.ANSWERED:
            return Repeat(done.usage, trouble=done.detail or done.stop.value)
        if not passes:
            return Repeat(done.usage)
        self._size = len(done.stdout) // passes
        once = done.stdout[: self._size]
        count = len(self._cases)
        if once.count(b"\n") == count and done.stdout == once * passes:  # as nearly always
            return Repeat(done.usage, (self._read(once),))
        lines = done.stdout.splitlines(keepends=True)
        if len(lines) != count * passes:
            return Repeat(done.usage, trouble="it answered no more")
        blocks = dict.fromkeys(b"".join(lines[at : at + count]) for at in range(0, len(lines), count))
        return Repeat(done.usage, tuple(map(self._read, blocks)))

    def _read(self, block: bytes) -> Replies:
        if self._runner.calls:
            from judge.sandbox import calls

            found, _ = calls.replies(block, len(self._cases))
        else:
            text = block.decode("ascii", errors="replace")
            found = [Reply(Stop.ANSWERED, line) for line in text.splitlines()]
        return Replies(found, Usage())


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
