"""What a comparison needs of an exact answer, in doubles: made once, cached as JSON, cheap to load.

A number is the tuple (lo, hi, nearest, residual, ulp): a double is accepted where lo <= y <= hi; `nearest` is
the correctly rounded double of the exact x, `ulp` is ulp(x) and residual = (x − nearest)/ulp(x).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from msgspec import Struct

from judge.problem import AnswerKind, Tolerance

if TYPE_CHECKING:
    from judge.compare.answers import Answer

Target = tuple[float, float, float, float, float]


class CountTarget(Struct, frozen=True):
    """The wanted count, or None."""

    value: int | None


class PointsTarget(Struct, frozen=True):
    """The wanted points in order, each as the targets of x and y."""

    points: tuple[tuple[Target, Target], ...]


class ParameterTarget(Struct, frozen=True):
    """The wanted parameter, or None."""

    t: Target | None


AnyTarget = CountTarget | PointsTarget | ParameterTarget


def compile_answer(answer: Answer, tolerance: Tolerance) -> AnyTarget:
    """The target of an exact answer; raises ProblemError where the tolerance does not fit it."""
    # Only building data needs exact numbers: judging with a warm cache must not pay for importing them.
    from judge.compare.answers import Count, Points
    from judge.compare.tolerance import measure, shared_roots

    if isinstance(answer, Count):
        return CountTarget(answer.value)
    if isinstance(answer, Points):
        roots = shared_roots()
        unit = answer.unit
        return PointsTarget(
            tuple(
                [
                    (measure(x, tolerance, unit, roots), measure(y, tolerance, unit, roots))
                    for x, y in answer.points
                ]
            )
        )
    return ParameterTarget(None if answer.t is None else measure(answer.t, tolerance, answer.unit))


def to_json(target: AnyTarget) -> Any:
    """Plain JSON: a count or None; a list of pairs [x, y]; t or None; a number is its five doubles."""
    if isinstance(target, CountTarget):
        return target.value
    if isinstance(target, PointsTarget):
        return [[list(x), list(y)] for x, y in target.points]
    return None if target.t is None else list(target.t)


def from_json(kind: AnswerKind, value: Any) -> AnyTarget:
    """The target that `to_json` wrote. The value is trusted: whoever stores it keeps a checksum."""
    if kind is AnswerKind.COUNT:
        return CountTarget(value)
    if kind is AnswerKind.POINTS:
        return PointsTarget(tuple([(tuple(x), tuple(y)) for x, y in value]))
    return ParameterTarget(None if value is None else tuple(value))
