"""The elements of a list's target, its runs resolved, and the loop that decides most lists of points."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from judge.values.decode import Written, written_off


class Wanted(NamedTuple):
    """One element: its target, the steps to it in the list's exact tree, and the elements of its run."""

    target: Any
    steps: tuple[int, ...]
    run: range  # the indices among which this element's place is


def elements(target: Sequence[Any]) -> list[Wanted]:
    """The elements of a list's target, in order."""
    found: list[Wanted] = []
    for place, each in enumerate(target):
        if type(each) is dict and "run" in each:
            run = range(len(found), len(found) + len(each["run"]))
            found += [Wanted(one, (place, step), run) for step, one in enumerate(each["run"])]
        else:
            found.append(Wanted(each, (place,), range(len(found), len(found) + 1)))
    return found


def hot_pairs(raw: Any, target: Any) -> float | None:
    """How far off the worst of these points' numbers is, in ulps, if they are doubles that are all accepted.

    -1.0 for no points; None, TypeError or ValueError where one must look closer, as at AnyOf in the target.
    """
    if type(raw) is not list or len(raw) != len(target):
        return None
    if not raw:
        return -1.0
    worst = 0.0
    # The usual answer costs two comparisons a number, and its error; so this loop is written to be quick.
    for point, (tx, ty) in zip(raw, target):  # noqa: B905  # the lengths are equal
        if type(point) is not list or len(point) != 2:
            return None
        x, y = point
        if type(x) is not float or type(y) is not float:
            return _written_pairs(raw, target) if type(x) is Written else None
        lo, hi, nearest, residual, unit = tx
        if not lo <= x <= hi:
            return None
        if nearest:
            away = (x - nearest) / unit - residual
            if away > worst or -away > worst:
                worst = abs(away)
        lo, hi, nearest, residual, unit = ty
        if not lo <= y <= hi:
            return None
        if nearest:
            away = (y - nearest) / unit - residual
            if away > worst or -away > worst:
                worst = abs(away)
    return worst


def _written_pairs(raw: Any, target: Any) -> float | None:
    """The same for points in decimals, as programs print them."""
    worst = 0.0
    for (x, y), (tx, ty) in zip(raw, target):  # noqa: B905  # the lengths are equal
        for given, bounds in ((x, tx), (y, ty)):
            off = written_off(given, bounds)
            if off is None:
                return None
            if off > worst:
                worst = off
    return worst
