"""Judging submissions as a person has asked for it: the one way of `judge run` and `judge watch`.

Containers are started as early as can be: most of what judging and showing need is imported while they boot.
"""

from __future__ import annotations

from collections.abc import Generator, Sequence
from typing import TYPE_CHECKING

from judge.cli.submissions import Submission
from judge.cli.wish import Wish
from judge.judging.containment import Containment
from judge.problem import Problem

if TYPE_CHECKING:
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
