"""Scenes of two circles, and of a circle and a polygon.

    pairs("outer", "inner~", **BIG)          (cx1, cy1, r1, cx2, cy2, r2)
    aside(pairs("cross", **PLAIN))           (cx1, cy1, r1, cx2, cy2, r2)
    polygons("on out tangent~", **NEAR)      (cx, cy, r, V)

After a way for two circles to lie, "slant" puts one nearly at 45 degrees beside the other, so that their
distance is 1.4 times the size, of which alone a near miss is clear.

The words of a polygon add corners, each beside a point P of the circle in whole numbers.

    on, in, out          at P, inside, outside
    pole                 on the circle, level with C or upright
    far, remote          1,000 to 10,000 radii away, or a million and more
    farthest             nearly as far as a circle is clear of its own centre
    tangent, brush       two corners on the tangent at P, near it or one of them very near
    leave                two corners: P, and one on the tangent at P
    across               two corners outside whose edge cuts the circle
    box                  four corners around the circle
    left, right          beside the circle, so that a level edge between them cuts it
    level                beside C, to the left or right
    short, stub          two corners: P, and one that is 2**-4 to 2**-21 of the radius away, or 1e-7 of it
    skim                 two corners: P, and one in the middle of a chord that nearly touches
    again                the first corner once more
    dot                  the first word of all: r is 0; at, by: at C, or on the other side of C
    slant                two corners as far on both sides of C, in nearly a diagonal
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache
from math import isqrt
from typing import Any

from judge.data.draw import Draw
from judge.geometry.level import Case, Level, Nudge, Scene, Vocabulary, levelled, maker
from judge.geometry.pose import Length, Point

_PAIR = Vocabulary.of(
    "a way for two circles to lie",
    "outer inner cross apart within close alike equal same ring dots dot-on dot-off dot-centre slant",
)


def _level_pair(draw: Draw, words: Sequence[str], size: int = 30, uneven: int = 0) -> Level:
    """Two circles with their centres on the x axis; one is `uneven` powers of two larger."""
    word, near = words[0].rstrip("~"), words[0][-1] == "~"
    a = draw.integer(size // 4 + 1, size) << uneven
    b = draw.integer(size // 4 + 1, size)
    if draw.boolean():
        a, b = b, a
    if word == "close":  # they touch, and their centres are 100 to 900 times nearer than their radii
        a = max(a, 1000 * b)
        b = a - a // draw.integer(100, 900)
        a, b = (a, b) if draw.boolean() else (b, a)
    if word in ("alike", "equal"):  # alike: the radii differ by 2**-10 to 2**-34
        b = a if word == "equal" else a - max(1, a >> draw.integer(10, 34)) * draw.sign()
    small, large = sorted((a, b))
    if word in ("inner", "within", "cross", "ring") and (large - small) * 50 < large:
        draw.reject()  # else the centres are almost one
    between = {
        "outer": lambda: a + b,
        "inner": lambda: large - small,
        "close": lambda: large - small,
        "alike": lambda: draw.integer(large // 2, 4 * large),
        "equal": lambda: draw.integer(large // 2, 4 * large),
        "cross": lambda: draw.integer(large - small + 1, a + b - 1),
        "apart": lambda: a + b + draw.integer(1, max(1, a + b)),
        "within": lambda: draw.integer(large // 100 + 1, max(large // 100 + 1, large - small - 1)),
        "dot-on": lambda: a,
        "dot-off": lambda: draw.choice((a // 2 + 1, 2 * a)),
    }
    d = between[word]() if word in between else 0
    if word == "same":
        b = a
    if word == "dots":
        a, b, d = 0, 0, draw.choice((0, a))
    if word.startswith("dot-"):
        a, b = (0, a) if draw.boolean() else (a, 0)
    x, y, c = draw.choice(((20, 21, 29), (119, 120, 169))) if "slant" in words else (1, 0, 1)
    one, centre, other = Length([a * c]), Point([d * x, d * y]), Length([b * c])
    nudge = Nudge(other, 0) if word == "same" else Nudge(centre, 0)
    nudge = Nudge(one, 0, times=Fraction(3, 4)) if "slant" in words else nudge
    return [Point([0, 0]), one, centre, other], [nudge] if near else []


pairs = levelled(_level_pair, lambda C1, r1, C2, r2: (*C1, r1, *C2, r2), _PAIR)


@maker
def aside(draw: Draw, drawn: Scene) -> Case:
    """A figure of C, r and a point or another circle, about the origin, moved far along an axis, and by a
    part of r along the other one, which is 0.6 to 1 times 1e-6, 1e-8 or 1e-10 of the way.
    """
    cx, cy, r, *rest = drawn(draw)
    off = r * draw.integer(20, 99) / 100
    far = off * draw.integer(101, 160) / 100 * 10 ** draw.choice((6, 8, 10)) * draw.sign()
    dx, dy = (far, off * draw.sign())[:: draw.choice((1, -1))]
    if len(rest) == 1:
        return cx + dx, cy + dy, r, (rest[0][0] + dx, rest[0][1] + dy)
    return cx + dx, cy + dy, r, rest[0] + dx, rest[1] + dy, rest[2]


@maker
def leant(draw: Draw, drawn: Scene, powers: Sequence[int] = (8,)) -> Case:
    """The same two circles, turned about C1 by 0.6 to 1 times 10 to minus one of `powers`: it hardly moves
    what is level or upright.
    """
    cx, cy, r, x, y, other = drawn(draw)
    lean = draw.integer(60, 99) / 10 ** (2 + draw.choice(powers)) * draw.sign()
    return cx, cy, r, x - lean * (y - cy), y + lean * (x - cx), other


_CORNERS = (
    "on in out far remote farthest tangent brush leave across level pole short stub skim box again left right"
    " at by slant"
)
_CORNER = Vocabulary.of("a corner of a polygon", _CORNERS)
_FIRST = Vocabulary.of("a corner of a polygon", f"{_CORNERS} dot")
_BRUSH = 2048  # parts of the radius: a corner is so few of them away from where its edge touches


@cache
def _spots(radius: int) -> list[tuple[int, int]]:
    """The points in whole numbers of a circle about (0, 0)."""
    roots = ((x, isqrt(radius * radius - x * x)) for x in range(-radius, radius + 1))
    return [
        (x, side * y)
        for x, y in roots
        if x * x + y * y == radius * radius
        for side in ((1, -1) if y else (1,))
    ]


def _level_polygon(draw: Draw, words: Sequence[str], size: int = 30) -> Level:
    """A circle about (0, 0) and the corners of a polygon; a word adds one corner, or as many as it says."""
    radius = 5 * 13 * 17 if size > 5 * 13 * 17 else 5 * 5  # with 36 points in whole numbers, or 20
    k = draw.integer(max(1, size // radius // 2), max(1, size // radius))
    k *= _BRUSH if "brush" in words else 1
    dot = words[0] == "dot"
    points: list[Point] = []
    nudges: list[Nudge] = []
    for word in words[dot:]:
        x, y = (k * each for each in draw.choice(_spots(radius)))
        found = _corners(draw, word.rstrip("~"), x, y, points)
        points += found
        if word[-1] == "~":
            away = draw.sign()
            for point in found:
                nudges += [Nudge(point, i, away * (1 if n > 0 else -1)) for i, n in ((0, x), (1, y)) if n]
    return [Point([0, 0]), Length([0 if dot else radius * k]), *points], nudges


def _corners(draw: Draw, name: str, x: int, y: int, before: Sequence[Point]) -> list[Point]:
    """Corners that go with the point (x, y) of the circle."""

    def grown(low: int, high: int) -> Point:
        return Point([draw.integer(low, high) * x // 100, draw.integer(low, high) * y // 100])

    def beside(along: int, height: int = 100, per: int = 1) -> Point:
        """So many radii along the tangent at that height, in parts."""
        return Point([height * x // 100 - along * y // per, height * y // 100 + along * x // per])

    if name in ("tangent", "brush"):
        ends = sorted((draw.integer(-3, 3), draw.integer(-3, 3)))
        if ends[0] == ends[1]:
            draw.reject()
        if name == "tangent":
            return [beside(end) for end in ends]
        near, far = draw.integer(1, 20) * draw.sign(), draw.integer(1, 3) * draw.sign()
        pair = [beside(near, per=_BRUSH), beside(far)]
        return pair if draw.boolean() else pair[::-1]
    if name == "leave":
        return [beside(0), beside(draw.integer(1, 3) * draw.sign())]
    if name == "across":
        high, side = draw.integer(0, 90), draw.sign()
        return [beside(end * side * draw.integer(2, 4), high) for end in (-1, 1)]
    if name in ("short", "stub", "skim"):
        reach = max(abs(x), abs(y)) >> draw.integer(4, 21)
        pair = [beside(0), Point([x + draw.integer(-reach, reach), y + draw.integer(-reach, reach)])]
        if name == "stub":
            along = 0 if abs(x) > abs(y) else 1
            gap = draw.integer(100, 125) * (x * x + y * y) // (10**9 * max(abs(x), abs(y))) + 1
            pair[1] = beside(0)
            pair[1][along] += gap * draw.sign()
        if name == "skim":  # the chord is 1/256 of the radius
            flat = 512 * draw.sign()
            pair[1] = Point([x - (x + flat * y) // flat**2, y - (y - flat * x) // flat**2])
        return pair if draw.boolean() else pair[::-1]
    if name == "box":
        out = draw.integer(160, 400)
        return [Point([out * px // 100, out * py // 100]) for px, py in ((x, y), (-y, x), (-x, -y), (y, -x))]
    if name == "slant":
        far = isqrt(x * x + y * y) * 2
        corner = [far * draw.sign(), (far - draw.integer(1, far // 20)) * draw.sign()]
        return [Point(corner), Point([-n for n in corner])]
    if name in ("left", "right"):  # of the circle, and nearly level
        side = 1 if name == "right" else -1
        return [
            Point([side * (abs(x) + abs(y)) * draw.integer(105, 200) // 100, y * draw.integer(0, 30) // 100])
        ]
    found = {
        "on": lambda: beside(0),
        "in": lambda: grown(5, 60),
        "out": lambda: grown(150, 400),
        "far": lambda: grown(10**5, 10**6),
        "remote": lambda: grown(10**8, 4 * 10**8),
        "farthest": lambda: grown(67 * 10**7, 85 * 10**7),
        "level": lambda: Point([draw.sign() * (abs(x) + abs(y)) * draw.integer(1, 400) // 100, 0]),
        "pole": lambda: Point([0, isqrt(x * x + y * y) * draw.sign()][:: draw.sign()]),
        "at": lambda: Point([0, 0]),
        "by": lambda: Point([-k * n for k in [draw.integer(1, 3)] for n in next(filter(any, before[::-1]))]),
        "again": lambda: Point(before[0]),
    }
    return [found[name]()]


polygons = levelled(_level_polygon, lambda C, r, *V: (*C, r, V), _FIRST, _CORNER)


@maker
def polygons_of(draw: Draw, /, *words: str, count: tuple[int, int], turns: bool = False, **how: Any) -> Case:
    """Polygons of as many of these words as `count` bounds; with `turns` they take turns."""
    number = draw.integer(*count)
    plan = [words[at % len(words)] if turns else draw.choice(words) for at in range(number)]
    return polygons(" ".join(plan), **how)(draw)


@maker
def cornered(draw: Draw, make: Callable[..., Scene], count: tuple[int, int], *how: Any) -> Case:
    """A circle and a polygon of any numbers that `make` draws for a shape, such as `grid`."""
    case = make("nnr" + "p" * draw.integer(*count), *how)(draw)
    return *case[:3], case[3:]
