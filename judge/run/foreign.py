"""The race of a submission in another language than Python, and what it is made of: passes over the cases.

It is held to the reference in its own language where there is one, else to Python's, generously. Both make as
many passes over the cases as take the reference a tenth of a second beyond its start, which is measured in
every turn and taken off; the submission makes fewer where that is long enough too. Times are given for the
reference's passes, so that they compare.

What a program in another language takes for a few hundred cases is less than the noise of its start, or
mostly the work of a compiler at run time. Its driver goes on to read cases until its input ends, so repeating
them is no more than a longer input; a program of a learner's gets them as more cases. A first pass, cold,
says something else than those that come after it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, NamedTuple, cast

from judge.errors import JudgeError
from judge.languages import NAME as PYTHON
from judge.problem import Case, TimeRule
from judge.run.group import GroupRun
from judge.run.groups import Judging
from judge.run.program import ProgramRunner, render_group
from judge.run.runner import Replies, Runner
from judge.run.settings import Reference
from judge.run.timing import CLEARLY_BELOW, Race, exactly
from judge.sandbox.boundary import Box, Limits, Reply, Stop, Usage

if TYPE_CHECKING:
    from judge.sandbox.native import NativeBox

LONG_SECONDS = 0.1  # of CPU time beyond the start, for the reference's turn
_LONG_ENOUGH_SECONDS = 0.5  # for the submission's
_COLD_SECONDS = 0.05  # of a first pass: what is less may be mostly the start's own noise
_NOISE_SECONDS = 0.005  # by which two starts of one language may differ
_CPU_SECONDS = 6.0  # that a turn may take at least
_PATIENCE = 4.0  # times the CPU time, by the clock
_READING = 2.0  # times Python's limit, for a program that is held to a function, which reads nothing
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


class Opponent(NamedTuple):
    """Whom it is raced against, and how; `limit` is in the rival's time, `why` is as in `Timing`."""

    box: Box
    runner: Runner
    limit: float
    why: str = ""


def rival_of(runner: Runner, rule: TimeRule, reference: Reference, limit: float) -> Opponent | None:
    """The reference for a submission in another language; None where there is none in Python either.

    `limit` is that of the groups, as a multiple of a reference's time.

    Raises JudgeError where the reference does not compile.
    """
    from judge.languages.model import language_called

    problem, language = runner.problem, language_called(runner.language)
    assert language is not None
    box = reference.open(rule.references.get(language.id)) if runner.calls else None
    if box is not None:
        if fault := box.inspect().fault:
            raise JudgeError(f"the reference solution in {language.name} does not compile: {fault.message}")
        if box.inspect().defines(problem.entry):
            return Opponent(box, Runner(problem, language.name), limit)
    limit *= language.factor
    what = "reference" if runner.calls else "reference program"
    why = f"no {what} in {language.name}: held to Python's"
    box = None if runner.calls else reference.open(rule.program)
    if box is not None:
        return Opponent(box, ProgramRunner(problem), limit, why)
    box = reference.open(rule.function)
    generous = limit if runner.calls else limit * _READING
    return None if box is None else Opponent(box, Runner(problem), generous, why)


class LongRace(Race):
    """A submission and its rival on the cases of some groups, turn by turn, in as many passes as it takes.

    A learner's program that ends badly on several passes, of which nobody told it, has single ones from then
    on. A function's answers are compared in every pass.
    """

    def __init__(self, judging: Judging, runs: Sequence[GroupRun], rival: Opponent) -> None:
        super().__init__(judging, runs, rival.box, rival.limit)
        self.language, self.why = rival.runner.language or PYTHON, rival.why
        self._mine = course(judging.runner, judging.box, self._cases)
        self._theirs = course(rival.runner, rival.box, self._cases)
        self._same = judging.runner.language == rival.runner.language
        self._start = 0.0  # CPU seconds that the rival's language takes to begin, in the turn of now
        self._cold = 0.0  # of the rival's first pass
        self._last = 0.0  # of the rival's latest turn
        self._ready: float | None = None  # that turn, where it was taken while the passes were counted
        self._near = CLEARLY_BELOW * rival.limit
        self._own_passes = 0  # of a turn of the submission; unknown before its first one
        most = min(self._mine.most, self._theirs.most)
        self._begin()
        self.passes, self._ready = passes_for(LONG_SECONDS, self._counted, most)
        self.cases *= self.passes

    def _counted(self, passes: int) -> float:
        took = self._rivals(passes)
        self._cold = took if passes == 1 else self._cold
        return took

    def _begin(self) -> None:
        """Measure the start of now where it is the start of both."""
        if self._same:
            self._start = self._theirs.run(0, self._limits).usage.cpu_seconds

    def _rivals(self, passes: int) -> float:
        cpu, wall = self._limits.cpu_seconds * passes, self._limits.wall_seconds * passes
        lap = self._theirs.run(passes, self._limits._replace(cpu_seconds=cpu, wall_seconds=wall))
        if lap.trouble:
            raise JudgeError(f"the reference solution in {self.language} cannot be timed: {lap.trouble}")
        self.theirs_took.append(lap.usage)
        self._last = max(0.0, lap.usage.cpu_seconds - self._start)
        return self._last

    def theirs(self) -> float | None:
        """The reference's turn. Raises JudgeError where it does not come to the end of the cases."""
        if self._ready is not None:
            took, self._ready = self._ready, None
            return took
        self._begin()
        return self._rivals(self.passes)

    def mine(self) -> float | None:
        """The submission's turn, as if it were as many passes; None where it is no longer accepted."""
        took = self._turn(self._own_passes) if self._own_passes else self._first_turn()
        return None if took is None else self._scaled(took, self._own_passes)

    def _first_turn(self) -> float | None:
        """A turn that is long enough, or of as many passes as the rival's.

        Who remembers answers makes only the first pass slowly: where that is near the limit by itself, first
        passes are what is raced.
        """
        passes, took = 1, self._turn(1)
        slow = took is not None and took >= _COLD_SECONDS and self._scaled(took, 1) > self._near * self._last
        while took is not None and not slow and not self._own_passes:
            if took >= _LONG_ENOUGH_SECONDS or passes >= self.passes:
                break
            expected = took * self.passes / passes
            more = more_passes(passes, took, _LONG_ENOUGH_SECONDS)
            passes = self.passes if expected <= 2 * _LONG_ENOUGH_SECONDS else min(self.passes, more)
            took = self._turn(passes)
        self._own_passes = self._own_passes or passes
        return took

    def _scaled(self, took: float, passes: int) -> float:
        """What so many passes come to beside the rival's, whose first one is cold as well."""
        if passes == 1 < self.passes:
            took = max(0.0, took - _NOISE_SECONDS)
        cold = max(self._cold, self._last / self.passes, 1e-9)
        later = max(0.0, self._last - cold) / max(1, self.passes - 1)
        return took * self._last / (cold + (passes - 1) * later)

    def _turn(self, passes: int) -> float | None:
        """CPU seconds of so many passes; of a single one, from then on, where it cannot make several."""
        budget = self._judging.budget
        lap = self._mine.run(passes, budget.within(self._within()))
        budget.booked(self._taking(Replies((), lap.usage)))
        alike = self._runner.calls or all(exactly(each) == self._accepted for each in lap.answers)
        if passes > 1 and (lap.trouble or not alike):
            self._own_passes = 1
            return self._turn(1)
        if lap.trouble:
            return self._plainly()
        if not all(self._as_before(each) for each in lap.answers):
            return None
        own = self._start if self._same else self._mine.start
        return max(0.0, lap.usage.cpu_seconds - own)

    def _plainly(self) -> float | None:
        """One pass as when it was judged, so that it is told what has become of which case."""
        replies = self._taking(self._judging.ask(self._cases, self._within()))
        return replies.usage.cpu_seconds if self._as_before(replies) else None

    def _within(self) -> Limits:
        cpu = max(self._limits.cpu_seconds, _CPU_SECONDS)
        wall = max(self._limits.wall_seconds, _PATIENCE * cpu)
        return self._limits._replace(cpu_seconds=cpu, wall_seconds=wall)
