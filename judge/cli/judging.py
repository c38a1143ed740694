"""Judging submissions as a person has asked for it: the one way of `judge run` and `judge watch`.

Containers are started as early as can be: most of what judging and showing need is imported while they boot.
"""

from __future__ import annotations

from collections.abc import Generator, Sequence
from contextlib import closing, nullcontext
from typing import TYPE_CHECKING

from msgspec.structs import replace

from judge.cli.submissions import Submission, Unjudged
from judge.cli.wish import Wish
from judge.errors import JudgeError, UsageError
from judge.judging.containment import Containment
from judge.problem import Problem

if TYPE_CHECKING:
    from judge.cli.fitting import Task
    from judge.cli.outputs import Outputs
    from judge.cli.picture import Drawing


def judged(problem: Problem, submissions: Sequence[Submission], wish: Wish) -> Generator[Drawing, None, None]:
    """Judge them; each result is in the history before it is handed out, so that none is shown and then lost.

    Close it, so that what was started for the rest ends. Raises JudgeError.
    """
    first, terms = submissions[0], wish.terms
    jobs = min(wish.jobs, len(submissions) * len(terms.chosen(problem)))
    with Containment(problem, terms.isolation, jobs, wish.had) as containment:
        containment.boot(first.source, first.name)
        from judge.cli.drawings import drawings  # while it boots

        yield from drawings(problem, submissions, wish, containment)


def all_judged(
    tasks: Sequence[Task], wish: Wish, show: Outputs, *, silent: bool
) -> Generator[Drawing, None, None]:
    """Judge all tasks, one problem after another.

    Of several tasks, one whose problem fails costs its own submissions only. A bar counts them where several
    are judged at once and the results are `silent`: else these tell how far it is.
    """
    from judge.report.progress import progress

    counted = silent and wish.jobs > 1 and wish.total > 1
    with progress("judging") if counted else nullcontext() as advance:
        done = 0
        for task in tasks:
            begun = done
            try:
                with closing(judged(task.problem, task.submissions, replace(wish, before=done))) as drawings:
                    for drawing in drawings:
                        yield drawing
                        done += 1
                        if advance:
                            advance(done, wish.total)
            except JudgeError as fault:
                if isinstance(fault, UsageError) or len(tasks) == 1:
                    raise
                for submission in task.submissions[done - begun :]:
                    show.unjudged(Unjudged(submission.name, str(fault), task.problem.id), submission.source)
                    done += 1
