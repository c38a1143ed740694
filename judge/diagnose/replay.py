"""Replay ids: a case in a word that survives a shell, a chat and another machine.

    <problem>:<group>:v<values>:<check>

    values    `v0,0,1,-1,0,0,22361`: as a program reads them, in order; of a text all but letters, digits
              and `_.+~-` is percent-encoded
    check     six hex digits of the case's sha256, so that a slip of the pen is noticed

A decoded case is proved like any other before it is judged.
"""

from __future__ import annotations

import hashlib
import re
from typing import TYPE_CHECKING, NamedTuple
from urllib.parse import quote, unquote

from judge.data.build import validate
from judge.errors import UsageError
from judge.problem import Case, Group, Problem
from judge.problem.declare import InvalidCase
from judge.problem.module import Module
from judge.values import parameters
from judge.values.wire import cut

if TYPE_CHECKING:
    from judge.values.answers import Exact

_ID = re.compile(r"([\w-]+):([\w-]+):([vc])([^:\s]*):([0-9a-f]{6})", re.ASCII)
_BEGINS = re.compile(r"([\w-]+):[\w-]+:", re.ASCII)
LONGEST = 16_000  # characters of an id: a case of the longest integers has fewer


class Decoded(NamedTuple):
    """What a replay id stands for."""

    group: Group
    case: Case
    answer: Exact


def encode(problem: Problem, group: Group, case: Case) -> str:
    """The id of a case under that group's tolerance."""
    values = zip(problem.parameters, case, strict=True)
    tokens = (word for parameter, value in values for word in parameters.tokens(parameter.type, value))
    words = ",".join(quote(word, safe="+") for word in tokens)
    return f"{problem.id}:{group.name}:v{words}:{_check(case)}"


def has_form(word: str) -> bool:
    """Whether a word is written as an id is."""
    return bool(_ID.fullmatch(word))


def begun(word: str) -> str:
    """The problem that a word names as an id does, which may be damaged behind; nothing where it does not."""
    found = _BEGINS.match(word)
    return found[1] if found else ""


def problem_name(replay: str) -> str:
    """The problem that an id belongs to. Raises UsageError where it is no id."""
    return _parts(replay)[0]


def decode(replay: str, problem: Problem, module: Module) -> Decoded:
    """The group and the case of an id, proved, and its exact answer.

    Raises:
        UsageError: it is no id of this version of the problem.
        ProblemError: the problem's own code fails on the case.
    """
    _, name, form, payload, check = _parts(replay)
    if form != "v":
        raise _fault("it is of an older judge", "run the file again, which shows an id of today")
    group = problem.group(name)
    if group is None:
        raise _fault(f"{problem.id} has no group {name!r}", "it may be of another version")
    case = _from_values(payload, problem)
    if case is None or _check(case) != check:
        raise _fault("it does not fit its own check digits", "copy it whole; other versions have other ids")
    try:
        return Decoded(group, case, validate(problem, module, case))
    except InvalidCase as fault:
        remedy = "other versions have other ids"
        raise _fault(f"its case is not one of this kata's: {fault}", remedy) from None


def _parts(replay: str) -> tuple[str, str, str, str, str]:
    found = _ID.fullmatch(replay) if len(replay) <= LONGEST else None
    if found is None:
        raise UsageError(f"{cut(replay, 60)!r} is no replay id", remedy="copy the one that `judge run` shows")
    problem, group, form, payload, check = found.groups()
    return problem, group, form, payload, check


def _from_values(payload: str, problem: Problem) -> Case | None:
    words = map(unquote, payload.split(",") if payload else ())
    try:
        case = tuple([parameters.from_tokens(parameter.type, words) for parameter in problem.parameters])
    except (ValueError, StopIteration):
        return None
    return case if next(words, None) is None else None


def _check(case: Case) -> str:
    return hashlib.sha256(repr(case).encode()).hexdigest()[:6]


def _fault(what: str, remedy: str) -> UsageError:
    return UsageError(f"this replay id cannot be used: {what}", remedy=remedy)
