"""Where answers about a moving disc and a wall turn: nine figures each, to measure a threshold in.

They are laid out as those of two discs (ball_borders.py). A wall takes the place of the second disc: it goes
away from a graze, and across the way of a disc that leaves it or comes to it. The radius is what moves.
"""

from __future__ import annotations

from judge.problem import Problem
from judge.problem.border import Border, Probe
from judge.topics.circles.motion.ball_borders import GRAZES, STRAIGHT, WIDEST, FloatPair, Layout, step

_LONG = 0.25  # a wall, in steps


def wall_borders(problem: Problem) -> tuple[Border, ...]:
    """Those of a problem with the bands `snap` and `clear`; each time the radius shrinks."""
    snap, clear = float(problem.bands["snap"]), float(problem.bands["clear"])
    return (
        Border("a graze", snap, clear, tuple(map(_graze, GRAZES))),
        Border("a touch at the start", snap, clear, tuple(map(_start, STRAIGHT))),
        Border("a touch at the end", snap, clear, tuple(map(_end, STRAIGHT))),
    )


def _graze(each: Layout) -> Probe:
    (p, q, _), _, reach, before, after, _ = each
    foot = -q * reach, p * reach
    ends = step(foot, (p, q), -before), step(foot, (p, q), after)
    return _probe(each, ends, ((0, 0), step((0, 0), (q, -p), _LONG)))


def _start(each: Layout) -> Probe:
    (p, q, _), _, reach, length, _, _ = each
    start = step((0, 0), (p, q), reach)
    return _probe(each, (start, step(start, (p, q), length)), _across(p, q))


def _end(each: Layout) -> Probe:
    (p, q, _), _, reach, length, _, _ = each
    end = step((0, 0), (p, q), -reach)
    return _probe(each, (step(end, (p, q), -length), end), _across(p, q))


def _across(p: int, q: int) -> tuple[FloatPair, FloatPair]:
    return step((0, 0), (-q, p), _LONG), step((0, 0), (-q, p), -_LONG)


def _probe(each: Layout, ends: tuple[FloatPair, FloatPair], wall: tuple[FloatPair, FloatPair]) -> Probe:
    """A disc and a wall about (far, −far); r shrinks."""
    (_, _, h), scale, steps, _, _, far = each
    radius = h * steps * scale
    x, y = far * scale, 0.0 - far * scale  # a zero has no sign
    first, last, a, b = ((x + at[0] * scale, y + at[1] * scale) for at in (*ends, *wall))
    spans = [end[axis] - place[axis] for end in (a, b) for place in (first, last) for axis in (0, 1)]
    sizes = {
        "extent": max(radius, *map(abs, spans)),
        "radius": radius,
        "way": max(abs(last[0] - first[0]), abs(last[1] - first[1])),
        "coordinate": max(map(abs, (*first, *last, *a, *b))),
    }
    case = (first, last, radius, a, b)
    return Probe(case, (2,), radius, -1, sizes, min(WIDEST, radius / sizes["extent"] / 4))
