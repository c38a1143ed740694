"""fat wall

Let the disc be a point, and fatten the wall by r: two sides, and a cap around each end. The distance from the
wall's line changes evenly, and is r at one moment on the side that P0 is on. Each cap is a circle that a ray meets.
The first of all these moments is the answer.
"""

from math import hypot, sqrt


def time_of_impact(P0, P1, r, A, B):
    dx, dy = P1[0] - P0[0], P1[1] - P0[1]
    wx, wy = B[0] - A[0], B[1] - A[1]
    fx, fy = P0[0] - A[0], P0[1] - A[1]
    gx, gy = P0[0] - B[0], P0[1] - B[1]
    near = 1e-10 * max(r, *(abs(z) for z in (fx, fy, gx, gy, P1[0] - A[0], P1[1] - A[1], P1[0] - B[0], P1[1] - B[1])))
    wall = hypot(wx, wy)
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
    turn = (wx * dy - wy * dx) / wall if wall else 0
    if turn:
        t = ((r if height > 0 else -r) - height) / turn
        if 0 <= foot + t * (dx * wx + dy * wy) / wall <= wall:
            times.append(t)
    t = min(times, default=-1)
    return t if t >= 0 and (t - 1) * way <= near else None
