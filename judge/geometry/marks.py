"""How an answer is drawn in a view: as points, a place on the ray, a vector, or not at all.

Each function adds to the view what it can of an answer, be it the exact one or a submission's, which may be
anything.
"""

from __future__ import annotations

from decimal import Decimal

from judge.drawing.shapes import Role
from judge.geometry.view import (
    Place,
    Plain,
    View,
    Way,
    dot,
    foot_of,
    length,
    met,
    minus,
    numbers,
    points,
    step,
    text,
)

_NONE = Decimal(0)
_TIP = Decimal(1) / 3  # of e: how long a vector of length 1 is drawn
_SPAN = 0.03  # panels: how far beside the ray a span is drawn
_MOST = 8  # points of an answer


def nothing(view: View, answer: Plain, role: Role) -> None:
    """The answer has no place."""


def common(view: View, answer: Plain, role: Role) -> None:
    """A number of common points, which are drawn where it is the right one."""
    if role is Role.WANTED and view.ways and isinstance(answer, Decimal):
        found = met(view.ways[0], view.rings[0])
        for t in found if answer else ():
            view.name(view.ways[0].at(t), role.said, role)


def chord(view: View, answer: Plain, role: Role) -> None:
    """A length, which stands for points as far from the foot of the perpendicular as half of it."""
    if not isinstance(answer, Decimal) or not view.ways:
        return
    way, foot = view.ways[0], foot_of(view)
    for number, half in enumerate((-answer / 2, answer / 2) if answer else (_NONE,), 1):
        view.name(step(foot or way.start, way.along, half), _numbered(role, number, 2 if answer else 1), role)


def listed(view: View, answer: Plain, role: Role) -> list[Place]:
    """Every point in the answer, which it returns."""
    found = points(answer)[:_MOST]
    for number, at in enumerate(found, 1):
        view.name(at, _numbered(role, number, len(found)), role)
    return found


def _numbered(role: Role, number: int, of: int) -> str:
    return f"{role.said} {number}" if of > 1 else role.said


def touching(view: View, answer: Plain, role: Role) -> None:
    """Points of tangents through P."""
    P = view.spots[1].at
    for at in listed(view, answer, role):
        if at != P:
            view.ways.append(Way(P, minus(at, P), role=_beside(role), arrow=False))


def across(view: View, answer: Plain, role: Role) -> None:
    """Points of circle 1 on common tangents."""
    C = view.spots[0].at
    for at in listed(view, answer, role):
        u, v = minus(at, C)
        if u or v:
            view.ways.append(Way(at, (-v, u), None, None, _beside(role), arrow=False))


def _beside(role: Role) -> Role:
    return Role.LINE if role is Role.WANTED else Role.BEYOND


def on_ray(view: View, answer: Plain, role: Role) -> None:
    """A parameter t."""
    if isinstance(answer, Decimal) and view.ways:
        view.name(view.ways[0].at(answer), f"{role.said} t = {text(answer)}", role)


def spatial(view: View, answer: Plain, role: Role) -> None:
    """(t, normal) of a sphere."""
    if isinstance(answer, list) and len(answer) == 2 and isinstance(answer[0], Decimal) and view.ways:
        on_ray(view, answer[0], role)
        normal = numbers(answer[1], 3)
        if normal:
            x, y = (dot(normal, axis) for axis in view.frame)
            _vector(view, view.ways[0].at(answer[0]), (x, y), role)


def _vector(view: View, start: Place, vector: Place, role: Role, *, long: Decimal | None = None) -> None:
    by = view.size * _TIP if long is None else long
    view.arrow(start, (start[0] + vector[0] * by, start[1] + vector[1] * by), role)


def _first_hit(view: View) -> Place | None:
    """The first point that the ray and the circle have in common."""
    if not view.ways or view.ways[0].high is not None:
        return None
    way = view.ways[0]
    hits = [t for t in met(way, view.rings[0]) if t >= -view.size / length(way.along) * Decimal("1e-9")]
    return way.at(min(hits)) if hits else None


def normal(view: View, answer: Plain, role: Role) -> None:
    """A vector where the ray meets the circle; at O where it does not."""
    vector = numbers(answer, 2)
    if vector:
        at = _first_hit(view) or view.spots[1].at
        _vector(view, at, (vector[0], vector[1]), role)


def bounce(view: View, answer: Plain, role: Role) -> None:
    """(point, vector): the vector as long as D is drawn half as long as e."""
    found = points(answer)
    if len(found) == 2 and view.ways:
        at, vector = found
        view.name(at, "hit" if role is Role.WANTED else "got hit", role)
        _vector(view, at, vector, role, long=view.size / 2 / length(view.ways[0].along))


def nearest_point(view: View, answer: Plain, role: Role) -> None:
    """A foot, or the distance that it is away."""
    foot = foot_of(view)
    if isinstance(answer, Decimal) and foot:
        P = view.spots[0].at
        view.name(step(P, minus(foot, P), answer), role.said, role)
    else:
        listed(view, answer, role)


def normal_form(view: View, answer: Plain, role: Role) -> None:
    """(a, b, c), as the normal from the foot of the origin on the line a·x + b·y + c = 0."""
    found = numbers(answer, 3)
    square = dot(found[:2], found[:2]) if found else _NONE
    if found and square:
        a, b, c = found
        _vector(view, (-a * c / square, -b * c / square), (a, b), role)


def tagged(view: View, answer: Plain, role: Role) -> None:
    """(t, circle, what happens there) along the ray."""
    for hit in answer[:_MOST] if isinstance(answer, list) and view.ways else ():
        if isinstance(hit, list) and hit and isinstance(hit[0], Decimal):
            what = " ".join(text(each) for each in reversed(hit[1:]))
            view.name(view.ways[0].at(hit[0]), f"{what}" if role is Role.WANTED else f"got {what}", role)


def spans(view: View, answer: Plain, role: Role) -> None:
    """(t, t) along the ray: what of it is inside, wanted on its left and given on its right."""
    for span in answer[:_MOST] if isinstance(answer, list) and view.ways else ():
        found = numbers(span, 2)
        if found:
            way, beside = view.ways[0], _SPAN if role is Role.WANTED else -_SPAN
            start, end = map(way.at, found)
            view.ways.append(Way(start, minus(end, start), role=role, arrow=False, beside=beside))
            for at in (start, end):
                view.name(at, "", role)
