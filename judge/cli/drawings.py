"""From submissions to results that can be shown and drawn, each kept in the history."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from contextlib import AbstractContextManager

from judge.cli.picture import Drawing
from judge.cli.recording import Recording
from judge.cli.regression import save_regression
from judge.cli.submissions import Submission
from judge.cli.wish import Wish
from judge.judging.containment import Containment
from judge.judging.executors import executor
from judge.judging.session import Session
from judge.problem import Problem
from judge.report.progress import Advance, progress
from judge.report.screen import Notes
from judge.run.execute import judge_fault
from judge.run.result import Result


def drawings(
    problem: Problem, submissions: Sequence[Submission], wish: Wish, containment: Containment
) -> Generator[Drawing, None, None]:
    """Judge the submissions, of which the first has its box already; see `judge.cli.judging.judged`."""

    def judge(submission: Submission) -> Result:
        return session.judge(submission.source, submission.name)

    def lost(submission: Submission, why: str) -> Result:
        return judge_fault(problem.id, submission.name, why)

    done = wish.before

    def bars(label: str) -> AbstractContextManager[Advance | None]:
        return progress(f"{done + 1} of {wish.total}: {label}" if wish.total > 1 else label)

    said = Notes()
    session = Session(problem, wish.terms, containment, expected=len(submissions), bars=bars)
    with Recording(wish.db, wanted=wish.kept) as recording:
        recording.open()  # while the box boots
        said.say(session.notes)
        session.prepare()
        said.say(session.data.notes)
        results = executor(session.jobs).results(judge, submissions, lost)
        for submission, result in zip(submissions, results, strict=True):
            recording.add(submission, result)
            said.say(result.notes)
            if wish.regression is not None:
                said.say(save_regression(wish.regression, session.data, result))
            done += 1
            yield Drawing(problem, session.data, result)
