"""a least t

The second ray is like the first, but starts a hair off the surface and ends at the light.

Both rays ask each circle for its roots: with d the distance of the line from C, the foot minus and plus √((r − d)(r + d)).
The first one takes the least root ahead. The second one takes any root between 1e-9 of the size, so that the point is
not in its own shadow, and the light. Which side the ray sees is the sign of D·N, N = P − C.
"""

from math import hypot, sqrt


def distances(circle, start, way):
    """How far along the unit vector `way` the line meets the circle: two distances, or none."""
    x, y, r = circle
    fx, fy = start[0] - x, start[1] - y
    d = abs(way[0] * fy - way[1] * fx)
    if d >= r:
        return ()
    foot, half = -(fx * way[0] + fy * way[1]), sqrt((r - d) * (r + d))
    return foot - half, foot + half


def light(circles, O, D, L):
    size = max(abs(L[0] - O[0]), abs(L[1] - O[1]), *(max(r, abs(x - O[0]), abs(y - O[1])) for x, y, r in circles))
    near = 1e-9 * size
    length = hypot(*D)
    way = D[0] / length, D[1] / length
    first = min(((s, circle) for circle in circles for s in distances(circle, O, way) if s > 0), default=None)
    if first is None:
        return None
    s, (x, y, r) = first
    # Seen from the centre of the circle that is hit, so that nothing is lost far from the plane's origin.
    nx, ny = O[0] - x + s * way[0], O[1] - y + s * way[1]
    vx, vy = L[0] - x - nx, L[1] - y - ny
    if (way[0] * nx + way[1] * ny < 0) != (vx * nx + vy * ny > 0):
        return "dark"
    reach = hypot(vx, vy)
    to_light = vx / reach, vy / reach
    for cx, cy, radius in circles:
        if any(near < s < reach for s in distances((cx - x, cy - y, radius), (nx, ny), to_light)):
            return "dark"
    return "lit"
