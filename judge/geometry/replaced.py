"""What a case's numbers are: points, directions and lengths, by the types and the names of its parameters."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

from judge.problem import Case, Problem
from judge.problem.declare import Change

_X = re.compile(r"[a-z]?x\d?")
_LENGTHS = re.compile(r"[rs]\d?")
_POINTS = ("point", "integer-point", "point3", "vec2", "vec3")
_WAYS = ("D", "dirs")
_CIRCLES, _RAYS = ("circle", "integer-circle"), ("ray", "integer-ray")
_ENDS = ("A", "B")


def replaced(problem: Problem, case: Case, change: Change) -> Case | None:
    """The case with every point, direction and length of it as `change(role, name, numbers)` makes it.

    The role is "point", "end" for a point that the line or the segment is given by, "way" or "length"; the
    two numbers of a point that are parameters of their own have the name of the first. None where there is
    no point in it.
    """
    names = [parameter.name for parameter in problem.parameters]
    made: list[Any] = []
    points = 0

    def pair(role: str, name: str, numbers: Sequence[Any]) -> tuple[Any, ...]:
        nonlocal points
        points += role in ("point", "end")
        return change(role, name, tuple(numbers))

    for at, (parameter, value) in enumerate(zip(problem.parameters, case, strict=True)):
        name, kind = parameter.name, parameter.type.text
        item = kind.strip("[]").partition(";")[0]
        several = value if kind.startswith("[") else (value,)
        if kind in ("number", "integer"):
            if _X.fullmatch(name) and names[at + 1 : at + 2] == [name.replace("x", "y")]:
                role = "end" if name[0].upper() in _ENDS else "point"
                made += pair(role, name, case[at : at + 2])
            elif len(made) == at:
                made += change("length", name, (value,)) if _LENGTHS.fullmatch(name) else (value,)
            continue
        found: list[Any] = [*several]
        for place, each in enumerate(several):
            own = f"{name}[{place}]" if kind.startswith("[") else name
            if item in _POINTS:
                role = "way" if name in _WAYS else "end" if name in _ENDS else "point"
                found[place] = pair(role, own, each)
            elif item in _CIRCLES:
                found[place] = (*pair("point", own, each[:2]), *change("length", own, each[2:]))
            elif item in _RAYS:
                found[place] = (pair("point", own, each[0]), change("way", own, tuple(each[1])))
        made.append(tuple(found) if kind.startswith("[") else found[0])
    return tuple(made) if points else None
