"""convex pieces

The squared distance of P(t) from the wall is a convex function of t in at most three pieces: before A, beside the
wall, and after B. Cut the time where the foot passes an end. In each piece the function is a quadratic; look through
the pieces in order for the first root, or where it does not go below r², for the lowest point that is as low as r².
"""

from math import hypot, inf, sqrt


def pieces(fx, fy, dx, dy, wx, wy):
    """(from, to, a, b, k, g): there the distance is that of (g + b·t, k + a·t)."""
    wall = hypot(wx, wy)
    if wall == 0:
        return [(-inf, inf, fx, fy, dx, dy)]
    ux, uy = wx / wall, wy / wall
    x, y, u, v = fx * ux + fy * uy, ux * fy - uy * fx, dx * ux + dy * uy, ux * dy - uy * dx
    if u == 0:  # straight towards the wall, or no motion
        over = min(max(x, 0), wall)
        return [(-inf, inf, x - over, y, u, v)]
    first, last = sorted((-x / u, (wall - x) / u))
    at, to = (0, wall) if u > 0 else (wall, 0)
    return [(-inf, first, x - at, y, u, v), (first, last, 0, y, 0, v), (last, inf, x - to, y, u, v)]


def time_of_impact(P0, P1, r, A, B):
    fx, fy = P0[0] - A[0], P0[1] - A[1]
    dx, dy = P1[0] - P0[0], P1[1] - P0[1]
    sizes = [z - p for end in (A, B) for place in (P0, P1) for z, p in zip(end, place)]
    near = 1e-10 * max(r, *map(abs, sizes))
    parts = pieces(fx, fy, dx, dy, B[0] - A[0], B[1] - A[1])
    way = hypot(dx, dy)
    for low, high, x, y, u, v in parts:
        if low <= 0 <= high and hypot(x, y) <= r + near:
            return 0
    lowest = None
    for low, high, x, y, u, v in parts if way else []:
        speed = hypot(u, v)
        if speed < 1e-9 * way:  # along the wall: it is as low at the end of the piece before
            continue
        d, foot = abs(x * v - y * u) / speed, -(x * u + y * v) / speed / speed
        half = sqrt(max(0.0, (r - d) * (r + d))) / speed
        slack = near / way
        if (d < r - near or d == 0) and low - slack <= foot - half <= high + slack:
            t = foot - half
            return t if t >= 0 and (t - 1) * way <= near else None
        if abs(d - r) <= near and low - slack <= foot <= high + slack and lowest is None:
            lowest = foot
    if lowest is None or lowest < 0 or (lowest - 1) * way > near:
        return None
    return lowest
