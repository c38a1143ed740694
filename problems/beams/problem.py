"""Many circles and beams from one place: the circle that each beam meets first, exactly."""

from functools import partial
from math import sqrt

from judge.geometry.boxes import scan
from judge.geometry.hooks import MANY, hooks
from judge.geometry.scenes import either, telling
from judge.geometry.scenes.close import narrow
from judge.geometry.scenes.growth import arcs
from judge.geometry.scenes.many import FASTEST, any_point, any_way, besides, scanned, scans, touches, turned, wraps
from judge.problem.declare import group

HOOKS = hooks(MANY)


def solve(circles, O, dirs):
    return scan(circles, O, dirs, FASTEST)


def first_beam(circles, O, dirs, near=0.0, apart=1e-10):
    """Where a plain program meets each circle along the first beam, in parts of the size."""
    (ox, oy), (dx, dy), found = O, dirs[0], []
    size = max(max(r, abs(x - ox), abs(y - oy)) for x, y, r in circles)
    length = sqrt(dx * dx + dy * dy)
    ux, uy = dx / length, dy / length
    for x, y, r in circles:
        d = abs(ux * (y - oy) - uy * (x - ox))
        half = sqrt((r - d) * (r + d)) if d < r - near * size else 0.0
        found.append(None if d > r + apart * size else round((ux * (x - ox) + uy * (y - oy) - half) / size * 3e8))
    return found


def close_by(draw):
    """A large circle close to O, and beams on all sides: it covers nearly half of all angles."""
    r, quarters, times = draw.integer(100_000, 250_000), draw.integer(0, 3), draw.choice((1, 50, 50))
    circle = turned((r + draw.integer(9, r // 20 // times), draw.integer(-r // 5 // times, r // 5 // times), r), quarters)
    past = [turned((-draw.integer(1, 9), draw.integer(70, 99) * draw.sign()), quarters) for _ in range(3)]
    return scanned([circle], any_point(draw, 750_000), [*past, *(any_way(draw) for _ in range(draw.integer(5, 9)))])


TOUCH = touches((1, 1), 24)
TOLERANT = partial(first_beam, near=1e-10)

INTERVIEW = [
    group("few", "Up to ten circles around O, and some beams: a plain loop is good enough.", scans((5, 10), (8, 12), 120, (4, 50), across=False), skills="the nearest of several"),
    group("misses", "Small circles far apart: most beams meet nothing.", scans((3, 8), (12, 20), 2_000, (10, 60), across=False), skills="the nearest of several"),
    group("repeated", "Neighbouring calls differ in one argument.", scans((2, 6), (4, 8), 60, (10, 40)), turns=True, cases=60, skills="nothing kept between calls"),
]

PRODUCTION = [
    group("touch", "Beams that touch a circle or miss that by 1, and a circle behind it; one beam alone, too.", either(touches((3, 8), 24), TOUCH, telling(TOUCH, partial(first_beam, apart=0.0), TOLERANT), *2 * [telling(TOUCH, first_beam, TOLERANT)]), cases=160, skills="collapse the tangent"),
    group("near", "Beams that nearly touch a circle, or meet two at nearly one place.", narrow((1, 2), 4_000), cases=150, skills="nearly is not touching"),
    group("wrap", "Circles across the direction of π, where the angles begin anew, and beams on both sides of it.", either(wraps((1, 5), (6, 10), 90, (10, 40)), wraps((0, 0), (1, 4), 90, (10, 40))), skills="angles wrap around"),
    group("hidden", "Large circles that small ones hide in part, and circles behind them that cannot be seen at all.", scans((1, 5), (14, 24), 90, (8, 30), hidden=True), skills="the nearest of several"),
    group("beside", "A crowd of large circles beside a beam: they reach nearer to O than the small one that the beam meets first.", besides((20, 40), (2, 6), 500), cases=20, skills="the nearest of several"),
    group("short", "Directions of −2 to 2, (1, 0) and (2, −1) among them, through a crowd on all sides of O.", scans((30, 60), (12, 20), 400, (3, 20), fastest=2), cases=20, skills="the nearest of several"),
    group("long", "Small circles close to O, and directions of up to 1,000: t is small.", scans((2, 6), (12, 16), 9, (1, 3), fastest=FASTEST), cases=40, skills="full precision"),
    group("wide", "Few circles and whole numbers of all seven digits, O among them; or O close to a large circle.", either(scans((1, 8), (8, 12), 250_000, (10_000, 200_000), fastest=FASTEST), close_by), cases=80, skills="full precision"),
    group("n-500", "500 circles and as many beams: where the growth is measured from.", arcs(500), cases=5, size=500, skills="sweep by angle"),
    group("n-2000", "2,000 circles and as many beams.", arcs(2_000), cases=3, size=2_000, time_limit=30, limits={"cpu_seconds": 8, "wall_seconds": 60}, skills=("sweep by angle", "do not ask all of them")),
    group("n-8000", "8,000 circles and as many beams.", arcs(8_000), cases=2, size=8_000, time_limit=30, limits={"cpu_seconds": 10, "wall_seconds": 60}, skills=("sweep by angle", "do not ask all of them")),
    group("n-32000", "32,000 circles and as many beams.", arcs(32_000), cases=1, size=32_000, time_limit=30, limits={"cpu_seconds": 12, "wall_seconds": 60}, skills=("sweep by angle", "do not ask all of them")),
]
