"""Deciding one answer: accepted, or rejected with what was wanted, what was given and how far off it is."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from math import inf, nextafter
from sys import float_info
from typing import TYPE_CHECKING, Any

from msgspec import Struct

from judge.compare.decode import Fault, Given, Written, fault, near, number, show
from judge.compare.targets import AnyTarget, CountTarget, ParameterTarget, PointsTarget, Target
from judge.problem import AnswerKind, Tolerance

if TYPE_CHECKING:
    from judge.compare.answers import Answer
    from judge.exact import Surd

Exact = Callable[[], "tuple[Answer, Tolerance]"]


class Accepted(Struct, frozen=True):
    """The answer is right; `worst_ulps` is the largest error of its numbers, in ulps of the exact ones.

    None where the answer has no measured number; an exact 0, which has no scale of its own, adds nothing.
    """

    worst_ulps: float | None = None


class Rejection(Struct, frozen=True):
    """The answer is wrong, and why, for a person.

    `wanted` and `got` are whole answers. Where one number decided, `where` names it ("y of point 2") and its
    errors are given: absolute, relative to the exact number (None where that is 0), and in its ulps.
    """

    message: str
    wanted: str
    got: str
    where: str = ""
    absolute: float | None = None
    relative: float | None = None
    ulps: float | None = None


Outcome = Accepted | Rejection
_UNMEASURED = Accepted()
_POINTS = AnswerKind.POINTS  # looking it up in the enumeration costs as much as a comparison


def check(kind: AnswerKind, answer: Any, target: AnyTarget, exact: Exact) -> Outcome:
    """Decide `answer`, JSON of any shape whatever, as `judge.sandbox.encode` writes it; never raises for one.

    `exact` gives the case's exact answer and tolerance; it is asked only where a number that is no double
    lies between an end of the interval and the next double. Raises TypeError for a target of another kind.
    """
    if kind is _POINTS and isinstance(target, PointsTarget):
        return _check_points(answer, target, exact)
    if kind is AnswerKind.COUNT and isinstance(target, CountTarget):
        return _check_count(answer, target)
    if kind is AnswerKind.PARAMETER and isinstance(target, ParameterTarget):
        return _check_parameter(answer, target, exact)
    raise TypeError(f"a {kind.value} is not judged by a {type(target).__name__}")


def wanted_text(target: AnyTarget) -> str:
    """The wanted answer as a person would write it, its numbers correctly rounded."""
    if isinstance(target, CountTarget):
        return str(target.value)
    if isinstance(target, PointsTarget):
        return f"[{', '.join(f'({x[2]!r}, {y[2]!r})' for x, y in target.points)}]"
    return "None" if target.t is None else repr(target.t[2])


# -- counts ----------------------------------------------------------------------------------------------


def _check_count(answer: Any, target: CountTarget) -> Outcome:
    wanted = target.value
    if type(answer) is int or answer is None:
        if answer == wanted:
            return _UNMEASURED
        return Rejection(f"{wanted} wanted, {show(answer)} given", str(wanted), show(answer))
    given = number(answer)
    if isinstance(given, Fault):
        message = _sentence(given, "an int is meant")
    elif isinstance(given, int):
        message = f"{wanted} wanted, {show(answer)} given"
    else:
        name = "float" if isinstance(given, float) else "number"
        message = f"the {name} {show(answer)} where an int is meant"
    return Rejection(message, str(wanted), show(answer))


# -- parameters ------------------------------------------------------------------------------------------


def _check_parameter(answer: Any, target: ParameterTarget, exact: Exact) -> Outcome:
    wanted = target.t
    if type(answer) is float and wanted is not None and wanted[0] <= answer <= wanted[1]:
        return Accepted(_ulps_off(answer, wanted))
    if answer is None:
        if wanted is None:
            return _UNMEASURED
        return Rejection(f"None given, but the ray hits: t = {wanted[2]!r}", wanted_text(target), "None")
    given = number(answer)
    if isinstance(given, Fault):
        return Rejection(_sentence(given, "a number or None is meant"), wanted_text(target), show(answer))
    if wanted is None:
        return Rejection(f"None wanted, {show(answer)} given", "None", show(answer))
    if _accepts(given, wanted, exact, _parameter_of):
        return Accepted(_ulps_off(given, wanted))
    return _off("t", given, wanted, target, answer)


def _parameter_of(answer: Answer) -> Surd:
    t: Surd = answer.t  # type: ignore[union-attr,assignment]  # the target said it is a parameter
    return t


# -- points ----------------------------------------------------------------------------------------------

_PLURAL = {0: "no points", 1: "1 point", 2: "2 points"}


def _check_points(answer: Any, target: PointsTarget, exact: Exact) -> Outcome:
    wanted = target.points
    if type(answer) is not list or len(answer) != len(wanted):
        return _judge_points(answer, target, exact)
    if not wanted:
        return _UNMEASURED
    worst = 0.0
    # The usual answer costs two comparisons a number, and its error; so this loop is written to be quick.
    for point, (tx, ty) in zip(answer, wanted):  # noqa: B905  # the lengths are equal
        if type(point) is not list or len(point) != 2:
            return _judge_points(answer, target, exact)
        x, y = point
        if type(x) is not float or type(y) is not float:
            return _judge_points(answer, target, exact)
        lo, hi, nearest, residual, unit = tx
        if not lo <= x <= hi:
            return _judge_points(answer, target, exact)
        if nearest:
            away = (x - nearest) / unit - residual
            if away > worst or -away > worst:
                worst = abs(away)
        lo, hi, nearest, residual, unit = ty
        if not lo <= y <= hi:
            return _judge_points(answer, target, exact)
        if nearest:
            away = (y - nearest) / unit - residual
            if away > worst or -away > worst:
                worst = abs(away)
    return Accepted(worst)


def _judge_points(answer: Any, target: PointsTarget, exact: Exact) -> Outcome:
    """Whatever is not a list of doubles that are all accepted."""
    points = _read_points(answer)
    if isinstance(points, str):
        return Rejection(points, wanted_text(target), show(answer))
    if len(points) != len(target.points):
        return Rejection(_wrong_number(points, target, exact), wanted_text(target), show(answer))
    worst = 0.0
    for row, (point, wanted) in enumerate(zip(points, target.points, strict=True)):
        for column, (given, bounds) in enumerate(zip(point, wanted, strict=True)):
            if not _accepts(given, bounds, exact, _coordinate(row, column)):
                if len(points) == 2 and _swapped(points, target, exact):
                    message = (
                        "the right points in the wrong order: they come in the order of t along the line"
                    )
                    return Rejection(message, wanted_text(target), show(answer))
                where = f"{'xy'[column]} of point {row + 1}" if len(points) > 1 else f"{'xy'[column]}"
                return _off(where, given, bounds, target, answer)
            worst = max(worst, _ulps_off(given, bounds))
    return Accepted(worst)


def _read_points(answer: Any) -> list[tuple[Given, Given]] | str:
    """The points, or why `answer` is no list of points."""
    if type(answer) not in (list, tuple):
        if answer is None:
            return "None where a list of points is meant: no points are []"
        return _sentence(fault(answer), "a list of points is meant")
    points: list[tuple[Given, Given]] = []
    if len(answer) > 2:
        return f"{len(answer)} points given: a line and a circle have at most 2 in common"
    for place, point in enumerate(answer, 1):
        if type(point) not in (list, tuple):
            return _sentence(fault(point), f"point {place} is meant to be (x, y)")
        if len(point) != 2:
            return f"point {place} has {len(point)} coordinates where (x, y) is meant"
        x, y = number(point[0]), number(point[1])
        if isinstance(x, Fault):
            return _sentence(x, f"x of point {place} is meant")
        if isinstance(y, Fault):
            return _sentence(y, f"y of point {place} is meant")
        points.append((x, y))
    return points


def _wrong_number(points: list[tuple[Given, Given]], target: PointsTarget, exact: Exact) -> str:
    message = f"{_PLURAL[len(target.points)]} wanted, {len(points) or 'none'} given"
    if len(target.points) == 1 and len(points) == 2 and all(_fits(p, target, 0, exact) for p in points):
        message += ": the same point twice"
    return message


def _swapped(points: list[tuple[Given, Given]], target: PointsTarget, exact: Exact) -> bool:
    return _fits(points[0], target, 1, exact) and _fits(points[1], target, 0, exact)


def _fits(point: tuple[Given, Given], target: PointsTarget, row: int, exact: Exact) -> bool:
    bounds = target.points[row]
    return all(
        _accepts(given, bounds[column], exact, _coordinate(row, column)) for column, given in enumerate(point)
    )


def _coordinate(row: int, column: int) -> Callable[[Answer], Surd]:
    def pick(answer: Answer) -> Surd:
        x: Surd = answer.points[row][column]  # type: ignore[union-attr]  # the target said it is points
        return x

    return pick


# -- numbers ---------------------------------------------------------------------------------------------


def _accepts(given: Given, bounds: Target, exact: Exact, pick: Callable[[Answer], Surd]) -> bool:
    """Whether L <= given <= U, exactly."""
    lo, hi = bounds[0], bounds[1]
    if isinstance(given, Written):
        # A decimal lies on the same side of a double as its own rounding, unless it rounds to that double.
        if lo < given.approx < hi:
            return True
        if given.approx < nextafter(lo, -inf) or given.approx > nextafter(hi, inf):
            return _beyond_doubles(bounds) and _exactly(given.exact(), exact, pick)
        given = given.exact()
    if lo <= given <= hi:  # Python compares ints and Fractions with floats exactly
        return True
    if isinstance(given, float):
        return False
    between = nextafter(lo, -inf) < given < nextafter(hi, inf)
    return (between or _beyond_doubles(bounds)) and _exactly(given, exact, pick)


def _beyond_doubles(bounds: Target) -> bool:
    """Whether the interval lies beyond the largest double, where its rounded ends say nothing."""
    return bounds[0] == float_info.max and bounds[1] == -float_info.max


def _exactly(given: int | float | Fraction, exact: Exact, pick: Callable[[Answer], Surd]) -> bool:
    from judge.compare.tolerance import exact_ends  # exact numbers are needed about once in 10**15 answers

    answer, tolerance = exact()
    unit: Surd = answer.unit  # type: ignore[union-attr]  # a count never comes here
    low, high = exact_ends(pick(answer), tolerance, unit)
    return low <= given <= high


def _ulps_off(given: Given, bounds: Target) -> float:
    """|given − x|/ulp(x) of an accepted number, taken as its double; 0 where x is 0, which has no scale."""
    _, _, nearest, residual, unit = bounds
    if nearest == 0.0:
        return 0.0
    double = given.approx if isinstance(given, Written) else near(given)
    return abs((double - nearest) / unit - residual)


def _error(given: Given, bounds: Target) -> tuple[float, float | None, float | None]:
    """The absolute, relative and ulp error of any number, as doubles; the last two None for x = 0."""
    _, _, nearest, residual, unit = map(Fraction, bounds)
    x = nearest + residual * unit
    away = abs((given.exact() if isinstance(given, Written) else Fraction(given)) - x)
    if nearest == 0:
        return near(away), None, None
    return near(away), near(away / abs(x)), near(away / unit)


def _off(where: str, given: Given, bounds: Target, target: AnyTarget, answer: Any) -> Rejection:
    absolute, relative, ulps = _error(given, bounds)
    share = "" if relative is None or ulps is None else f", relative error {relative:.2g} ({ulps:.3g} ulps)"
    message = f"{where} is off by {absolute:.2g}{share}"
    return Rejection(message, wanted_text(target), show(answer), where, absolute, relative, ulps)


def _sentence(wrong: Fault, meant: str) -> str:
    return f"{wrong.text} where {meant}" + (f": {wrong.remedy}" if wrong.remedy else "")
