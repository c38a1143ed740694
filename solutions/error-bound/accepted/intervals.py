"""interval-arithmetic

Every number is an interval, and every operation rounds its ends outward by one double, where it rounds at
all: sums and products whose error is 0 stay as they are.
"""

from math import inf, nextafter


def outward(low, high, exact):
    return (low, high) if exact else (nextafter(low, -inf), nextafter(high, inf))


def minus(x, y):
    low, high = x[0] - y[1], x[1] - y[0]
    point = x[0] == x[1] and y[0] == y[1]
    exact = point and low + y[0] == x[0] and x[0] - low == y[0] and abs(low) <= max(abs(x[0]), abs(y[0]))
    return outward(low, high, exact or (low == high == 0.0))


def plus(x, y):
    if y == (0.0, 0.0):
        return x
    return outward(x[0] + y[0], x[1] + y[1], x == (0.0, 0.0))


def times(x, y):
    ends = [a * b for a in x for b in y]
    return outward(min(ends), max(ends), min(ends) == max(ends) == 0.0)


def square(x):
    low, high = sorted(map(abs, x))
    inside = x[0] <= 0.0 <= x[1]
    if high == 0.0:
        return 0.0, 0.0
    return (0.0 if inside else nextafter(low * low, 0.0)), nextafter(high * high, inf)


def delta_enclosure(cx, cy, r, ax, ay, bx, by):
    cx, cy, r, ax, ay, bx, by = ((float(x), float(x)) for x in (cx, cy, r, ax, ay, bx, by))
    dx, dy, fx, fy = minus(bx, ax), minus(by, ay), minus(ax, cx), minus(ay, cy)
    k = minus(times(dx, fy), times(dy, fx))
    return minus(times(square(r), plus(square(dx), square(dy))), square(k))
