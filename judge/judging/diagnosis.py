"""What is added to a verdict: the smallest case that breaks a submission."""

from __future__ import annotations

from typing import TYPE_CHECKING

from msgspec.structs import replace

from judge.data.load import ProblemData
from judge.errors import told
from judge.run.reference import Reference
from judge.run.result import NOTHING, Behaviour, Failure, Result
from judge.run.runner import Runner
from judge.sandbox.boundary import Box, BoxFactory

if TYPE_CHECKING:
    from judge.diagnose.shrink import Choices


def diagnosed(
    result: Result,
    data: ProblemData,
    runner: Runner,
    box: Box,
    open_box: BoxFactory,
    does: Behaviour = NOTHING,
    choices: Choices | None = None,
) -> Result:
    """The result with its counterexample, if there is one; `box` holds the submission, which `does` that.

    `choices` say what fresh cases are built from. A fault in the search is a note and leaves the verdict
    alone.
    """
    if result.failure is None:
        return result
    try:
        found = _smallest(result, data, runner, box, open_box, choices)
    except Exception as fault:
        return result.noting(f"no smaller case for {result.submission}: {told(fault)}")
    if found is None:
        return result
    if found.replay is not None:
        found = runner.explained(found, does)
    return replace(result, counterexample=found)


def _smallest(
    result: Result,
    data: ProblemData,
    runner: Runner,
    box: Box,
    open_box: BoxFactory,
    choices: Choices | None,
) -> Failure | None:
    from judge.diagnose.shrink import shrink  # only after a wrong answer

    assert result.failure is not None
    rule = data.problem.time
    name = runner.reference(rule) if rule else None
    with Reference(data.problem, open_box) as reference:
        return shrink(
            data,
            box,
            runner,
            result.verdict,
            result.failure,
            reference=lambda: reference.open(name),
            choices=choices,
        )
