"""The elements of a list's target, its runs resolved."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple


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
