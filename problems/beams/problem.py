"""Many circles and beams from one place: the circle that each beam meets first, exactly."""

from functools import partial
from math import asin, atan2, cos, hypot, pi, sin, sqrt

from judge.geometry.boxes import scan
from judge.geometry.hooks import hooks
from judge.geometry.scenes import either, telling
from judge.geometry.scenes.close import narrow
from judge.geometry.scenes.growth import arcs
from judge.geometry.scenes.many import FASTEST, TRIPLES, any_circle, any_point, any_way, besides, scanned, scans, touches, turned, wraps
from judge.problem.declare import group

HOOKS = hooks("many")


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
    """A large circle close to O covers nearly half of all angles; beams on all sides, some that would touch it backwards."""
    r, quarters, times = draw.integer(100_000, 250_000), draw.integer(0, 3), draw.choice((1, 50, 1_000, 99_999))
    x, y = r + draw.integer(0, r // 20 // times), draw.integer(-r // 5, r // 5) // min(times, 100)
    ways = [any_way(draw) for _ in range(draw.integer(5, 9))]
    for _ in range(3):
        angle = atan2(y, x) + draw.sign() * (pi - asin(min(1, r / hypot(x, y))) + 2.0 ** -draw.integer(5, 10))
        ways.append(turned((round(FASTEST * cos(angle)), round(FASTEST * sin(angle))), quarters))
    return scanned([turned((x, y, r), quarters)], any_point(draw, 750_000), ways, apart=0)


def cornered(draw):
    """A scene in a corner of the bounds, where all numbers have seven digits."""
    O = tuple([draw.integer(1_020_000, 1_028_000) * draw.sign() for _ in "xy"])
    circles = [any_circle(draw, 20_000, (100, 9_000)) for _ in range(draw.integer(1, 5))]
    return scanned(circles, O, [any_way(draw) for _ in range(draw.integer(6, 9))])


def skimmed(draw):
    """One beam that touches a huge circle close to O: the sine of half its angle is nearly 1."""
    (p, q, c), times, quarters = draw.choice(TRIPLES), draw.integer(4_000, 20_000), draw.integer(0, 3)
    ahead, side = times // draw.integer(100, 500), times * draw.sign()
    circle = turned((p * ahead - q * side, q * ahead + p * side, c * times), quarters)
    return scanned([circle], any_point(draw, 300_000), [turned((p, q), quarters)], apart=0)


def bulging(draw):
    """A circle that is inside a larger one but for a hundredth of its radius or less, or more, and beams at what sticks out."""
    (p, q, c), R, r = draw.choice(TRIPLES), draw.integer(100_000, 250_000), draw.integer(5_000, 40_000)
    off, far = R - r + r * draw.integer(2, draw.choice((10, 10, 300))) // 1_000 + 1, 2 * R + draw.integer(0, 200_000)
    large, small = ((part * p // c - far * p // c, part * q // c - far * q // c, radius) for part, radius in ((0, R), (off, r)))
    ways = [(-p, -q), *[(-p * 20 + draw.integer(-3, 3), -q * 20 + draw.integer(-3, 3)) for _ in range(3)]]
    quarters = draw.integer(0, 3)
    circles = [turned(each, quarters) for each in (large, small)[:: draw.choice((1, -1))]]
    return scanned(circles, any_point(draw, 250_000), [turned(way, quarters) for way in ways], apart=0)


def smallest(draw):
    """A touch in the smallest numbers, and beams on all sides; often another circle."""
    r, quarters = draw.integer(1, 2), draw.integer(0, 3)
    touching = turned((r * draw.sign(), draw.integer(1, 3), r), quarters)
    others = [any_circle(draw, 3, (1, 2)) for _ in range(draw.integer(0, 1))]
    return scanned([touching, *others], any_point(draw, 3), [turned((0, 1), quarters), *(any_way(draw, 2) for _ in range(5))], apart=0)


def afar(draw):
    """A circle of a few units straight ahead, up to two million away: the beam along an axis cuts, touches or passes it."""
    far, quarters, r = draw.choice((draw.integer(500_000, 1_000_000), draw.integer(1_002_000, 1_048_000))), draw.integer(0, 3), draw.integer(1, 4)
    beside = draw.choice((r, r + 1, r - 1, 1, 1)) * draw.sign()
    circle, O = (beside, draw.integer(far, 2 * far - 99), r), (draw.choice((0, 1, 1, 3)) * draw.sign(), -far)
    return scanned([turned(circle, quarters)], turned(O, quarters), [turned((0, draw.integer(1, 9)), quarters)], apart=0)


TOUCH = touches((1, 1), 24)
TOLERANT = partial(first_beam, near=1e-10)

INTERVIEW = [
    group("few", "Up to ten circles around O, and some beams: a plain loop is good enough.", scans((5, 10), (8, 12), 120, (4, 50), across=False), skills="the nearest of several"),
    group("misses", "Small circles far apart: most beams meet nothing.", scans((3, 8), (12, 20), 2_000, (10, 60), across=False), skills="the nearest of several"),
    group("repeated", "Neighbouring calls differ in one argument.", scans((2, 6), (4, 8), 60, (10, 40)), turns=True, cases=60, skills="nothing kept between calls"),
]

PRODUCTION = [
    group("touch", "Beams that touch a circle or miss that by 1, and a circle behind it; one beam alone, too.", either(touches((3, 8), 24), TOUCH, smallest, telling(TOUCH, partial(first_beam, apart=0.0), TOLERANT), *2 * [telling(TOUCH, first_beam, TOLERANT)], skimmed, *2 * [afar]), cases=246, skills="collapse the tangent"),
    group("near", "Beams that nearly touch a circle, or meet two at nearly one place.", narrow((1, 2), 40_000), cases=150, skills="nearly is not touching"),
    group("wrap", "Circles across the direction of π, where the angles begin anew, and beams on both sides of it.", either(wraps((1, 5), (6, 10), 90, (10, 40)), wraps((0, 0), (1, 4), 90, (10, 40))), skills="angles wrap around"),
    group("hidden", "Large circles that small ones hide in part, and circles behind them that cannot be seen at all.", either(*3 * [scans((1, 5), (14, 24), 90, (8, 30), hidden=True)], bulging), cases=80, skills="the nearest of several"),
    group("beside", "A crowd of large circles beside a beam: they reach nearer to O than the small one that the beam meets first.", either(*3 * [besides((20, 40), (2, 6), 500)], besides((210, 240), (2, 6), 500)), cases=27, skills="the nearest of several"),
    group("short", "Directions of −2 to 2, (1, 0) and (2, −1) among them, through a crowd on all sides of O.", scans((30, 60), (12, 20), 400, (3, 20), fastest=2), cases=20, skills="the nearest of several"),
    group("long", "Small circles close to O, and directions of up to 1,000: t is small.", scans((2, 6), (12, 16), 9, (1, 3), fastest=FASTEST), cases=40, skills="full precision"),
    group("wide", "Few circles and whole numbers of all seven digits, O among them; or O close to a large circle.", either(scans((1, 8), (8, 12), 250_000, (10_000, 200_000), fastest=FASTEST), close_by, cornered), cases=90, skills="full precision"),
    group("n-500", "500 circles and as many beams: where the growth is measured from.", arcs(500), cases=5, size=500, skills="sweep by angle"),
    group("n-2000", "2,000 circles and as many beams.", arcs(2_000), cases=3, size=2_000, time_limit=30, limits={"cpu_seconds": 8, "wall_seconds": 60}, skills=("sweep by angle", "do not ask all of them")),
    group("n-8000", "8,000 circles and as many beams.", arcs(8_000), cases=2, size=8_000, time_limit=30, limits={"cpu_seconds": 10, "wall_seconds": 60}, skills=("sweep by angle", "do not ask all of them")),
    group("n-32000", "32,000 circles and as many beams.", arcs(32_000), cases=1, size=32_000, time_limit=30, limits={"cpu_seconds": 12, "wall_seconds": 60}, skills=("sweep by angle", "do not ask all of them")),
]
