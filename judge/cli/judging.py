"""Judging submissions as a person has asked for it: the one way of `judge run` and `judge start`.

Containers are started as early as can be: most of what judging and showing need is imported while they boot.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Generator, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING

from msgspec.structs import replace

from judge.cli.submissions import Submission
from judge.cli.wish import Wish
from judge.judging.containment import Containment
from judge.problem import Problem, Verdict
from judge.problem.load import load_problem, own_files

if TYPE_CHECKING:
    from judge.cli.picture import Drawing


def judged(problem: Problem, submissions: Sequence[Submission], wish: Wish) -> Generator[Drawing, None, None]:
    """Judge them; each result is in the history before it is handed out, so that none is shown and then lost.

    Close it, so that what was started for the rest ends. Raises JudgeError.
    """
    first, options = submissions[0], wish.options
    with Containment(problem, options.isolation, had=wish.had, program=options.program) as containment:
        if min(wish.jobs, len(submissions)) == 1:
            containment.boot(first.source, first.name)
        from judge.cli.drawings import drawings, opened  # while it boots

        yield from drawings(opened(problem, wish, containment), submissions, wish)


class Sitting:
    """One problem whose submissions come one by one, such as the saves of a file: what can be kept between
    two of them is, the data and the reference's box. Close it, so that the box ends.
    """

    def __init__(self, problem: Problem, wish: Wish) -> None:
        self._problem = problem
        self._wish = wish
        self._containment: Containment | None = None
        self._judge: Callable[[Submission], Drawing] | None = None
        self._seen: list[tuple[str, int, int]] = []

    def judged(self, submission: Submission) -> Drawing:
        """Judge it, and keep the result in the history. Raises JudgeError.

        Whatever is raised, and a verdict that says nothing of the submission, ends what was kept.
        """
        clean = False
        try:
            self._look_at_problem()
            if self._containment is None:
                self._containment = Containment(
                    self._problem, self._wish.options.isolation, had=self._wish.had
                )
            self._containment.boot(submission.source, submission.name)
            from judge.cli.drawings import one_by_one  # while it boots

            if self._judge is None:
                self._judge = one_by_one(self._problem, self._wish, self._containment)
            drawn = self._judge(submission)
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
        containment, self._containment, self._judge = self._containment, None, None
        if containment is not None:
            containment.close()
