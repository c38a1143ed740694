"""kept-between-calls

What depends on the wall is kept, under its first end alone: another wall from there gets the answer of the first one.
Make both ends the key, or keep nothing.
"""

from math import hypot, sqrt

walls = {}


def time_of_impact(P0, P1, r, A, B):
    if A not in walls:
        walls[A] = B[0] - A[0], B[1] - A[1], hypot(B[0] - A[0], B[1] - A[1])
    wx, wy, wall = walls[A]
    dx, dy = P1[0] - P0[0], P1[1] - P0[1]
    fx, fy = P0[0] - A[0], P0[1] - A[1]
    gx, gy = fx - wx, fy - wy
    near = 1e-10 * max(r, hypot(fx, fy), hypot(gx, gy), hypot(dx, dy))
    height = (wx * fy - wy * fx) / wall if wall else 0
    foot = (fx * wx + fy * wy) / wall if wall else 0
    start = abs(height) if 0 < foot < wall else min(hypot(fx, fy), hypot(gx, gy))
    if start <= r + near:
        return 0
    way = hypot(dx, dy)
    if way == 0:
        return None
    times = []
    for x, y in ((fx, fy), (gx, gy)):
        d = abs(dx * y - dy * x) / way
        if d <= r + near:
            half = sqrt((r - d) * (r + d)) if d < r - near else 0
            times.append((-(dx * x + dy * y) / way - half) / way)
    if wx * dy != wy * dx and wall:
        turn = (wx * dy - wy * dx) / wall
        t = ((r if height > 0 else -r) - height) / turn
        if 0 <= foot + t * (dx * wx + dy * wy) / wall <= wall:
            times.append(t)
    t = min(times, default=-1)
    return t if t >= 0 and (t - 1) * way <= near else None
