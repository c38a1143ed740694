"""Many circles and many rays: the circle that each ray meets first, exactly."""

from math import gcd, sqrt

from judge.geometry.boxes import nearest
from judge.geometry.hooks import hooks
from judge.geometry.pose import triple
from judge.geometry.scenes import either
from judge.geometry.scenes.close import nearly
from judge.geometry.scenes.growth import crowded
from judge.geometry.scenes.many import FASTEST, any_circle, aside, clusters, fields, heaps, inside, leaving, strips, ties, turned
from judge.geometry.scenes.signs import across
from judge.problem.declare import group

HOOKS = hooks("many")


def solve(circles, rays):
    return nearest(circles, rays, FASTEST)


def edges(draw):
    """Small circles, at an axis or anywhere, and rays straight along a side of one's box or out of it; some are askew by 1:1000."""
    u, v = (draw.choice((0, draw.integer(-99, 99))) for _ in "xy")
    circles, rays = [any_circle(draw, draw.integer(0, 1), (1, 2)) for _ in range(draw.integer(1, 3))], []
    circles = [(x + u, draw.choice((y + v, y + v, r, -r)), r) for x, y, r in circles]
    for _ in range(draw.integer(24, 30)):
        (x, y, r), far = draw.choice(circles), draw.integer(1, 9) * draw.sign()
        O = x + r, draw.choice((0, y, y + draw.integer(-9, 9)))
        rays.append((O, draw.choice(((far, 0), (0, far), (0, far), (draw.sign(), FASTEST * draw.sign())))))
    quarters = draw.integer(0, 3)
    return tuple(turned(each, quarters) for each in circles), tuple((turned(O, quarters), turned(D, quarters)) for O, D in rays)


def askew(draw):
    """Rays askew by 1:1000 from hundreds of thousands of units away; each runs into a circle, from outside of its strip."""
    quarters, circles, rays = draw.integer(0, 3), [], []
    for _ in range(draw.integer(1, 2)):
        O, steps, r = any_circle(draw, 300_000, (150, 600))[:2], draw.integer(200, 600), draw.integer(5, 100)
        D = draw.sign(), FASTEST * draw.sign()
        circles.append((O[0] + steps * D[0] + draw.integer(1 - r, r - 1), O[1] + steps * D[1], r))
        rays.append((O, D))
    return tuple(turned(each, quarters) for each in circles), tuple((turned(O, quarters), turned(D, quarters)) for O, D in rays)


def afar(draw):
    """A circle of a few units, and rays along an axis from hundreds of thousands of units away: they cut, touch or pass it."""
    x, far, quarters, r = draw.integer(-3, 3), draw.integer(500_000, 1_048_000), draw.integer(0, 3), draw.integer(1, 4)
    circles, rays = [(x, far - draw.integer(9, far), r)], []
    for _ in range(3):
        beside = draw.choice((r, r + 1, r - 1, 1, 1)) * draw.sign()
        rays.append(((x + beside, -far), (0, draw.integer(1, 9))))
    return tuple(turned(each, quarters) for each in circles), tuple((turned(O, quarters), turned(D, quarters)) for O, D in rays)


def hairs(draw):
    """A small scene up to a million units from (0, 0), and rays that pass a circle by a ten-thousandth and less, inside or outside."""
    ox, oy = (draw.choice((0, 1, 1)) * draw.integer(900_000, 1_000_000) * draw.sign() for _ in "xy")
    circles, rays = [], []
    for _ in range(draw.integer(1, 3)):
        found, apart = [], draw.integer(0, 400)
        for _ in range(draw.choice((1, 12, 12))):
            p, q, least = draw.integer(1, 40), draw.integer(1, 40), draw.integer(5, 30)
            way = p // gcd(p, q), q // gcd(p, q)
            length = sqrt(way[0] ** 2 + way[1] ** 2)
            offs = ((abs(round(r * length) / length - r), r) for r in range(least, least + 50))
            found += [(off, r, way, length) for off, r in offs if off > 1.3e-7 * (r + 5 * length + apart)]
        _, r, way, length = min(found) if found else draw.reject()
        x, y = across(way, round(r * length) * draw.sign(), draw.integer(1, 4))
        circles.append((ox + apart + x, oy + y, r))
        rays.append(((ox + apart, oy), way))
    return tuple(circles), tuple(rays)


def slight(draw):
    """A large circle before rays along an axis: they pass its centre, or touch its wall but for, a part of r from 1e-6 to 1e-2."""
    r, quarters, rays = draw.integer(200_000, 450_000), draw.integer(0, 3), []
    x, y = draw.integer(-50_000, 50_000), draw.integer(-99_999, 99_999)
    for _ in range(draw.integer(3, 6)):
        part = max(1, r * draw.integer(10, 99) // 10 ** draw.integer(3, 7))
        beside = draw.choice((part, part, r - part)) * draw.sign()
        rays.append(((x - r - draw.integer(1, 9_000), y + beside), (draw.integer(1, 9), 0)))
    return (turned((x, y, r), quarters),), tuple((turned(O, quarters), turned(D, quarters)) for O, D in rays)


def walled(draw):
    """Rays that start right at the wall of a huge circle, and meet a small one before it; up to a hundred more outside."""
    r, quarters, others = draw.integer(100_000, 250_000), draw.integer(0, 3), draw.choice((5, 52, 52))
    off = draw.integer(r // 4000, r // 1100)  # of the start from the wall
    within = draw.integer(1, off // 5)
    circles = [(0, 0, r), (r - off // 2 + draw.integer(-off // 8, off // 8), 0, within)]
    for at in range(2 * others):
        x, y, other = any_circle(draw, 300_000, (10, 20_000))
        circles.append(((-1) ** at * (abs(x) + r + 40_000), y, other))
    rays = [((r - off, draw.integer(1 - within, within - 1)), (draw.integer(1, 9), 0)) for _ in range(draw.integer(1, 3))]
    rays.append((any_circle(draw, r // 2, (1, 1))[:2], (draw.integer(-9, 9), draw.integer(1, 9))))
    return tuple(turned(each, quarters) for each in circles[:: draw.sign()]), tuple((turned(O, quarters), turned(D, quarters)) for O, D in rays)


def rings(draw):
    """A thousand circles and more about one centre, and rays into them."""
    x, y, r = any_circle(draw, 90, (1, 99))
    circles = [(x, y, r + at) for at in range(draw.integer(1001, 1100))]
    return tuple(circles[:: draw.sign()]), (((x + draw.integer(-r // 2, 900), y - draw.integer(1200, 2000)), (0, draw.integer(1, 9))),)


def departing(draw):
    """Rays from exactly on circles of any size, a huge one among them: inwards, along the oblique tangent, and outwards."""
    circles, rays = [], []
    for at in range(draw.integer(1, 3)):
        p, q, c = triple(draw, 500)
        least, most = draw.choice(((5, 900), (1_000, 9_000), (10_000, 90_000))) if at else (100_000, 500_000)
        k = draw.integer(-(-least // c), max(most // c, -(-least // c)))
        x, y, i, j = draw.integer(-500_000, 500_000), draw.integer(-500_000, 500_000), draw.sign(), draw.sign()
        circles.append((x, y, k * c))
        u, v, turn = draw.integer(1, 1000), draw.integer(1, 1000), draw.sign() * draw.integer(1, 2)
        ways = (-i * u, -j * v), (-j * q * turn, i * p * turn), (i * v, j * u)
        rays += [((x + i * k * p, y + j * k * q), D) for D in ways]
    first = draw.integer(0, len(rays) - 1)
    return tuple(circles), tuple(rays[first:] + rays[:first])


def opposite(draw):
    """Rays across one corner of the world that pass a small circle there, and by far a large one in the opposite corner."""
    quarters, s, far = draw.integer(0, 3), draw.integer(10, 90), 1 << 20
    circles = [(s - far, s - far, s * draw.integer(110, 135) // 100)]
    for _ in range(draw.integer(1, 2)):
        r = draw.integer(1, 900) * draw.choice((1, 30, 500))
        circles.append((far - draw.integer(0, 9_000), far - draw.integer(0, 9_000), r))
    rays = []
    for _ in range(draw.integer(1, 3)):
        a = draw.integer(990, 1000)
        rays.append(((-far, -far), (a, draw.integer(1, 20) - a)[:: draw.choice((1, -1))]))
    return tuple(turned(each, quarters) for each in circles[:: draw.choice((1, -1))]), tuple((turned(O, quarters), turned(D, quarters)) for O, D in rays)


def corners(draw):
    """Rays from within 9,000 units of a corner of the world, along its diagonal or a side: they meet a circle at the far end, or pass it."""
    quarters, far, circles, rays = draw.integer(0, 3), 1 << 20, [], []
    for _ in range(draw.integer(1, 3)):
        O = tuple(draw.integer(-far, 9_000 - far) for _ in "xy")
        D = draw.choice(((1, 1), (1, 1), (1, 1), (1, 0), (0, 1)))
        steps = far - draw.integer(0, 9_000) - max(o for o, d in zip(O, D, strict=True) if d)
        r, times = draw.choice((draw.integer(1, 9), draw.integer(10, 4_000))), draw.integer(1, 9)
        at = [min(far, o + d * steps) for o, d in zip(O, D, strict=True)]
        circles.append((*at, r))
        rays.append((O, tuple(d * times for d in D)))
    return tuple(turned(each, quarters) for each in circles), tuple((turned(O, quarters), turned(D, quarters)) for O, D in rays)


INTERVIEW = [
    group("few", "Up to ten circles of about one size, and some rays: a plain loop is good enough.", aside(fields((1, 10), (4, 9), 70, (9, 17)), 90), skills="the nearest of several"),
    group("inside", "Rays that start inside one circle or several: they meet the curve where they leave, or another circle before.", either(*5 * [inside((1, 8), (4, 8), 40, (12, 30))], walled), cases=72, skills="origin inside"),
]

PRODUCTION = [
    group("ties", "Several circles met at once, touches, and origins on a circle; others are just off.", ties((5, 9), 40), skills="ties of circles"),
    group("grid", "The smallest numbers: origins on a circle, touches and ties come up by themselves.", either(fields((1, 2), (12, 17), 1, (1, 2), fastest=2), aside(fields((5, 9), (12, 17), 3, (1, 3), fastest=2), 4), edges, edges), cases=280, skills="the small grid"),
    group("near", "Rays that nearly touch a circle, nearly begin on one, nearly pass its centre, or meet two at nearly one place.", either(*4 * [nearly((3, 6), 4_000)], *2 * [hairs], slight), cases=145, skills="nearly is not touching"),
    group("leaving", "Rays in any direction from a place on a circle, and from its centre, there with a D of two lengths.", either(*2 * [leaving((3, 6), 60)], departing), cases=45, skills="origin inside"),
    group("sparse", "Small circles far apart: most rays go a long way and meet nothing.", fields((150, 300), (60, 90), 20_000, (60, 110)), cases=20, skills="walk through boxes"),
    group("big-and-small", "Radii from 1 to 1000 times of that: large circles reach over hundreds of small ones.", fields((150, 300), (60, 90), 30_000, (20, 60), (9_000, 20_000)), cases=20, skills="large among small"),
    group("clustered", "Dense clusters of circles that overlap, wide empty room between them, and a few large circles.", clusters((300, 500), (80, 120), 50_000, (20, 300), (15_000, 30_000)), cases=10, skills="walk through boxes"),
    group("heaps", "Each circle many times over, or as rings about one centre: no cut parts them.", either(*3 * [heaps((3, 8), (8, 16), 90, (5, 20), (3, 12))], rings), cases=27, skills="ties of circles"),
    group("strip", "Small circles in a strip that is thousands of times as long as wide: rays run along it.", strips((150, 300), (40, 60), 1_000_000, 60, (1, 4)), cases=10, skills="walk through boxes"),
    group("wide", "Few circles and whole numbers of all seven digits.", either(*5 * [fields((2, 8), (9, 17), 1 << 20, (10_000, 400_000))], askew, *3 * [afar], opposite), cases=120, skills="full precision"),
    group("corner-to-corner", "Rays from one corner of the world to another one, or all along a side of it.", corners, cases=12, skills="full precision"),
    group("n-500", "500 circles and 125 rays: where the growth is measured from.", crowded(500), cases=5, size=500, skills="do not ask all of them"),
    group("n-2000", "2,000 circles and 500 rays.", crowded(2_000), cases=3, size=2_000, time_limit=30, limits={"cpu_seconds": 10, "wall_seconds": 60}, skills="do not ask all of them"),
    group("n-8000", "8,000 circles and 2,000 rays.", crowded(8_000), cases=2, size=8_000, time_limit=30, limits={"cpu_seconds": 15, "wall_seconds": 60}, skills="do not ask all of them"),
    group("n-32000", "32,000 circles and 8,000 rays.", crowded(32_000), cases=1, size=32_000, time_limit=30, limits={"cpu_seconds": 30, "wall_seconds": 90}, skills="do not ask all of them"),
]
