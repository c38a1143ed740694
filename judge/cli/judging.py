"""Judging submissions as a person has asked for it: the one way of `judge run` and `judge start`.

Containers are started as early as can be: most of what judging and showing need is imported while they boot.
"""

from __future__ import annotations

import os
from collections.abc import Generator, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING

from msgspec.structs import replace

from judge.cli.submissions import Submission
from judge.cli.wish import Wish
from judge.judging.session import Session
from judge.problem import Problem, Verdict
from judge.problem.load import load_problem, own_files

if TYPE_CHECKING:
    from judge.cli.picture import Drawing


def judged(problem: Problem, submissions: Sequence[Submission], wish: Wish) -> Generator[Drawing, None, None]:
    """Judge them; each result is in the history before it is handed out, so that none is shown and then lost.

    Close it, so that what was started for the rest ends. Raises JudgeError.
    """
    first = submissions[0]
    with Session(problem, wish.options, had=wish.had) as session:
        if min(wish.jobs, len(submissions)) == 1:
            session.boot(first.source, first.name)
        from judge.cli.drawings import drawings  # while it boots

        yield from drawings(session, submissions, wish)


class Sitting:
    """One problem whose submissions come one by one, such as the saves of a file: what can be kept between
    two of them is, the data and the reference's box. Close it, so that the box ends.
    """

    def __init__(self, problem: Problem, wish: Wish) -> None:
        self._problem = problem
        self._wish = wish
        self._session: Session | None = None
        self._seen: list[tuple[str, int, int]] = []

    def judged(self, submission: Submission) -> Drawing:
        """Judge it, and keep the result in the history. Raises JudgeError.

        Whatever is raised, and a verdict that says nothing of the submission, ends what was kept.
        """
        clean = False
        try:
            self._look_at_problem()
            if self._session is None:
                self._session = Session(self._problem, self._wish.options, had=self._wish.had)
            self._session.boot(submission.source, submission.name)
            from judge.cli.drawings import drawings  # while it boots

            (drawn,) = drawings(self._session, [submission], self._wish)
            if drawn.result.verdict is not Verdict.JE:  # that one was held nowhere
                self._wish = replace(self._wish, had=drawn.result.isolation or self._wish.had)
                clean = True
        finally:
            if not clean:
                self.close()
        return drawn

    def _look_at_problem(self) -> None:
        """A setter may be at work on the problem: then nothing is kept."""
        seen = []
        with suppress(OSError):  # whoever reads them says so
            for path in own_files(self._problem.folder):
                mark = os.stat(path)  # noqa: PTH116
                seen.append((path, mark.st_mtime_ns, mark.st_size))
        if seen != self._seen:
            self.close()
            if self._seen:
                self._problem = load_problem(self._problem.folder, self._problem.solutions)
            self._seen = seen

    def close(self) -> None:
        """End what was kept; judging goes on without."""
        session, self._session = self._session, None
        if session is not None:
            session.close()
