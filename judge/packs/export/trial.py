"""Which verdict a program gets where a package is judged: that of the first file that it fails."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from math import ceil

from msgspec import Struct

from judge.data.load import ProblemData
from judge.packs.export.cases import Test
from judge.packs.export.metadata import memory
from judge.problem import Verdict
from judge.run.program import answer_lines
from judge.run.replies import VERDICTS
from judge.sandbox.boundary import BoxFactory, Limits, ProgramResult, Stop
from judge.values.check import Accepted, check_line

SLOWEST = 5  # times the slowest accepted program: the time limit, as the legacy format has it
SURELY = 6  # times the time limit: a program that takes so long is too slow elsewhere too
PATIENCE = 20.0  # seconds of CPU for an accepted program and one file
_WALL = 4  # times the CPU seconds, and some


class Trial(Struct, frozen=True):
    """What came of it: `test` is the first that it fails, `seconds` the most CPU time of a file."""

    verdict: Verdict
    test: str | None = None
    seconds: float = 0.0


def time_limit(trials: Sequence[Trial]) -> int:
    """The package's time limit, in seconds, by the trials of the accepted programs."""
    return max(1, ceil(SLOWEST * max((each.seconds for each in trials), default=0.0)))


def tried(
    data: ProblemData,
    tests: Sequence[Test],
    source: bytes,
    name: str,
    boxes: BoxFactory,
    seconds: float = PATIENCE,
) -> Trial:
    """Run the program, contained, on one file after another until one fails; `seconds` of CPU for each.

    Raises JudgeError where nothing can be run.
    """
    limits = Limits(
        seconds, _WALL * seconds + 5, memory(data.problem) << 20, data.problem.limits.output_bytes
    )
    most = 0.0
    with boxes(source, name) as box:
        if box.inspect().fault:
            return Trial(Verdict.CE)
        for test in tests:
            result = box.run_program(test.input, limits)
            most = max(most, result.usage.cpu_seconds)
            verdict = _verdict(data, test, result)
            if verdict is not Verdict.AC:
                return Trial(verdict, test.stem, most)
    return Trial(Verdict.AC, None, most)


def _verdict(data: ProblemData, test: Test, result: ProgramResult) -> Verdict:
    """As a package has it: how a program ends goes before what it has printed."""
    if result.stop is not Stop.ANSWERED:
        return VERDICTS[result.stop]
    lines = answer_lines(result.stdout, complete=True)
    group = test.group
    if len(lines) != len(group.cases):
        return Verdict.WA
    answer = data.problem.answer
    for line, case, target in zip(lines, group.cases, group.targets, strict=True):
        if not isinstance(check_line(answer, line, target, partial(data.exact, case, group.group)), Accepted):
            return Verdict.WA
    return Verdict.AC
