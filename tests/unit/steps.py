"""How many steps a pattern may take at one place of a text: the worst that its repetitions allow.

What follows a repetition is tried again for each number of times, unless that is never gone back into, as in
`a*+` and `(?>…)`.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any, NamedTuple

from judge.languages.scan import AT_ONCE, WINDOW

_LONGEST = AT_ONCE + WINDOW  # characters that a repetition without a bound may go on for
_ENDLESS = 10**12


def steps(pattern: str) -> int:
    """So many."""
    return _cost(import_module("re._parser").parse(pattern)).steps


class _Cost(NamedTuple):
    """What trying a pattern at one place may take: steps, and in how many ways it may be met."""

    steps: int
    ways: int = 1


def _cost(parsed: Any) -> _Cost:
    """What follows is tried again for each way of what was before."""
    steps, ways = 0, 1
    for kind, held in parsed:
        each = _cost_of(str(kind), held, parsed.state.groupwidths)
        steps, ways = _sum(steps, ways * each.steps), _sum(ways * each.ways)
    return _Cost(steps, ways)


def _cost_of(kind: str, held: Any, widths: Any) -> _Cost:
    match kind:
        case "MAX_REPEAT" | "MIN_REPEAT":
            return _repeated(*held)
        case "POSSESSIVE_REPEAT":
            return _Cost(_first(*held))
        case "BRANCH":
            branches = [_cost(branch) for branch in held[1]]
            return _Cost(_sum(*(each.steps for each in branches)), _sum(*(each.ways for each in branches)))
        case "SUBPATTERN":
            return _cost(held[-1])
        case "ATOMIC_GROUP":
            (kind, inner), *others = [*held] or [("", None)]
            repeats = kind is not None and str(kind) in ("MAX_REPEAT", "MIN_REPEAT") and not others
            return _Cost(_first(*inner) if repeats else _cost(held).steps)
        case "ASSERT" | "ASSERT_NOT":
            return _Cost(_cost(held[1]).steps)
        case "GROUPREF":
            return _Cost(min(_LONGEST, widths[held][1]))
        case "GROUPREF_EXISTS":
            parts = [_cost(part) for part in held[1:] if part]
            return _Cost(_sum(*(each.steps for each in parts)), _sum(*(each.ways for each in parts)))
    return _Cost(1)


def _repeated(least: int, most: int, body: Any) -> _Cost:
    """The body so many times: each way of one time goes on in each way of the next."""
    once, most = _cost(body), min(int(most), _LONGEST)
    steps, ways, branches = 1, 0, 1
    for times in range(most + 1):
        ways = _sum(ways, branches if times >= int(least) else 0)
        if times < most:
            steps = _sum(steps, branches * once.steps)
            branches = _sum(branches * once.ways)
    return _Cost(steps, max(ways, 1))


def _first(least: int, most: int, body: Any) -> int:
    """Its steps where the first way is the last: no time is gone back into, once the least is reached."""
    return _sum(_repeated(0, least, body).steps, min(int(most), _LONGEST) * _cost(body).steps)


def _sum(*counts: int) -> int:
    return min(sum(counts), _ENDLESS)
