"""interval-arithmetic

Every number is an interval, and every operation moves its ends outward by one double. Only 0, which comes of
nothing but zeros and equal numbers, stays as it is.
"""

from math import inf, nextafter


def outward(low, high):
    return (low, high) if low == high == 0.0 else (nextafter(low, -inf), nextafter(high, inf))


def minus(x, y):
    return outward(x[0] - y[1], x[1] - y[0])


def plus(x, y):
    return outward(x[0] + y[0], x[1] + y[1])


def times(x, y):
    ends = [a * b for a in x for b in y]
    return outward(min(ends), max(ends))


def square(x):
    low, high = times(x, x)
    return max(0.0, low), high


def delta_enclosure(cx, cy, r, ax, ay, bx, by):
    cx, cy, r, ax, ay, bx, by = ((float(x), float(x)) for x in (cx, cy, r, ax, ay, bx, by))
    dx, dy, fx, fy = minus(bx, ax), minus(by, ay), minus(ax, cx), minus(ay, cy)
    k = minus(times(dx, fy), times(dy, fx))
    return minus(times(square(r), plus(square(dx), square(dy))), square(k))
