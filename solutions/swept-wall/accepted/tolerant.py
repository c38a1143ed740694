"""the widest tolerance

All lengths are compared with 1e-8 of the size: the distance at the start, that of an end from the way, and the way
that is left at the end.
"""

from math import hypot, sqrt


def time_of_impact(P0, P1, r, A, B):
    fx, fy, gx, gy = P0[0] - A[0], P0[1] - A[1], P0[0] - B[0], P0[1] - B[1]
    dx, dy, wx, wy = P1[0] - P0[0], P1[1] - P0[1], B[0] - A[0], B[1] - A[1]
    near = 1e-8 * max(r, *map(abs, (fx, fy, gx, gy, P1[0] - A[0], P1[1] - A[1], P1[0] - B[0], P1[1] - B[1])))
    wall, way = hypot(wx, wy), hypot(dx, dy)
    foot, height = ((fx * wx + fy * wy) / wall, (wx * fy - wy * fx) / wall) if wall else (0.0, 0.0)
    if (abs(height) if 0 < foot < wall else min(hypot(fx, fy), hypot(gx, gy))) <= r + near:
        return 0
    if way == 0:
        return None
    ways = []
    for x, y in ((fx, fy), (gx, gy)):
        d, middle = abs(dx * y - dy * x) / way, -(dx * x + dy * y) / way
        if d <= r + near:
            ways.append(middle - (sqrt((r - d) * (r + d)) if d < r - near else 0.0))
    turn = (wx * dy - wy * dx) / wall if wall else 0.0
    if abs(turn) > 1e-5 * way:
        t = ((r if height > 0 else -r) - height) / turn
        if 0 <= foot + t * (dx * wx + dy * wy) / wall <= wall:
            ways.append(t * way)
    first = min((each for each in ways if each >= 0), default=None)
    return None if first is None or first > way + near else first / way
