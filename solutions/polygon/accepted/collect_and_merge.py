"""collect and merge

Every closed edge gives its crossings by the parameter t of the quadratic; those at an end are kept under their
corner, so that the second edge that finds it changes nothing. Sorting the keys is the way along the boundary.
"""

from math import copysign, sqrt


def boundary_hits(cx, cy, r, V):
    n = len(V)
    e = max(r, *(max(abs(x - cx), abs(y - cy)) for x, y in V))
    kept = {}
    for i, (ax, ay) in enumerate(V):
        bx, by = V[(i + 1) % n]
        dx, dy, fx, fy = bx - ax, by - ay, ax - cx, ay - cy
        a, b, k = dx * dx + dy * dy, fx * dx + fy * dy, dx * fy - dy * fx
        size = sqrt(a)
        gap = abs(k) / size - r
        if gap > 1e-9 * e:
            continue
        if gap >= -1e-9 * e:
            roots = [-b / a]
        else:
            q = -b - copysign(sqrt(max(0.0, r * size - abs(k)) * (r * size + abs(k))), b)
            off = sqrt(fx * fx + fy * fy)
            roots = sorted((q / a, (off - r) * (off + r) / q))
        for place, t in enumerate(roots, 1):
            if abs(t) * size <= 1e-9 * e:
                kept[i, 0] = (ax, ay)
            elif abs(t - 1) * size <= 1e-9 * e:
                kept[(i + 1) % n, 0] = (bx, by)
            elif 0 < t < 1:
                kept[i, place] = (ax + t * dx, ay + t * dy)
    return [(key[0], kept[key]) for key in sorted(kept)]
