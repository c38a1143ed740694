"""quadratic

Every beam asks every circle: n·m tests, four times as many for twice the size. Sort the angles once, and ask only the
circles whose interval of angles holds the beam.
"""

from math import hypot, inf, sqrt


def scan(circles, O, dirs):
    ox, oy = O
    seen = [(x - ox, y - oy, r, i) for i, (x, y, r) in enumerate(circles)]
    near = 1e-10 * max(max(r, abs(fx), abs(fy)) for fx, fy, r, i in seen)
    answers = []
    for dx, dy in dirs:
        length = hypot(dx, dy)
        best, found = inf, None
        for fx, fy, r, i in seen:
            d = abs(dx * fy - dy * fx) / length
            if d > r + near:
                continue
            foot = (dx * fx + dy * fy) / length
            if foot < 0:
                continue
            s = foot - (sqrt((r - d) * (r + d)) if d < r - near else 0.0)
            if s < best:
                best, found = s, i
        answers.append(None if found is None else (found, best / length))
    return answers
