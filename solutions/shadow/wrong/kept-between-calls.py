"""kept-between-calls

The first hit is kept for each list of circles and origin, and a later call with another direction is given that one.
What is kept needs a key of all that it was made of; or keep nothing.
"""

from math import hypot, sqrt

known = {}


def distances(circle, start, way):
    x, y, r = circle
    fx, fy = start[0] - x, start[1] - y
    d = abs(way[0] * fy - way[1] * fx)
    if d >= r:
        return ()
    foot, half = -(fx * way[0] + fy * way[1]), sqrt((r - d) * (r + d))
    return foot - half, foot + half


def light(circles, O, D, L):
    extent = max(abs(L[0] - O[0]), abs(L[1] - O[1]), *(max(r, abs(x - O[0]), abs(y - O[1])) for x, y, r in circles))
    length = hypot(*D)
    way = D[0] / length, D[1] / length
    key = tuple(circles), tuple(O)
    if key not in known:
        known[key] = min(((s, c) for c in circles for s in distances(c, O, way) if s > 0), default=None)
    if known[key] is None:
        return None
    s, (x, y, r) = known[key]
    nx, ny = O[0] - x + s * way[0], O[1] - y + s * way[1]
    vx, vy = L[0] - x - nx, L[1] - y - ny
    if (way[0] * nx + way[1] * ny < 0) != (vx * nx + vy * ny > 0):
        return "dark"
    reach = hypot(vx, vy)
    for cx, cy, radius in circles:
        seen = cx - x, cy - y, radius
        if any(1e-9 * extent < each < reach for each in distances(seen, (nx, ny), (vx / reach, vy / reach))):
            return "dark"
    return "lit"
