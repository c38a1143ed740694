"""distance-by-pythagoras

The distance of the line is taken from |f|² − (f·u)². For a point, or a circle far smaller than its distance, both are
nearly the same, and their difference is rounding. Take the cross product: d = |D × f| / |D|.
"""

from math import hypot, sqrt


def all_hits(circles, O, D):
    ox, oy = O
    dx, dy = D
    n = hypot(dx, dy)
    ux, uy = dx / n, dy / n
    e = max(max(abs(x - ox), abs(y - oy), r) for x, y, r in circles)
    eps = 1e-10 * e
    hits = []
    for i, (x, y, r) in enumerate(circles):
        gx, gy = x - ox, y - oy
        s = gx * ux + gy * uy
        d = sqrt(max(0.0, gx * gx + gy * gy - s * s))
        if d > r + eps:
            continue
        if d >= r - eps:
            found = [(s, "touch")]
        else:
            h = sqrt((r - d) * (r + d))
            found = [(s - h, "enter"), (s + h, "exit")]
        for t, tag in found:
            if t >= -eps:
                hits.append((0.0 if t <= eps else t / n, i, tag))
    hits.sort(key=lambda hit: hit[0])
    return hits
