"""off the surface

The point is moved a little along the normal, to the side that the ray sees. Then the segment to the light is asked of
every circle alike: is it cut between its ends?
"""

from math import sqrt


def cut(circle, p, q):
    """Whether the circle has a point between p and q, by the power of both ends and the foot."""
    x, y, r = circle
    fx, fy, gx, gy = p[0] - x, p[1] - y, q[0] - x, q[1] - y
    inner, outer = sqrt(fx * fx + fy * fy) - r, sqrt(gx * gx + gy * gy) - r
    if inner < 0 or outer < 0:
        return (inner < 0) != (outer < 0)
    dx, dy = gx - fx, gy - fy
    along, square = -(fx * dx + fy * dy), dx * dx + dy * dy
    return 0 < along < square and abs(dx * fy - dy * fx) < r * sqrt(square)


def light(circles, O, D, L):
    moved = [(x - O[0], y - O[1], r) for x, y, r in circles]
    lx, ly = L[0] - O[0], L[1] - O[1]
    e = max(abs(lx), abs(ly), *(max(abs(x), abs(y), r) for x, y, r in moved))
    a = D[0] * D[0] + D[1] * D[1]
    best = None
    for x, y, r in moved:
        k = (D[0] * y - D[1] * x) / sqrt(a)
        if abs(k) < r:
            m, h = (D[0] * x + D[1] * y) / sqrt(a), sqrt((r - k) * (r + k))
            for s in (m - h, m + h):
                if s > 0 and (best is None or s < best[0]):
                    best = s, x, y, r
    if best is None:
        return None
    s, x, y, r = best
    px, py = s * D[0] / sqrt(a), s * D[1] / sqrt(a)
    nx, ny = (px - x) / r, (py - y) / r
    side = -1 if nx * D[0] + ny * D[1] > 0 else 1
    if side * (nx * (lx - px) + ny * (ly - py)) < 0:
        return "dark"
    start = px + side * 1e-9 * e * nx, py + side * 1e-9 * e * ny
    return "dark" if any(cut(circle, start, (lx, ly)) for circle in moved) else "lit"
