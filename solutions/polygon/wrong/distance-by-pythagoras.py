"""distance-by-pythagoras

The distance of the line is taken from |f|² − (f·u)². For a point, or a circle far smaller than its distance, both are
nearly the same, and their difference is rounding. Take the cross product: d = |D × f| / |D|.
"""

from math import hypot, sqrt


def boundary_hits(cx, cy, r, V):
    e = max([r] + [max(abs(x - cx), abs(y - cy)) for x, y in V])
    eps = 1e-10 * e
    hits = []
    for i in range(len(V)):
        ax, ay = V[i]
        bx, by = V[(i + 1) % len(V)]
        dx, dy = bx - ax, by - ay
        length = hypot(dx, dy)
        ux, uy = dx / length, dy / length
        fx, fy = ax - cx, ay - cy
        s = -(fx * ux + fy * uy)
        k = ux * fy - uy * fx
        d = sqrt(max(0.0, fx * fx + fy * fy - s * s))
        if d > r + eps:
            continue
        if d >= r - eps:
            places = [s]
        else:
            h = sqrt((r - d) * (r + d))
            places = [s - h, s + h]
        for t in places:
            if abs(t) <= eps:
                hits.append((i, (ax, ay)))
            elif 0 < t < length - eps:
                w = t - s
                hits.append((i, (cx - uy * k + w * ux, cy + ux * k + w * uy)))
    return hits
