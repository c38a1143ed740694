"""From submissions to results that can be shown and drawn, each kept in the history."""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from contextlib import AbstractContextManager, suppress
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

from msgspec import Struct

from judge.cli.files import OutFile, Submission
from judge.cli.judging import Wish, judged_at_once
from judge.cli.resolve import history_at
from judge.data.load import ProblemData
from judge.errors import StoreError, told
from judge.judging.session import Session
from judge.problem import Problem
from judge.report.screen import Notes, Screen, note
from judge.report.wait import Advance, progress
from judge.run.result import Result

if TYPE_CHECKING:
    from rich.text import Text

    from judge.drawing import Picture
    from judge.drawing.chart import Chart


def drawings(
    session: Session, submissions: Sequence[Submission], wish: Wish
) -> Generator[Drawing, None, None]:
    """Judge the submissions, of which a single one has its box already; see `judge.cli.judging.judged`."""

    def numbered(label: str) -> AbstractContextManager[Advance | None]:
        return progress(f"{done + 1} of {wish.total}: {label}")

    done, said, problem = wish.before, Notes(), session.problem
    session.bars = numbered if wish.total > 1 else progress
    if keeps := wish.kept:
        with suppress(StoreError):  # which is said with the first result
            import_module("judge.practice.history")  # while the box boots
    if (jobs := min(wish.jobs, len(submissions))) > 1:
        results, short = judged_at_once(problem, submissions, session.options, jobs)
        said.say(short)
    else:
        session.prepare()
        results = (session.judge(each.source, each.name) for each in submissions)
    said.say(session.data.notes)
    for submission, result in zip(submissions, results, strict=True):
        # Before it is shown: whoever has seen it finds it there, even if the judge is killed at that moment.
        keeps = keeps and _kept(result, submission, wish.db)
        said.say(result.notes)
        done += 1
        yield Drawing(problem, session.data, result, submission.source)


def _kept(result: Result, submission: Submission, db: Path | None) -> bool:
    """Keep the result in the history; where that fails it is said, and exit status and verdicts stay.

    A commit hands it to the system, which outlives the judge (see `judge.database`).
    """
    try:
        from judge.practice.history import run_of

        with history_at(db) as history:
            history.keep(run_of(result, submission.source, _absolute(submission.name)), submission.source)
    except Exception as fault:
        note(f"not kept in the history: {told(fault)}")
        return False
    return True


def _absolute(name: str) -> str:
    """The file from the root, or nothing where there will be no such file tomorrow: a pipe."""
    path = Path(name)
    try:
        return str(path.absolute()) if path.is_file() else ""
    except OSError:  # the current folder is gone
        return ""


class Drawing(Struct, frozen=True):
    """A result and what its picture is drawn from; nothing is computed until it is asked for.

    Where no small case failed and the time has grown with n, how it has is drawn instead.
    """

    problem: Problem
    data: ProblemData
    result: Result
    source: bytes = b""

    def rows(self, screen: Screen) -> Callable[[int], Sequence[Text]] | None:
        """What draws it in so many rows; None where there is nothing to draw, or no room."""
        found = self.result
        if found.hurdle or (found.failure is None and found.time.growth is None):
            return None
        from judge.report.picture import drawing

        return drawing(self.picture, screen, "the failing case")

    def picture(self) -> Picture | Chart | None:
        """The smallest case found that fails, or else the first one; None where there is nothing to draw."""
        from judge.report.picture import case_picture, growth_chart

        failure, small, growth = self.result.failure, self.result.counterexample, self.result.time.growth
        if growth is not None and (failure is None or failure.input is None):
            return growth_chart(growth)
        if failure is None:
            return None
        shown, heading = failure, f"{failure.group}, case {failure.case}"
        if small is not None and small.input:
            shown, heading = small, "counterexample"
        return case_picture(self.problem, self.data.module, shown, failure.group, heading)

    def save(self, target: OutFile) -> None:
        """Write the SVG, if one was asked for. Raises UsageError where that cannot be done."""
        if target.path is None:
            return
        from judge.drawing import Picture
        from judge.drawing.chart import chart_svg
        from judge.drawing.svg import to_svg

        picture = self.picture()
        if picture is None:
            note(f"nothing to draw, {target.path} is not written: no case failed that can be drawn")
            return
        drawn = to_svg(picture) if isinstance(picture, Picture) else chart_svg(picture, alone=True)
        target.write(drawn.encode())
