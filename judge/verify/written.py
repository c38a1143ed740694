"""What a setter's own code promises: draws and types that come to the same when they are asked again."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import chain
from typing import Any

from judge.data import ProblemData
from judge.data.draw import Draw, Rejected, seeded
from judge.problem.model import EXAMPLES
from judge.values import parameters, show
from judge.values.atoms import Atom
from judge.verify.model import Fault

_TWICE = 5  # cases of a group that are drawn again
_OWN = re.compile(r"judge_type_(\w+)_[0-9a-f]+")  # the module of a pack's own type


def draws_twice(data: ProblemData) -> Iterator[Fault]:
    """The groups whose draw does not depend on its choices alone."""
    for each in data.groups:
        name, size = each.group.name, each.group.size
        if name == EXAMPLES or size is not None:
            continue
        for number in range(_TWICE):
            first, second = (_drawn(data, name, f"{name}/{number}") for _ in range(2))
            if first != second:
                where = f"{data.problem.id}/problem.py:{each.group.line}"
                what = f"group {name!r}: its draw is not the same twice"
                yield Fault(what, where, "take all choices from draw")
                break


def _drawn(data: ProblemData, group: str, seed: str) -> str:
    try:
        return repr(data.module.draws[group](Draw(seeded(seed))))
    except Rejected:
        return ""


def own_tokens(data: ProblemData) -> Iterator[Fault]:
    """The first value of each type of the pack's own that its token does not stand for."""
    told, problem = set[str](), data.problem
    for group in data.groups:
        for case, target in zip(group.cases, group.targets, strict=True):
            given = (
                parameters.leaves(p.type, value) for p, value in zip(problem.parameters, case, strict=True)
            )
            answer = parameters.leaves(problem.answer, show.best(problem.answer, target))
            for atom, value in chain(*given, answer):
                own = _OWN.fullmatch(type(atom).__module__)
                if own and own[1] not in told and (why := _unlike(atom, value)):
                    told.add(own[1])
                    remedy = "text_of writes a token without blanks, value_from reads it"
                    yield Fault(why, f"types/{own[1]}.py", remedy)


def _unlike(atom: Atom, value: Any) -> str:
    """What is wrong with the token of a value; nothing where it comes back."""
    token = atom.text_of(value)
    if len(token.split()) != 1:
        return f"the token {token!r} of {value!r} has a blank"
    try:
        again = atom.value_from(token)
    except ValueError as fault:
        return f"the token {token!r} of {value!r} is refused: {fault}"
    return "" if again == value else f"{value!r} comes back as {again!r}"
