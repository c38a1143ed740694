"""Quadratic equations a·t² + 2·b·t + c = 0 with numbers that doubles hold.

QUADRATIC     the topic of problems with the arguments (a, b, c)
recipes.py    test cases: coefficients that have one property each
decisions.py  how far a case is from where its answer turns, or its digits are lost
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from judge.problem.topic import Topic

if TYPE_CHECKING:
    from judge.problem import Problem
    from judge.problem.topic import Decision

__all__ = ["QUADRATIC"]


def _decisions(_problem: Problem) -> tuple[Decision, ...]:
    from judge.topics.quadratics.decisions import DECISIONS  # late: only a setter asks

    return DECISIONS


QUADRATIC = Topic(decisions=_decisions)
