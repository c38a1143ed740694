"""kept-between-calls

Answers are kept under the first circle and the second centre, so that another second radius gets the answer of
the first one. Make all arguments the key, or keep nothing.
"""

from math import hypot, sqrt


def common_tangents(cx1, cy1, r1, cx2, cy2, r2, known={}):
    key = cx1, cy1, r1, cx2, cy2
    if key not in known:
        known[key] = touching(cx1, cy1, r1, cx2, cy2, r2)
    return known[key]


def touching(cx1, cy1, r1, cx2, cy2, r2):
    vx, vy = cx2 - cx1, cy2 - cy1
    d = hypot(vx, vy)
    found = []
    for q in (r1 - r2, r1 + r2):
        gap = d - abs(q)
        if gap >= -1e-10 * max(r1, r2, d):
            c = q / d
            h = sqrt(max(0.0, gap * (d + abs(q)))) / d
            sides = (h, -h) if gap > 1e-10 * max(r1, r2, d) else (0,)
            found += [(cx1 + r1 * (c * vx - s * vy) / d, cy1 + r1 * (c * vy + s * vx) / d) for s in sides]
    return found
