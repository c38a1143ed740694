"""the widest tolerance

Everything is compared with 1e-8 of the size: d with r, and the way from O to a hit with 0.
"""

from math import hypot, sqrt


def all_hits(circles, O, D):
    size = max(max(r, abs(x - O[0]), abs(y - O[1])) for x, y, r in circles)
    near, length = 1e-8 * size, hypot(*D)
    hits = []
    for index, (x, y, r) in enumerate(circles):
        fx, fy = O[0] - x, O[1] - y
        d = abs(D[0] * fy - D[1] * fx) / length
        foot = -(fx * D[0] + fy * D[1]) / length
        if d > r + near:
            continue
        half = 0.0 if d >= r - near else sqrt((r - d) * (r + d))
        found = [(foot - half, "enter"), (foot + half, "exit")] if half else [(foot, "touch")]
        hits += [(max(way, 0.0) / length, index, tag) for way, tag in found if way >= -near]
    return sorted(hits)
