"""The one composer: a view at true scale, the place that decides enlarged, and both in words.

Where a length that decides is too small to be seen, the lens shows it. At a near touch of a line that lens
is stretched: with u across and √(2·r·u) along, a circle is the parabola g/u + v², whatever the sizes. What
decides is what `solve` asked of `Sure`; a kata without a promise asks nothing, and all lengths count.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from decimal import MAX_EMAX, MIN_EMIN, Decimal, localcontext
from fractions import Fraction
from math import hypot
from typing import Any

from judge.drawing.clip import inside
from judge.drawing.lengths import round_below
from judge.drawing.lengths import short as figures
from judge.drawing.shapes import Bar, Dot, Mark, Panel, Picture, Role
from judge.geometry.frame import Frame
from judge.geometry.sure import short
from judge.geometry.view import (
    Contact,
    NamedPoint,
    Place,
    View,
    Way,
    cross,
    dot,
    given,
    length,
    minus,
    precision,
    tiny,
    wanted,
)
from judge.geometry.views import view_of
from judge.problem.declare import Decided, InvalidCase, Shown, decisions

_CLOSE = Decimal(1) / 50  # what is closer than this share of the window cannot be seen at true scale
_ROOM = Decimal(5) / 2  # half a lens, in lengths that it shows
_FAR = 6  # points further out than so many sizes of what is drawn are shown at the edge
_MARGIN = Decimal("1.2")
_TOGETHER = 0.05  # marks that are closer than this share a label
_EDGE = 0.97  # where the arrow stands, whole, for a point further out
_REMARK = re.compile(r" \(.*")  # behind a name


def compose(kind: str, shown: Shown, solve: Callable[..., Any]) -> Picture | None:
    """The picture of a case, or None where its arguments are not of that kind."""
    case = list(shown.values.values())
    with localcontext() as context:
        context.prec, context.Emax, context.Emin = precision(case), MAX_EMAX, MIN_EMIN
        view = view_of(kind, shown.values, wanted(shown.exact), given(shown.given))
        if view is None:
            return None
        found = _deciding(view, _decided(solve, case))
        window = _window(view)
        said, why = _said(view, found, window)
        panel, lens = _whole(view, window), _lens(view, found, window)
    answers = f"expected {shown.wanted}, got {shown.got}" if shown.got else f"answer {shown.wanted}"
    description = f"{answers[0].upper()}{answers[1:]}; {said}."
    return Picture(description, panel, lens, why)


# -- what decides ------------------------------------------------------------------------------------------


def _decided(solve: Callable[..., Any], case: list[Any]) -> list[Decided]:
    with decisions() as made, suppress(InvalidCase, ValueError):
        solve(*case)
    return made


def _deciding(view: View, made: list[Decided]) -> list[Contact]:
    """The contacts that `solve` decided by, the closest first; all of them where it asked for nothing."""
    e = view.size or Decimal(1)
    found = [
        replace(each, gap=Decimal(0)) if abs(each.gap) < tiny() * e else each for each in _contacts(view)
    ]
    asked = [each for each in found if any(_same(each, e, one) for one in made)]
    return sorted(asked or found, key=lambda each: abs(each.gap))


def _same(contact: Contact, e: Decimal, one: Decided) -> bool:
    """Whether that decision was made there: by its gap, or where it is exact by its name."""
    if not contact.gap:
        return not one.gap and one.what == contact.words.name
    gap = abs(float(contact.gap / e))
    return abs(gap - abs(one.gap)) <= 1e-6 * gap


def _contacts(view: View) -> Iterator[Contact]:
    """Where a line may touch a circle, a point may be on one, and what the view has besides."""
    yield from view.contacts
    for ring in view.rings:
        if ring.decides is None:
            continue
        centre = ring.x, ring.y
        for way in view.ways:
            if way.decides:
                f = minus(centre, way.start)
                away = abs(cross(way.along, f)) / length(way.along)
                foot = way.at(dot(way.along, f) / dot(way.along, way.along))
                yield Contact(away - ring.r, foot, ring.decides, way.along, ring.r)
        for spot in view.spots:
            if spot.decides is not None:
                yield Contact(length(minus(spot.at, centre)) - ring.r, spot.at, spot.decides)


def _said(view: View, found: list[Contact], window: Frame) -> tuple[str, str]:
    """The case in words: what of it is shown, what is exact or closest, and e; and what it turns on."""
    e, parts = view.size or Decimal(1), [view.about] if view.about else []
    exact = [each for each in found if not each.gap]
    near = [each for each in found if each.gap][:1]
    close = near if near and abs(near[0].gap) < _CLOSE * window.along else []

    def words(contacts: list[Contact]) -> list[str]:
        return list(dict.fromkeys(each.words.said(each.gap / e) for each in contacts))[:3]

    parts += words(exact + close or near)
    size = f"e = {figures(Fraction(view.size), 3)}"
    said = "; ".join([*([", ".join(parts)] if parts else []), size])
    why = ", ".join(words([each for each in exact + near if abs(each.gap) < _CLOSE * e]))
    return said, f"{why} ({size})" if "·e" in why else why


# -- the panels --------------------------------------------------------------------------------------------


def _window(view: View) -> Frame:
    """A window around the circles and all points that are not far from them."""
    core = [(ring.x + s * ring.r, ring.y + s * ring.r) for ring in view.rings for s in (-1, 1)]
    for ring in view.rings:
        for way in view.ways[:1]:
            f = minus((ring.x, ring.y), way.start)
            core.append(way.at(dot(way.along, f) / (dot(way.along, way.along) or 1)))
    points = [spot.at for spot in view.spots if spot.role is not Role.GOT]
    if _span(core)[1] == 0:
        core = points
    middle, half = _span(core)
    near = [at for at in (spot.at for spot in view.spots) if _apart(at, middle) <= 2 * _FAR * half]
    middle, half = _span([*core, *near])
    unit = (half or view.size or Decimal(1)) * _MARGIN
    return Frame(middle, unit, unit)


def _span(points: list[Place]) -> tuple[Place, Decimal]:
    """The middle of points, and how far the furthest is from it in x or in y."""
    if not points:
        return (Decimal(0), Decimal(0)), Decimal(0)
    ranges = [(min(each), max(each)) for each in zip(*points, strict=True)]
    (x0, x1), (y0, y1) = ranges
    return ((x0 + x1) / 2, (y0 + y1) / 2), max(x1 - x0, y1 - y0) / 2


def _apart(p: Place, q: Place) -> Decimal:
    return max(abs(p[0] - q[0]), abs(p[1] - q[1]))


def _whole(view: View, frame: Frame) -> Panel:
    size = round_below(Fraction(frame.along) / 2)
    bar = Bar(float(size / Fraction(frame.along)), figures(size))
    return Panel("True scale", _strokes(view, frame), _marks(view, frame, beyond=True), (bar,))


def bare(view: View) -> Picture:
    """The figure at true scale alone, without a word but the names of its points."""
    panel = _whole(view, _window(view))
    return Picture("", replace(panel, title="", bars=()), None)


def _strokes(view: View, frame: Frame) -> tuple[Any, ...]:
    rings = [stroke for ring in view.rings for stroke in frame.ring(ring)]
    return (*rings, *(stroke for way in view.ways for stroke in frame.way(way)))


def _marks(view: View, frame: Frame, *, beyond: bool) -> tuple[Mark, ...]:
    """Every point in the panel; given ones outside it at its edge, and with `beyond` those of the case."""
    found: list[Mark] = []
    for spot in view.spots:
        at, sign = frame.place(spot.at), _sign(spot.text)
        if inside(at):
            found.append(Mark(at, spot.role, spot.text, sign))
        elif spot.text and (spot.role is Role.GOT or (beyond and spot.role is Role.CASE)):
            away = length(minus(spot.at, frame.middle))
            text = figures(Fraction(away)) if beyond else f"{short(away / (view.size or 1))} e"
            (x, y), towards = _leaving(view, frame, spot)
            found.append(Mark((x * _EDGE, y * _EDGE), spot.role, spot.text, sign, towards, text))
    return _merged(found)


def _leaving(view: View, frame: Frame, spot: NamedPoint) -> tuple[Dot, Dot]:
    """Where a point outside stands, and towards where: at the end of what is seen of its own line, if any."""
    for way in view.ways:
        if spot.at in (way.start, way.at(1)):
            whole = Way(way.start, way.along, None, None, beside=way.beside)
            ends = [dot for stroke in frame.way(whole) for dot in (stroke.dots[0], stroke.dots[-1])]
            if ends:
                forth = dot(minus(spot.at, frame.middle), way.along) > 0
                x, y = frame.turned(way.along)
                size = length((x, y)) * (1 if forth else -1)
                return ends[-1 if forth else 0], (float(x / size), float(y / size))
    u, v = frame.place(spot.at)
    far, away = max(abs(u), abs(v)), hypot(u, v)
    return (u / far, v / far), (u / away, v / away)


def _sign(name: str) -> str:
    """What of a name stands in a terminal: `C` of `C (r = 0)`, `AB` of `A = B`, `D` of `O + D`."""
    return "".join(_REMARK.sub("", name).rpartition(" + ")[2].split(" = "))


def _merged(marks: list[Mark]) -> tuple[Mark, ...]:
    """The same marks; of those in one place the first has the words of all."""
    kept: list[Mark] = []
    for mark in marks:
        close = next((i for i, other in enumerate(kept) if other.text and _together(mark, other)), None)
        if close is None or not mark.text:
            kept.append(mark)
            continue
        first = kept[close]
        same = mark.text in first.text.split(", ")
        text = first.text if same else f"{first.text}, {mark.text}"
        kept[close] = replace(first, text=text, shared=first.shared or first.role is not mark.role)
        kept.append(replace(mark, text=""))
    return tuple(kept)


def _together(one: Mark, other: Mark) -> bool:
    if (one.towards is None, one.away) != (other.towards is None, other.away):
        return False
    return hypot(one.at[0] - other.at[0], one.at[1] - other.at[1]) < _TOGETHER


# -- the lens ----------------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Sight:
    """What a lens shows: a length, where it is, and its heading and note."""

    size: Decimal
    at: Place
    title: str
    note: str
    touch: Contact | None = None


def _lens(view: View, found: list[Contact], window: Frame) -> Panel | None:
    """The lens, or None where all can be seen at true scale."""
    e = view.size or Decimal(1)
    sight = _error(view, window) or _closest(found, window, e) or _small(view, window)
    if sight is None:
        return None
    unit = sight.size * _ROOM
    frame, bars = Frame(sight.at, unit, unit), [_bar(unit / e, "")]
    touch = sight.touch
    if touch is not None and touch.along is not None and touch.r > 4 * unit:
        frame = Frame(sight.at, (2 * touch.r * unit).sqrt(), unit, touch.along)
        bars = [_bar(unit / e, " across", upright=True), _bar(frame.along / e, " along")]
    times = figures(Fraction(window.along / unit))
    title = f"Lens: {sight.title}, × {times}{' across, not to scale' if len(bars) > 1 else ''}"
    return Panel(title, _strokes(view, frame), _marks(view, frame, beyond=False), tuple(bars), sight.note)


def _bar(unit: Decimal, way: str, *, upright: bool = False) -> Bar:
    share = Fraction(unit)
    size = round_below(share / 2)
    return Bar(float(size / share), f"{figures(size)} e{way}", upright)


def _error(view: View, window: Frame) -> _Sight | None:
    """The worst of the given points that are nearly, but not quite, the wanted ones, each in its turn."""
    e = view.size or Decimal(1)
    right = [spot for spot in view.spots if spot.role is Role.WANTED]
    told = [spot for spot in view.spots if spot.role is Role.GOT]
    if not told or len(right) != len(told):
        return None
    errors = [length(minus(got.at, spot.at)) for got, spot in zip(told, right, strict=True)]
    worst = max(errors)
    crossed = max(length(minus(got.at, spot.at)) for got, spot in zip(told, reversed(right), strict=True))
    if not 0 < worst <= 4 * _CLOSE * window.along or crossed < worst or worst < e * Decimal("1e-15"):
        return None
    at = errors.index(worst)
    note = f"{told[at].text or 'got'} is {short(worst / e)} e from where it should be"
    return _Sight(worst, told[at].at, "the answer's error", note)


def _closest(found: list[Contact], window: Frame, e: Decimal) -> _Sight | None:
    for each in found:
        if 0 < abs(each.gap) < _CLOSE * window.along:
            note = each.words.said(each.gap / e)
            return _Sight(abs(each.gap), each.at, "what decides", note, each)
    return None


def _small(view: View, window: Frame) -> _Sight | None:
    """The one circle, or the segment, where it is but a dot at true scale."""
    least = _CLOSE * window.along
    if len(view.rings) == 1 and 0 < view.rings[0].r < least:
        ring = view.rings[0]
        return _Sight(ring.r, (ring.x, ring.y), "the circle", f"r is {short(ring.r / view.size)} e")
    ends: list[Way] = [way for way in view.ways if way.low == 0 and way.high == 1 and way.decides]
    if len(ends) == 1 and 0 < length(ends[0].along) < least:
        half = length(ends[0].along) / 2
        return _Sight(
            half, ends[0].at(Decimal("0.5")), "the segment", f"it is {short(2 * half / view.size)} e long"
        )
    return None
