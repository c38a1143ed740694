"""Scenes of moving discs, and of a disc and a wall.

    balls("chord before first~ rest", **NEAR)    (P0, P1, r, Q0, Q1, s)
    walls("graze cap", **BIG)                    (P0, P1, r, A, B)

Of discs, a height and two places say how the first moves as seen from the second: see
judge.geometry.level; "=" for the second place is no way at all. Vocabulary after them:

    rest, alone       the second disc rests, or the first
    along, together   both run along one line, or both far in one direction
    rush              each runs to where the other one began, and as far again
    dot, tiny         one radius is 0, or a small part of the other one
    grain             both are so small that just a hit is no graze; the height is "dot"
    home              P0 is the origin, or P1, or Q0

Of a wall, the first word says what happens, the second one where: at its side, a cap (a round end), or a
post. Others may follow: "dot", the radius is 0; "grain", it is tiny beside way and wall; "level", the way
runs along an axis; "afar", from far away; "rim", close to an end; "home".

    hit, fast, flat       the disc comes to it: from near, from far, nearly along it
    graze, slide          it passes just in touch; along the side
    start, end            it touches at t = 0 and leaves, or at t = 1
    short, away, past     it stops before, it leaves, it meets only the wall's line
    shy, stop             it stops before it would graze, or where it does
    overlap, rest         it overlaps at t = 0; it does not move
    broad                 the disc is hundreds of times as large as the wall
"""

from __future__ import annotations

from collections.abc import Sequence
from math import ldexp

from judge.data.draw import Draw
from judge.geometry.level import HEIGHT, PLACE, Case, Level, Nudge, Vocabulary, levelled, maker, over_circle
from judge.geometry.pose import Atom, Length, Point, triple

_DRIFT = Vocabulary.of("how discs move", "rest alone along together rush dot tiny grain home")
_FINE = 30  # bits by which a way grows beside grains
_WHAT = Vocabulary.of(
    "what happens at a wall",
    "hit fast flat graze slide start end short away past overlap rest shy stop broad",
)
_WHERE = Vocabulary.of("a place of a wall", "side cap post")
_HOW = Vocabulary.of("how a disc comes to a wall", "dot grain level afar rim home")


def _level_balls(draw: Draw, words: Sequence[str], size: int = 30) -> Level:
    """The way of P as seen from Q along the x axis; Q begins at (0, 0) and moves as it likes."""
    R, (start, end), nudges = over_circle(draw, words[:3], size)
    if start == end and words[2] != "=":
        draw.reject()
    if "grain" in words:
        start[0], end[0] = start[0] << _FINE, end[0] << _FINE
        R = draw.integer(10, 12) * max(abs(start[0]), abs(end[0] - start[0])) // 10**8 + 1
    if "rush" in words:
        end[:] = [-2 * start[0], start[1]]
    far = draw.integer(20, 100) * size
    ways = {
        "rest": (0, 0),
        "alone": (start[0] - end[0], start[1] - end[1]),
        "along": (draw.integer(-3, 3) * (end[0] - start[0]) or size, 0),
        "rush": (2 * start[0], 0),
        "together": (far * draw.sign(), far * draw.integer(-1, 1)),
    }
    any_way = draw.choice((0, draw.integer(-2 * size, 2 * size))), draw.integer(-2 * size, 2 * size)
    way = next((ways[word] for word in words if word in ways), any_way)
    r = 0 if "dot" in words else R // draw.integer(100, 1000) if "tiny" in words else draw.integer(0, R)
    r = R - r if draw.boolean() else r
    end[:] = [end[0] + way[0], end[1] + way[1]]
    atoms: list[Atom] = [start, end, Length([r]), Point([0, 0]), Point(way), Length([R - r])]
    if "home" in words:
        _home(draw, atoms, (0, 1, 3))
    return atoms, nudges


def _home(draw: Draw, atoms: list[Atom], those: Sequence[int]) -> None:
    """Move all points so that one of those is the origin."""
    x, y = atoms[draw.choice(those)]
    for each in atoms:
        if isinstance(each, Point):
            each[:] = [each[0] - x, each[1] - y]


def _level_wall(draw: Draw, words: Sequence[str], size: int = 30) -> Level:
    """The wall from (0, 0) to (W, 0). The touch is laid out first, and the way goes through it."""
    what, where, near = words[0].rstrip("~"), words[1], words[0][-1] == "~"
    W = 0 if where == "post" else draw.integer(1, 3 * size)
    if "grain" in words:
        W <<= draw.integer(*draw.choice(((10, 34), (18, 24), (32, 34))))
    if what == "flat":
        W *= draw.choice((10, 3_000, 100_000))
    if where == "side":
        R = draw.integer(size // 4 + 1, size) * (draw.integer(100, 600) if what == "broad" else 1)
        R = 0 if "dot" in words else R
        x = W + R + draw.integer(1, max(W, size)) if what == "past" else draw.integer(0, W)
        x = W >> draw.integer(4, 16) if "rim" in words else x
        spot, away, across = (x, R), (0, 1), (1, 0)
    else:
        p, q, c = triple(draw, max(5, min(size, 4_418)))
        k = draw.integer(max(1, size // c // 2), max(1, size // c))
        away, R = (-p, q * draw.sign()), c * k
        if "dot" in words:
            R = k = 0
        spot, across = (away[0] * k, away[1] * k), (-away[1], away[0])
    stride = max(
        1, (R or size) // max(map(abs, away)) // 4, W >> draw.integer(6, 11) if "grain" in words else 0
    )
    way = _way(draw, away, "level" if "level" in words else what)
    if what == "flat" and "grain" not in words:
        stride = 1

    def at(d: Sequence[int], n: int) -> Point:
        return Point([spot[0] + d[0] * n * stride, spot[1] + d[1] * n * stride])

    most = 3 if what == "flat" else 9
    a, b = draw.integer(1, most), draw.integer(1, most)
    if what == "fast":
        a, b = a * draw.integer(100, 1000), b * draw.integer(100, 1000)
    if "afar" in words:
        a *= 10 ** draw.integer(3, 7)
    if what == "shy":  # by 1 or the least part of R that is clear; from afar, by R and more
        k, stride, a = R // max(map(abs, away)), 1, a * stride
        b = max(1, k * draw.integer(5, 300) // 10_000)
        if "afar" in words:
            b = k * draw.integer(1, 3)
            a = b * draw.integer(10**6, 8 * 10**6)
    rests = draw.choice((0, -3))
    d, first, last = {
        "graze": (across, -a, b),
        "shy": (across, -a - b, -b),
        "stop": (across, -a, 0),
        "start": (way, 0, -b),
        "end": (way, -a, 0),
        "short": (way, -a - b, -a),
        "away": (way, -a, -a - b),
        "rest": (way, rests, rests),
    }.get(what, (way, -a, b))
    start, end = at(d, first), at(d, last)
    if what == "slide" or words[:2] == ["stop", "side"]:
        start, end = Point([-R * a // b - 1, R]), Point([draw.integer(0, W) if what == "slide" else 0, R])
    elif what == "overlap":
        deep = draw.integer(1, max(1, R // 2)) if where == "side" else 1
        start, end = Point([spot[0] - away[0] * deep, spot[1] - away[1] * deep]), at(way, b - 5)
    outwards = draw.sign() if what in ("graze", "slide", "end", "start") else 1
    moved = {"graze": (0, 1), "slide": (0, 1), "end": (1,), "start": (0,)}.get(what, ()) if near else ()
    along = way if "level" in words and not R else away  # a point is just off on its own line
    nudges = [
        Nudge((start, end)[at], i, outwards * (1 if n > 0 else -1))
        for at in moved
        for i, n in enumerate(along)
        if n
    ]
    ends = [Point([0, 0]), Point([W, 0])]
    atoms: list[Atom] = [start, end, Length([R]), *(ends if draw.boolean() else ends[::-1])]
    if "home" in words:
        _home(draw, atoms, (0, 1, 3))
    return atoms, nudges


def _way(draw: Draw, away: Sequence[int], what: str) -> tuple[int, int]:
    """A way to the spot from outside."""
    if what == "past":
        return 0, -1
    if what == "flat":
        return draw.choice((draw.integer(100, 9_000), draw.integer(9_000, 9_990))) * draw.sign(), -1
    x, y = draw.integer(-12, 12), draw.integer(-12, 12)
    if what == "level":
        x, y = (draw.sign(), 0) if draw.boolean() else (0, draw.sign())
    towards = x * away[0] + y * away[1]
    if abs(towards) * 100 <= (abs(x) + abs(y)) * (abs(away[0]) + abs(away[1])):
        draw.reject()  # nearly along the wall
    return (x, y) if towards < 0 else (-x, -y)


balls = levelled(_level_balls, lambda *case: case, HEIGHT, PLACE, PLACE, _DRIFT)
walls = levelled(_level_wall, lambda *case: case, _WHAT, _WHERE, _HOW)


@maker
def meeting(draw: Draw, bits: int) -> Case:
    """Two points that run to one place: whole numbers of any size up to 2**bits, or doubles of 53 bits."""
    whole = draw.boolean()

    def point() -> list[int | float]:
        large = draw.choice((3, bits, draw.integer(0, bits)))
        if whole:
            return [draw.sign() * draw.integer(0, 1 << large) for _ in range(2)]
        return [ldexp(draw.sign() * draw.integer(0, 1 << 53), large - 53) for _ in range(2)]

    P, Q, X = point(), point(), point()
    axis = draw.integer(0, 2)
    if axis < 2:  # close together along it
        P[axis], Q[axis] = draw.choice((0, draw.integer(-9, 9))), draw.integer(-9, 9)
    return tuple(P), tuple(X), 0, tuple(Q), tuple(X), 0
