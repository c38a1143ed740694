"""How long right programs take, each as a multiple of the reference, all in one session."""

from __future__ import annotations

from collections.abc import Sequence

from judge.judging.job import Terms
from judge.judging.naming import Bars
from judge.judging.session import Session
from judge.problem import Problem, Verdict
from judge.run.result import Result

Program = tuple[str, bytes]  # a file's name and its source


def paces(problem: Problem, programs: Sequence[Program], bars: Bars) -> list[float | None]:
    """The median ratio of each program; None for one that is not accepted, or whose time says
    nothing: it was too short, or too noisy.

    Raises:
        UsageError: the isolation cannot be had.
        ProblemError: the data cannot be built.
    """
    terms = Terms(diagnosed=False, named=False)
    with Session(problem, terms, bars=bars) as session:
        session.boot(programs[0][1], programs[0][0])
        results = [session.judge(source, name) for name, source in programs]
    return [_believed(result) for result in results]


def _believed(result: Result) -> float | None:
    ratio = result.time.ratio
    if result.verdict is not Verdict.AC or ratio is None or ratio.unreliable:
        return None
    return ratio.median
