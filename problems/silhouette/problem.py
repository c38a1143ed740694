"""A line held against a circle that moves: 1 or 0 for each frame, steadily."""

from fractions import Fraction
from math import hypot

from judge.geometry.frames import steady
from judge.geometry.hooks import hooks
from judge.geometry.pose import triple
from judge.geometry.scenes import ASKEW, AXIS, HUGE, NEAR, OFFSET, PLAIN, STEEP, TILTED, TINY, aimed, anything, either, frames, ratios
from judge.geometry.scenes.lines import astray
from judge.problem.declare import group

HOOKS = hooks("frames")
ALL = "in", "less", "more", "out", "centre"
FULL = {**HUGE, "size": 2**32}
CLOSE = {**NEAR, "size": 40, "least": 7}
EXACT = "low", "high", "low", "high", "less", "more"


def solve(circles, O, D, h):
    return steady(circles, O, D, h)


def thin(draw):
    """h is 0.0004 to 0.0005, and a distance misses a threshold by little more than 1e-7 of the figure."""
    h, r = draw.integer(400, 499) / 10**6, draw.integer(2**28, 2**29)
    gap = r * draw.integer(1010, 1200) // 10**10 + 1
    distances = [draw.choice((r // 2, r // 2, 3 * r // 2))]
    for _ in range(draw.integer(1, 3)):
        distances.append(round(r * (1 + Fraction(h) * draw.sign()) + gap * draw.choice((1, 1, -1))))
    scale, upright = 2.0 ** draw.choice((0, -20, -60)), draw.boolean()
    start = draw.integer(0, r // 2)
    rows = [((start + draw.integer(-r, r)) * scale, d * draw.sign() * scale, r * scale) for d in distances]
    O, D = (start * scale, 0), (draw.integer(1, 9) * draw.sign(), 0)
    if upright:
        O, D, rows = O[::-1], D[::-1], [(y, x, r) for x, y, r in rows]
    return tuple(rows), O, D, h


def hardly(draw):
    """D leaves an axis by 6e-7 to 9e-7, and a distance hardly misses a threshold; or points are 2e-7 to 6e-7 beside it."""
    far, h = draw.integer(2**40, 2**41) * 2.0 ** -draw.integer(20, 60), draw.integer(1, 31) / 64
    dots, turn = draw.boolean(), draw.choice((1, -1))
    lean, rows = 0 if dots else draw.integer(60, 90) / 10**8 * draw.sign(), []
    for at in range(draw.integer(4, 8)):
        y, gap = (far * draw.integer(low, high) / per * draw.sign() for low, high, per in ((70, 99, 100), (110, 300, 10**9)))
        r = 0 if dots and at % 2 else far * draw.integer(10, 60) / 100
        d = 2 * gap if not r else r / 2 if dots or not at else r * (1 + h * draw.sign()) + gap
        rows.append((*(lean * y + d * draw.sign(), y)[::turn], r))
    k = draw.integer(1, 9) * draw.sign()
    return tuple(rows), (0, 0), (lean * k, k)[::turn], h


def laid(draw, frames, unit=1.0):
    """The rows (along, d, r) of frames beside a line that is turned by a triple or along an axis."""
    p, q, c = draw.choice(((1, 0, 1), (0, 1, 1), triple(draw, 65)))
    p, q = p * draw.sign() * unit, q * draw.sign() * unit
    start, k = draw.integer(-9, 9), draw.integer(1, 9) * draw.sign()
    rows = [((start + x) * p - d * q + 0, (start + x) * q + d * p + 0, r * c * unit) for x, d, r in frames]
    return tuple(rows), (start * p + 0, start * q + 0), (k * p + 0, k * q + 0)  # no −0.0


def verge(draw):
    """h is the least or the greatest there is, or of many digits, and a distance hardly misses a threshold."""
    kind, frames = draw.choice(("least", "most", "digits")), []
    h = {"least": draw.integer(100, 107) / 10**6, "most": draw.integer(499_800, 499_899) / 10**6}.get(kind)
    h = h or (draw.integer(1, 4_900) * 10_000 + draw.integer(35, 65)) / 10**8
    low, high = (11, 14) if kind == "digits" else (12, 50)
    for _ in range(draw.integer(2, 4)):
        r, side = draw.integer(2**28, 2**29), draw.sign()
        d, x = r * (1 + Fraction(h) * side), draw.integer(-r // 4, r // 4)
        gap = hypot(x, max(r, d)) * draw.integer(low, high) / 10**8
        frames.append((draw.integer(-r, r), draw.sign() * (r // 5 if side > 0 else 2 * r), r))
        for each in draw.choice(((1, -1), (-1, 1))):
            frames.append((x, draw.sign() * round(d + gap * each * draw.choice((1, 1, 2))), r))
    return *laid(draw, frames, 2.0 ** -draw.choice((10, 30, 70))), h


def staying(draw):
    """The same circle is exactly at a threshold in three frames or four, one after the other."""
    parts, frames = draw.integer(1, 31), []
    for side in draw.choice(((1, -1), (-1, 1))):
        r = 64 * draw.integer(1, 99)
        frames.append((draw.integer(-r, r), r // 4 if side > 0 else 2 * r, r))
        circle = draw.integer(-r, r), (r + side * r // 64 * parts) * draw.sign(), r
        frames += draw.integer(3, 4) * [circle]
    rows, O, D = laid(draw, frames, 2.0 ** -draw.choice((10, 30, 70)))
    return rows, O, D, parts / 64


def later(draw):
    """A circle between the thresholds comes again after 32 to 75 frames, when what is shown is something else."""
    parts, r, side = draw.integer(8, 31), 64 * draw.integer(1, 9), draw.sign()

    def clear(shown):
        return draw.integer(-r, r), (draw.integer(0, 31 * r // 64) if shown else draw.integer(2 * r, 3 * r)) * draw.sign(), r

    between = draw.integer(-r, r), r + (r // 64 * draw.integer(1, parts - 1)) * draw.sign(), r
    frames = [clear(side > 0), between]
    frames += [clear(draw.boolean()) for _ in range(draw.choice((draw.integer(30, 58), draw.integer(62, 72), draw.integer(62, 72))))]
    frames += [clear(side < 0), between, *[between] * draw.integer(0, 1)]
    return *laid(draw, frames, 1), parts / 64


def afield(draw):
    """Far from the origin a distance is exactly at a threshold, and that of the rounded foot is beyond it; of many the size is 1e-8."""
    large = draw.choice((True, True, False))
    for _ in range(200):
        times, eighths, side = draw.choice(((3, 2, -1), (5, 2, 1), (7, 1, -1), (9, 1, 1), (11, 3, 1)))
        cx, cy, d, A, B = astray(times=times)(draw)
        r, dx, dy = 8 * d / times if eighths != 2 else 4 * d / times, B[0] - A[0], B[1] - A[1]
        fx, fy, length = A[0] - cx, A[1] - cy, hypot(dx, dy)
        s, size = -(fx * dx + fy * dy) / length, max(r, abs(fx), abs(fy))
        off = hypot(A[0] + s * (dx / length) - cx, A[1] + s * (dy / length) - cy) - d
        if off * side > 2e-9 * size and (not large or abs(cx) + abs(cy) < 1e8 * size):
            break
    else:
        draw.reject()
    rows, k = [(cx, cy, 3 * d if side > 0 else d / 2), (cx, cy, r)], draw.integer(1, 9)
    for _ in range(draw.integer(0, 2)):
        at = draw.choice((0, 1, -1))
        rows.append((cx + at * dx, cy + at * dy, draw.choice((3 * d, d / 2, r))))
    return tuple(rows), A, (k * dx, k * dy), eighths / 8


def swaying(draw):
    """A circle far away along a slanting line is exactly at a threshold, and the most that rounding can do puts it beyond."""
    p, q, c = draw.choice(((1475, 1428, 2053), (1428, 1475, 2053), (620, 861, 1061), (120, 119, 169), (403, 396, 565)))
    parts, frames = draw.integer(2, 31), []
    for _ in range(50 * draw.integer(1, 3)):
        r, side, up = 64 * draw.integer(2**12, 2**22), draw.sign(), draw.sign()
        s, d = r * draw.integer(50, 500) * draw.sign() + draw.integer(0, r), r // 64 * (64 + side * parts)
        x, y = s * p - up * d * q, s * q + up * d * p
        if (abs(p / c * y - q / c * x) - d * c) * side > 1.52e-16 * max(abs(x), abs(y)):
            frames += [(draw.integer(-r, r), r // 4 if side > 0 else 2 * r, r), (s, up * d, r)]
    if not frames:
        draw.reject()
    unit, k, turn, left, back = 2.0 ** -draw.choice((20, 30, 70)), draw.integer(0, 4), draw.choice((1, -1)), draw.sign(), draw.sign()
    rows = [(*((x * p - y * q) * unit * left, (x * q + y * p) * unit * back)[::turn], r * c * unit) for x, y, r in frames]
    return tuple(rows), (0, 0), (p * 2**k * left, q * 2**k * back)[::turn], parts / 64


def apart(draw):
    """A line along an axis, 1e8 to 1e13 radii from the origin; a distance hardly misses a threshold, or r in the first frame."""
    h, rows = draw.integer(1, 31) / 64, []
    unit, turn = 2.0 ** -draw.integer(60, 90), draw.choice((1, -1))
    far, step = draw.integer(2**20, 2**22) * 2.0 ** draw.integer(39, 52), 2**30
    for at in range(draw.integer(2, 5)):
        r, side = draw.integer(2**31, 2**32), draw.sign()
        d = r * (1 + (Fraction(h) * side if at else 0)) + r * draw.integer(22, 60) // 10**8 * draw.sign()
        if at:  # what is shown before is the other one
            rows.append((far, 3 * r * (side < 0), r))
        rows.append((far + draw.integer(-1, 1) * step, round(d) * draw.sign(), r))
    O, D = (far + draw.integer(-1, 1) * step, 0.0), (draw.integer(1, 9) * draw.sign(), 0)
    rows = [(*(x * unit, y * unit)[::turn], r * unit) for x, y, r in rows]
    return tuple(rows), tuple(n * unit for n in O)[::turn], D[::turn], h


def parts(draw):
    """A distance hardly misses r in the first frame, or the upper threshold in the second one."""
    cx, cy, r, O, D = aimed(ratios(near=True))(draw)
    h, second = draw.integer(1, 31) / 64, draw.boolean()
    rows = ((cx, cy, 3 * r), (cx, cy, r / (1 + h))) if second else ((cx, cy, r),)
    return rows, O, D, h


INTERVIEW = [
    group("grid", "Small whole numbers: everything that can happen.", anything(4, 4), cases=120, skills="distance against radius"),
    group("walk", "The circle comes and goes, past both thresholds and between them.", either(frames(*ALL, **PLAIN), frames(*ALL, **AXIS)), skills=("a state that is kept", "distance against radius", "no slopes")),
    group("flicker", "The circle trembles about a touch, between the thresholds: what is shown stays.", frames("less", "more", **PLAIN), skills="two thresholds"),
    group("one-sided", "Beyond r, but not past the threshold that counts.", either(frames("less", "out", **PLAIN), frames("more", "in", **PLAIN)), skills="two thresholds"),
    group("growing", "The radius changes from frame to frame, and the thresholds with it.", either(frames(*ALL, grows=True, **PLAIN), frames(*ALL, first=("broad",), **PLAIN)), skills="thresholds as wide as the figure"),
    group("start", "The first frame is between the thresholds: it shows whether d < r.", frames(*ALL, first=("less", "more"), count=(1, 10), **PLAIN), skills="the first frame has no past"),
    group("again", "The same few circles come again and again.", either(*3 * [frames(*ALL, again=True, **PLAIN)], later), cases=54, skills="a state that is kept"),
]

PRODUCTION = [
    group("at-threshold", "A distance exactly at a threshold, which does not pass it.", either(*4 * [frames(*EXACT, exact=True, **FULL)], staying, swaying), cases=90, skills="a tangent has a width"),
    group("near-threshold", "A distance that misses a threshold by 1e-7 of the figure, or r in the first frame.", either(*5 * [either(frames("low~", "high~", exact=True, **CLOSE), frames("low~", "high~", exact=True, count=(2, 4), **CLOSE), frames("low~", "high~", first=("broad",), exact=True, count=(2, 4), **CLOSE), frames("less", "more", first=("even~",), count=(1, 4), **CLOSE), frames("dot~", "dot", "in", "out", **CLOSE))], thin, hardly, verge, verge), cases=155, skills="nearly is not touching"),
    group("vanishing", "The radius is 0 in some frames.", either(frames(*ALL, "dot", "dot-miss", "dot-origin", **PLAIN), frames("dot-again", first=("centre",), count=(2, 3), away=10**4, **{**FULL, "move": "split"}), frames(*EXACT, first=("dot-miss",), exact=True, **FULL)), cases=90, skills="thresholds as wide as the figure"),
    group("tiny", "Circles of 1e-20 and less.", frames(*ALL, "low", "high", exact=True, grows=True, **{**TINY, "size": 40}), skills=("no absolute epsilon", "scale invariance")),
    group("long", "Two hundred frames.", frames(*ALL, count=(200, 200), **PLAIN), cases=8, skills="a state that is kept"),
    group("far", "The centre is up to a thousand radii away along the line.", frames(*ALL, *EXACT, exact=True, away=1000, **PLAIN), skills="scale invariance"),
    group("direction-length", "Directions up to 1e24 times longer than the figure.", frames(*ALL, "low~", "high~", exact=True, **{**NEAR, "size": 40, "shift": -60, "stretch": (0, 40, 70, 82)}), skills="scale invariance"),
    group("offset", "A small circle far from the origin.", either(*2 * [frames(*EXACT, "in", "out", exact=True, **{**OFFSET, "size": 8}), frames("low~", "high~", exact=True, **{**OFFSET, "size": 8})], afield, afield, *2 * [apart]), cases=106, skills="far from the origin"),
    group("steep", "Directions almost along an axis.", either(frames(*ALL, count=(1, 8), **ASKEW), frames(*ALL, *EXACT, exact=True, **{**STEEP, "size": 16}), frames(*ALL, count=(1, 8), **{**TILTED, "tilt": (20, 75)})), cases=80, skills="no slopes"),
    group("small-parts", "A coordinate, a product or the short side of a triangle is tiny beside the others, and decides.", parts, skills="no slopes"),
    group("large", "Whole numbers up to 2**30.", anything(2**30, 24), skills="whole numbers that are large"),
    group("repeated", "Neighbouring calls differ in one argument.", anything(4, 4), turns=True, skills="nothing kept between calls"),
]
