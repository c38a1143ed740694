"""Pictures of motions: discs at the start, at the end, and where they touch or come closest.

What moves is told as a `Film`, in the integers of its case; a wall is a segment that stays where it is.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from judge.drawing.clip import polyline
from judge.drawing.frame import Frame
from judge.drawing.lengths import round_below, short
from judge.drawing.shapes import Bar, Dot, Fact, Panel, Picture, Role, Stroke
from judge.exact import Surd
from judge.problem.topic import Shown
from judge.topics.circles.picture.compose import LEGEND, argument_text
from judge.topics.circles.picture.given import read_given
from judge.topics.circles.picture.marks import points_in
from judge.topics.circles.picture.strokes import circle
from judge.topics.circles.plane import IntPoint

Point = tuple[Fraction, Fraction]

_DIGITS = 60  # of a place that something is drawn at: a gap of 1e-13 e is seen, and more
_MARGIN = Fraction(5, 4)
_ROOM = Fraction(5, 2)
_BAR = Fraction(1, 2)
_REACH = 4  # how far a way is followed, in panels
_RING = 121  # points of a small ring, the first one once more
_CLOSE = Fraction(1, 50)  # what is closer than this share of the window cannot be seen at true scale


@dataclass(frozen=True, slots=True)
class Disc:
    """A disc that moves from one place to another; `name` is that of its centre."""

    name: str
    start: IntPoint
    end: IntPoint
    r: int

    def at(self, t: Fraction) -> Point:
        """Its centre at a moment."""
        (x, y), (u, v) = self.start, self.end
        return x + t * (u - x), y + t * (v - y)


@dataclass(frozen=True, slots=True)
class Close:
    """A moment at which something is decided: where that is, and how wide the gap is, below 0
    where things overlap.
    """

    t: Fraction
    at: Point
    size: Fraction
    title: str


@dataclass(frozen=True, slots=True)
class Film:
    """What moves, in units of 2**-shift; the wanted moment comes from `solve`.

    `closest` is the moment from 0 to 1 at which the things are closest, and `close` all that may be too
    narrow to be seen. `said` is the geometry in words.
    """

    discs: tuple[Disc, ...]
    wall: tuple[IntPoint, IntPoint] | None
    shift: int
    extent: int
    closest: Fraction
    close: tuple[Close, ...]
    said: str


@dataclass(frozen=True, slots=True)
class _Ring:
    cx: Fraction
    cy: Fraction
    r: int


def fraction(value: Surd | Fraction | int) -> Fraction:
    """A number to many digits."""
    return Fraction(Surd.of(value).decimal(_DIGITS))


def length(x: Fraction, y: Fraction) -> Fraction:
    """√(x² + y²) to many digits."""
    square = x * x + y * y
    top, bottom = square.numerator, square.denominator
    return fraction(Surd(0, 1, top * bottom, bottom))


def film_picture(film: Film, shown: Shown) -> Picture:
    """The picture of one case."""
    wanted = None if shown.exact is None else fraction(shown.exact.x)
    given = read_given(shown.given).number
    moment = film.closest if wanted is None else wanted
    whole = _whole(film)
    panel = Panel(
        f"True scale, {'the closest' if wanted is None else 'the first touch'}",
        _strokes(whole, film, moment, ghosts=True),
        points_in(whole, _spots(film, wanted, given)),
        (_bar(whole, 1 << film.shift, ""),),
        "dashed: the start and the end",
    )
    said = f"{film.said}; e = {short(Fraction(film.extent, 1 << film.shift), 3)}"
    got = shown.got or "no answer"
    facts = (
        Fact("input", ", ".join(f"{name}={argument_text(value)}" for name, value in shown.values.items())),
        Fact("wanted", shown.wanted or "", Role.WANTED),
        Fact("got", got, Role.GOT),
        Fact("geometry", said),
    )
    description = f"Wanted {shown.wanted}, got {got}; {film.said}."
    lens = _lens(film, whole, moment, wanted, given)
    return Picture(shown.problem.title, shown.heading, description, panel, lens, facts, LEGEND)


def _lens(
    film: Film, whole: Frame, moment: Fraction, wanted: Fraction | None, given: Fraction | None
) -> Panel | None:
    """The narrowest gap, or the discs where they are but dots."""
    near = [each for each in film.close if 0 < abs(each.size) < _CLOSE * whole.unit]
    if near:
        place = min(near, key=lambda each: abs(each.size))
        frame = Frame(*place.at, abs(place.size) * _ROOM)
        title, t = place.title, place.t
    else:
        largest = max(film.discs, key=lambda disc: disc.r)
        if not 0 < largest.r < _CLOSE * whole.unit * 2:
            return None
        frame = Frame(*largest.at(moment), largest.r * _ROOM)
        title, t = "the discs" if len(film.discs) > 1 else "the disc", moment
    return Panel(
        f"Lens: {title}, × {short(whole.unit / frame.unit)}",
        _strokes(frame, film, t, ghosts=False),
        points_in(frame, _spots(film, wanted, given), beyond=False),
        (_bar(frame, film.extent or 1, " e"),),
        f"at t = {short(t, 6)}",
    )


def _whole(film: Film) -> Frame:
    """A window around everything, from the start to the end."""
    xs: list[int] = []
    ys: list[int] = []
    for disc in film.discs:
        for x, y in (disc.start, disc.end):
            xs += [x - disc.r, x + disc.r]
            ys += [y - disc.r, y + disc.r]
    for x, y in film.wall or ():
        xs.append(x)
        ys.append(y)
    side = max(max(xs) - min(xs), max(ys) - min(ys)) or 2
    return Frame(Fraction(min(xs) + max(xs), 2), Fraction(min(ys) + max(ys), 2), Fraction(side, 2) * _MARGIN)


def _bar(frame: Frame, one: int, word: str) -> Bar:
    """A round length in the caller's units, or in those of e."""
    size = round_below(frame.unit / one * _BAR)
    return Bar(float(size * one / frame.unit), f"{short(size)}{word}")


def _strokes(frame: Frame, film: Film, moment: Fraction, *, ghosts: bool) -> tuple[Stroke, ...]:
    """The wall, every disc's way and the disc at that moment; with `ghosts`, at the start and the end too."""
    found: list[Stroke] = []
    if film.wall:
        found += _straight(frame, *film.wall, Role.LINE)
    for disc in film.discs:
        for place in (disc.start, disc.end) if ghosts and disc.start != disc.end else ():
            found += [
                replace(each, role=Role.BEYOND, dots=_fewer(each.dots))
                for each in _ring(frame, disc, _exact(place))
                if not each.filled
            ]
        found += _ring(frame, disc, disc.at(moment))
        if disc.start != disc.end:
            found += _straight(
                frame, disc.start, disc.end, Role.BEYOND if film.wall else Role.LINE, arrow=True
            )
    return tuple(found)


def _fewer(dots: tuple[Dot, ...]) -> tuple[Dot, ...]:
    """Half of a small ring's points: enough for one that is dashed."""
    return dots[::2] if len(dots) == _RING else dots


def _ring(frame: Frame, disc: Disc, at: Point) -> tuple[Stroke, ...]:
    return circle(frame, _Ring(*at, disc.r))


def _straight(
    frame: Frame, start: IntPoint, end: IntPoint, role: Role, *, arrow: bool = False
) -> list[Stroke]:
    """What is seen of the way from one place to another, cut before it is rounded: an end may be far."""
    ways = [
        (Fraction(start[axis] - at) / frame.unit, Fraction(end[axis] - start[axis]) / frame.unit)
        for axis, at in enumerate((frame.x, frame.y))
    ]
    low, high = Fraction(0), Fraction(1)
    for at, step in ways:
        if step:
            enter, leave = sorted(((-_REACH - at) / step, (_REACH - at) / step))
            low, high = max(low, enter), min(high, leave)
        elif abs(at) > _REACH:
            return []
    if low >= high:
        return []
    (x, u), (y, v) = ways
    dots = [(float(x + t * u), float(y + t * v)) for t in (low, high)]
    return [Stroke(part, role, arrow=arrow) for part in polyline(dots)]


def _spots(film: Film, wanted: Fraction | None, given: Fraction | None) -> list[tuple[Point, Role, str]]:
    """The places of the case, and those of the first disc at the wanted and the given moment."""
    first = film.discs[0]
    spots: list[tuple[Point, Role, str]] = []
    for disc in film.discs:
        if disc.start == disc.end:
            spots.append((_exact(disc.start), Role.CASE, disc.name))
        else:
            spots.append((_exact(disc.start), Role.CASE, f"{disc.name}0"))
            spots.append((_exact(disc.end), Role.CASE, f"{disc.name}1"))
    if film.wall:
        names = ("A = B",) if film.wall[0] == film.wall[1] else ("A", "B")
        spots += [(_exact(at), Role.CASE, name) for at, name in zip(film.wall, names, strict=False)]
    for t, role, word in ((wanted, Role.WANTED, "wanted"), (given, Role.GOT, "got")):
        if t is not None:
            spots.append((first.at(t), role, f"{word} t = {short(t, 6)}"))
    return spots


def _exact(place: IntPoint) -> Point:
    return Fraction(place[0]), Fraction(place[1])


def share(gap: Fraction, extent: int) -> str:
    """A length in parts of the extent, for a sentence."""
    return f"{short(abs(gap) / (extent or 1))} e"


def moment_words(t: Surd | None, step: int, extent: int) -> str:
    """What is to be said of a first touch that is close to the end, or after it; else nothing."""
    if t is None:
        return ""
    late = t - 1
    away = fraction(abs(late)) * step / (extent or 1)
    if late.sign() > 0:
        return f"; the touch comes {short(away)} e after the end"
    return f"; the touch comes {short(away)} e before the end" if away < Fraction(1, 1000) else ""


def shown_values(shown: Shown) -> list[Any]:
    """The arguments of a case, points as tuples."""
    return [tuple(value) if isinstance(value, list) else value for value in shown.values.values()]
