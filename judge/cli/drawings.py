"""From submissions to results that can be shown and drawn, each kept in the history."""

from __future__ import annotations

from collections.abc import Generator, Iterator, Sequence
from contextlib import AbstractContextManager

from judge.cli.kept import Recording
from judge.cli.picture import Drawing
from judge.cli.submissions import Submission
from judge.cli.wish import Wish
from judge.judging.session import Session
from judge.report.screen import Notes
from judge.report.wait import Advance, progress
from judge.run.result import Result


def drawings(
    session: Session, submissions: Sequence[Submission], wish: Wish
) -> Generator[Drawing, None, None]:
    """Judge the submissions, of which a single one has its box already; see `judge.cli.judging.judged`."""

    def numbered(label: str) -> AbstractContextManager[Advance | None]:
        return progress(f"{done + 1} of {wish.total}: {label}")

    done = wish.before
    session.bars = numbered if wish.total > 1 else progress
    said = Notes()
    with Recording(wish.db, wanted=wish.kept) as recording:
        recording.open()  # while the box boots
        judged = _results(session, submissions, wish, said)
        said.say(session.data.notes)
        for submission, result in zip(submissions, judged, strict=True):
            recording.add(submission, result)
            said.say(result.notes)
            done += 1
            yield Drawing(session.problem, session.data, result, submission.source)


def _results(
    session: Session, submissions: Sequence[Submission], wish: Wish, said: Notes
) -> Iterator[Result]:
    """The results in order, once the data are there. Raises JudgeError."""
    jobs = min(wish.jobs, len(submissions))
    if jobs > 1:
        from judge.cli.several import judged_at_once  # most runs are of one file
        from judge.judging.pool import Processes

        pool = Processes(jobs)
        said.say([pool.short] if pool.short else [])
        return judged_at_once(session.problem, submissions, session.options, wish.had, pool)
    session.prepare()
    return (session.judge(each.source, each.name) for each in submissions)
