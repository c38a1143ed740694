"""The outlines of the right answers, which wrong ones are held against."""

from __future__ import annotations

from collections.abc import Sequence

from judge.data.model import ProblemData
from judge.values import outline
from judge.values.outline import Outline


def right_outlines(data: ProblemData) -> dict[str, Sequence[Outline]]:
    """Those of every case, by the group's name."""
    answer = data.problem.answer
    return {
        each.group.name: [outline.right(answer, target) for target in each.targets] for each in data.groups
    }
