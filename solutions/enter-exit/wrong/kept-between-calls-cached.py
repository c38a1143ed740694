"""kept-between-calls

The hits are kept for each list of circles, and a later call with another ray is given those of the first one.
What is kept needs a key of all arguments; or keep nothing.
"""

from math import hypot, sqrt

known = {}


def all_hits(circles, O, D):
    key = tuple(circles), tuple(O)
    if key in known:
        return known[key]
    near = 1e-10 * max(max(r, abs(x - O[0]), abs(y - O[1])) for x, y, r in circles)
    length = hypot(*D)
    hits = []
    for index, (x, y, r) in enumerate(circles):
        fx, fy = O[0] - x, O[1] - y
        d = abs(D[0] * fy - D[1] * fx) / length
        foot = -(fx * D[0] + fy * D[1]) / length
        if d > r + near:
            continue
        half = sqrt((r - d) * (r + d)) if d < r - near else 0
        found = [(foot - half, "enter"), (foot + half, "exit")] if half else [(foot, "touch")]
        hits += [(max(s, 0.0) / length, index, tag) for s, tag in found if s >= -near]
    known[key] = sorted(hits)
    return known[key]
