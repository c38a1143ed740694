"""What this machine has to offer to a cluster, and what it prepares before its first submission."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import msgspec

from judge.batch.model import Task
from judge.batch.standard import standard_of
from judge.batch.work import learn_task
from judge.cluster.greeting import Offer, offered
from judge.errors import UsageError
from judge.judging.containment import every_hidden_folder
from judge.judging.job import Terms
from judge.problem import Problem
from judge.sandbox import levels

_OPEN = "limits"  # the level that keeps nobody's files from a submission


def offer_here(problems: Sequence[Problem], level: str | None) -> Offer:
    """What this machine judges by. `level` is the only one to be used, where it is named.

    Raises:
        UsageError: that level cannot be had, or nothing better than limits and nobody has named that.
    """
    found = levels(every_hidden_folder())
    had = [each.name for each in found if each.available]
    if level is not None and level not in had:
        refused = next(each for each in found if each.name == level)
        raise UsageError(
            f"isolation {level} cannot be had here: {refused.why_not}", remedy=refused.remedy or None
        )
    if level is None:
        had = [name for name in had if name != _OPEN]
        if not had:
            what = "only isolation 'limits' can be had here: submissions could read this machine's files"
            remedies = "; ".join(dict.fromkeys(each.remedy for each in found if each.remedy))
            raise UsageError(
                what, remedy=f"{remedies or 'see judge doctor'}; or allow it by --isolation {_OPEN}"
            )
    return offered(problems, (level,) if level is not None else tuple(had))


def warm(problem: Problem, level: str, folders: Sequence[Path]) -> str:
    """Build the problem's data and learn its mistakes; why that failed, or nothing."""
    terms = Terms(isolation=level)
    standard = msgspec.json.encode(standard_of(problem, terms, level)).decode()
    names = tuple(str(folder) for folder in folders)
    return learn_task(Task(problem.id, "", b"", msgspec.json.encode(terms).decode(), standard, names))
