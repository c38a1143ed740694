"""The panel that enlarges the place that matters: the gap at the tangency, an end at the circle, an error.

At a near tangency the gap g = d − r is far narrower than the stretch of line beside it, so that lens has two
scales, one across the line and one along it: with u across and √(2·r·u) along, the circle is the parabola
g/u + v², whatever the sizes.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import hypot, sqrt

from judge.drawing.clip import inside, polygon, polyline
from judge.drawing.frame import Frame, length, near, over_root, root, rounded
from judge.drawing.lengths import round_below, short
from judge.drawing.shapes import Bar, Dot, Mark, Panel, Role, Stroke
from judge.exact import Surd
from judge.topics.circles.pair import CirclePair
from judge.topics.circles.part import Part
from judge.topics.circles.picture.couple import nearest_touch, pair_words, touching_place
from judge.topics.circles.picture.marks import at_edge, distance, every_spot, extent, marks_in, merged
from judge.topics.circles.picture.scene import Scene
from judge.topics.circles.picture.spots import Spot
from judge.topics.circles.picture.strokes import circles, pieces, straight
from judge.topics.circles.picture.whole import scale_bar, whole_frame

_CLOSE = Fraction(1, 50)  # what is closer than this share of the window cannot be seen at true scale
_EXACT = Fraction(1, 10**9)  # of e: the scale on which a distance of exactly 0 is shown
_ROOM = Fraction(5, 2)


@dataclass(frozen=True, slots=True)
class _Place:
    """Somewhere that may be worth a lens: how small what it shows is, in the scene's units."""

    size: Fraction
    x: Fraction
    y: Fraction
    title: str
    note: str
    tangency: bool = False


def lens_panel(scene: Scene) -> Panel | None:
    """The lens, or None where nothing is too small to be seen at true scale."""
    window = whole_frame(scene).unit
    place = _error(scene, window) or _closest(scene, window) or _small(scene, window)
    if place is None:
        return None
    unit = (place.size or extent(scene) * _EXACT) * _ROOM
    if place.tangency and scene.line.r > 4 * unit:
        return _stretched(scene, place, unit)
    frame = Frame(place.x, place.y, unit)
    strokes = (*circles(frame, scene), *straight(frame, scene))
    bar = scale_bar(frame, scene, of_extent=True)
    marks = marks_in(frame, scene, beyond=False)
    return Panel(_magnified(place.title, window / unit), strokes, marks, (bar,), place.note)


def _magnified(title: str, factor: Fraction) -> str:
    return f"Lens: {title}, × {short(factor)}"


def _error(scene: Scene, window: Fraction) -> _Place | None:
    """The worst of the given points that are nearly, but not quite, the wanted ones, each in its turn."""
    if scene.arrows or not scene.given or len(scene.given) != len(scene.wanted):
        return None
    errors = [_apart(got, wanted) for got, wanted in zip(scene.given, scene.wanted, strict=True)]
    worst = max(errors)
    crossed = max(map(_apart, scene.given, reversed(scene.wanted)))
    if not 0 < worst <= 4 * _CLOSE * window or crossed < worst:
        return None
    got = scene.given[errors.index(worst)]
    note = f"{got.text} is {short(worst / extent(scene))} e from where it should be"
    return _Place(worst, rounded_exact(got.x), rounded_exact(got.y), "the answer's error", note)


def _apart(got: Spot, wanted: Spot) -> Fraction:
    return length(rounded_exact(got.x) - wanted.x, rounded_exact(got.y) - wanted.y)


def rounded_exact(value: Fraction | Surd) -> Fraction:
    """A given coordinate, which is rational."""
    if isinstance(value, Surd):
        return Fraction(value.p, value.s)
    return value


def _closest(scene: Scene, window: Fraction) -> _Place | None:
    """The nearest approach of line and circle, or of an end and the circle: the closer of them."""
    places = [*_tangency(scene), *_ends(scene)]
    close = [place for place in places if place.size <= _CLOSE * window]
    return min(close, key=lambda place: place.size, default=None)


def _tangency(scene: Scene) -> list[_Place]:
    if not scene.line.a:
        return []
    fx, fy = scene.foot
    size = abs(rounded(scene.gap))
    return [_Place(size, fx, fy, "nearest approach", gap_words(scene), tangency=True)]


def gap_words(scene: Scene) -> str:
    """Where the line, or the one point A == B, runs relative to the circle."""
    if scene.pair:
        return pair_words(scene.pair)
    line, gap = scene.line, scene.gap
    what = "the line" if line.a else ("O" if scene.part.of_ray else "the point")
    side = gap.sign()
    if scene.part in (Part.FOOT, Part.NORMAL):
        away = f"is {short(abs(gap) / extent(scene))} e from" if side else "runs through" if line.a else "is"
        return f"{what} {away} {scene.centre}"
    if not side:
        if not line.r:
            return f"{what} is exactly on the circle's one point" if line.a else f"{what} is exactly on C"
        return f"{what} is exactly tangent" if line.a else f"{what} is exactly on the circle"
    share = short(abs(gap) / extent(scene))
    if not line.r:
        return f"{what} is {share} e from the circle's one point"
    if line.a:
        return f"{what} cuts {share} e deep" if side < 0 else f"{what} passes {share} e outside"
    return f"{what} is {share} e {'inside' if side < 0 else 'outside'} the circle"


def _ends(scene: Scene) -> list[_Place]:
    line = scene.line
    if scene.pair:
        return [_touch(scene.pair)]
    ends: tuple[tuple[tuple[int, int], str], ...] = ()
    if scene.part is Part.SEGMENT:
        ends = (scene.start, "A"), (scene.end, "B")
    elif scene.part.of_ray or scene.part.of_point:
        ends = ((scene.start, "O" if scene.part.of_ray else "P"),)
    places = []
    for (x, y), name in ends if line.a else ends[:1]:
        square = (x - line.cx) ** 2 + (y - line.cy) ** 2
        away = Surd(-line.r, 1, square, 1)
        share = short(abs(away) / extent(scene))
        side = away.sign()
        where = (
            f"{share} e {'outside' if side > 0 else 'inside'} the circle" if side else "exactly on the circle"
        )
        label = "A = B" if scene.part is Part.SEGMENT and not line.a else name
        note = f"{label} is {where}"
        places.append(_Place(abs(rounded(away)), Fraction(x), Fraction(y), f"{label} and the circle", note))
    return places


def _touch(pair: CirclePair) -> _Place:
    size = abs(rounded(nearest_touch(pair)[0]))
    x, y = (rounded_near_foot(each, Fraction(0), Fraction(1)) for each in touching_place(pair))
    return _Place(size, x, y, "where they come closest", pair_words(pair))


def _small(scene: Scene, window: Fraction) -> _Place | None:
    """The circle or the segment where it is but a dot at true scale."""
    line = scene.line
    if line.r and line.r < _CLOSE * window:
        return _Place(Fraction(line.r), Fraction(line.cx), Fraction(line.cy), "the circle", gap_words(scene))
    if scene.part is not Part.SEGMENT or not line.a:
        return None
    size = root(Fraction(line.a))
    if size >= 2 * _CLOSE * window:
        return None
    x, y = line.ax + Fraction(line.dx, 2), line.ay + Fraction(line.dy, 2)
    return _Place(size / 2, x, y, "the segment", f"A and B are {short(size / extent(scene))} e apart")


# -- the stretched lens ------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Stretch:
    """A frame turned so that the line runs level, left to right: `across` and `along` are its two units.

    `side` is +1 where the centre is above the line, -1 below; `middle` is the height of the panel's centre.
    """

    scene: Scene
    across: Fraction
    along: Fraction
    side: int
    middle: float

    def place(self, spot: Spot) -> Dot:
        """A point in the panel."""
        line = self.scene.line
        fx, fy = self.scene.foot
        x, y = rounded_near_foot(spot.x, fx, self.along), rounded_near_foot(spot.y, fy, self.along)
        v = over_root((x * line.dx + y * line.dy) / self.along, line.a)
        n = self._height(spot)
        return v, n - self.middle

    def _height(self, spot: Spot) -> float:
        """How far above the line a point is; a wanted one is an end of the chord, on the line."""
        if isinstance(spot.x, Surd) or isinstance(spot.y, Surd):
            return 0.0
        line = self.scene.line
        cross = line.dx * (spot.y - line.ay) - line.dy * (spot.x - line.ax)
        return over_root(cross / self.across, line.a)

    def circle(self) -> tuple[Stroke, ...]:
        """The arc next to the line, and faintly the disc behind it."""
        line = self.scene.line
        gap = near(self.scene.gap / self.across)
        bend = near(self.along * self.along / (self.across * line.r))
        flat = near(self.along / line.r)
        dots = []
        for step in range(-48, 49):
            v = step / 40
            rise = bend * v * v / (1 + sqrt(1 - (flat * v) ** 2))
            dots.append((v, self.side * (gap + rise) - self.middle))
        (x1, _), (x2, _) = dots[0], dots[-1]
        depth = self.side * 9.0
        area = polygon((*dots, (x2, depth), (x1, depth)))
        fill = (Stroke(area, Role.SHAPE, filled=True),) if area else ()
        return (*fill, *(Stroke(part, Role.SHAPE) for part in polyline(dots)))

    def straight(self) -> tuple[Stroke, ...]:
        """The line, level, as far as the figure has any."""
        line = self.scene.line
        start = over_root(line.b / self.along, line.a)
        end = over_root((line.b + line.a) / self.along, line.a)
        return pieces(self.scene.part, (0.0, -self.middle), (1.0, 0.0), start, end)

    def band(self) -> tuple[Stroke, ...]:
        """Where the circle's edge may be for the line to count as tangent."""
        half = near(self.scene.snap * extent(self.scene) / self.across)
        if not 0.02 <= half <= 20:
            return ()
        low, high = -half - self.middle, half - self.middle
        area = polygon(((-1.0, low), (1.0, low), (1.0, high), (-1.0, high)))
        return (Stroke(area, Role.BAND, filled=True),) if area else ()


def rounded_near_foot(value: Fraction | Surd, foot: Fraction, unit: Fraction) -> Fraction:
    """A coordinate relative to the foot, near enough for a panel of that unit."""
    return Fraction(Surd.of((value - foot) / unit).decimal(8)) * unit


def _stretched(scene: Scene, place: _Place, across: Fraction) -> Panel:
    line = scene.line
    along = root(2 * line.r * across)
    side = -1 if line.k > 0 else 1
    middle = side * near(scene.gap / across) / 2
    lens = _Stretch(scene, across, along, side, middle)
    found: list[Mark] = []
    for spot, role in every_spot(scene):
        at = lens.place(spot)
        if inside(at):
            found.append(Mark(at, role, spot.text))
        elif role is Role.GOT and not scene.crowded:
            fx, fy = scene.foot
            size = hypot(*at)
            away = distance(scene, length(spot.x - fx, spot.y - fy), in_extents=True)
            found.append(at_edge((at[0] / size, at[1] / size), role, f"{spot.text}, {away}"))
    e = extent(scene)
    bars = (_bar(across / e, "across", upright=True), _bar(along / e, "along"))
    note = place.note
    band = lens.band()
    if band:
        note += "; shaded: the band"
    title = f"Lens: {place.title}, × {short(whole_frame(scene).unit / across)} across"
    return Panel(title, (*band, *lens.circle(), *lens.straight()), merged(found), bars, note)


def _bar(unit: Fraction, way: str, *, upright: bool = False) -> Bar:
    size = round_below(unit / 2)
    return Bar(float(size / unit), f"{short(size)} e {way}", upright)
