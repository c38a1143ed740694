"""What a wrong answer was, reduced to what tells one mistake from another: its form and its few numbers.

    count 1          an int where a count is asked for
    points x y …     a list of points, by their coordinates
    number t         a number where a parameter is asked for
    none             None
    type bool        a value of a wrong type
    shape 3 x …      a list of something else, by those of its items that are numbers
    text             a line of output that is no answer

A run that ended without an answer has the outlines of `judge.run.group`.
"""

from __future__ import annotations

from typing import Any

from judge.compare.decode import Fault, Given, Written, near, number
from judge.compare.text import read_line
from judge.problem import AnswerKind

Outline = tuple[str, tuple[float, ...]]

_NONE: Outline = ("none", ())
_LONGEST = 40  # characters of a foreign type's name that are kept


def outline(kind: AnswerKind, answer: Any) -> Outline:
    """The outline of an answer, JSON of any shape whatever; never raises for one."""
    if answer is None:
        return _NONE
    if kind is AnswerKind.POINTS and type(answer) in (list, tuple):
        return _points(answer)
    if type(answer) in (list, tuple):
        return _shape(answer)
    given = number(answer)
    if isinstance(given, Fault):
        return _wrong_type(answer)
    plain = _double(given)
    if kind is AnswerKind.COUNT:
        return ("count" if isinstance(given, int) else "type float", (plain,))
    return ("number", (plain,))


def line_outline(kind: AnswerKind, line: str) -> Outline:
    """The outline of one line of a program's output."""
    answer = read_line(kind, line)
    return ("text", ()) if isinstance(answer, str) else outline(kind, answer[0])


def _points(points: Any) -> Outline:
    numbers: list[float] = []
    for point in points[:3]:
        if type(point) not in (list, tuple) or len(point) != 2:
            return _shape(points)
        for coordinate in point:
            given = number(coordinate)
            if isinstance(given, Fault):
                return _wrong_type(coordinate)
            numbers.append(_double(given))
    return (f"points {len(points)}", tuple(numbers))


def _shape(items: Any) -> Outline:
    given = [number(item) for item in items[:4]]
    return (f"shape {len(items)}", tuple(_double(each) for each in given if not isinstance(each, Fault)))


def _wrong_type(answer: Any) -> Outline:
    if type(answer) is dict and type(answer.get("type")) is str:
        return (f"type {answer['type'][:_LONGEST]}", ())
    return (f"type {type(answer).__name__}", ())


def _double(given: Given) -> float:
    return given.approx if isinstance(given, Written) else near(given)
