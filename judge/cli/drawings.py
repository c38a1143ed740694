"""From submissions to results that can be shown and drawn, each kept in the history."""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from contextlib import AbstractContextManager

from judge.cli.picture import Drawing
from judge.cli.recording import Recording
from judge.cli.regression import save_regression
from judge.cli.submissions import Submission
from judge.cli.wish import Wish
from judge.judging.containment import Containment
from judge.judging.executors import executor, results
from judge.judging.session import Session
from judge.problem import Problem
from judge.report.progress import Advance, progress
from judge.report.screen import Notes
from judge.run.execute import judge_fault
from judge.run.result import Result


def opened(problem: Problem, wish: Wish, containment: Containment, expected: int = 1) -> Session:
    """What judges the submissions to a problem, of which so many are expected."""
    return Session(problem, wish.terms, containment, expected=expected, bars=progress)


def one_by_one(problem: Problem, wish: Wish, containment: Containment) -> Callable[[Submission], Drawing]:
    """Judges one submission after another as they come, with all that they share."""
    session = opened(problem, wish, containment)

    def judged(submission: Submission) -> Drawing:
        (drawing,) = drawings(session, [submission], wish)
        return drawing

    return judged


def drawings(
    session: Session, submissions: Sequence[Submission], wish: Wish
) -> Generator[Drawing, None, None]:
    """Judge the submissions, of which the first has its box already; see `judge.cli.judging.judged`."""

    def judge(submission: Submission) -> Result:
        return session.judge(submission.source, submission.name)

    def lost(submission: Submission, why: str) -> Result:
        return judge_fault(session.problem.id, submission.name, why)

    def numbered(label: str) -> AbstractContextManager[Advance | None]:
        return progress(f"{done + 1} of {wish.total}: {label}")

    done = wish.before
    if wish.total > 1:
        session.bars = numbered
    said = Notes()
    with Recording(wish.db, wanted=wish.kept) as recording:
        recording.open()  # while the box boots
        said.say(session.notes)
        session.prepare()
        said.say(session.data.notes)
        judged = results(executor(session.jobs), judge, submissions, lost)
        for submission, result in zip(submissions, judged, strict=True):
            recording.add(submission, result)
            said.say(result.notes)
            if wish.regression is not None:
                said.say(save_regression(wish.regression, session.data, result))
            done += 1
            yield Drawing(session.problem, session.data, result)
