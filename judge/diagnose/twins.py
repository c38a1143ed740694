"""Known-wrong programs that answer exactly as a submission does, case by case.

`judge.diagnose.naming` weighs one group against the others, and no group counts for more than a hundred to
one: where a problem has only a few groups that can fail, nothing is ever likely enough. Such a problem's own
wrong programs, and whatever answers as one of them in every case, are recognised here.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from judge.diagnose.answers import Behaviour
from judge.diagnose.naming import Known, Match

ENOUGH = 6  # wrong answers that agree; evidence.py has cases that are much alike count for as many at most


def twins(submission: Behaviour, known: Sequence[Known]) -> list[int]:
    """The places of the programs that answer as the submission does, right or wrong, in all its groups."""
    return [place for place, each in enumerate(known) if _alike(submission, each.behaviour)]


def as_match(submission: Behaviour, places: Sequence[int], known: Sequence[Known]) -> Match | None:
    """The mistake that the twins make, if all make the same one and enough answers of it are wrong."""
    if len({known[place].name for place in places}) != 1 or wrong_answers(submission) < ENOUGH:
        return None
    return Match((places[0],), 1.0, 1 - 1 / (1 + wrong_answers(submission)))


def wrong_answers(submission: Behaviour) -> int:
    """In how many cases it is wrong."""
    return sum(len(answers.wrong) for answers in submission.values())


def _alike(submission: Behaviour, other: Mapping[str, object]) -> bool:
    return all(other.get(name) == answers for name, answers in submission.items())
