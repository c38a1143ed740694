"""Groups whose cases follow one another: each differs from the one before in a single parameter.

A program that keeps something between calls, by a key that leaves a parameter out, is met by such cases. The
parameter is the next one in turn; its new value is that of a case which the builder makes, and the exact
answer is to be another one.
"""

from __future__ import annotations

from judge.problem import Case, Group

_ROUNDS = 2  # of all parameters, until a case stands for itself again
_CONTENT = 100  # attempts after which a neighbour may have the same answer


def follows(group: Group, number: int, parameters: int) -> int | None:
    """The place of the parameter in which case `number` (from 1) of the group differs from the one before;
    None where it stands for itself.
    """
    if not group.neighbours:
        return None
    place = (number - 1) % (_ROUNDS * parameters + 1)
    return (place - 1) % parameters if place else None


def neighbour(prior: Case, made: Case, place: int) -> Case:
    """The case before, with that parameter's value from a case that the builder made."""
    return (*prior[:place], made[place], *prior[place + 1 :])


def may_agree(attempt: int) -> bool:
    """Whether so many attempts show that no neighbour has another answer, as where nothing changes it."""
    return attempt >= _CONTENT
