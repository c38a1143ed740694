"""A circle that moves from frame to frame, and a line that stands: whether they meet, shown without flicker.

A case is (circles, O, D, h), a circle a frame. The first frame shows d < r. Later it turns to a hit only
where d < r(1 − h), and to a miss only where d > r(1 + h); within the band a threshold counts as not passed.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import hypot, sqrt
from typing import TYPE_CHECKING

from msgspec import Struct

from judge.exact.dyadic import integers
from judge.exact.surd import Surd
from judge.problem import Case, Problem
from judge.problem.model import Number, Point
from judge.problem.topic import Shown, Topic
from judge.topics.circles.bands import Bands

if TYPE_CHECKING:
    from judge.drawing import Picture

_CERTAIN = 1e-6  # of the extent: far more than what is rounded in a double, and than any band here
_DIGITS = (1, 2, 3, 5)


class Frame(Struct, frozen=True):
    """One circle beside the line, in integers: `reach` is (D × f)²·a, so d is √reach/a.

    `x` and `y` are |O − C|, and the extent is the largest of them and r. `away` and `size` are doubles near
    d and r in extents: each is off by less than 1e-14, so that they decide what is not nearly the same.
    """

    radius: int
    x: int
    y: int
    reach: int
    a: int
    shift: int  # a length of 1 is 2**shift
    away: float
    size: float

    @property
    def extent(self) -> int:
        """The frame's own size e."""
        return max(self.radius, self.x, self.y)

    def beside(self, bands: Bands, share: Fraction) -> int:
        """Whether d is less than that share of r (-1), more (1), or the same within the band (0)."""
        about = self.away - float(share) * self.size
        if abs(about) > _CERTAIN:
            return 1 if about > 0 else -1
        return bands.beside(*self._compared(share))

    def forbids(self, bands: Bands, share: Fraction) -> bool:
        """Whether d is nearly that share of r, inside the forbidden band."""
        if abs(self.away - float(share) * self.size) > _CERTAIN:
            return False
        return bands.forbids(*self._compared(share))

    def gap(self, share: Fraction) -> Surd:
        """d less that share of r, in extents."""
        square, radius, extent = self._compared(share)
        return Surd(-radius, 1, square, extent)

    def _compared(self, share: Fraction) -> tuple[int, int, int]:
        n, m = share.numerator, share.denominator
        return self.reach * m * m, self.radius * n * self.a, self.extent * m * self.a


def frames_of(circles: Sequence[tuple[Number, Number, Number]], origin: Point, way: Point) -> list[Frame]:
    """Each circle and the line O + t·D. Raises ValueError for nan, infinities and a radius below 0."""
    numbers, shift = integers(*origin, *way, *(value for circle in circles for value in circle))
    ox, oy, dx, dy = numbers[:4]
    a, found = dx * dx + dy * dy, []
    length = sqrt(a)
    for x, y, radius in zip(*(numbers[at::3] for at in (4, 5, 6)), strict=True):
        if radius < 0:
            raise ValueError("a radius is negative")
        fx, fy = ox - x, oy - y
        k, extent = dx * fy - dy * fx, max(radius, abs(fx), abs(fy))
        known = a and extent  # else the doubles are 0 and decide nothing
        away, size = (abs(k) / extent / length, radius / extent) if known else (0.0, 0.0)
        found.append(Frame(radius, abs(fx), abs(fy), k * k * a, a, shift, away, size))
    return found


def _narrow(bands: Bands) -> None:
    if bands.clear * 2 > Fraction(_CERTAIN):
        raise ValueError("the bands are wider than what doubles leave to be decided exactly")


def thresholds(h: Number) -> tuple[Fraction, Fraction]:
    """1 − h and 1 + h, exactly."""
    share = Fraction(h)
    return 1 - share, 1 + share


def steady(frames: Sequence[Frame], h: Number, bands: Bands) -> list[int]:
    """1 or 0 for each frame."""
    _narrow(bands)
    low, high = thresholds(h)
    shown = [int(frames[0].beside(bands, Fraction(1)) < 0)]
    for frame in frames[1:]:
        if shown[-1]:
            shown.append(int(frame.beside(bands, high) <= 0))
        else:
            shown.append(int(frame.beside(bands, low) < 0))
    return shown


def broken(frames: Sequence[Frame], h: Number, bands: Bands) -> str | None:
    """What of the promise the case breaks: a line, a clear first frame, no threshold nearly passed."""
    _narrow(bands)
    if not frames[0].a:
        return "D is (0, 0), and there is no line"
    if frames[0].beside(bands, Fraction(1)) == 0 or frames[0].forbids(bands, Fraction(1)):
        return "the circle of the first frame is touched, or nearly so"
    shares = thresholds(h)
    for place, frame in enumerate(frames[1:], 1):
        if any(frame.forbids(bands, share) for share in shares):
            return f"in frame {place + 1} the distance less a threshold is inside the forbidden band"
    return None


# -- the topic ---------------------------------------------------------------------------------------------


def _simpler(_problem: Problem, case: Case) -> Iterator[Case]:
    """The line level through the origin, each circle straight above it; at its own size and about 1."""
    circles, origin, way, h = case
    size = hypot(*way)
    if not size:
        return
    laid = []
    for x, y, radius in circles:
        away = abs(way[0] * (origin[1] - y) - way[1] * (origin[0] - x)) / size
        laid.append((away, radius))
    unit = laid[0][1] or 1
    for scale in (unit, 1):
        for digits in _DIGITS:
            above = tuple(
                (0, _few(away / scale, digits), _few(radius / scale, digits)) for away, radius in laid
            )
            yield above, (0, 0), (1, 0), _few(h, min(digits, 2))
            yield above, (0, 0), (1, 0), h
    yield tuple((0, away, radius) for away, radius in laid), (0, 0), (1, 0), h


def _few(value: Number, digits: int) -> Number:
    short = float(f"{value:.{digits}g}")
    return int(short) if short.is_integer() else short


def _special(case: Case) -> int:
    """How many circles are points, and how many there are twice."""
    circles = case[0]
    points = sum(1 for circle in circles if circle[2] == 0)
    return points + len(circles) - len(set(circles))


def _picture(shown: Shown) -> Picture | None:
    from judge.topics.circles.picture.strip import strip  # late: most problems are loaded to be judged

    return strip(shown)


FRAMES = Topic(simpler=_simpler, special=_special, picture=_picture)
