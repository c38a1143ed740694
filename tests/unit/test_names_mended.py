"""Programs that were once given the name of a mistake that they do not make."""

from __future__ import annotations

import pytest

from judge.judging import Session, Terms
from judge.problem.find import find_problem

pytestmark = pytest.mark.slow

OWN_BAND = """
from math import hypot, sqrt

def all_hits(circles, O, D):
    '''The origin is moved to (0, 0), the direction scaled to one along its larger axis.'''
    m = max(abs(D[0]), abs(D[1]))
    ux, uy = D[0] / m, D[1] / m
    n = hypot(ux, uy)
    moved = [(x - O[0], y - O[1], r) for x, y, r in circles]
    e = max(max(abs(x), abs(y), r) for x, y, r in moved)
    if e == 0:
        return [(0.0, i, "touch") for i in range(len(circles))]
    tol = 1e-10
    out = []
    for i, (x, y, r) in enumerate(moved):
        x, y, r = x / e, y / e, r / e
        d = abs(ux * y - uy * x) / n
        mid = (x * ux + y * uy) / n
        eps = 1e-10 * max(r, abs(x), abs(y))
        if d > r + eps:
            continue
        if d > r - eps:
            found = [(mid, "touch")]
        else:
            h = sqrt((r - d) * (r + d))
            found = [(mid - h, "enter"), (mid + h, "exit")]
        for way, tag in found:
            way /= n                      # along the larger axis
            if way > tol:
                out.append((way * (e / m), i, tag))
            elif way >= -tol:
                out.append((0.0, i, tag))
    out.sort()
    return out
"""
TOWARDS_THE_OTHER = """
from math import hypot, sqrt

def common_tangents(cx1, cy1, r1, cx2, cy2, r2):
    '''A tangent is its unit normal n: n·(C2 − C1) is r1 − r2 for an outer one, r1 + r2 for an inner one.'''
    x, y = cx2 - cx1, cy2 - cy1
    d = hypot(x, y)
    ux, uy = x / d, y / d
    tol = 1e-10 * max(r1, r2, abs(x), abs(y))
    out = []
    for k in (r1 - r2, r1 + r2):
        if abs(k) > d + tol:
            continue
        if abs(k) > d - tol:
            c = 1
            out.append((cx1 + r1 * c * ux, cy1 + r1 * c * uy))
            continue
        c = k / d
        s = sqrt((d - k) * (d + k)) / d
        for side in (s, -s):
            out.append((cx1 + r1 * (c * ux - side * uy), cy1 + r1 * (c * uy + side * ux)))
    return out
"""
SHARE_OF_THE_RESULT = """
def delta_enclosure(cx, cy, r, ax, ay, bx, by):
    dx, dy = bx - ax, by - ay
    fx, fy = ax - cx, ay - cy
    a = dx * dx + dy * dy
    k = dx * fy - dy * fx
    v = r * r * a - k * k
    err = 2.0 ** -48 * abs(v)
    return v - err, v + err
"""


@pytest.mark.parametrize(
    ("problem", "name", "source"),
    [
        ("enter-exit", "own-extent", OWN_BAND),
        ("common-tangents", "inner-side", TOWARDS_THE_OTHER),
        ("error-bound", "relative-to-result", SHARE_OF_THE_RESULT),
    ],
)
def test_the_mistake_that_is_made_is_named(problem, name, source):
    with Session(find_problem(problem), Terms(timed=False, diagnosed=False)) as session:
        result = session.judge(source.encode(), "mine.py")
    assert result.pitfall is not None
    assert result.pitfall.names == (name,)
