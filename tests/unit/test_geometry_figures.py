"""Each answer of a figure against the formula of a school book, in Fractions and decimals of 80 digits."""

from __future__ import annotations

from decimal import Decimal, getcontext
from fractions import Fraction
from random import Random

import pytest

from judge.exact import Surd
from judge.geometry import Lie, Line, Pair, Sphere
from judge.problem.declare import InvalidCase

CLOSE = Decimal(10) ** -60  # relative to the size


@pytest.fixture(autouse=True)
def eighty_digits(monkeypatch):
    monkeypatch.setattr(getcontext(), "prec", 80)


def number(x) -> Decimal:
    if isinstance(x, Surd):
        return (x.p + x.q * Decimal(x.d).sqrt()) / x.s
    return Decimal(x.numerator) / x.denominator if isinstance(x, Fraction) else Decimal(x)


def same(answer, wanted, size) -> None:
    """The answer's numbers are those wanted, all with a unit of the size's."""
    assert len(answer) == len(wanted)
    for real, value in zip(answer, wanted, strict=True):
        assert abs(number(real.x) - value) <= CLOSE * (abs(value) + number(size))


class Plain:
    """A circle and f + t·D about its centre, by the usual quadratic formula, in any dimension."""

    def __init__(self, centre, r, start, direction):
        self.c = [Fraction(x) for x in centre]
        self.r = Fraction(r)
        self.d = [Fraction(x) for x in direction]
        self.f = [Fraction(x) - c for x, c in zip(start, self.c, strict=True)]
        self.a = sum(x * x for x in self.d)
        self.b = sum(x * y for x, y in zip(self.f, self.d, strict=True))
        self.c2 = sum(x * x for x in self.f) - self.r**2
        self.delta = self.b**2 - self.a * self.c2
        self.t = []
        if self.a and self.delta == 0:
            self.t = [number(-self.b / self.a)]
        elif self.a and self.delta > 0:
            root = number(self.delta).sqrt()
            self.t = [(number(-self.b) + sign * root) / number(self.a) for sign in (-1, 1)]

    def at(self, t) -> list[Decimal]:
        return [
            number(c) + number(f) + t * number(d)
            for c, f, d in zip(self.c, self.f, self.d, strict=True)
        ]  # fmt: skip

    def normal(self, t) -> list[Decimal]:
        return [(x - number(c)) / number(self.r) for x, c in zip(self.at(t), self.c, strict=True)]


def grids(seed: int, count: int, width: int, most: int = 4):
    """Tuples of small whole numbers, the third of which is not negative."""
    random = Random(seed)
    for _ in range(count):
        numbers = [random.randint(-most, most) for _ in range(width)]
        numbers[2] = abs(numbers[2])
        yield tuple(numbers)


def doubles(seed: int, count: int, width: int):
    """Tuples of doubles to 100, the third of which is not negative; some with a unit of 1e-25."""
    random = Random(seed)
    for _ in range(count):
        scale = random.choice((1.0, 2.0**-83, 2.0**20))
        numbers = [random.uniform(-100, 100) * scale for _ in range(width)]
        numbers[2] = abs(numbers[2])
        yield tuple(numbers)


SEVENS = [*grids(1, 1000, 7), *grids(12, 1000, 7, most=1), *doubles(2, 300, 7)]


# -- a circle and a line -----------------------------------------------------------------------------


def test_a_line_meets_a_circle_where_the_quadratic_formula_says():
    counts = set()
    for cx, cy, r, ax, ay, bx, by in SEVENS:
        line = Line.through(cx, cy, r, (ax, ay), (bx, by))
        plain = Plain((cx, cy), r, (ax, ay), (Fraction(bx) - Fraction(ax), Fraction(by) - Fraction(ay)))
        size = max(map(abs, (*plain.f, plain.f[0] + plain.d[0], plain.f[1] + plain.d[1], plain.r)))
        counts.add(line.count())
        if not plain.a:
            assert (line.count(), line.points(), line.chord()) == (None, None, None)
            continue
        assert line.count() == len(plain.t)
        points = line.points()
        assert len(points) == len(plain.t)
        for point, t in zip(points, plain.t, strict=True):
            same(point, plain.at(t), size)
            assert {real.unit for real in point} == {size}
        chord = line.chord()
        if plain.t:
            same([chord], [(plain.t[-1] - plain.t[0]) * number(plain.a).sqrt()], size)
            assert chord.unit == size
        else:
            assert chord is None
    assert counts == {None, 0, 1, 2}


def test_a_segment_keeps_the_points_between_its_ends():
    kept = set()
    for cx, cy, r, ax, ay, bx, by in SEVENS:
        line = Line.through(cx, cy, r, (ax, ay), (bx, by))
        plain = Plain((cx, cy), r, (ax, ay), (Fraction(bx) - Fraction(ax), Fraction(by) - Fraction(ay)))
        wanted = [plain.at(t) for t in plain.t if -CLOSE <= t <= 1 + CLOSE]
        if not plain.a:
            wanted = [[number(ax), number(ay)]] if plain.c2 == 0 else []
        found = [line.real_point(which) for which in line.within()]
        assert len(found) == len(wanted)
        for point, place in zip(found, wanted, strict=True):
            same(point, place, line.unit())
        kept.add((plain.a == 0, len(found)))
    assert kept == {(False, 0), (False, 1), (False, 2), (True, 0), (True, 1)}


def test_the_foot_the_distance_and_the_normal_form():
    for cx, cy, _, ax, ay, bx, by in SEVENS:
        line = Line.through(cx, cy, 0, (ax, ay), (bx, by))
        plain = Plain((cx, cy), 0, (ax, ay), (Fraction(bx) - Fraction(ax), Fraction(by) - Fraction(ay)))
        if not plain.a:
            assert (line.foot(), line.distance(), line.normal_form()) == (None, None, None)
            continue
        (dx, dy), size = plain.d, line.unit()
        t, place = line.foot()
        assert Fraction(t.x.p, t.x.s) == -plain.b / plain.a
        assert t.unit == size / max(abs(dx), abs(dy))
        same(place, plain.at(number(-plain.b / plain.a)), size)
        length = number(plain.a).sqrt()
        height = number(plain.f[0] * dy - plain.f[1] * dx) / length  # f × D: above 0 where C is on the left
        same([line.distance()], [abs(height)], size)
        a, b, c = line.normal_form()
        same([a, b], [-number(dy) / length, number(dx) / length], 1)
        same([c], [height], size)
        assert (a.unit, b.unit, c.unit, line.distance().unit) == (1, 1, size, size)


# -- a ray -------------------------------------------------------------------------------------------


def test_a_ray_stops_at_the_first_point_faces_its_normal_and_is_reflected():
    seen = set()
    for cx, cy, r, ox, oy, dx, dy in SEVENS:
        line, plain = Line.ray(cx, cy, r, (ox, oy), (dx, dy)), Plain((cx, cy), r, (ox, oy), (dx, dy))
        t = next((t for t in plain.t if t >= -CLOSE), None)
        which = line.first()
        assert (which is None) == (t is None)
        if which is not None:
            seen.add(which)
            same([line.time(which)], [t], 1)
            assert line.time(which).unit == line.unit() / Fraction(max(abs(dx), abs(dy)))
            assert plain.c2 or line.time(which).x == 0
        try:
            hit = line.hit()
        except InvalidCase:
            assert 0 < r < max(map(abs, plain.f)) / 10_000
            continue
        assert hit == (which if r else None)
        if hit is None:
            continue
        normal = plain.normal(t)
        along = sum(x * number(d) for x, d in zip(normal, plain.d, strict=True))
        same(line.normal(hit), normal, 1)
        same(line.facing(hit), [-x for x in normal] if along > CLOSE * line.step() else normal, 1)
        away = [number(d) - 2 * along * x for x, d in zip(normal, plain.d, strict=True)]
        same(line.reflected(hit), away, max(abs(dx), abs(dy)))
        assert {part.unit for part in line.facing(hit)} == {line.unit() / Fraction(r)}
        unit = line.unit() / Fraction(r) * Fraction(max(abs(dx), abs(dy)))
        assert {part.unit for part in line.reflected(hit)} == {unit}
    assert seen == {-1, 0, 1}


def test_a_ray_in_space_meets_a_sphere():
    random, seen = Random(3), set()
    for i in range(1500):
        centre, origin, direction = (tuple(random.randint(-3, 3) for _ in range(3)) for _ in range(3))
        r = random.randint(0, 4)
        if i % 3 == 0:
            centre, r = tuple(x / 2**90 for x in centre), r / 2**90
            origin = tuple(x / 2**90 for x in origin)
        sphere, plain = Sphere(centre, r, origin, direction), Plain(centre, r, origin, direction)
        t = next((t for t in plain.t if t >= -CLOSE), None) if r else None
        hit = sphere.hit()
        assert (hit is None) == (t is None)
        seen.add(hit)
        if hit is not None:
            same([sphere.time(hit)], [t], 1)
            normal = plain.normal(t)
            along = sum(x * number(d) for x, d in zip(normal, plain.d, strict=True))
            same(sphere.facing(hit), [-x for x in normal] if along > CLOSE else normal, 1)
            size = max(plain.r, *map(abs, plain.f))
            assert sphere.time(hit).unit == size / max(map(abs, direction))
            assert {part.unit for part in sphere.facing(hit)} == {size / plain.r}
    assert seen == {None, -1, 0, 1}


def test_a_point_is_beside_a_circle_and_tangents_touch_it():
    counts = set()
    for cx, cy, r, px, py in [*grids(4, 800, 5), *doubles(5, 200, 5)]:
        point = Line.point(cx, cy, r, (px, py))
        plain = Plain((cx, cy), r, (px, py), (0, 0))
        assert point.side() == (plain.c2 > 0) - (plain.c2 < 0)
        try:
            found = point.tangents()
        except InvalidCase:
            assert 0 < r < max(map(abs, plain.f)) / 10_000
            continue
        counts.add((r == 0, len(found)))
        if r == 0:
            same(found[0], [number(cx), number(cy)], point.unit())
        elif plain.c2 <= 0:
            assert [[part.x for part in place] for place in found] == [[px, py]] * (plain.c2 == 0)
        else:
            sides = []
            for place in found:
                x, y = (number(part.x) - number(c) for part, c in zip(place, (cx, cy), strict=True))
                fx, fy = map(number, plain.f)
                scale = number(point.unit()) ** 2
                assert abs(x * x + y * y - number(plain.r) ** 2) <= CLOSE * scale  # on the circle
                assert abs(x * (x - fx) + y * (y - fy)) <= CLOSE * scale  # at right angles to the way to P
                sides.append(-fx * (y - fy) + fy * (x - fx))  # (C − P) × (T − P): above 0 on the left
            assert sides[0] > 0 > sides[1]
    assert counts == {(True, 1), (False, 0), (False, 1), (False, 2)}


# -- two circles -------------------------------------------------------------------------------------


def lie_of(square, r1, r2) -> Lie:
    """By the distance's square, which is a whole number."""
    if square == 0 and r1 == r2:
        return Lie.SAME if r1 else Lie.POINT
    for bound, beyond, at in ((r1 + r2, Lie.APART, Lie.OUTER), (abs(r1 - r2), Lie.CROSSING, Lie.INNER)):
        if square >= bound**2:
            return beyond if square > bound**2 else at
    return Lie.INSIDE


def test_two_circles_lie_and_meet_as_their_equations_say():
    seen = set()
    for cx1, cy1, r1, cx2, cy2, r2 in (*grids(6, 2000, 6), *grids(13, 500, 6, most=1)):
        r2 = abs(r2)
        pair, square = Pair(cx1, cy1, r1, cx2, cy2, r2), (cx2 - cx1) ** 2 + (cy2 - cy1) ** 2
        lie = lie_of(square, r1, r2)
        seen.add(lie)
        assert pair.lie() is lie
        points = pair.points()
        if lie is Lie.SAME:
            assert points is None
            continue
        count = {Lie.CROSSING: 2, Lie.OUTER: 1, Lie.INNER: 1, Lie.POINT: 1}.get(lie, 0)
        assert len(points) == count
        sides = []
        for place in points:
            x, y = (number(part.x) for part in place)
            assert abs((x - cx1) ** 2 + (y - cy1) ** 2 - r1 * r1) < CLOSE
            assert abs((x - cx2) ** 2 + (y - cy2) ** 2 - r2 * r2) < CLOSE
            sides.append((cx2 - cx1) * (y - cy1) - (cy2 - cy1) * (x - cx1))
            assert {part.unit for part in place} == {max(r1, r2, abs(cx2 - cx1), abs(cy2 - cy1))}
        assert count < 2 or sides[0] > 0 > sides[1]
    assert seen == set(Lie)


def test_common_tangents_touch_both_circles_outer_ones_first():
    counts = set()
    for cx1, cy1, r1, cx2, cy2, r2 in grids(7, 2000, 6):
        r2, pair = abs(r2), Pair(cx1, cy1, r1, cx2, cy2, abs(r2))
        dx, dy = cx2 - cx1, cy2 - cy1
        square = dx * dx + dy * dy
        if 0 in (square, r1, r2):
            with pytest.raises(InvalidCase, match=r"is 0·e. It must be at least 1e-3·e"):
                pair.tangents()
            continue
        found, wanted = pair.tangents(), []
        for reach in (r1 - r2, r1 + r2):
            over = square - reach * reach
            wanted += [(reach, side) for side in ((1, -1) if over > 0 else (0,) if over == 0 else ())]
        counts.add(len(wanted))
        assert len(found) == len(wanted)
        for place, (reach, side) in zip(found, wanted, strict=True):
            nx, ny = ((number(part.x) - c) / r1 for part, c in zip(place, (cx1, cy1), strict=True))
            assert abs(nx * nx + ny * ny - 1) < CLOSE
            assert abs(nx * dx + ny * dy - reach) < CLOSE  # so the tangent is r2 from C2 too
            across = dx * ny - dy * nx
            assert (across > CLOSE) - (across < -CLOSE) == side
    assert counts == {0, 1, 2, 3, 4}


# -- exact touches, and what is neither exact nor clear ---------------------------------------------


SCALES = (1, 2.0**-84, 2.0**20, 2.0**-20)


@pytest.mark.parametrize("scale", SCALES)
@pytest.mark.parametrize(("p", "q", "n"), [(3, 4, 5), (-5, 12, 13), (8, -15, 17), (697, 696, 985)])
def test_turned_touches_are_exact_at_any_size(p, q, n, scale):
    """The circle of radius n·k and the line that touches at k·(p, q), a ray from there and a point there."""
    k, m = scale, 7 * scale
    place, r = (p * k, q * k), n * k
    a, b = (place[0] - 2 * q * m, place[1] + 2 * p * m), (place[0] + q * m, place[1] - p * m)
    line = Line.through(0, 0, r, a, b)
    assert (line.count(), line.within(), line.chord().x) == (1, [0], 0)
    assert [part.x for part in line.real_point(0)] == list(place)
    assert Line.through(0, 0, r, place, b).within() == [0]
    assert Line.through(0, 0, r, place, place).within() == [0]
    assert Line.point(0, 0, r, place).side() == 0
    ray = Line.ray(0, 0, r, place, (1, -2))
    assert ray.time(ray.first()).x == 0
    touch = Line.ray(0, 0, r, a, (q, -p))
    assert [part.x for part in touch.reflected(touch.hit())] == [q, -p]
    assert [part.x for part in touch.facing(0)] == [Fraction(p, n), Fraction(q, n)]
    for far, lie in ((3, Lie.OUTER), (1, Lie.INNER)):  # circles of radius 2r and r about 0 and far·place
        assert Pair(0, 0, 2 * r, far * place[0], far * place[1], r).lie() is lie
    flat = Sphere((0, 0, 0), r, (*a, 0), (q, -p, 0))
    assert flat.hit() == 0


OFFS = [1e-12, -1e-12, 3e-9, -3e-9, 9e-8, -9e-8]


@pytest.mark.parametrize("scale", SCALES)
@pytest.mark.parametrize("off", OFFS)
def test_what_is_nearly_exact_is_no_case(off, scale):
    r, near = scale, scale * (1 + off)
    for ask, text in (
        (lambda: Line.through(0, 0, r, (-r / 2, near), (r, near)).count(), "almost a tangent"),
        (lambda: Line.through(0, 0, r, (-r, near), (r / 4, near)).within(), "almost a tangent"),
        (lambda: Line.through(0, 0, r, (0, near), (r / 2, r / 4)).within(), "A is almost on the circle"),
        (lambda: Line.through(0, 0, r, (r / 2, r / 4), (near, 0)).within(), "B is almost on the circle"),
        (lambda: Line.through(0, 0, r, (near, 0), (near, 0)).within(), "A is almost on the circle"),
        (lambda: Line.point(0, 0, r, (near, 0)).side(), "P is almost on the circle"),
        (lambda: Line.point(0, 0, r, (near, 0)).tangents(), "P is almost on the circle"),
        (lambda: Line.ray(0, 0, r, (near, 0), (1, 2)).first(), "O is almost on the circle"),
        (lambda: Line.ray(0, 0, r, (0, near), (1, 0)).hit(), "O is almost on the circle"),
        (lambda: Sphere((0, 0, 0), r, (0, near, 0), (1, 1, 0)).hit(), "O is almost on the sphere"),
        (lambda: Sphere((0, 0, 0), r, (-r, near, 0), (1, 0, 0)).hit(), "almost a tangent"),
        (lambda: Pair(0, 0, r, 2 * near, 0, r).lie(), "almost touch from outside"),
        (lambda: Pair(0, 0, 2 * near, r, 0, r).tangents(), "almost touch, one inside"),
        (lambda: Pair(0, 0, r, 0, 0, near).points(), "almost the same"),
        (lambda: Pair(0, 0, r, off * r, 0, 2 * r).lie(), "The distance of the centres"),
    ):
        with pytest.raises(InvalidCase, match=text):
            ask()


@pytest.mark.parametrize("scale", SCALES)
@pytest.mark.parametrize("off", [3e-7, -3e-7])
def test_what_is_clear_is_a_case(off, scale):
    r, near, side = scale, scale * (1 + off), 1 if off > 0 else -1
    assert Line.through(0, 0, r, (-r / 2, near), (r, near)).count() == 1 - side
    assert len(Line.through(0, 0, r, (0, near), (r / 2, r / 4)).within()) == (side > 0)
    assert Line.point(0, 0, r, (near, 0)).side() == side
    assert Line.ray(0, 0, r, (near, 0), (1, 0)).first() == (None if side > 0 else 1)
    assert Pair(0, 0, r, 2 * near, 0, r).lie() is (Lie.APART if side > 0 else Lie.CROSSING)


def test_ends_do_not_bother_a_count_and_a_direction_not_the_size():
    near = 1 + 1e-11
    assert Line.through(0, 0, 1, (near, 0), (0, 0.5)).count() == 2
    assert Line.through(0, 0, 1, (near, 0), (0, 0.5)).chord() is not None
    for k in (-40, 40):
        ray = Line.ray(0, 0, 1, (-2, 0.5), (2.0**k, 0))
        assert (ray.first(), ray.unit()) == (-1, 2)
        assert ray.time(-1).unit == Fraction(2) / Fraction(2.0**k)


def test_no_line_no_normal_and_small_radii():
    assert Line.ray(0, 0, 5, (3, 4), (0, 0)).first() is None
    assert Line.ray(0, 0, 0, (-2, 0), (1, 0)).first() == 0
    assert Line.ray(0, 0, 0, (-2, 0), (1, 0)).hit() is None
    assert Sphere((0, 0, 0), 0, (-2, 0, 0), (1, 0, 0)).hit() is None
    small = r"The radius is 5e-5·e. It must be 0, or at least 1e-4·e."
    for ask in (
        Line.ray(0, 0, 5e-5, (1, 0), (1, 0)).hit,
        Line.point(0, 0, 5e-5, (1, 0)).tangents,
        Sphere((0, 0, 0), 5e-5, (1, 0, 0), (1, 0, 0)).hit,
    ):
        with pytest.raises(InvalidCase, match=small):
            ask()
    assert Line.ray(0, 0, 1.5e-4, (1, 0), (-1, 0)).hit() == -1
    for ask in (lambda: Line.point(0, 0, -1, (0, 0)), lambda: Pair(0, 0, 1, 0, 0, -1)):
        with pytest.raises(ValueError, match="negative"):
            ask()
    with pytest.raises(ValueError, match="meet"):
        Line.through(0, 0, 1, (-1, 2), (1, 2)).real_point(1)
