"""Many circles in whole numbers, and which of them a ray meets first.

A grid of cells leads a ray to the circles that may be first. Doubles with a wide margin sort out nearly all
of them; what they leave is decided in integers. e is the scene's extent as seen from the ray's origin O: the
largest of all r, |Ox − cx| and |Oy − cy|.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import inf, sqrt

from msgspec import Struct
from msgspec.structs import replace

from judge.exact.signs import two_root_sign
from judge.exact.surd import Surd
from judge.topics.circles.bands import Bands
from judge.topics.circles.line import CircleLine
from judge.values import AnyOf, Exact, Real

IntCircle = tuple[int, int, int]
IntPoint = tuple[int, int]

_MARGIN = 4e-7  # of e: wider than the promise's band, and far wider than what doubles lose
_CELLS = 1.5  # side of a cell, in places that a circle has on average
_EDGE = 0.02  # of a cell: what a circle is grown by, so that the walk may round,
_REACH = 1.0  # and more than any margin with coordinates up to 2**20


class Sight(Struct, frozen=True):
    """What doubles say of a ray: the circles that may be met first, by index.

    `sure` is -1 or +1 where the only one of them is met clearly, at that root; 0 where integers must decide.
    """

    near: tuple[int, ...]
    sure: int = 0

    @property
    def clear(self) -> bool:
        """Whether the answer is beyond doubt, and far from where it turns."""
        return not self.near or self.sure != 0


_NOTHING = Sight(())


class Cells:
    """Circles (x, y, r) in ints, at least one, sorted into square cells."""

    def __init__(self, circles: Sequence[IntCircle]) -> None:
        self.circles = circles
        xs, ys, rs = zip(*circles, strict=True)
        self._box: tuple[int, ...] = min(xs), max(xs), min(ys), max(ys), max(rs)
        left, right = (sign * max(sign * x + r for x, _, r in circles) for sign in (-1, 1))
        low, high = (sign * max(sign * y + r for _, y, r in circles) for sign in (-1, 1))
        wide, tall = right - left + 1, high - low + 1
        self._side = side = max(1.0, _CELLS * sqrt(wide * tall / len(circles)), max(wide, tall) / 2000)
        self._grown = grown = _EDGE * side + _REACH
        self._left, self._low = left - grown, low - grown
        self._columns = int((wide + 2 * grown) / side) + 1
        self._rows = int((tall + 2 * grown) / side) + 1
        self._cells: dict[tuple[int, int], list[int]] = {}
        for index, circle in enumerate(circles):
            for cell in self._under(circle):
                self._cells.setdefault(cell, []).append(index)

    def extent(self, origin: IntPoint) -> int:
        """e, as seen from there."""
        least_x, most_x, least_y, most_y, most_r = self._box
        x, y = origin
        return max(most_r, x - least_x, most_x - x, y - least_y, most_y - y)

    def first(self, origin: IntPoint, direction: IntPoint, bands: Bands) -> tuple[Exact, str | None]:
        """(index, t) of the circle met first at t >= 0, any of those that tie, or None; what is broken."""
        sight = self.sight(origin, direction)
        if not sight.near:
            return None, None
        extent = self.extent(origin)
        unit = Fraction(extent, max(map(abs, direction)))
        if sight.sure:
            index = sight.near[0]
            return (index, Real(self._line(index, origin, direction).root(sight.sure), unit)), None
        return self._decided(sight.near, origin, direction, extent, unit, bands)

    def sight(self, origin: IntPoint, direction: IntPoint) -> Sight:
        """What doubles say. Coordinates up to 2**20 and D up to 2**20: the products below are exact."""
        (ox, oy), (dx, dy) = origin, direction
        margin = _MARGIN * self.extent(origin)
        length = sqrt(dx * dx + dy * dy)
        circles, found, seen = self.circles, [], set()
        bound = inf  # up to which nothing beyond it can be first
        for cell, left in self._walk(ox, oy, dx, dy):
            for index in cell:
                if index in seen:
                    continue
                seen.add(index)
                x, y, r = circles[index]
                fx, fy = x - ox, y - oy
                away = abs(dx * fy - dy * fx) / length - r
                if away > margin:
                    continue
                middle = (dx * fx + dy * fy) / length
                if away < -margin:  # half is right to 1e-9 of itself at least
                    half = sqrt(-away * (away + r + r))
                    if middle - half > margin:
                        at, which = middle - half, -1
                    elif middle - half < -margin and middle + half > margin:
                        at, which = middle + half, 1
                    elif middle + half < -margin:
                        continue
                    else:
                        at, which = 0.0, 0
                else:
                    half = sqrt((r + margin) ** 2 - (away + r) ** 2 if away + r < r + margin else 0.0)
                    if middle + half < -margin:
                        continue
                    at, which = max(0.0, middle - half), 0
                found.append((at, index, which))
                if which and at < bound:
                    bound = at + margin
            if bound < left * length - self._grown:
                break
        near = [each for each in found if each[0] <= bound]
        if not near:
            return _NOTHING
        return Sight(tuple(sorted(index for _, index, _ in near)), near[0][2] if len(near) == 1 else 0)

    def _decided(
        self,
        near: Sequence[int],
        origin: IntPoint,
        direction: IntPoint,
        extent: int,
        unit: Fraction,
        bands: Bands,
    ) -> tuple[Exact, str | None]:
        """The same among these few, in integers."""
        hits, broken = [], None
        for index in near:
            line = replace(self._line(index, origin, direction), extent=extent)
            broken = broken or bands.broken_ray(line)
            t = bands.ray(line)
            if t is not None:
                hits.append((t, index))
        if not hits:
            return None, broken
        best = min(t for t, _ in hits)
        answers = []
        for t, index in hits:
            if _within(t, best, bands.snap * unit):
                answers.append((index, Real(t, unit)))
            elif _within(t, best, bands.clear * unit, strictly=True):
                broken = broken or "two circles are met nearly at once, inside the forbidden band"
        return answers[0] if len(answers) == 1 else AnyOf(answers), broken

    def _line(self, index: int, origin: IntPoint, direction: IntPoint) -> CircleLine:
        return CircleLine.ray(*self.circles[index], origin, direction)

    # -- the grid ------------------------------------------------------------------------------------

    def _under(self, circle: IntCircle) -> Iterator[tuple[int, int]]:
        """The cells that the disc reaches, one row of them by another."""
        x, y, r = circle
        side, reach = self._side, r + self._grown
        first, last = int((x - reach - self._left) / side), int((x + reach - self._left) / side)
        for row in range(int((y - reach - self._low) / side), int((y + reach - self._low) / side) + 1):
            if last - first < 2:
                for column in range(first, last + 1):
                    yield column, row
                continue
            bottom = self._low + row * side
            off = max(0.0, bottom - y, y - bottom - side)
            if off > reach:
                continue
            half = sqrt((reach - off) * (reach + off))
            ends = int((x - half - self._left) / side), int((x + half - self._left) / side)
            for column in range(max(first, ends[0] - 1), min(last, ends[1] + 1) + 1):
                yield column, row

    def _walk(self, ox: int, oy: int, dx: int, dy: int) -> Iterator[tuple[Sequence[int], float]]:
        """The circles of each cell along the ray, and the t at which it leaves that cell."""
        side, low, high = self._side, 0.0, inf
        for o, d, least, count in ((ox, dx, self._left, self._columns), (oy, dy, self._low, self._rows)):
            start, end = least - self._grown, least + count * side + self._grown
            if d:
                near, far = (start - o) / d, (end - o) / d
                low, high = max(low, min(near, far)), min(high, max(near, far))
            elif not start <= o <= end:
                return
        if low > high:
            return
        column, row = int((ox + low * dx - self._left) // side), int((oy + low * dy - self._low) // side)
        right, up = (1 if dx > 0 else -1), (1 if dy > 0 else -1)
        to_column = (self._left + (column + (dx > 0)) * side - ox) / dx if dx else inf
        to_row = (self._low + (row + (dy > 0)) * side - oy) / dy if dy else inf
        per_column, per_row = side / abs(dx) if dx else inf, side / abs(dy) if dy else inf
        cells, columns, rows = self._cells, self._columns + 1, self._rows + 1
        while -1 <= column <= columns and -1 <= row <= rows:
            leaves = min(to_column, to_row)
            found = cells.get((column, row))
            if found:
                yield found, leaves
            if to_column < to_row:
                column, to_column = column + right, to_column + per_column
            else:
                row, to_row = row + up, to_row + per_row


def _within(t: Surd, other: Surd, bound: Fraction, *, strictly: bool = False) -> bool:
    """Whether |t − other| is <= (or <) bound."""
    n, m, s = bound.numerator, bound.denominator, t.s * other.s
    p, q, u = (t.p * other.s - other.p * t.s) * m, t.q * other.s * m, -other.q * t.s * m
    signs = [two_root_sign(n * s - side * p, -side * q, t.d, -side * u, other.d) for side in (1, -1)]
    return min(signs) > 0 if strictly else min(signs) >= 0
