"""A sphere and a ray in space, drawn as two projections: from above (x and y), and from the front (x and z).

Both panels have one scale, and x runs alike in both. Normals are arrows at the points they belong to.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import cos, pi, sin
from typing import Any

from msgspec import Struct

from judge.drawing.clip import inside, polygon, polyline
from judge.drawing.frame import Frame, direction, near, root, rounded
from judge.drawing.lengths import round_below, short
from judge.drawing.shapes import Bar, Dot, Fact, Mark, Panel, Picture, Role, Stroke
from judge.exact import Surd
from judge.problem.topic import Shown
from judge.topics.circles.picture.marks import at_edge, merged
from judge.topics.spheres.hit import SphereRay
from judge.values.decode import Fault, Raw, Written, number

Spot = tuple[Fraction, Fraction, Fraction]  # seen from the sphere's centre, in the ray's integers

_VIEWS = (("True scale, from above: x, y", 1), ("From the front: x, z", 2))
_FAR = 6  # the origin is in the window if it is within so many radii
_MARGIN = Fraction(5, 4)
_BAR = Fraction(1, 2)
_REACH = 4.0  # how far a ray is followed, in panels
_NORMAL = 0.4  # how long a normal is drawn, in panels


class Answer(Struct, frozen=True):
    """A point on the ray and a normal there."""

    at: Spot
    normal: tuple[float, float, float]


def compose(shown: Shown) -> Picture | None:
    """The picture of one case, or None where its arguments are no sphere and ray."""
    if len(shown.values) != 4:
        return None
    centre, radius, origin, way = shown.values.values()
    hit = SphereRay.of(tuple(centre), radius, tuple(origin), tuple(way))
    wanted, given = _wanted(hit, shown.exact), _given(hit, shown.given)
    middle, unit = _window(hit, wanted)
    panels = [_panel(hit, wanted, given, middle, unit, view) for view in _VIEWS]
    got = shown.got or "no answer"
    facts = (
        Fact("input", ", ".join(f"{name}={_argument(value)}" for name, value in shown.values.items())),
        Fact("wanted", shown.wanted or "", Role.WANTED),
        Fact("got", got, Role.GOT),
        Fact("geometry", _situation(hit)),
    )
    description = f"Wanted {shown.wanted}, got {got}; {_situation(hit)}."
    return Picture(
        shown.problem.title,
        shown.heading,
        description,
        panels[0],
        panels[1],
        facts,
        "e: the case's own size; arrows at a point: its normal",
    )


def _argument(value: Any) -> str:
    if isinstance(value, list | tuple):
        return f"({', '.join(map(_argument, value))})"
    return repr(value)


def _situation(hit: SphereRay) -> str:
    """The geometry in words."""
    size = short(Fraction(hit.extent, 1 << hit.shift), 3)
    if not hit.r or not hit.a:
        return f"{'r = 0: no sphere' if hit.a else 'D = 0: no ray'}; e = {size}"
    distance = root(Fraction(hit.square, hit.a << 2 * hit.shift))
    gap = Surd(-hit.r * hit.a, 1, hit.square * hit.a, hit.a * hit.extent)
    beside = "past the sphere" if gap.sign() > 0 else "within the sphere" if gap.sign() else "touching it"
    away = f" by {short(abs(gap), 3)} e" if gap.sign() else ""
    return f"the line passes C at a distance of {short(distance, 3)}, {beside}{away}; e = {size}"


# -- the answers -------------------------------------------------------------------------------------------


def _wanted(hit: SphereRay, exact: Any) -> Answer | None:
    if exact is None:
        return None
    t, normal = exact
    share = Surd.of(t.x)
    # Three digits of where it is, beside the size of the sphere: the root may be far from O, and near C.
    at = tuple(
        _near_centre(Surd(f * share.s + share.p * d, share.q * d, share.d, share.s), hit)
        for f, d in _axes(hit)
    )
    x, y, z = (near(part.x) for part in normal)
    return Answer((at[0], at[1], at[2]), (x, y, z))


def _near_centre(value: Surd, hit: SphereRay) -> Fraction:
    return rounded(value / hit.extent) * hit.extent


def _given(hit: SphereRay, raw: Raw) -> Answer | None:
    if type(raw) not in (list, tuple) or len(raw) != 2 or type(raw[1]) not in (list, tuple):
        return None
    parts = [_number(part) for part in (raw[0], *raw[1][:4])]
    if len(parts) != 4 or None in parts:
        return None
    t, x, y, z = (part or Fraction(0) for part in parts)
    at = tuple(f + t * d for f, d in _axes(hit))
    return Answer((at[0], at[1], at[2]), (near(x), near(y), near(z)))


def _axes(hit: SphereRay) -> Iterator[tuple[int, int]]:
    return zip(hit.f, hit.d, strict=True)


def _number(raw: Raw) -> Fraction | None:
    read = number(raw)
    if isinstance(read, Fault):
        return None
    return read.exact() if isinstance(read, Written) else Fraction(read)


# -- the panels --------------------------------------------------------------------------------------------


def _window(hit: SphereRay, wanted: Answer | None) -> tuple[Spot, Fraction]:
    """The middle of the cube that is shown, and half its side."""
    reach = hit.r or hit.extent or 1
    spots = [(Fraction(sign * hit.r),) * 3 for sign in (-1, 1)]
    start = tuple(map(Fraction, hit.f))
    if max(map(abs, start)) <= _FAR * reach:
        spots.append((start[0], start[1], start[2]))
    if wanted is not None:
        spots.append(wanted.at)
    bounds = [(min(spot[axis] for spot in spots), max(spot[axis] for spot in spots)) for axis in range(3)]
    side = max(high - low for low, high in bounds) or Fraction(reach)
    x, y, z = ((low + high) / 2 for low, high in bounds)
    return (x, y, z), side / 2 * _MARGIN


def _panel(
    hit: SphereRay,
    wanted: Answer | None,
    given: Answer | None,
    middle: Spot,
    unit: Fraction,
    view: tuple[str, int],
) -> Panel:
    title, up = view
    frame = Frame(middle[0], middle[up], unit)
    strokes = [*_disc(frame, hit), *_ray(frame, hit, up)]
    spots = [((Fraction(0),) * 3, Role.CASE, "C"), (tuple(map(Fraction, hit.f)), Role.CASE, "O")]
    for answer, role in ((wanted, Role.WANTED), (given, Role.GOT)):
        if answer is not None:
            strokes += _arrow(frame, answer, up, role)
            spots.append((answer.at, role, role.value))
    one = Fraction(1 << hit.shift)
    size = round_below(unit / one * _BAR)
    bar = Bar(float(size * one / unit), short(size))
    return Panel(title, tuple(strokes), _marks(frame, spots, up), (bar,))


def _disc(frame: Frame, hit: SphereRay) -> list[Stroke]:
    """The sphere as it is seen: a disc."""
    if not hit.r:
        return []
    (x, y), size = frame.place(0, 0), near(hit.r / frame.unit)
    dots = tuple(
        (x + size * cos(turn), y + size * sin(turn)) for turn in (2 * pi * at / 120 for at in range(120))
    )
    area = polygon(dots)
    fill = [Stroke(area, Role.SHAPE, filled=True)] if area else []
    return [*fill, *(Stroke(part, Role.SHAPE) for part in polyline((*dots, dots[0])))]


def _ray(frame: Frame, hit: SphereRay, up: int) -> list[Stroke]:
    """The ray from O; a point where it comes straight at whoever looks."""
    dx, dy = hit.d[0], hit.d[up]
    if not dx and not dy:
        return []
    u, v = direction(dx, dy)
    x, y = frame.place(hit.f[0], hit.f[up])
    far = _REACH + abs(x) + abs(y)
    ends = ((x, y), (x + far * u, y + far * v))
    back = ((x, y), (x - far * u, y - far * v))
    return [
        *(Stroke(part, Role.BEYOND) for part in polyline(back)),
        *(Stroke(part, Role.LINE, arrow=True) for part in polyline(ends)),
    ]


def _arrow(frame: Frame, answer: Answer, up: int, role: Role) -> list[Stroke]:
    """The normal, from its point; cut to a length that a panel holds."""
    x, y = frame.place(answer.at[0], answer.at[up])
    size = max(1.0, *map(abs, answer.normal))
    tip = x + _NORMAL * answer.normal[0] / size, y + _NORMAL * answer.normal[up] / size
    if not inside((x, y)) or max(abs(tip[0] - x), abs(tip[1] - y)) < 1e-3:
        return []
    return [Stroke(part, role, arrow=True) for part in polyline(((x, y), tip))]


def _marks(frame: Frame, spots: Sequence[tuple[Sequence[Fraction], Role, str]], up: int) -> tuple[Mark, ...]:
    """Every point in the panel or at its edge; those in one place share their words."""
    found = []
    for spot, role, text in spots:
        x, y = spot[0], spot[up]
        at: Dot = frame.place(x, y)
        way = direction(x - frame.x, y - frame.y)
        found.append(Mark(at, role, text) if inside(at) else at_edge(way, role, text))
    return merged(found)
