"""What a program answered wrongly on a problem's data, as far as that is known."""

from __future__ import annotations

from collections.abc import Mapping

from msgspec import Struct

from judge.run.result import Result
from judge.values import Outline


class Answers(Struct, frozen=True):
    """What a program answered wrongly in one group, by case from 0; before `reached` all is known."""

    reached: int
    wrong: Mapping[int, Outline]


Behaviour = Mapping[str, Answers]  # by the group's name


def behaviour(result: Result) -> Behaviour:
    """What judging has found out about a program."""
    return {group.name: Answers(group.reached, group.wrong) for group in result.groups}
