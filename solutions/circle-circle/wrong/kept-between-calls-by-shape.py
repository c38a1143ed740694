"""kept-between-calls

Answers are kept under both radii and where C2 is seen from C1, so that a pair elsewhere gets the answer of
the first one. Make all arguments the key, or keep nothing.
"""

from math import hypot, sqrt


def circle_circle(cx1, cy1, r1, cx2, cy2, r2, known={}):
    key = r1, r2, cx2 - cx1, cy2 - cy1
    if key not in known:
        known[key] = common(cx1, cy1, r1, cx2, cy2, r2)
    return known[key]


def common(cx1, cy1, r1, cx2, cy2, r2):
    vx, vy = cx2 - cx1, cy2 - cy1
    d = hypot(vx, vy)
    near = 1e-10 * max(r1, r2, d)
    if d <= near:
        if r1 == r2 == 0:
            return [(cx1, cy1)]
        return None if abs(r1 - r2) <= near else []
    if d > r1 + r2 + near or d < abs(r1 - r2) - near:
        return []
    a = (d + (r1 - r2) * (r1 + r2) / d) / 2
    h = sqrt(max(0.0, r1 * r1 - a * a))
    if d >= r1 + r2 - near or d <= abs(r1 - r2) + near:
        return [(cx1 + a * vx / d, cy1 + a * vy / d)]
    return [(cx1 + (a * vx - s * vy) / d, cy1 + (a * vy + s * vx) / d) for s in (h, -h)]
