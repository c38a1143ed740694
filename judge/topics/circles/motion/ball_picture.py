"""Two moving discs as a film."""

from __future__ import annotations

from fractions import Fraction

from judge.drawing.shapes import Picture
from judge.problem.topic import Shown
from judge.topics.circles.bands import Bands
from judge.topics.circles.motion.balls import Balls
from judge.topics.circles.motion.film import (
    Close,
    Disc,
    Film,
    film_picture,
    fraction,
    length,
    moment_words,
    share,
    shown_values,
)


def ball_picture(shown: Shown) -> Picture | None:
    """The picture of one case; None where its arguments are no two discs."""
    values = shown_values(shown)
    if [type(value) is tuple for value in values] != [True, True, False, True, True, False]:
        return None
    balls = Balls.of(*values)
    bands = Bands.of(shown.problem.bands)
    line = balls.line
    names = zip(("P", "Q"), (balls.p, balls.q), (balls.r, balls.s), strict=True)
    discs = tuple(Disc(name, *way, radius) for name, way, radius in names)
    foot = Fraction(-line.b, line.a) if line.a else Fraction(0)
    closest = min(max(foot, Fraction(0)), Fraction(1))
    first = balls.first(bands)
    moments = {Fraction(0): "at the start", foot: "where they come closest"}
    if first is not None:
        moments[Fraction(1)] = "at the end"
    close = tuple(_close(discs, t, title) for t, title in moments.items() if 0 <= t <= 1)
    said = _words(balls, bands, close[0], _close(discs, foot, ""))
    film = Film(discs, None, line.shift, line.extent, closest, close, said)
    return film_picture(film, shown)


def _close(discs: tuple[Disc, ...], t: Fraction, title: str) -> Close:
    """The gap between both discs at a moment: less than 0 where they overlap, and where it is."""
    p, q = discs
    (x, y), (u, v) = p.at(t), q.at(t)
    apart = length(u - x, v - y)
    along = p.r / apart if apart else Fraction(0)
    return Close(t, (x + along * (u - x), y + along * (v - y)), apart - p.r - q.r, title)


def _words(balls: Balls, bands: Bands, start: Close, foot: Close) -> str:
    line = balls.line
    counts = bands.beside(balls.apart, line.r, line.extent)
    if counts <= 0:
        if counts == 0:
            exactly = "the discs touch at the start"
            return exactly if not start.size else f"{exactly}, but for {share(start.size, line.extent)}"
        return f"the discs overlap by {share(start.size, line.extent)} at the start"
    if not line.a:
        return f"the discs keep their distance, {share(start.size, line.extent)} from a touch"
    if not line.delta:
        way = "seen from Q, P grazes it exactly"
    else:
        gap = share(fraction(foot.size), line.extent)
        way = f"seen from Q, P passes {gap} {'too near' if line.delta > 0 else 'away'}"
        if bands.count(line) == 1:
            way += ", which counts as a graze"
    first = balls.first(bands)
    if first is not None and first.sign() < 0:
        return f"{way}, but backwards in time"
    return way + moment_words(first, balls.pace.step, line.extent)
