"""What `judge run` adds to a submission that was not accepted: the smallest case that breaks it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click
from msgspec import Struct
from msgspec.structs import replace

from judge.cli.submissions import Submission
from judge.data import ProblemData
from judge.errors import told
from judge.report.screen import note
from judge.run import Reference, Result
from judge.run.result import Failure
from judge.run.runner import Runner
from judge.sandbox import Box, BoxFactory

if TYPE_CHECKING:
    from judge.diagnose import Counterexample
    from judge.diagnose.shrink import Choices

no_shrink_option = click.option(
    "--no-shrink", "unshrunk", is_flag=True, help="Do not search for the smallest failing case."
)
save_regression_option = click.option(
    "--save-regression",
    "regression",
    metavar="FILE",
    type=click.Path(path_type=Path, dir_okay=False),
    help="Write the smallest failing case as a pytest case; add to FILE if it holds such cases.",
)


class Diagnosis(Struct, frozen=True):
    """Shrinks failures, and keeps them as tests where that is asked for."""

    data: ProblemData
    open_box: BoxFactory
    regression: Path | None = None
    choices: Choices | None = None  # of fresh data, which know what they are built from

    def __call__(self, submission: Submission, result: Result, runner: Runner, box: Box) -> Result:
        """The result with its counterexample; a fault in the search is told and leaves the verdict alone."""
        if result.failure is None:
            return result
        try:
            found = self._search(result, result.failure, runner, box)
        except Exception as fault:
            note(f"no smaller case for {submission.name}: {told(fault)}")
            return result
        if self.regression is not None:
            self._save(submission, runner, found)
        return result if found is None else replace(result, counterexample=found.as_json())

    def _search(self, result: Result, failure: Failure, runner: Runner, box: Box) -> Counterexample | None:
        from judge.diagnose import shrink  # only after a wrong answer

        with Reference(self.data.problem, self.open_box) as reference:
            return shrink(
                self.data,
                box,
                runner,
                result.verdict,
                failure,
                reference=lambda: reference.open(runner),
                choices=self.choices,
            )

    def _save(self, submission: Submission, runner: Runner, found: Counterexample | None) -> None:
        from judge.diagnose.regression import add_case

        assert self.regression is not None
        if found is None or found.replay is None:
            text = f"{submission.name} fails on no case by itself; {self.regression} is as it was"
        elif not runner.calls:
            text = f"{submission.name} is a program, not a function; {self.regression} is as it was"
        else:
            target = Path(submission.name)
            added = add_case(self.regression, target, self.data, found)
            text = f"{self.regression} {'now holds' if added else 'already held'} {found.replay}"
        note(text)
