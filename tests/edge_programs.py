"""Programs that are right but for one thing, which their keywords change: a threshold, a type, a memory.

Each is careful otherwise: centre at the origin, r²a − k² for the discriminant, roots that add.
"""

from __future__ import annotations

from fractions import Fraction
from math import hypot, inf, sqrt

USUAL = 1e-10  # of the extent


def wrapped(value, bits=64):
    """An integer as so many bits keep it."""
    half = 1 << (bits - 1)
    return (int(value) + half) % (2 * half) - half


def of_bits(bits):
    """r²a, k and k² of whole numbers, every product kept in so many bits."""

    def wrap(value):
        return wrapped(value, bits)

    return wrap


def count(
    cx,
    cy,
    r,
    a,
    b,
    *,
    hit=USUAL,
    miss=USUAL,
    null=0.0,
    upright=0.0,
    floor=False,
    bits=None,
    reach=None,
    least=0.0,
):
    (ax, ay), (bx, by) = a, b
    if bits and all(type(v) is int for v in (cx, cy, r, *a, *b)):
        wrap = of_bits(bits)
        dx, dy, fx, fy = bx - ax, by - ay, ax - cx, ay - cy
        if dx == dy == 0:
            return None
        k = wrap(wrap(dx * fy) - wrap(dy * fx))
        gap = wrap(wrap(wrap(r * r) * wrap(wrap(dx * dx) + wrap(dy * dy))) - wrap(k * k))
        return 1 + (gap > 0) - (gap < 0)
    dx, dy, fx, fy = bx - ax, by - ay, ax - cx, ay - cy
    spans = {"r": r, "ax": abs(fx), "ay": abs(fy), "bx": abs(bx - cx), "by": abs(by - cy)}
    if reach:
        spans |= reach(r, fx, fy, bx - cx, by - cy)
    e = max(spans.values())
    length = hypot(dx, dy)
    if length <= null * e or length == 0:
        return None
    if abs(dx) < upright * e:
        dx, length = 0.0, abs(dy)
    if floor:
        gap = r * r - (dx * fy - dy * fx) ** 2 // (dx * dx + dy * dy)
        return 1 + (gap > 0) - (gap < 0)
    d = abs(dx * fy - dy * fx) / length if length else inf
    if -hit * e - least <= d - r <= miss * e + least:
        return 1
    return 2 if d < r else 0


def segment(
    cx, cy, r, a, b, *,
    hit=USUAL, miss=USUAL, before=USUAL, inside=0.0, point=USUAL, null=0.0, upright=0.0, bits=None, least=0.0,
):  # fmt: skip
    (ax, ay), (bx, by) = a, b
    dx, dy, fx, fy = bx - ax, by - ay, ax - cx, ay - cy
    e = max(r, abs(fx), abs(fy), abs(bx - cx), abs(by - cy))
    length = hypot(dx, dy)
    if length <= null * e:
        return [a] if abs(hypot(fx, fy) - r) <= point * e + least else []
    if bits and all(type(v) is int for v in (cx, cy, r, *a, *b)):
        wrap = of_bits(bits)
        k = wrap(wrap(dx * fy) - wrap(dy * fx))
        gap = wrap(wrap(wrap(r * r) * wrap(wrap(dx * dx) + wrap(dy * dy))) - wrap(k * k))
        near = gap == 0
        crosses = gap > 0
        half = sqrt(max(gap, 0)) / length
    else:
        if abs(dx) < upright * e:
            dx = 0.0
            length = abs(dy)
        if not length:
            return []
        d = abs(dx * fy - dy * fx) / length
        near = -hit * e - least <= d - r <= miss * e + least
        crosses = d < r
        half = sqrt(max(0.0, (r - d) * (r + d)))
    if not near and not crosses:
        return []
    foot = -(fx * dx + fy * dy) / length
    roots = [foot] if near else [foot - half, foot + half]
    low, high = inside * e - before * e - least, length - inside * e + before * e + least
    return [(ax + s * dx / length, ay + s * dy / length) for s in roots if low <= s <= high]


def ray(
    cx, cy, r, o, d, *,
    hit=USUAL, miss=USUAL, behind=USUAL, ahead=USUAL, skip=0.0, skip_t=0.0, upright=0.0, bits=None, least=0.0,
):  # fmt: skip
    (ox, oy), (dx, dy) = o, d
    fx, fy = ox - cx, oy - cy
    e = max(r, abs(fx), abs(fy))
    length = hypot(dx, dy)
    if length == 0:
        return None
    c = fx * fx + fy * fy - r * r
    if bits and all(type(v) is int for v in (cx, cy, r, *o, *d)):
        wrap = of_bits(bits)
        k = wrap(wrap(dx * fy) - wrap(dy * fx))
        gap = wrap(wrap(wrap(r * r) * wrap(wrap(dx * dx) + wrap(dy * dy))) - wrap(k * k))
        if gap < 0:
            return None
        c = wrap(wrap(wrap(fx * fx) + wrap(fy * fy)) - wrap(r * r))
        near, half = gap == 0, sqrt(gap) / length
    else:
        if abs(dx) < upright * length:
            dx, length = 0.0, abs(dy)
        away = abs(dx * fy - dy * fx) / length
        near = -hit * e - least <= away - r <= miss * e + least
        if not near and away > r:
            return None
        half = sqrt(max(0.0, (r - away) * (r + away)))
        c = float(Fraction(fx) ** 2 + Fraction(fy) ** 2 - Fraction(r) ** 2) if abs(c) < 1e-3 * e * e else c
    b = (fx * dx + fy * dy) / length
    if near:
        roots = [-b]
    else:
        q = -b - half if b > 0 else -b + half
        roots = sorted([q, c / q if q else 0.0])
    for s in roots:
        if (skip and s < skip * e) or (skip_t and s / length < skip_t):
            continue
        if -behind * e - least <= s <= ahead * e + least:
            return 0.0
        if s > 0:
            return s / length
    return None


def forgetful(function, *left_out):
    """The function with a memory whose key leaves arguments out: 0 to 4, of which 3 and 4 are the points."""
    kept = {}

    def call(*case):
        key = tuple(value for place, value in enumerate(case) if place not in left_out)
        if key not in kept:
            kept[key] = function(*case)
        return kept[key]

    return call


def stale(function, *left_out):
    """The function that remembers its last call only."""
    last = []

    def call(*case):
        key = tuple(value for place, value in enumerate(case) if place not in left_out)
        if not last or last[0] != key:
            last[:] = [key, function(*case)]
        return last[1]

    return call


ENTRIES = {"count": count, "segment": segment, "ray-nearest": ray}
TIGHT, LOOSE = (5e-13, 9e-13), (1.2e-7, 1.5e-7, 2e-7)


def thresholds(*names, of=(*TIGHT, *LOOSE)):
    return [{name: threshold} for name in names for threshold in of]


WRONG = {
    "count": [
        *thresholds("hit", "miss"),
        {"null": 1e-6},
        {"upright": 1e-9},
        {"floor": True},
        {"bits": 64},
        {"bits": 32},
        {"least": 1e-29},
    ],
    "segment": [
        *thresholds("hit", "miss", "before", "point"),
        {"inside": 1.2e-7},
        {"null": 1e-6},
        {"upright": 1e-9},
        {"bits": 64},
        {"bits": 32},
        {"least": 1e-29},
    ],
    "ray-nearest": [
        *thresholds("hit", "miss", "behind"),
        *thresholds("ahead", of=LOOSE),  # a shorter one is right: where t is 0, the band's width is allowed
        {"skip": 1e-6},
        {"skip_t": 1e-6},
        {"upright": 1e-9},
        {"bits": 64},
        {"bits": 32},
        {"least": 1e-29},
    ],
}
