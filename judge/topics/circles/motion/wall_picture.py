"""A moving disc and a wall as a film."""

from __future__ import annotations

from fractions import Fraction

from judge.drawing.shapes import Picture
from judge.exact import Surd
from judge.problem.topic import Shown
from judge.topics.circles.bands import Bands
from judge.topics.circles.motion.film import (
    Close,
    Disc,
    Film,
    film_picture,
    fraction,
    moment_words,
    share,
    shown_values,
)
from judge.topics.circles.motion.wall import Wall


def wall_picture(shown: Shown) -> Picture | None:
    """The picture of one case; None where its arguments are no disc and wall."""
    values = shown_values(shown)
    if [type(value) is tuple for value in values] != [True, True, False, True, True]:
        return None
    wall = Wall.of(*values)
    bands = Bands.of(shown.problem.bands)
    foot = _closest(wall)
    closest = min(max(foot, Fraction(0)), Fraction(1))
    first = wall.first(bands)
    moments = {Fraction(0): "at the start", foot: "where they come closest"}
    if first is not None:
        moments[Fraction(1)] = "at the end"
    close = tuple(_close(wall, t, title) for t, title in moments.items() if 0 <= t <= 1)
    disc = Disc("P", *wall.p, wall.r)
    cap = wall.caps[0]
    said = _words(wall, bands, _close(wall, Fraction(0), "").size, first)
    return film_picture(Film((disc,), wall.wall, cap.shift, wall.extent, closest, close, said), shown)


def _closest(wall: Wall) -> Fraction:
    """When P is closest to the wall, on the line that it moves along; the first such moment, if any."""
    if not wall.caps[0].a:
        return Fraction(0)
    feet = [Fraction(-cap.b, cap.a) for cap in wall.caps]
    if wall.turn and not wall.least:  # it goes through the wall
        (ax, ay), (px, py), (wx, wy) = wall.wall[0], wall.p[0], wall.along
        return Fraction(wy * (px - ax) - wx * (py - ay), wall.turn)
    return min(feet, key=lambda t: (wall.apart(t), t))


def _close(wall: Wall, t: Fraction, title: str) -> Close:
    """The gap between disc and wall at a moment, and where on the wall that is."""
    (ax, ay), (wx, wy) = wall.wall[0], wall.along
    x, y = (place + t * step for place, step in zip(wall.p[0], wall.way, strict=True))
    square = wx * wx + wy * wy
    part = Fraction((x - ax) * wx + (y - ay) * wy) / (square or 1)
    foot = min(max(part, Fraction(0)), Fraction(1))
    return Close(t, (ax + foot * wx, ay + foot * wy), _root(wall.apart(t)) - wall.r, title)


def _root(square: Fraction) -> Fraction:
    top, bottom = square.numerator, square.denominator
    return fraction(Surd(0, 1, top * bottom, bottom))


def _words(wall: Wall, bands: Bands, start: Fraction, first: Surd | None) -> str:
    counts = wall.beside(wall.start, bands)
    if counts == 0:
        return "the disc touches the wall at the start" + (
            f", but for {share(start, wall.extent)}" if start else ""
        )
    if counts < 0:
        return f"disc and wall overlap by {share(start, wall.extent)} at the start"
    if not wall.caps[0].a:
        return f"the disc rests {share(start, wall.extent)} from a touch"
    gap = _root(wall.least) - wall.r
    if not wall.least:
        way = "the way of P goes through the wall" if wall.turn else "the way of P goes along the wall"
    elif not gap:
        way = "on its way the disc grazes the wall exactly"
    else:
        way = f"the way of P passes the wall {share(gap, wall.extent)} {'too near' if gap < 0 else 'away'}"
        if wall.beside(wall.least, bands) == 0:
            way += ", which counts as a graze"
    if first is not None and first.sign() < 0:
        return f"{way}, but backwards in time"
    return way + moment_words(first, wall.pace.step, wall.extent)
