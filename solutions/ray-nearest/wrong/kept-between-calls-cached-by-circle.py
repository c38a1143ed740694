"""kept-between-calls

Answers are kept in a dict whose key is the circle alone, so that another ray gets the answer of the first
one. Make all arguments the key, or keep nothing.
"""

from math import hypot, sqrt


known = {}


def ray_nearest(cx, cy, r, O, D):
    key = cx, cy, r
    if key in known:
        return known[key]
    known[key] = None
    n = hypot(*D)
    if n == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
    d = abs(D[0] * fy - D[1] * fx) / n
    foot = -(fx * D[0] + fy * D[1]) / n
    if d > r + near:
        return None
    if d >= r - near:
        roots = [foot]
    else:
        half = sqrt((r - d) * (r + d))
        far = foot + half if foot > 0 else foot - half
        roots = sorted([far, (fx * fx + fy * fy - r * r) / far])
    for s in roots:
        if s >= -near:
            known[key] = 0 if s <= near else s / n
            break
    return known[key]
