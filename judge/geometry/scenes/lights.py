"""Scenes of a ray, circles and a light: lights("open", "back", **PLAIN) draws (circles, O, D, L).

A word says what the light L is to the point P that the ray hits first.

    miss                          the ray hits nothing
    open, back                    nothing is between; on the side that the ray does not see
    torch                         the same, far from the ray's start, where L is
    brink                         open, and the ray begins just before the circle
    level-open, level-back        the same, nearly on the tangent at P
    level-far                     open, nearly on the tangent, and all is far from the small circle
    room, wall, level-wall        the ray begins inside: L is in the same room, or outside of it
    candle                        the ray begins inside, where L is
    outdoors                      the same, and L is on the other side of the tangent
    straight                      the ray runs through the centre, from inside or outside; L is upright over O
    blocked, gap                  a circle is between, or a tiny one near P
    beyond, behind                a circle is on the line, but not between
    around-light, around-point    a circle around L, or around the way to P
    skin                          P is just inside another circle, whose wall is behind P or before it
    ledge                         P is just outside of a circle beside the ray
    sill                          the same, and the way to L goes into that one, often aslant
    pillar, moat, court           a second circle about the centre, or around all: a smaller one that blocks,
                                  a larger one that blocks, one that does not
    lamp                          a tiny circle around L, just before or just beyond it, or a large one there
    lamp-thin                     a large one that begins just before L, or just beyond it
    close, close-early            a circle beside the way to L, which nearly touches it; it is nearer to P
    close-large                   the same, and it is a large one
    first-close                   the ray nearly touches a circle; another one stands behind
"""

from __future__ import annotations

from math import isqrt
from typing import Any

from judge.data.draw import Draw
from judge.geometry.level import Case, Scene, Vocabulary, height, maker, near_gap, parsed, tried
from judge.geometry.pose import Atom, Length, Point, Vector, posed
from judge.geometry.scenes.crowds import Row, circles_of, mixed
from judge.geometry.scenes.many import any_point
from judge.geometry.shadow import Shade, shade
from judge.problem.declare import InvalidCase

_SHADES = {
    "miss": (Shade.NOTHING,),
    "candle open brink torch room court beyond behind level-open level-far ledge": (Shade.LIT,),
    "back level-back outdoors": (Shade.BACK,),
    "wall level-wall": (Shade.OWN,),
    "blocked gap around-light around-point skin sill pillar moat": (Shade.BLOCKED,),
    "lamp lamp-thin close close-early close-large": (Shade.LIT, Shade.BLOCKED),
    "first-close": (Shade.LIT, Shade.BACK, Shade.BLOCKED),
    "straight": (Shade.LIT, Shade.OWN),
}
_SHADE = {word: shades for words, shades in _SHADES.items() for word in words.split()}
_WORDS = Vocabulary("a way for a light to shine", tuple(_SHADE))

Spot = tuple[int, int]


def lights(*words: str, others: tuple[int, int] = (0, 0), size: int = 60, **how: Any) -> Scene:
    """A light of one of these words; `others` bounds how many circles stand about."""
    parsed(words, _WORDS)

    def draw_case(draw: Draw) -> Case:
        word = draw.choice(words)
        rows, light = _laid(draw, word, size)
        rows = list(mixed(draw, [*rows, *(_about(draw, size) for _ in range(draw.integer(*others)))]))
        atoms: list[Atom] = [Point([0, 0]), Vector([draw.integer(1, 9), 0]), Point(light)]
        for x, y, r in rows:
            atoms += [Point([x, y]), Length([r])]
        O, D, L, *rest = posed(draw, atoms, **how)
        case = circles_of(rest), O, D, L
        return case if _shade(case) in _SHADE[word] else draw.reject()

    return draw_case


@maker
def shaded(draw: Draw, drawn: Scene, *shades: str) -> Case:
    """Only cases in which the light is one of these: "nothing", "lit", "back", "own" or "blocked"."""
    wanted = Shade(draw.choice(shades))
    return tried(drawn, lambda case: _shade(case) is wanted)(draw)


def _shade(case: Case) -> Shade | None:
    try:
        return shade(*case)
    except InvalidCase:
        return None


def _laid(draw: Draw, word: str, size: int) -> tuple[list[Row], Spot]:
    """The circle that is hit first and what is in the way, for a ray from (0, 0) along the x axis; and L."""

    if word == "miss":
        r = draw.integer(size // 4, size)
        high = (r + draw.integer(1, size)) * draw.sign()
        return [(draw.integer(-size, 2 * size), high, r)], any_point(draw, 2 * size)
    if word == "first-close":
        return _first_close(draw, size)
    if word == "straight":
        r = draw.integer(size // 4, size)
        x = draw.choice((draw.integer(1 - r, r - 1), r + draw.integer(1, size)))
        return [(x, 0, r)], (0, draw.choice((0, draw.integer(-size, size))))
    r, y, whole = height(draw, "chord", size)
    half = whole or 0
    if not word.startswith("close") and draw.boolean():  # P is irrational
        r = draw.integer(2, size)
        y = draw.integer(1 - r, r - 1)
        half = isqrt(r * r - y * y)
    if word in ("room", "wall", "outdoors", "level-wall", "pillar", "candle"):
        back = draw.integer(1, max(1, 2 * half - 1))  # O is so far behind the wall that is hit
        x = back - half
        if word == "pillar":
            share = draw.integer(20, 90)
            within = draw.integer(1, max(1, abs(y) - 1))
            return [(x, y, r), (x, y, within)], (x - half * share // 100, y + y * share // 100)
        if word == "level-wall":
            along = draw.integer(2, 4) * draw.sign()
            return [(x, y, r)], (back + along * y - draw.integer(1, 9), along * half)
        dx, dy = any_point(draw, r if word == "room" else 3 * size)
        return [(x, y, r)], (0, 0) if word == "candle" else (x + dx, y + dy)
    if word == "brink":
        if half * 2 < r:
            draw.reject()
        at = near_gap(draw, 3 * size, 7) * r // half + 1
    else:
        at = draw.integer(1, 2 * size)
    at *= 99 if word == "torch" else 1
    at = at // draw.choice((1, 64, 64, 64)) + 1 if word == "sill" else at
    circle = at + half, y, r
    wx, wy = draw.integer(-2 * size, size), draw.integer(-2 * size, 2 * size)
    if (wx * half + wy * y > 0) != (word == "back"):  # it would be on the other side of the tangent
        wx, wy = -wx, -wy
    light = at + wx, wy
    if word in ("open", "back", "brink", "torch"):
        return [circle], (0, 0) if word == "torch" else light
    if word == "court":
        x, y = draw.choice((circle[:2], any_point(draw, size)))
        return [circle, (x, y, draw.integer(7 * size, 9 * size))], light
    if word == "moat":
        wall = isqrt(circle[0] ** 2 + y * y) + draw.integer(2, size)
        return [circle, (circle[0], y, wall)], (-draw.integer(0, 9 * size), draw.integer(-9 * size, 9 * size))
    if word.startswith("level-"):
        along, inward = draw.integer(2, 4) * draw.sign(), 1 if word == "level-back" else -1
        if word == "level-far":
            at += size * draw.integer(1000, 4000)
            circle, along = (at + half, y, r), along * draw.integer(300, 1000)
            inward = -size * draw.integer(5, 9) // 1000
        up = (y > 0) - (y < 0)
        return [circle], (at + along * y + inward, -along * half + inward * up)
    if word == "skin":
        if 2 * half < r:  # a grazing ray: the wall is right before the point, on the way to L
            wx = abs(wx)
            wy = -5 * wx * half // y // 4
        light = at + 3 * wx, 3 * wy
        return [circle, (near_gap(draw, max(at + half + r, *map(abs, light))), 0, at)], light
    if word in ("ledge", "sill"):
        side, high = (1 if y < 0 else -1), draw.integer(size // 4, size)
        light = at - draw.integer(size, 3 * size), -side * draw.integer(1, max(1, half // 2))
        ahead, up, length = draw.choice(((0, 1, 1), *[(20, 21, 29)] * 2)) if word == "sill" else (0, 1, 1)
        away = draw.integer(size // 8, 3 * size)
        if ahead:  # L is in it
            high = away * draw.integer(7, 10) // 10
        light = light if word == "ledge" else (at + away * ahead // up, side * away)
        reach = max(at + half, r, high, *map(abs, light))
        centre = at + high * ahead // length, side * high * up // length
        return [circle, (*centre, high - near_gap(draw, reach, 7))], light
    if word == "around-point":
        return [
            circle,
            (at // 2, draw.integer(-at // 8, at // 8), max(2, at * draw.integer(60, 90) // 100)),
        ], light
    if word.startswith("lamp"):
        return [circle, _lamp(draw, word, light, (light[0] - at, light[1]), size)], light
    return [circle, _between(draw, word, at, light, size, at + half + r)], light


def _between(draw: Draw, word: str, at: int, light: Spot, size: int, reach: int) -> Row:
    """A circle on or beside the line from P = (at, 0) to the light."""
    wx, wy = light[0] - at, light[1]
    length = max(1, isqrt(wx * wx + wy * wy))
    r = max(2, size // 300) if word == "gap" else max(2, length // draw.integer(5, 12))
    shares = {"beyond": (130, 250), "behind": (-150, -30), "around-light": (100, 100), "close-early": (5, 25)}
    along = 4 * r if word == "gap" else length * draw.integer(*shares.get(word, (25, 75))) // 100
    aside = draw.integer(-r // 2, r // 2)
    if word.startswith("close"):
        aside = draw.sign() * (size * draw.integer(3, 9) if word == "close-large" else draw.integer(r, 2 * r))
    x, y = at + (wx * along - wy * aside) // length, (wy * along + wx * aside) // length
    if word.startswith("close"):
        away = isqrt((wx * y - wy * (x - at)) ** 2 // (wx * wx + wy * wy))
        r = away + near_gap(draw, max(abs(x), abs(y), away, reach, *map(abs, light))) * draw.sign()
    return x, y, max(1, r)


def _lamp(draw: Draw, word: str, light: Spot, way: Spot, size: int) -> Row:
    length = max(1, isqrt(way[0] ** 2 + way[1] ** 2))
    kind = "large" if word == "lamp-thin" else draw.choice(("around", "before", "beyond", "large"))
    r = draw.integer(size // 100, size // 10) if kind == "large" else draw.integer(size // 2000, size // 1500)
    off = near_gap(draw, 4 * size, 7) if word == "lamp-thin" else size // 3000
    off *= draw.sign()
    past = {"around": 0, "before": -r - r // 4, "beyond": r + r // 4, "large": r + off}[kind]
    return light[0] + way[0] * past // length, light[1] + way[1] * past // length, r


def _first_close(draw: Draw, size: int) -> tuple[list[Row], Spot]:
    high, at, side = draw.integer(size // 4, size), draw.integer(size // 4, size), draw.sign()
    r = draw.integer(size // 8, size // 4)
    behind = at + draw.integer(high, 2 * size) + r, draw.integer(-r // 2, r // 2), r
    # L shines on the one that is nearly hit, and on the back of the other one.
    light = behind[0] + draw.integer(r, size // 2), -draw.integer(size // 2, size) * side
    return [(at, high * side, high + near_gap(draw, light[0]) * draw.sign()), behind], light


def _about(draw: Draw, size: int) -> Row:
    """A circle somewhere about, seldom in the way."""
    x, y = draw.integer(-3 * size, 3 * size), draw.sign() * draw.integer(0, 3 * size)
    return x, y, draw.integer(max(1, size // 20), max(2, size // 3))


@maker
def topped(draw: Draw, reach: int) -> Case:
    """Rays in whole numbers to the top of a circle, or its bottom, left or right; L is anywhere."""
    (px, py), (dx, dy) = any_point(draw, reach), any_point(draw, 9)
    r, k = draw.integer(1, reach) * draw.sign(), draw.integer(1, max(1, reach // 9))
    case = ((px, py - r, abs(r)),), (px - k * dx, py - k * dy), (dx, dy), any_point(draw, reach)
    if draw.boolean():
        return case
    (circle,), *rest = case
    return ((circle[1], circle[0], circle[2]),), *((y, x) for x, y in rest)


@maker
def home(draw: Draw, reach: int) -> Case:
    """Rays in whole numbers or steep ones from inside a circle; C, O and L are level or upright, or one."""
    r, axis, far = draw.integer(2, reach), draw.integer(0, 1), draw.choice((0, 0, reach))
    O = any_point(draw, far)

    def beside(most: int) -> Spot:
        by = draw.choice((0, 0, draw.integer(-most, most), draw.integer(-1, 1)))
        return (O[0] + by, O[1]) if axis else (O[0], O[1] + by)

    steep = draw.integer(-9, 9) * 2.0 ** -draw.integer(10, 30)
    D = draw.choice((0, draw.integer(-9, 9), steep)), draw.integer(1, 9) * draw.sign()
    return ((*beside(r - 1), r),), O, D[:: draw.sign()], beside(2 * r)
