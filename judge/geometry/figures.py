"""What is drawn of each signature: circles, ways, named points, and where something decides.

Each function takes the arguments of a case in order, in decimals, and by name what else there is: `names`
are those of the parameters, `answers` the exact answer and the submission's.
"""

# mypy: allow-untyped-defs, allow-incomplete-defs

from __future__ import annotations

from collections.abc import Iterator, Sequence
from decimal import Decimal
from itertools import pairwise
from typing import Any

from judge.drawing.shapes import Role
from judge.geometry.crowd import PLACES
from judge.geometry.motion import Cap, Discs
from judge.geometry.pair import INNER, OUTER
from judge.geometry.polygon import EDGE
from judge.geometry.quadratic import on_circle
from judge.geometry.view import (
    Contact,
    Place,
    Ring,
    View,
    Way,
    cross,
    dot,
    foot_of,
    length,
    met,
    minus,
    step,
    text,
)

_ONE, _NONE = Decimal(1), Decimal(0)
_SHOWN = 60  # circles
_NAMED = 16  # if there are no more


def _disc(view: View, cx: Decimal, cy: Decimal, r: Decimal, name: str = "C") -> None:
    view.rings.append(Ring(cx, cy, r))
    view.name((cx, cy), name if r else f"{name} (r = 0)")


def _beside(cx: Decimal, cy: Decimal, r: Decimal, points: Sequence[Place]) -> View:
    """A circle, and e of it and the points beside it."""
    view = View()
    _disc(view, cx, cy, r)
    view.measure((cx, cy), points, r)
    return view


def circle_and_line(cx, cy, r, A, B, part="line", names=(), **_: Any) -> View:
    """A circle and a line through two points, or the segment between them."""
    view = _beside(cx, cy, r, [A, B])
    segment = part == "segment"
    _two_points(view, A, B, segment, names[-2:])
    return view


def _two_points(view: View, A: Place, B: Place, segment: bool, names: Any = "AB") -> None:
    low, high = (0, 1) if segment else (None, None)
    first, last = (on_circle(name) if segment else None for name in names)
    if A != B:
        view.ways.append(Way(A, minus(B, A), low, high, beyond=segment, decides=True))
        view.name(A, names[0], decides=first)
        view.name(B, names[1], decides=last)
    else:
        view.name(A, f"{names[0]} = {names[1]}", decides=first)
        view.about = "A = B"


def seven_numbers(cx, cy, r, *ends, **_: Any) -> View:
    """The same, as numbers."""
    ax, ay, bx, by = ends
    return circle_and_line(cx, cy, r, (ax, ay), (bx, by), names="AB")


def circle_and_ray(cx, cy, r, O, D, **_: Any) -> View:
    """A circle and a ray."""
    view = _beside(cx, cy, r, [O])
    _shoot(view, O, D)
    return view


def _shoot(view: View, O: Place, D: Place, *, tip: bool = True, of: str = "the circle") -> None:
    decides = on_circle("O", of)
    if any(D):
        view.ways.append(Way(O, D, 0, None, beyond=True, decides=True))
        view.name(O, "O", decides=decides)
        if tip:
            view.name((O[0] + D[0], O[1] + D[1]), "O + D (t = 1)")
    else:
        view.name(O, "O (D = 0)", decides=decides)
        view.about = "D = 0: no ray"


def sphere_and_ray(C, r, O, D, **_: Any) -> View:
    """The plane through C and the ray: C is (0, 0), x runs along D, and the ray is above C."""
    f, size = [p - q for p, q in zip(O, C, strict=True)], length(D)
    x = dot(f, D) / size if size else length(f)
    high = max(dot(f, f) - x * x, _NONE).sqrt()
    view = View(about="the plane through C and the ray")
    _disc(view, _NONE, _NONE, r)
    view.size = max(r, *map(abs, f))
    _shoot(view, (x, high), (size, _NONE), of="the sphere")
    up = [part - x * along / (size or 1) for part, along in zip(f, D, strict=True)]
    view.frame = [[along / (size or 1) for along in D], [part / (high or 1) for part in up]]
    return view


def circle_and_point(cx, cy, r, P, names=("", "", "", "P"), **_: Any) -> View:
    """A circle and a point."""
    view = _beside(cx, cy, r, [P])
    view.name(P, names[3], decides=on_circle(names[3]))
    return view


def line_and_foot(A, B, P, part="line", names=(), **_: Any) -> View:
    """A line and a point beside it, with the perpendicular."""
    view = View()
    view.measure(P, [A, B])
    view.name(P, names[2])
    _two_points(view, A, B, part == "segment", names[:2])
    foot = foot_of(view)
    if foot:
        view.ways.append(Way(P, minus(foot, P), role=Role.BEYOND, arrow=False))
    return view


def line_and_point(A, B, P, names=(), **_: Any) -> View:
    """A line and a point beside it."""
    view = View()
    view.measure(A, [B, P])
    _two_points(view, A, B, False, names[:2])
    view.name(P, names[2])
    return view


def line_and_origin(A, B, names=(), **_: Any) -> View:
    """A line, and the origin."""
    view = View()
    view.measure((_NONE, _NONE), [A, B])
    view.name((_NONE, _NONE), "(0, 0)")
    _two_points(view, A, B, False, names)
    return view


def two_points(P, Q, names=(), **_: Any) -> View:
    """Two points and the way between them."""
    view = View()
    view.measure(P, [Q])
    _two_points(view, P, Q, True, names)
    view.ways = [Way(way.start, way.along, arrow=False) for way in view.ways]
    return view


def diameter(A, B, P, names=(), **_: Any) -> View:
    """A circle on a diameter, and a point."""
    view = View()
    middle = (A[0] + B[0]) / 2, (A[1] + B[1]) / 2
    view.measure(middle, [A, B, P])
    view.rings.append(Ring(*middle, length(minus(B, A)) / 2))
    view.ways.append(Way(A, minus(B, A), arrow=False))
    for at, name in zip((A, B), names[:2], strict=True):
        view.name(at, name)
    view.name(P, names[2], decides=on_circle(names[2]))
    return view


def two_circles(cx1, cy1, r1, cx2, cy2, r2, **_: Any) -> View:
    """Two circles, and how far they are from touching."""
    view = View()
    _disc(view, cx1, cy1, r1, "C1")
    _disc(view, cx2, cy2, r2, "C2")
    first, way = (cx1, cy1), (cx2 - cx1, cy2 - cy1)
    view.measure(first, [(cx2, cy2)], r1, r2)
    apart = length(way)
    outward = r1 if r1 > r2 else -r1  # where an inner touch is
    if apart:
        view.contacts += [
            Contact(apart - (r1 + r2), step(first, way, r1), OUTER),
            Contact(apart - abs(r1 - r2), step(first, way, outward), INNER),
        ]
    return view


def many_circles(circles, O, D, *_: Any, **__: Any) -> View:
    """Many circles and a ray; of very many those that it comes nearest to."""
    view = View()
    view.measure(O, [(x, y) for x, y, _ in circles], *(r for _, _, r in circles))
    for number, (x, y, r) in _nearest(circles, O, D):
        view.rings.append(Ring(x, y, r))
        if len(circles) <= _NAMED:
            view.name((x, y), str(number) if r else f"{number} (r = 0)")
    _shoot(view, O, D, tip=False)
    if any(D):
        places = sorted(t for ring in view.rings for t in met(view.ways[0], ring) if t >= 0)
        size = length(D)
        for before, after in pairwise(places):
            view.contacts.append(Contact((after - before) * size, view.ways[0].at(after), PLACES))
    return view


def _nearest(circles, O, D) -> list[tuple[int, Any]]:
    numbered = list(enumerate(circles))
    if len(numbered) <= _SHOWN:
        return numbered
    size = length(D)

    def gap(each: tuple[int, Any]) -> Decimal:
        x, y, r = each[1]
        f = x - O[0], y - O[1]
        away: Decimal = abs(cross(D, f)) / size if dot(f, D) > 0 else length(f)
        return away - Decimal(r)

    return sorted(sorted(numbered, key=gap)[:_SHOWN])


def light(circles, O, D, L, **_: Any) -> View:
    """Many circles and a ray, and the way from its first hit to a light."""
    view = many_circles(circles, O, D)
    view.measure(O, [*((x, y) for x, y, _ in circles), L], *(r for _, _, r in circles))
    view.contacts = []
    if any(D):
        way = view.ways[0]
        hits = [t for ring in view.rings for t in met(way, ring) if t >= 0]
        if hits:
            P = way.at(min(hits))
            view.ways.append(Way(P, minus(L, P), decides=False))
            view.name(P, "P")
    view.name(L, "L", decides=on_circle("L"))
    return view


def polygon(cx, cy, r, V, **_: Any) -> View:
    """A circle and a closed polygon."""
    view = _beside(cx, cy, r, V)
    view.rings[:] = [Ring(cx, cy, r, decides=EDGE)]
    few = len(V) <= 12
    for number, (start, end) in enumerate(zip(V, [*V[1:], V[0]], strict=True)):
        view.ways.append(Way(start, minus(end, start), arrow=few, decides=True))
        view.name(start, f"V{number}" if few or not number else "", decides=on_circle("A corner"))
    return view


def two_discs(P0, P1, r, Q0, Q1, s, answers=(), **_: Any) -> View:
    """Two moving discs."""
    view = View()
    view.measure(P0, [P1, Q0, Q1], r + s)
    ways = Way(P0, minus(P1, P0)), Way(Q0, minus(Q1, Q0))
    f, d = minus(P0, Q0), minus(ways[0].along, ways[1].along)
    _moving(view, ways[0], r, "P", answers)
    _moving(view, ways[1], s, "Q", answers)
    for t, words in _moments(f, d, Discs):
        P, Q = ways[0].at(t), ways[1].at(t)
        view.contacts.append(Contact(length(minus(P, Q)) - (r + s), step(P, minus(Q, P), r), words))
        if words is Discs.touch:
            _ghosts(view, (P, r), (Q, s))
    return view


def disc_and_wall(P0, P1, r, A, B, answers=(), **_: Any) -> View:
    """A moving disc and a wall."""
    view = View()
    view.measure(P0, [A, B, P1], r)
    way, wall = Way(P0, minus(P1, P0)), minus(B, A)
    view.size = max(view.size, *map(abs, (*minus(A, P1), *minus(B, P1))))
    _moving(view, way, r, "P", answers)
    view.ways.append(Way(A, wall, arrow=False))
    view.name(A, "A" if A != B else "A = B")
    if A != B:
        view.name(B, "B")
    square = dot(wall, wall)
    for end in (A, B):
        for t, words in _moments(minus(P0, end), way.along, Cap):
            P, at = way.at(t), end
            if words is not Cap.touch and square:
                share = dot(minus(P, A), wall) / square
                at = Way(A, wall).at(min(max(share, _NONE), _ONE))
            view.contacts.append(Contact(length(minus(P, at)) - r, at, words))
            if words is Cap.touch and abs(view.contacts[-1].gap) * 1000 < view.size:
                _ghosts(view, (P, r))
    return view


def _moments(f: Place, d: Place, figure: type[Discs | Cap]) -> Iterator[tuple[Decimal, Any]]:
    """The start, the end and the least distance on the way, with what decides there."""
    yield _NONE, figure.ends[0]
    square = dot(d, d)
    if square:
        yield _ONE, figure.ends[1]
        t = -dot(f, d) / square
        if 0 < t < 1:
            yield t, figure.touch


def _moving(view: View, way: Way, r: Decimal, name: str, answers: Any) -> None:
    """A disc on its way: at the start, at the end, and at each answer's moment."""
    ends = [(way.start, f"{name}0")]
    if any(way.along):
        view.ways.append(way)
        ends.append((way.at(1), f"{name}1"))
    for at, called in ends:
        view.rings.append(Ring(*at, r, Role.SHAPE if called.endswith("0") else Role.BEYOND, None))
        view.name(at, called)
    for t, role in zip(answers, (Role.WANTED, Role.GOT), strict=True):
        if isinstance(t, Decimal) and abs(t) < 100:
            view.rings.append(Ring(*way.at(t), r, role, None))
            view.name(way.at(t), f"{role.said} t = {text(t)}" if name == "P" else "", role)


def _ghosts(view: View, *discs: tuple[Place, Decimal]) -> None:
    view.rings += [Ring(*at, r, Role.BEYOND, None) for at, r in discs]
