"""Program mode's lines: one line of output per case, read strictly and decided exactly.

count       0 | 1 | 2 | none
points      k x1 y1 …
parameter   t | none
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

from msgspec.structs import replace

from judge.compare.check import Exact, Outcome, Rejection, check
from judge.compare.decode import Fault, Written, decimal, shown
from judge.compare.targets import AnyTarget, CountTarget, ParameterTarget, PointsTarget
from judge.problem import AnswerKind

if TYPE_CHECKING:
    from judge.compare.answers import Answer

_INTEGER = re.compile(r"[+-]?[0-9]{1,400}", re.ASCII)
_FOREIGN = re.compile(r"[^\t -~]")
_MEANT = {
    AnswerKind.COUNT: "0, 1, 2 or none",
    AnswerKind.POINTS: "k x1 y1 …",
    AnswerKind.PARAMETER: "t or none",
}


class _UnreadableError(Exception):
    """A line that is no answer; its text says why."""


def check_line(kind: AnswerKind, line: str, target: AnyTarget, exact: Exact) -> Outcome:
    """Decide one line of output (without its newline, whatever it holds); see `check`."""
    answer = read_line(kind, line)
    if isinstance(answer, str):
        return Rejection(answer, render_target(target), shown(line)[1:-1])
    outcome = check(kind, answer[0], target, exact)
    if isinstance(outcome, Rejection):
        # The answers are shown as this mode writes them.
        message = outcome.message.replace("None", "none")
        return replace(outcome, message=message, wanted=render_target(target), got=shown(line)[1:-1])
    return outcome


def read_line(kind: AnswerKind, line: str) -> tuple[Any] | str:
    """The answer that a line holds, in a tuple of one, or why it holds none."""
    try:
        return (_parse(kind, line),)
    except _UnreadableError as why:
        return str(why)


def _parse(kind: AnswerKind, line: str) -> Any:
    tokens = _tokens(line)
    if not tokens:
        raise _UnreadableError(f"an empty line where {_MEANT[kind]} is meant")
    if kind is AnswerKind.POINTS:
        return _points(tokens)
    if len(tokens) > 1:
        raise _UnreadableError(f"{shown(tokens[1])} after the answer: one line holds {_MEANT[kind]}")
    token = tokens[0]
    if token == "none":
        return None
    if token.lower() in {"none", "null"}:
        raise _UnreadableError(f"{shown(token)} where {_MEANT[kind]} is meant: write none in lower case")
    return _integer(token, _MEANT[kind]) if kind is AnswerKind.COUNT else _number(token, _MEANT[kind])


def _tokens(line: str) -> list[str]:
    line = line.removesuffix("\r")
    foreign = _FOREIGN.search(line)
    if foreign:
        name = "a NUL" if foreign[0] == "\0" else f"the character {foreign[0]!a}"
        raise _UnreadableError(f"{name} in the output: answers are plain ASCII text")
    return line.split()


def _integer(token: str, meant: str) -> int:
    if not _INTEGER.fullmatch(token):
        raise _UnreadableError(f"{shown(token)} where {meant} is meant: write a plain integer")
    return int(token)


def _number(token: str, meant: str) -> Written:
    read = decimal(token)
    if isinstance(read, Fault):
        raise _UnreadableError(f"{read.text} where {meant} is meant: {read.remedy}")
    return read


def _points(tokens: list[str]) -> list[list[Written]]:
    if tokens[0].lower() == "none":
        raise _UnreadableError(f"{shown(tokens[0])} where k x1 y1 … is meant: no points are 0")
    count = _integer(tokens[0], "the number of points k")
    if not 0 <= count <= 2:
        raise _UnreadableError(f"k = {tokens[0][:20]}: a line and a circle have 0, 1 or 2 points in common")
    if len(tokens) != 1 + 2 * count:
        raise _UnreadableError(f"k = {count} needs {2 * count} coordinates, {len(tokens) - 1} given")
    numbers = [_number(token, "a coordinate") for token in tokens[1:]]
    return [numbers[2 * row : 2 * row + 2] for row in range(count)]


def render(kind: AnswerKind, answer: Answer | AnyTarget) -> str:
    """The line that a perfect program prints: correctly rounded doubles, as repr writes them.

    Takes an exact answer or its target; raises TypeError for one of another kind.
    """
    if kind is AnswerKind.COUNT and hasattr(answer, "value"):
        return "none" if answer.value is None else str(answer.value)
    if kind is AnswerKind.POINTS and hasattr(answer, "points"):
        points: Any = answer.points
        return " ".join([str(len(points)), *(_repr(number) for point in points for number in point)])
    if kind is AnswerKind.PARAMETER and hasattr(answer, "t"):
        return "none" if answer.t is None else _repr(answer.t)
    raise TypeError(f"a {type(answer).__name__} is no answer to a {kind.value} problem")


def render_target(target: AnyTarget) -> str:
    """`render` of a target, whatever its kind."""
    kinds = {
        CountTarget: AnswerKind.COUNT,
        PointsTarget: AnswerKind.POINTS,
        ParameterTarget: AnswerKind.PARAMETER,
    }
    return render(kinds[type(target)], target)


def _repr(value: Any) -> str:
    return repr(value[2] if isinstance(value, tuple) else float(value))
